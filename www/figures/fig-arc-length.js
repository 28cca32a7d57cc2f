// Equal steps of t against equal lengths along a cubic, and the share of the length up to t.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure, numeric } from "./lib/figure.js";
import { decimal } from "./lib/numbers.js";
import { diamond, polyline, ring, slider } from "./lib/parts.js";
import { drawn, handles, marks, planeOf, pointName } from "./lib/plane.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 130, height: 82 };
/** @type {Point[]} */
const POINTS = [
  [12, 66],
  [12, 52],
  [36, 8],
  [118, 28],
];
const PARTS = 10;
/** Half the length of the strokes across the curve, in CSS pixels. */
const STROKE_HALF = 10;

/** `<fig-arc-length t="0.5">` */
export class FigArcLength extends Figure {
  static properties = { t: numeric({ least: 0, most: 1, otherwise: 0.5 }), points: { state: true } };

  constructor() {
    super();
    this.t = 0.5;
    this.points = POINTS;
  }

  get curve() {
    return new Curve(this.points);
  }

  /** @param {import("./lib/plane.js").Plane} plane @param {number} t */
  across(plane, t) {
    const [{ x, y }, normal] = [this.curve.eval(t), this.curve.normal(t)];
    const [px, py] = plane.place([x, y]);
    const [dx, dy] = [STROKE_HALF * normal.x, STROKE_HALF * normal.y];
    return svg`<path d="M${px - dx} ${py - dy}L${px + dx} ${py + dy}" stroke="var(--ink)" stroke-width="1.75" />`;
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const { curve, t } = this;
    const at = curve.eval(t);
    const [length, covered] = [curve.length(), curve.subsegment(0, t).length()];
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A cubic, divided into equal lengths and into equal steps of t">
            ${polyline("polygon", this.points.flatMap(plane.place))}
            <path class="curve" d=${drawn(plane, curve)} opacity="0.45" /><path class="curve" stroke-width="5" d=${drawn(plane, curve.subsegment(0, t))} />
            ${Array.from(curve.equidistantTimes(PARTS), (time) => this.across(plane, time))}
            ${Array.from({ length: PARTS + 1 }, (_, i) => {
              const { x, y } = curve.eval(i / PARTS);
              return ring(...plane.place([x, y]), "var(--handle)", 5);
            })}
            ${marks(plane, this.points, pointName)}
            ${diamond(...plane.place([at.x, at.y]))}
          </svg>
          ${handles(this, plane, this.points, { name: pointName, move: (points) => (this.points = points) })}
        </div>
        <p class="facts">Length <b>${decimal(length, 1)}</b>. From <i>t</i> = 0 to <i>t</i> = ${decimal(t)}: <b>${decimal(covered, 1)}</b>.</p>
        <div class="controls">
          ${slider({ name: html`<i>t</i>`, value: t, min: 0, max: 1, text: decimal(t), change: (to) => (this.t = to) })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-arc-length", FigArcLength);
