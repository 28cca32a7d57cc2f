// One HTML button for each control point of the picked patch, over the canvas.
import { placeOf, shiftOf } from "./camera.js";
import { patchesOf } from "./patches.js";

/**
 * @import { Sight } from "./camera.js"
 * @import { Scene } from "./geometry.js"
 */

/**
 * @typedef {object} HandlePort
 * @property {(vertex: number, to: number[], done: boolean) => void} moved
 * @property {() => { sight: Sight, width: number, height: number } | null} sight
 */

/** A net with more points is shown without handles: nobody can tell them apart. */
const MOST_HANDLES = 100;
const [STEP_PX, WIDE_STEP_PX, FINE_STEP_PX] = [4, 20, 1];

/** Towards the right, downwards, away from the eye. */
const KEYS = new Map([
  ["ArrowLeft", [-1, 0, 0]],
  ["ArrowRight", [1, 0, 0]],
  ["ArrowUp", [0, -1, 0]],
  ["ArrowDown", [0, 1, 0]],
  ["PageUp", [0, 0, 1]],
  ["PageDown", [0, 0, -1]],
]);

/** @typedef {{ vertex: number, x: number, y: number, before: number[], moved: boolean }} Drag where the pointer was, where the point was at first */

export class Handles {
  #overlay;
  #port;
  /** @type {HTMLButtonElement[]} */
  #buttons = [];
  /** The vertex of each button. @type {number[]} */
  #vertices = [];
  /** @type {Float64Array} */
  #points = new Float64Array();
  /** @type {Scene | null} */
  #scene = null;
  /** @type {Map<number, Drag>} */
  #drags = new Map();

  /**
   * @param {HTMLElement} overlay
   * @param {HandlePort} port
   */
  constructor(overlay, port) {
    this.#overlay = overlay;
    this.#port = port;
    const on = (/** @type {string} */ type, /** @type {(event: any) => void} */ listener) =>
      overlay.addEventListener(type, listener);
    on("pointerdown", (event) => this.#down(event));
    on("pointermove", (event) => this.#pulled(event));
    on("pointerup", (event) => this.#released(event, true));
    on("pointercancel", (event) => this.#released(event, false));
    on("keydown", (event) => this.#key(event));
  }

  /**
   * As many handles as the picked patch has control points.
   *
   * @param {Scene} scene
   */
  update(scene) {
    if (scene === this.#scene) return;
    this.#scene = scene;
    const patch = scene.picked === null ? null : patchesOf(scene.surface)[scene.picked];
    const vertices = patch ? [...scene.surface.patches[scene.picked ?? 0]] : [];
    this.#vertices = vertices.length > MOST_HANDLES ? [] : vertices;
    this.#points = patch?.controlPoints() ?? this.#points;
    while (this.#buttons.length > this.#vertices.length) this.#buttons.pop()?.remove();
    while (this.#buttons.length < this.#vertices.length) this.#add();
    this.#buttons.forEach((button, i) => this.#describe(button, i, (patch?.degreeU ?? 0) + 1));
  }

  #add() {
    const button = this.#overlay.ownerDocument.createElement("button");
    button.type = "button";
    button.className = "handle";
    button.setAttribute("part", "handle");
    this.#overlay.append(button);
    this.#buttons.push(button);
  }

  /**
   * @param {HTMLButtonElement} button
   * @param {number} i
   * @param {number} columns
   */
  #describe(button, i, columns) {
    const [column, row, rows] = [i % columns, Math.floor(i / columns), this.#vertices.length / columns];
    const corner = (column === 0 || column === columns - 1) && (row === 0 || row === rows - 1);
    const numbers = [...this.#points.subarray(3 * i, 3 * i + 3)].map((x) => Number(x.toPrecision(3)));
    button.dataset.index = String(i);
    button.dataset.kind = corner ? "on" : "off";
    button.setAttribute("aria-label", `P${column}${row}: x ${numbers[0]}, y ${numbers[1]}, z ${numbers[2]}`);
  }

  /**
   * Puts every handle where its point is seen; outside the picture only the focused one stays, at its edge.
   *
   * @param {Sight} sight
   * @param {number} width
   * @param {number} height
   */
  place(sight, width, height) {
    this.#buttons.forEach((button, i) => {
      const at = placeOf(sight, this.#points, 3 * i, width, height);
      const inside = at && at[0] >= 0 && at[1] >= 0 && at[0] <= width && at[1] <= height;
      button.hidden = !inside && !button.matches(":focus");
      if (!at || button.hidden) return;
      const clamped = (/** @type {number} */ x, /** @type {number} */ most) =>
        Math.min(Math.max(x, 0), most).toFixed(2);
      button.style.translate = `${clamped(at[0], width)}px ${clamped(at[1], height)}px`;
    });
  }

  /** The one whose centre is nearest, among those under the pointer. @param {PointerEvent} event */
  #nearest(event) {
    let [best, least] = [-1, Infinity];
    this.#buttons.forEach((button, i) => {
      const { left, top, width, height } = button.getBoundingClientRect();
      const distance = Math.hypot(event.clientX - left - width / 2, event.clientY - top - height / 2);
      if (!button.hidden && distance < least) [best, least] = [i, distance];
    });
    return best;
  }

  /** @param {PointerEvent} event */
  #down(event) {
    if (event.button !== 0 || !(/** @type {Element} */ (event.target).closest(".handle"))) return;
    const i = this.#nearest(event);
    event.preventDefault();
    this.#buttons[i].focus({ preventScroll: true });
    this.#overlay.setPointerCapture(event.pointerId);
    this.#drags.set(event.pointerId, {
      vertex: this.#vertices[i],
      x: event.clientX,
      y: event.clientY,
      before: this.#pointAt(i),
      moved: false,
    });
  }

  /** @param {number} i */
  #pointAt(i) {
    return [...this.#points.subarray(3 * i, 3 * i + 3)];
  }

  /** @param {PointerEvent} event */
  #pulled(event) {
    const drag = this.#drags.get(event.pointerId);
    if (!drag) return;
    const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
    if (!drag.moved && dx === 0 && dy === 0) return;
    drag.moved = true;
    this.#shift(drag.vertex, drag.before, [dx, dy, 0], false);
  }

