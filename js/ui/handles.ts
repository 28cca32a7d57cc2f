// One HTML handle for each shown point, over the canvas: two range inputs inside a hit box.
import { element } from "./dom.js";
import { clamped } from "../editor/plane.js";
import type { Box } from "../editor/plane.js";

export type Handle = { box: HTMLElement; x: HTMLInputElement; y: HTMLInputElement };

/** The inputs' step: what Alt and an arrow key do. */
const FINEST_STEP = 0.1;

/** What the handles are called, and whether their points lie on the curve. */
export type Nature = { nameOf: (index: number) => string; kindOf: (index: number) => string };

export class Handles {
  #handles: Handle[] = [];
  #overlay;
  #box;

  constructor(overlay: HTMLElement, box: Box) {
    this.#overlay = overlay;
    this.#box = box;
  }

  get count() {
    return this.#handles.length;
  }

  elementOf(index: number): HTMLElement {
    return this.#handles[index].box;
  }

  /**
   * @returns −1 for what is no input of a point
   */
  indexOf(input: EventTarget | null): number {
    return this.#handles.findIndex(({ x, y }) => x === input || y === input);
  }

  /** Puts the keyboard on a point. */
  focus(index: number) {
    this.#handles[index]?.x.focus({ preventScroll: true });
  }

  /**
   * As many handles as points, each at its place.
   *
   * @param view the part of the plane that is seen
   */
  update(points: readonly [number, number][], view: Box & { x?: number; y?: number }, nature: Nature) {
    while (this.#handles.length > points.length) this.#handles.pop()?.box.remove();
    while (this.#handles.length < points.length) this.#add(this.#handles.length);
    points.forEach((point, i) => {
      this.#place(this.#handles[i], point, view);
      name(this.#handles[i], nature.nameOf(i), nature.kindOf(i));
    });
  }

  #add(index: number) {
    const page = this.#overlay.ownerDocument;
    const input = (axis: "x" | "y") => element(page, "input", { type: "range", "data-axis": axis, step: FINEST_STEP });
    const [x, y] = [input("x"), input("y")];
    y.tabIndex = -1; // all four arrows work on x; a screen reader finds both
    const box = element(page, "div", { className: "handle", part: "handle", "data-index": index }, x, y);
    this.#overlay.append(box);
    this.#handles.push({ box, x, y });
  }

  #place({ box, x, y }: Handle, point: [number, number], view: Box & { x?: number; y?: number }) {
    const { width, height } = this.#box;
    const at = clamped(view, point);
    box.style.left = `${(100 * (at[0] - (view.x ?? 0))) / view.width}%`;
    box.style.top = `${(100 * (at[1] - (view.y ?? 0))) / view.height}%`;
    setRange(x, point[0], point[0], width);
    setRange(y, height - point[1], point[1], height); // more is higher up
  }
}

function name({ box, x, y }: Handle, called: string, kind: string) {
  if (box.dataset.name === called && box.dataset.kind === kind) return;
  Object.assign(box.dataset, { name: called, kind });
  for (const input of [x, y]) input.setAttribute("aria-label", `${called} ${input.dataset.axis}`);
}

/**
 * @param size of the view box; points outside stretch the range
 */
function setRange(input: HTMLInputElement, value: number, spoken: number, size: number) {
  const [min, max] = [Math.min(0, Math.floor(value)), Math.max(size, Math.ceil(value))];
  if (input.min !== `${min}`) input.min = `${min}`; // most are as they were, and writing costs
  if (input.max !== `${max}`) input.max = `${max}`;
  if (Math.abs(input.valueAsNumber - value) > FINEST_STEP / 2 + 1e-9) input.value = `${value}`;
  const words = `${Math.round(10 * spoken) / 10}`;
  if (input.getAttribute("aria-valuetext") !== words) input.setAttribute("aria-valuetext", words);
}
