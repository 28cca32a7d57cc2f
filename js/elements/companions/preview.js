// A ball that moves as the timing function has it, and the place on the curve that it is at.
import { across, down } from "./timing.js";

/**
 * @import { Heights } from "./timing.js"
 */

const DURATION_MS = 1200;
/** Where progress 0 and 1 are on the track; beyond them is room for those that go too far. */
const [START_PERCENT, WAY_PERCENT] = [20, 60];

export class Preview {
  #root;
  #frame = 0;

  /** @param {() => ShadowRoot} root */
  constructor(root) {
    this.#root = root;
  }

  /**
   * @param {(x: number) => number} ease
   * @param {Heights} heights
   */
  play(ease, heights) {
    this.stop();
    let start = NaN;
    const step = (/** @type {number} */ now) => {
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

  /**
   * @param {number} time
   * @param {number} progress
   * @param {Heights} heights
   */
  #show(time, progress, heights) {
    const ball = /** @type {HTMLElement | null} */ (this.#root().querySelector(".ball"));
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
