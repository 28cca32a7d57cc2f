// <lathe-surface for="profile" shows="surface">: turns the profile of an applet about the left edge of its picture.
import { element } from "../parts/dom.js";
import { maxRadialError } from "./lib/circle.js";
import { LinkedFigure } from "./lib/linked-figure.js";
import { revolved, TEAPOT_HANDLE } from "./lib/revolution.js";

/** Of the applet's picture: the length 1 and the height z = 0, in CSS pixels. */
const UNIT_PX = 180;
const GROUND_PX = 470;
const [MIN_HANDLE, MAX_HANDLE, STEP] = [0.4, 0.7, 0.0001];
const ARCS = 4;

export class LatheSurface extends LinkedFigure {
  #handle = TEAPOT_HANDLE;
  #input = Object.assign(document.createElement("input"), { type: "range" });
  #output = document.createElement("output");
  #words = element("p", { className: "note", role: "status" });
  #shown = "";

  build() {
    Object.assign(this.#input, { min: MIN_HANDLE, max: MAX_HANDLE, step: STEP });
    for (const type of ["input", "change"])
      this.#input.addEventListener(type, () => {
        this.handle = Number(this.#input.value);
      });
    const label = element("label", { className: "line" }, element("span", {}, "κ"), this.#input, this.#output);
    this.append(label, this.#words);
    this.handle = this.#handle;
  }

  /** The number κ. */
  get handle() {
    return this.#handle;
  }

  set handle(handle) {
    this.#handle = handle;
    this.#input.value = String(handle);
    this.#output.textContent = handle.toFixed(4);
    this.#words.textContent = `The largest difference from a circle is ${(100 * this.error).toFixed(3)} % of the radius.`;
    this.follow();
  }

  /** The largest distance from the circle, in radii. */
  get error() {
    return maxRadialError(ARCS, this.#handle);
  }

  follow() {
    const points = this.target?.figure?.points;
    if (!points) return;
    const profile = points.map((/** @type {[number, number]} */ [x, y]) => [
      Math.max(x / UNIT_PX, 0),
      (GROUND_PX - y) / UNIT_PX,
    ]);
    const key = JSON.stringify([profile, this.#handle]);
    if (key === this.#shown) return;
    this.#shown = key;
    const shown = /** @type {any} */ (document.getElementById(this.getAttribute("shows") ?? ""));
    if (shown) shown.surface = revolved(profile, this.#handle);
  }
}

customElements.define("lathe-surface", LatheSurface);
