// <surface-reading for="id" what="hit">: a line that says what a figure shows.
import { element } from "../parts/dom.js";
import { LinkedFigure } from "./lib/linked-figure.js";
import { jointAngle } from "./lib/surfaces.js";

const decimals = (/** @type {number} */ x) => x.toFixed(2);

/** The parts of the teapot by the number of their first patch. @type {[number, string][]} */
const TEAPOT_PARTS = [
  [28, "bottom"],
  [20, "lid"],
  [16, "spout"],
  [12, "handle"],
  [4, "body"],
  [0, "rim"],
];

/** What each line says. */
const READINGS = {
  joint: (/** @type {any} */ figure) =>
    figure
      ? `The largest angle between normals along the common side is ${jointAngle(figure.surface).toFixed(1)}°.`
      : "",
  point: (/** @type {any} */ figure) =>
    figure?.place
      ? `S(${decimals(figure.u)}, ${decimals(figure.v)}) = (${figure.place.point.map((/** @type {number} */ x) => x.toFixed(3).replace("-", "−")).join(", ")})`
      : "",
  hit: (/** @type {any} */ figure) =>
    figure && figure.patch === null
      ? "The click missed the pot."
      : `Patch ${figure?.patch} (${TEAPOT_PARTS.find(([first]) => figure?.patch >= first)?.[1]}), u = ${decimals(figure?.u ?? 0)}, v = ${decimals(figure?.v ?? 0)}.`,
  nearest: ({ nearest: found } = /** @type {any} */ ({})) =>
    found
      ? `The distance is ${found.distance.toFixed(3)}. The nearest point is on patch ${found.patch}, at u = ${decimals(found.u)}, v = ${decimals(found.v)}.`
      : "",
};

class SurfaceReading extends LinkedFigure {
  #line = element("p", { className: "note", role: "status" });

  build() {
    this.append(this.#line);
  }

  follow() {
    const what = /** @type {keyof typeof READINGS} */ (this.getAttribute("what"));
    this.#line.textContent = READINGS[what](this.target?.figure);
  }
}

customElements.define("surface-reading", SurfaceReading);
