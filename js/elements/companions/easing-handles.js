import { html } from "lit";
import { arrowStep } from "../../applet/keys.js";
import { shown } from "./numbers.js";
import { across, down, placeAt, rounded, SQUARE } from "./timing.js";

/**
 * @import { Handles, Heights } from "./timing.js"
 */

/** What an arrow key moves a handle by; ten times that with Shift, a tenth with Alt. */
const KEY_STEP = 0.01;
const NAMES = ["First handle", "Second handle"];

/**
 * @typedef {object} DragPort
 * @property {() => Handles} handles
 * @property {() => Heights} heights
 * @property {(handles: Handles, done: boolean) => void} move
 */

/** Pointers and keys on both handles; two fingers may move both. */
export class HandleDrag {
  #port;
  /** Which handle each pointer holds, how far from its middle, and what was before. @type {Map<number, { which: number, grip: [number, number], before: Handles }>} */
  #held = new Map();

  /** @param {DragPort} port */
  constructor(port) {
    this.#port = port;
  }

  /** Whether a pointer holds one. */
  get busy() {
    return this.#held.size > 0;
  }

  /**
   * @param {number} which
   * @param {number} x
   * @param {number} y
   * @param {boolean} done
   */
  to(which, x, y, done) {
    const handles = /** @type {Handles} */ ([...this.#port.handles()]);
    [handles[2 * which], handles[2 * which + 1]] = [Math.min(Math.max(x, 0), 1), y];
    this.#port.move(handles, done);
  }

  /**
   * @param {number} which
   * @param {PointerEvent} event
   */
  grab(which, event) {
    if (event.button !== 0) return;
    const box = /** @type {HTMLElement} */ (event.currentTarget);
    const { left, top, width, height } = box.getBoundingClientRect();
    box.setPointerCapture(event.pointerId);
    box.querySelector("input")?.focus({ preventScroll: true });
    event.preventDefault(); // the focus stays
    this.#held.set(event.pointerId, {
      which,
      grip: [event.clientX - left - width / 2, event.clientY - top - height / 2],
      before: this.#port.handles(),
    });
  }

  /** @param {PointerEvent} event */
  drag(event) {
    const held = this.#held.get(event.pointerId);
    if (held) this.to(held.which, ...this.#place(event, held.grip), false);
  }

  /** @param {PointerEvent} event */
  release(event) {
    const held = this.#held.get(event.pointerId);
    if (!held) return;
    this.#held.delete(event.pointerId);
    if (event.type === "pointerup") this.to(held.which, ...this.#place(event, held.grip), true);
    else this.#port.move(held.before, true);
  }

  /**
   * @param {number} which
   * @param {KeyboardEvent} event
   */
  press(which, event) {
    if (event.key === "Escape") return this.#restore(event);
    const step = arrowStep(event);
    if (!step) return;
    event.preventDefault();
    const [x, y] = this.#port.handles().slice(2 * which);
    const finer = event.altKey ? (/** @type {number} */ value) => Math.round(1e4 * value) / 1e4 : rounded;
    this.to(which, finer(x + step[0] * KEY_STEP), finer(y - step[1] * KEY_STEP), false);
    this.to(which, ...pairOf(this.#port.handles(), which), true);
  }

  /** @param {Event} event */
  #restore(event) {
    for (const [pointer, { before }] of this.#held) {
      this.#held.delete(pointer);
      event.preventDefault();
      this.#port.move(before, true);
    }
  }

  /**
   * @param {PointerEvent} event
   * @param {[number, number]} grip
   */
  #place(event, [gripX, gripY]) {
    const stage = /** @type {HTMLElement} */ (/** @type {HTMLElement} */ (event.currentTarget).parentElement);
    const { left, top, width, height } = stage.getBoundingClientRect();
    return placeAt(
      this.#port.heights(),
      (event.clientX - gripX - left) / width,
      (event.clientY - gripY - top) / height,
    );
  }
}

/**
 * @param {Handles} handles
 * @param {number} which
 * @returns {[number, number]}
 */
const pairOf = (handles, which) => [handles[2 * which], handles[2 * which + 1]];

/**
 * A hit box with two sliders inside, as the applet's points have.
 *
 * @param {number} which
 * @param {Handles} handles
 * @param {Heights} heights
 * @param {HandleDrag} drag
 */
export function handle(which, handles, heights, drag) {
  const [x, y] = pairOf(handles, which);
  const release = (/** @type {PointerEvent} */ event) => drag.release(event);
  const slider = (
    /** @type {string} */ axis,
    /** @type {number} */ value,
    /** @type {number[]} */ range,
    /** @type {(value: number) => [number, number]} */ place,
  ) => {
    const slid = (/** @type {Event} */ event) =>
      drag.to(which, ...place(Number(/** @type {HTMLInputElement} */ (event.target).value)), event.type === "change");
    return html`<input type="range" aria-label="${NAMES[which]} ${axis}" tabindex=${axis === "x" ? 0 : -1} min=${range[0]} max=${range[1]} step="0.01" .value=${String(value)} aria-valuetext=${shown(value)} @input=${slid} @change=${slid}>`;
  };
  // The place as a property: a strict policy forbids the attribute.
  return html`<div class="handle" part="handle" data-index=${which} .style=${`left: ${(100 * across(x)) / SQUARE.width}%; top: ${(100 * down(heights, y)) / SQUARE.height}%`}
    @pointerdown=${(/** @type {PointerEvent} */ event) => drag.grab(which, event)} @pointermove=${(/** @type {PointerEvent} */ event) => drag.drag(event)}
    @pointerup=${release} @pointercancel=${release} @lostpointercapture=${release} @keydown=${(/** @type {KeyboardEvent} */ event) => drag.press(which, event)}>
    ${slider("x", x, [0, 1], (to) => [to, y])}${slider("y", y, heights, (to) => [x, to])}</div>`;
}
