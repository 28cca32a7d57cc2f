// A conic as a rational quadratic Bézier curve: three points and the weight of the middle one.
import { html, svg } from "lit";
import { Figure } from "./lib/figure.js";
import { decimal } from "./lib/numbers.js";
import { pathOf, polyline, ring, slider } from "./lib/parts.js";
import { handles, marks, planeOf } from "./lib/plane.js";
import { circleWeight, rationalCurve } from "./lib/rational.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 134, height: 84 };
/** @type {Point[]} */
const POINTS = [
  [20, 70],
  [67, 23],
  [114, 70],
];
const MAX_WEIGHT = 4;
const STEPS = 200;
/** Parts of the other arc that are farther away than this, in units of the picture, are not drawn. */
const FAR = 400;
/** The weights that count as 1, and as that of a circle. */
const NEAR = 0.005;

const nameOf = (/** @type {number} */ i) => `P${i}`;

/** `<fig-conic>` */
export class FigConic extends Figure {
  static properties = { points: { state: true }, weight: { state: true } };

  constructor() {
    super();
    this.points = POINTS;
    this.weight = 0.4;
  }

  /** The point at t = 1/2. @returns {Point} */
  get middle() {
    return rationalCurve(this.points, [1, this.weight, 1])(0.5);
  }

  /** What the arc belongs to. */
  get kind() {
    const circle = circleWeight(this.points);
    if (circle !== null && Math.abs(this.weight - circle) < NEAR) return "a circle";
    if (Math.abs(this.weight - 1) < NEAR) return "a parabola";
    return this.weight < 1 ? "an ellipse" : "a hyperbola";
  }

  picture() {
    const plane = planeOf(this.wide, SIZE);
    const steps = Array.from({ length: STEPS + 1 }, (_, i) => i / STEPS);
    const arc = rationalCurve(this.points, [1, this.weight, 1]);
    // The same conic with the opposite weight is the rest of it. A hyperbola's goes through infinity.
    const rest = rationalCurve(this.points, [1, -this.weight, 1]);
    const [p0, p1, p2] = this.points;
    const foot = /** @type {Point} */ ([(p0[0] + p2[0]) / 2, (p0[1] + p2[1]) / 2]);
    const [mx, my] = plane.place(this.middle);
    const [fx, fy] = plane.place(foot);
    return html`
      <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A conic: three points, the weight ${decimal(this.weight)}, an arc of ${this.kind}">
        ${piecesWithin(steps.map(rest)).map((piece) => svg`<path class="ghost" d=${pathOf(piece.flatMap(plane.place))} />`)}
        ${polyline("polygon", this.points.flatMap(plane.place))}
        ${polyline("dropped", [fx, fy, ...plane.place(p1)])}
        ${polyline("curve", steps.map(arc).flatMap(plane.place))}
        ${ring(fx, fy, "var(--quiet)")}<text class="quiet haloed middle" x=${fx} y=${fy + 20}>M</text>
        <circle class="at" cx=${mx} cy=${my} r="6" /><text class="strong haloed" x=${mx + 11} y=${my + 5}>S</text>
        ${marks(plane, this.points, nameOf)}
      </svg>
      ${handles(this, plane, this.points, { name: nameOf, move: (points) => (this.points = points) })}
    `;
  }

  render() {
    const w = this.weight;
    return html`
      <div class="frame">
        <div class="stage">${this.picture()}</div>
        <p class="facts">
          An arc of <b>${this.kind}</b>. From M to P1, the point S at <i>t</i> = ½ has gone the part <i>w</i> / (1 + <i>w</i>) = <b>${decimal(w / (1 + w), 3)}</b>.
        </p>
        <div class="controls">
          ${slider({ name: html`<i>w</i>`, value: w, min: 0, max: MAX_WEIGHT, text: decimal(w), change: (weight) => (this.weight = weight) })}
        </div>
      </div>
    `;
  }
}

/** The runs of points that are not far away. @param {Point[]} points */
function piecesWithin(points) {
  /** @type {Point[][]} */
  const pieces = [[]];
  for (const point of points) {
    if (Math.hypot(...point) < FAR) pieces[pieces.length - 1].push(point);
    else if (pieces[pieces.length - 1].length) pieces.push([]);
  }
  return pieces.filter((piece) => piece.length > 1);
}

customElements.define("fig-conic", FigConic);
