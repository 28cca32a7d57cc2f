// One HTML button for each control point of the picked patch, over the canvas.
import { arrowDirection } from "../../ui/keys.js";
import { cssZoom } from "../../ui/canvas-size.js";
import { Drags } from "../../ui/drag.js";
import { placeOf, shiftOf } from "./camera.js";
import { patchesOf } from "./patches.js";
import type { CameraMatrices } from "./camera.js";
import type { Point2 } from "../../ui/capture.js";
import type { Scene } from "./geometry.js";

type Callbacks = {
  moved: (vertex: number, to: number[], isDone: boolean) => void;
  /** The last pointer has let go of its point */
  dropped: () => void;
  /** The pointer was taken away, or Escape was pressed: back to what was before */
  cancelled: () => void;
  /** Asks for a frame, which calls `apply` */
  schedule: () => void;
  matrices: () => CameraMatrices | null;
};

/** A net with more points is shown without handles, which would overlap. */
const MAX_HANDLES = 100;
const [STEP_PX, WIDE_STEP_PX, FINE_STEP_PX] = [4, 20, 1];

/** How far a key moves a point away from the eye. */
const DEPTH_KEYS = new Map([
  ["PageUp", 1],
  ["PageDown", -1],
]);

export class Handles {
  #overlay;
  #callbacks;
  #buttons: HTMLButtonElement[] = [];
  /** The vertex of each button. */
  #vertices: number[] = [];
  #points: Float64Array = new Float64Array();
  #scene: Scene | null = null;
  #drags;
  /** For each button that is dragged: its vertex, and the control point before. */
  #grabbed: Map<number, { vertex: number; point: number[] }> = new Map();

  constructor(overlay: HTMLElement, callbacks: Callbacks) {
    this.#overlay = overlay;
    this.#callbacks = callbacks;
    overlay.addEventListener("keydown", (event) => this.#key(event));
    this.#drags = new Drags(overlay, {
      count: () => this.#buttons.length,
      elementOf: (i) => this.#buttons[i],
      placeOf: () => [0, 0], // of a drag, only the shift counts
      toViewBox: ({ clientX, clientY }) => [clientX / cssZoom(overlay), clientY / cssZoom(overlay)],
      schedule: () => callbacks.schedule(),
      started: () => this.#grabbed.clear(),
      grabbed: (i) => {
        this.#buttons[i].focus({ preventScroll: true });
        this.#grabbed.set(i, { vertex: this.#vertices[i], point: this.#pointAt(i) });
      },
      move: (i, shift) => this.#follow(i, shift),
      cancelled: () => callbacks.cancelled(),
      ended: () => callbacks.dropped(),
    });
  }

  /** As many handles as the picked patch has control points. */
  update(scene: Scene) {
    if (scene === this.#scene) return;
    this.#scene = scene;
    const patch = scene.picked === null ? null : patchesOf(scene.surface)[scene.picked];
    const vertices = patch ? [...scene.surface.patches[scene.picked ?? 0]] : [];
    this.#vertices = vertices.length > MAX_HANDLES ? [] : vertices;
    this.#points = patch?.controlPoints() ?? this.#points;
    while (this.#buttons.length > this.#vertices.length) this.#buttons.pop()?.remove();
    while (this.#buttons.length < this.#vertices.length) this.#add();
    this.#buttons.forEach((button, i) => this.#describe(button, i, (patch?.degreeU ?? 0) + 1));
  }

  /** Moves the points to where their pointers are by now. */
  apply() {
    this.#drags.apply();
  }

  /** Lets all points go where they are, without a report. */
  release() {
    this.#drags.release();
  }

  #add() {
    const button = this.#overlay.ownerDocument.createElement("button");
    button.type = "button";
    button.className = "handle";
    button.setAttribute("part", "handle");
    this.#overlay.append(button);
    this.#buttons.push(button);
  }

  #describe(button: HTMLButtonElement, i: number, columns: number) {
    const [column, row, rows] = [i % columns, Math.floor(i / columns), this.#vertices.length / columns];
    const corner = (column === 0 || column === columns - 1) && (row === 0 || row === rows - 1);
    const numbers = [...this.#points.subarray(3 * i, 3 * i + 3)].map((x) => Number(x.toPrecision(3)));
    setAttribute(button, "data-index", String(i));
    setAttribute(button, "data-kind", corner ? "on" : "off");
    setAttribute(button, "aria-label", `P${column}${row}: x ${numbers[0]}, y ${numbers[1]}, z ${numbers[2]}`);
  }

  /** Puts every handle where its point is seen; outside the picture only the focused one stays, at its edge. */
  place(matrices: CameraMatrices) {
    const { width, height } = matrices;
    this.#buttons.forEach((button, i) => {
      const at = placeOf(matrices, this.#points, 3 * i);
      const inside = at && at[0] >= 0 && at[1] >= 0 && at[0] <= width && at[1] <= height;
      button.hidden = !inside && !button.matches(":focus");
      if (!at || button.hidden) return;
      const clamped = (x: number, max: number) => Math.min(Math.max(x, 0), max).toFixed(2);
      button.style.translate = `${clamped(at[0], width)}px ${clamped(at[1], height)}px`;
    });
  }

  /** @param shift of the pointer since it was pressed, in CSS pixels */
  #follow(i: number, shift: Point2) {
    const grabbed = this.#grabbed.get(i);
    if (grabbed) this.#shift(grabbed.vertex, grabbed.point, [...shift, 0], false);
  }

  #pointAt(i: number) {
    return [...this.#points.subarray(3 * i, 3 * i + 3)];
  }

  #key(event: KeyboardEvent) {
    if (event.key === "Escape" && this.#drags.cancel()) return event.preventDefault();
    const i = this.#buttons.indexOf(event.target as HTMLButtonElement);
    const [right, down] = arrowDirection(event) ?? [0, 0];
    const away = event.ctrlKey || event.metaKey ? 0 : (DEPTH_KEYS.get(event.key) ?? 0);
    if (i < 0 || !(right || down || away)) return;
    event.preventDefault();
    const step = event.shiftKey ? WIDE_STEP_PX : event.altKey ? FINE_STEP_PX : STEP_PX;
    this.#shift(this.#vertices[i], this.#pointAt(i), [right * step, down * step, away * step], true);
  }

  /**
   * @param way in pixels: right, down, away
   */
  #shift(vertex: number, from: number[], [dx, dy, away]: number[], done: boolean) {
    const matrices = this.#callbacks.matrices();
    if (!matrices) return;
    const flat = shiftOf(matrices, from, dx, dy);
    const unit = Math.hypot(...shiftOf(matrices, from, 1, 0));
    this.#callbacks.moved(
      vertex,
      from.map((x, k) => x + flat[k] + away * unit * matrices.forward[k]),
      done,
    );
  }
}

/** Writes an attribute if it differs: during a drag most are as they were, and writing costs. */
function setAttribute(element: HTMLElement, name: string, value: string) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}
