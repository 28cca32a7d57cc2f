// A conic as a rational quadratic Bézier curve: three points and the weight of the middle one.
import { html, svg } from "lit";
import { RationalCurve } from "casteljau/nurbs";
import { Figure } from "./lib/figure.js";
import { decimal } from "./lib/numbers.js";
import { pathOf, polyline, ring, slider } from "./lib/parts.js";
import { drawn, handles, marks, planeOf } from "./lib/plane.js";
import { circleWeight } from "./lib/rational.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 134, height: 84 };
/** @type {Point[]} */
const POINTS = [
  [29, 50],
  [67, 12],
  [105, 50],
];
const [MIN_WEIGHT, MAX_WEIGHT] = [0.01, 4];
/** Of the rest of the conic. */
const STEPS = 200;
/** Parts of the rest that are farther away than this, in units of the picture, are not drawn. */
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

  /** The arc between P0 and P2. */
  get arc() {
    const [p0, p1, p2] = this.points;
    return RationalCurve.conic(p0, p1, p2, this.weight);
  }

  /** The point at t = 1/2. @returns {Point} */
  get middle() {
    const { x, y } = this.arc.eval(0.5);
    return [x, y];
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
    const rest = Array.from({ length: STEPS + 1 }, (_, i) => restAt(this.points, this.weight, i / STEPS));
    const [p0, p1, p2] = this.points;
    const foot = /** @type {Point} */ ([(p0[0] + p2[0]) / 2, (p0[1] + p2[1]) / 2]);
    const [mx, my] = plane.place(this.middle);
    const [fx, fy] = plane.place(foot);
    return html`
      <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A conic: three points, the weight ${decimal(this.weight)}, an arc of ${this.kind}">
        ${piecesWithin(rest).map((piece) => svg`<path class="ghost" d=${pathOf(piece.flatMap(plane.place))} />`)}
        ${polyline("polygon", this.points.flatMap(plane.place))}
        ${polyline("dropped", [fx, fy, ...plane.place(p1)])}
        <path class="curve" d=${drawn(plane, this.arc)} />
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
          ${slider({ name: html`<i>w</i>`, value: w, min: MIN_WEIGHT, max: MAX_WEIGHT, text: decimal(w), change: (weight) => (this.weight = weight) })}
        </div>
      </div>
    `;
  }
}

/**
 * A point of the rest of the conic: the formula with the weight −w. That of a hyperbola goes through infinity.
 *
 * @param {Point[]} points
 * @param {number} w
 * @param {number} t
 * @returns {Point}
 */
function restAt([p0, p1, p2], w, t) {
  const [a, b, c] = [(1 - t) ** 2, -2 * w * (1 - t) * t, t ** 2];
  const at = (/** @type {0 | 1} */ axis) => (a * p0[axis] + b * p1[axis] + c * p2[axis]) / (a + b + c);
  return [at(0), at(1)];
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
