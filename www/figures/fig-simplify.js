// An outline of many lines, simplified within a tolerance.
import { html } from "lit";
import { Figure } from "./lib/figure.js";
import { OUTLINE } from "./lib/fitting.js";
import { decimal, grouped } from "./lib/numbers.js";
import { check, disc, slider } from "./lib/parts.js";
import { drawn, planeOf } from "./lib/plane.js";

const SIZE = { width: 128, height: 84 };
/** Exponents of 2 for the tolerance. */
const [FINE, COARSE] = [-6, 3];
/** Decimals of the coordinates in the path data. */
const PRECISION = 2;

const bytesOf = (/** @type {{ toSVG(options: { precision: number }): string }} */ path) =>
  path.toSVG({ precision: PRECISION }).length;

/** `<fig-simplify>` */
export class FigSimplify extends Figure {
  static properties = { exponent: { state: true }, extrema: { state: true } };

  constructor() {
    super();
    this.exponent = -2;
    this.extrema = false;
  }

  get tolerance() {
    return 2 ** this.exponent;
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const path = OUTLINE.simplify(this.tolerance, { extrema: this.extrema });
    const [outline] = path.subpaths;
    const count = outline.segmentCount;
    const joints = Array.from({ length: count }, (_, t) => outline.eval(t));
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A flower of ${count} segments">
            <path class="ghost" d=${drawn(plane, OUTLINE)} />
            <path class="curve" d=${drawn(plane, path)} />
            ${joints.map(({ x, y }) => disc(...plane.place([x, y]), 5))}
          </svg>
        </div>
        <p class="facts">${OUTLINE.subpaths[0].segmentCount} lines, ${grouped(bytesOf(OUTLINE))} bytes of path data: now <b>${count}</b> cubics, <b>${grouped(bytesOf(path))}</b> bytes.</p>
        <div class="controls">
          ${slider({ name: "Tolerance", value: this.exponent, min: FINE, max: COARSE, step: 1, text: decimal(this.tolerance, this.exponent < -1 ? 3 : 1), change: (to) => (this.exponent = to) })}
          ${check({ name: "joints at extrema", value: this.extrema, change: (to) => (this.extrema = to) })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-simplify", FigSimplify);
