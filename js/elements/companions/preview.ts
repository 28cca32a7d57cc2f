// A ball that moves as the timing function has it, and the place on the curve that it is at.
import { across, down } from "./timing.js";
import type { Heights } from "./timing.js";

const DURATION_MS = 1200;
/** Where progress 0 and 1 are on the track; beyond them is room for those that go too far. */
const [START_PERCENT, WAY_PERCENT] = [20, 60];

export class Preview {
  #root;
  #frame = 0;

  constructor(root: () => ShadowRoot) {
    this.#root = root;
  }

  play(ease: (x: number) => number, heights: Heights) {
    this.stop();
    let start = NaN;
    const step = (now: number) => {
      if (Number.isNaN(start)) start = now;
      const time = Math.min((now - start) / DURATION_MS, 1);
      this.#show(time, ease(time), heights);
      if (time < 1) this.#frame = requestAnimationFrame(step);
      else this.stop();
    };
    this.#frame = requestAnimationFrame(step);
  }

  stop() {
    cancelAnimationFrame(this.#frame);
    this.#dot()?.setAttribute("visibility", "hidden");
  }

  #show(time: number, progress: number, heights: Heights) {
    const ball = this.#root().querySelector(".ball") as HTMLElement | null;
    if (ball) ball.style.insetInlineStart = `${Math.min(Math.max(START_PERCENT + WAY_PERCENT * progress, 0), 100)}%`;
    const dot = this.#dot();
    dot?.setAttribute("cx", String(across(time)));
    dot?.setAttribute("cy", String(down(heights, progress)));
    dot?.setAttribute("visibility", "visible");
  }

  #dot() {
    return this.#root()?.querySelector(".now");
  }
}
