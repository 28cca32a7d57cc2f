import { html } from "lit";
import { arrowStep } from "../../ui/keys.js";
import { dragHandle } from "../../ui/capture.js";
import { shown } from "../../ui/numbers.js";
import { across, down, placeAt, rounded, SQUARE } from "./timing.js";
import { translated } from "../../editor/translations.js";
import type { Point2 } from "../../ui/capture.js";
import type { Handles, Heights } from "./timing.js";

/** What an arrow key moves a handle by; ten times that with Shift, a tenth with Alt. */
const KEY_STEP = 0.01;

export interface DragPort {
  handles: () => Handles;
  heights: () => Heights;
  move: (handles: Handles, done: boolean) => void;
}

/** Pointers and keys on both handles; two fingers may move both. */
export class HandleDrag {
  #port;
  /** What was before each drag, and what stops it. */
  #drags: Set<{ before: Handles; stop: () => void }> = new Set();

  constructor(port: DragPort) {
    this.#port = port;
  }

  /** Whether a pointer holds one. */
  get busy() {
    return this.#drags.size > 0;
  }

  to(which: number, x: number, y: number, done: boolean) {
    const handles = [...this.#port.handles()] as Handles;
    [handles[2 * which], handles[2 * which + 1]] = [Math.min(Math.max(x, 0), 1), y];
    this.#port.move(handles, done);
  }

  grab(which: number, event: PointerEvent) {
    if (event.button !== 0) return;
    const box = event.currentTarget as HTMLElement;
    const { left, top, width, height } = box.getBoundingClientRect();
    box.querySelector("input")?.focus({ preventScroll: true });
    event.preventDefault(); // the focus stays
    const before = this.#port.handles();
    const stop = dragHandle(event, {
      from: [left + width / 2, top + height / 2],
      placeOf: ({ clientX, clientY }) => [clientX, clientY],
      move: (to) => this.to(which, ...this.#valueAt(box, to), false),
      end: (_, released) => {
        this.#drags.delete(drag);
        this.#port.move(released ? this.#port.handles() : before, true);
      },
    });
    const drag = { before, stop };
    this.#drags.add(drag);
  }

  press(which: number, event: KeyboardEvent) {
    if (event.key === "Escape") return this.#restore(event);
    const step = arrowStep(event);
    if (!step) return;
    event.preventDefault();
    const [x, y] = this.#port.handles().slice(2 * which);
    const finer = event.altKey ? (value: number) => Math.round(1e4 * value) / 1e4 : rounded;
    this.to(which, finer(x + step[0] * KEY_STEP), finer(y - step[1] * KEY_STEP), false);
    this.to(which, ...pairOf(this.#port.handles(), which), true);
  }

  #restore(event: Event) {
    for (const { before, stop } of this.#drags) {
      stop();
      event.preventDefault();
      this.#port.move(before, true);
    }
    this.#drags.clear();
  }

  /** @param place in the window */
  #valueAt(box: HTMLElement, [x, y]: Point2) {
    const { left, top, width, height } = (box.parentElement as HTMLElement).getBoundingClientRect();
    return placeAt(this.#port.heights(), (x - left) / width, (y - top) / height);
  }
}

const pairOf = (handles: Handles, which: number): [number, number] => [handles[2 * which], handles[2 * which + 1]];

/** A hit box with two sliders inside, as the applet's points have. */
export function handle(which: number, handles: Handles, heights: Heights, drag: HandleDrag) {
  const [x, y] = pairOf(handles, which);
  const slider = (axis: string, value: number, range: number[], place: (value: number) => [number, number]) => {
    const slid = (event: Event) =>
      drag.to(which, ...place(Number((event.target as HTMLInputElement).value)), event.type === "change");
    return html`<input type="range" aria-label=${which ? translated("Second handle {0}", axis) : translated("First handle {0}", axis)} tabindex=${axis === "x" ? 0 : -1} min=${range[0]} max=${range[1]} step="0.01" .value=${String(value)} aria-valuetext=${shown(value)} @input=${slid} @change=${slid}>`;
  };
  // The place as a property: a strict policy forbids the attribute.
  return html`<div class="handle" part="handle" data-index=${which} .style=${`left: ${(100 * across(x)) / SQUARE.width}%; top: ${(100 * down(heights, y)) / SQUARE.height}%`}
    @pointerdown=${(event: PointerEvent) => drag.grab(which, event)} @keydown=${(event: KeyboardEvent) => drag.press(which, event)}>
    ${slider("x", x, [0, 1], (to) => [to, y])}${slider("y", y, heights, (to) => [x, to])}</div>`;
}
