// D1, the length of the control polygon, against D2, the distance between the ends.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure } from "./lib/figure.js";
import { decimal } from "./lib/numbers.js";
import { polyline } from "./lib/parts.js";
import { drawn, handles, marks, pairs, planeOf, pointName } from "./lib/plane.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 120, height: 70 };
/** @type {Point[]} */
const POINTS = [
  [14, 56],
  [26, 14],
  [88, 12],
  [106, 54],
];
const BARS = { height: 78, left: 40, right: 14, thick: 18 };
/** Control polygons below this length cannot be told from a point. */
const MIN_LENGTH = 2;

/** @param {Point[]} points */
export const lengthsOf = (points) => ({
  legs: points.slice(1).map(([x, y], i) => Math.hypot(x - points[i][0], y - points[i][1])),
  chord: Math.hypot(points[3][0] - points[0][0], points[3][1] - points[0][1]),
});

/** `<fig-lengths>` */
export class FigLengths extends Figure {
  static properties = { points: { state: true } };

  constructor() {
    super();
    this.points = POINTS;
  }

  /** @param {Point[]} points */
  show(points) {
    this.points = points;
    this.notifyChange();
  }

  halve() {
    const [first] = new Curve(this.points).halve();
    this.show(pairs(first.controlPoints()));
  }

  /** @param {import("./lib/plane.js").Plane} plane */
  picture(plane) {
    const places = this.points.map(plane.place);
    return html`
      <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A cubic, its control polygon, and the line between its ends">
        <path d="M${places.map((place) => place.join(" ")).join("L")}" fill="none" stroke="var(--handle)" stroke-width="2.5" />
        <path d="M${places[0].join(" ")}L${places[3].join(" ")}" fill="none" stroke="var(--level1)" stroke-width="2.5" stroke-dasharray="8 5" />
        <path class="curve" d=${drawn(plane, new Curve(this.points))} />
        ${marks(plane, this.points, pointName)}
      </svg>
    `;
  }

  bars() {
    const { legs, chord } = lengthsOf(this.points);
    const { height, left, right, thick } = BARS;
    const total = legs.reduce((sum, leg) => sum + leg, 0);
    const unit = (this.wide - left - right) / total;
    let from = left;
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="D1 and D2 as bars">
        <text class="strong" x="10" y="28">D1</text><text class="strong" x="10" y="61">D2</text>
        ${legs.map((leg) => {
          const bar = svg`<rect x=${from} y="14" width=${leg * unit} height=${thick} fill="var(--handle)" fill-opacity="0.75" stroke="var(--paper)" stroke-width="2" />`;
          from += leg * unit;
          return bar;
        })}
        <rect x=${left} y="47" width=${chord * unit} height=${thick} fill="var(--level1)" fill-opacity="0.75" />
        ${polyline("dropped", [left + chord * unit, 10, left + chord * unit, height - 8])}
      </svg>
    `;
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const { legs, chord } = lengthsOf(this.points);
    const total = legs.reduce((sum, leg) => sum + leg, 0);
    const error = new Curve(this.points).hausdorff(new Curve([this.points[0], this.points[3]]));
    return html`
      <div class="frame">
        <div class="stage">
          ${this.picture(plane)}
          ${handles(this, plane, this.points, { name: pointName, move: (points) => (this.points = points) })}
        </div>
        <div class="stage">${this.bars()}</div>
        <p class="facts">D1 = ${decimal(total)}, D2 = ${decimal(chord)}, <b class="line">D1 − D2 = ${decimal(total - chord, 3)}</b>. Distance between the curve and the line: <b>${decimal(error, 3)}</b>.</p>
        <div class="controls"><div class="row">
          <button ?disabled=${total < MIN_LENGTH} @click=${this.halve}>Halve</button>
          <button @click=${() => this.show(POINTS)}>Start again</button>
        </div></div>
      </div>
    `;
  }
}

customElements.define("fig-lengths", FigLengths);
