// One HTML handle for each weight, over the canvas: a slider inside a hit box, on a leg of the control polygon.
import { element } from "../../ui/dom.js";
import { clamped } from "../../editor/plane.js";
import { weightWords } from "../../editor/descriptions.js";
import { MAX_WEIGHT } from "../../editor/state.js";
import { translated } from "../../editor/translations.js";
import { weightPoints } from "../../editor/weights.js";
import type { Figure } from "../../editor/figure.js";
import type { Point2 } from "../../editor/state.js";
import type { State } from "../../editor/state.js";

type Handle = { box: HTMLElement; input: HTMLInputElement };

/** The slider has the logarithm of the weight, so that 1 is its middle. */
const LARGEST = Math.log10(MAX_WEIGHT);
const STEP = 0.01;

export class WeightHandles {
  #handles: Handle[] = [];
  #places: Point2[] = [];
  #overlay;

  constructor(overlay: HTMLElement) {
    this.#overlay = overlay;
  }

  get count() {
    return this.#handles.length;
  }

  elementOf(k: number): HTMLElement {
    return this.#handles[k].box;
  }

  /** In the plane. */
  placeOf(k: number): Point2 {
    return this.#places[k];
  }

  /** @returns −1 for what is no slider of a weight */
  indexOf(input: EventTarget | null): number {
    return this.#handles.findIndex((handle) => handle.input === input);
  }

  focus(k: number) {
    this.#handles[k]?.input.focus({ preventScroll: true });
  }

  /** The weight that a slider says. */
  weightOf(k: number): number {
    return 10 ** this.#handles[k].input.valueAsNumber;
  }

  /** As many handles as legs, each at its place. */
  update(figure: Figure, { view }: State) {
    this.#places = weightPoints(figure);
    while (this.#handles.length > this.#places.length) this.#handles.pop()?.box.remove();
    while (this.#handles.length < this.#places.length) this.#add();
    this.#handles.forEach(({ box, input }, k) => {
      const at = clamped(view, this.#places[k]);
      box.style.left = `${(100 * (at[0] - view.x)) / view.width}%`;
      box.style.top = `${(100 * (at[1] - view.y)) / view.height}%`;
      const weight = figure.weights?.[k + 1] ?? 1;
      const value = Math.log10(weight);
      if (Math.abs(input.valueAsNumber - value) > STEP / 2 + 1e-9) input.value = `${value}`;
      input.setAttribute("aria-valuetext", weightWords(weight));
      const label = translated("Weight of {0}", figure.names[k + 1]);
      input.setAttribute("aria-label", label);
      box.title = label;
    });
  }

  #add() {
    const page = this.#overlay.ownerDocument;
    const input = element(page, "input", { type: "range", min: -LARGEST, max: LARGEST, step: STEP });
    const box = element(
      page,
      "div",
      { className: "handle", part: "handle", "data-weight": this.#handles.length },
      input,
    );
    this.#overlay.append(box);
    this.#handles.push({ box, input });
  }
}