  /**
   * @param {PointerEvent} event
   * @param {boolean} kept
   */
  #released(event, kept) {
    const drag = this.#drags.get(event.pointerId);
    if (!drag) return;
    this.#drags.delete(event.pointerId);
    if (!drag.moved) return;
    if (kept) this.#shift(drag.vertex, drag.before, [event.clientX - drag.x, event.clientY - drag.y, 0], true);
    else this.#port.moved(drag.vertex, drag.before, true);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.key === "Escape" && this.#drags.size > 0) {
      for (const { vertex, before } of this.#drags.values()) this.#port.moved(vertex, before, true);
      this.#drags.clear();
      return event.preventDefault();
    }
    const i = this.#buttons.indexOf(/** @type {HTMLButtonElement} */ (event.target));
    const way = KEYS.get(event.key);
    if (i < 0 || !way || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const step = event.shiftKey ? WIDE_STEP_PX : event.altKey ? FINE_STEP_PX : STEP_PX;
    this.#shift(
      this.#vertices[i],
      this.#pointAt(i),
      way.map((x) => x * step),
      true,
    );
  }

  /**
   * @param {number} vertex
   * @param {number[]} from
   * @param {number[]} way in pixels: right, down, away
   * @param {boolean} done
   */
  #shift(vertex, from, [dx, dy, away], done) {
    const seen = this.#port.sight();
    if (!seen) return;
    const { sight, width, height } = seen;
    const flat = shiftOf(sight, from, dx, dy, width, height);
    const unit = Math.hypot(...shiftOf(sight, from, 1, 0, width, height));
    this.#port.moved(
      vertex,
      from.map((x, k) => x + flat[k] + away * unit * sight.forward[k]),
      done,
    );
  }
}
