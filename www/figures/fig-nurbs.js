// A quadratic NURBS curve: five points, the weight of the middle one, two inner knots, and the rational basis functions.
import { html, svg } from "lit";
import { NurbsCurve } from "casteljau/nurbs";
import { Figure } from "./lib/figure.js";
import { decimal, short } from "./lib/numbers.js";
import { polyline, ring, slider } from "./lib/parts.js";
import { drawn, handles, marks, pairs, planeOf } from "./lib/plane.js";
import { rationalBasis } from "./lib/rational.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 134, height: 78 };
/** @type {Point[]} */
const POINTS = [
  [14, 64],
  [24, 24],
  [67, 16],
  [110, 24],
  [120, 64],
];
const DEGREE = 2;
const MAX_WEIGHT = 8;
/** Steps of t in each segment. */
const STEPS = 60;
const PLOT = { height: 150, left: 30, right: 14, top: 14, bottom: 38 };

const nameOf = (/** @type {number} */ i) => `P${i}`;
const kindOf = (/** @type {number} */ i) => /** @type {"on" | "off"} */ (i === 0 || i === 4 ? "on" : "off");

/** `<fig-nurbs>` */
export class FigNurbs extends Figure {
  static properties = {
    points: { state: true },
    weight: { state: true },
    first: { state: true },
    second: { state: true },
  };

  constructor() {
    super();
    this.points = POINTS;
    /** The weight of P2; the others are 1. */
    this.weight = 1;
    /** The inner knots. */
    this.first = 0.35;
    this.second = 0.65;
  }

  get weights() {
    return [1, 1, this.weight, 1, 1];
  }

  get knots() {
    return [0, 0, 0, this.first, this.second, 1, 1, 1];
  }

  get curve() {
    return new NurbsCurve({ degree: DEGREE, points: this.points, weights: this.weights, knots: this.knots });
  }

  picture() {
    const plane = planeOf(this.wide, SIZE);
    const { curve } = this;
    const joints = pairs(curve.evalAt(curve.joints().slice(1, -1))).map(plane.place);
    return html`
      <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A quadratic NURBS curve of five points; the knots ${this.knots.map((knot) => short(knot)).join(", ")}; the weight of P2 is ${decimal(this.weight)}">
        ${polyline("polygon", this.points.flatMap(plane.place))}
        <path class="curve" d=${drawn(plane, curve)} />
        ${joints.map(([x, y]) => ring(x, y, "var(--ink)", 5))}
        ${marks(plane, this.points, nameOf, { kind: kindOf })}
      </svg>
      ${handles(this, plane, this.points, { name: nameOf, kind: kindOf, move: (points) => (this.points = points) })}
    `;
  }

  plot() {
    const { height, left, right, top, bottom } = PLOT;
    const x = (/** @type {number} */ t) => left + t * (this.wide - left - right);
    const y = (/** @type {number} */ value) => height - bottom - value * (height - top - bottom);
    const { curve, knots } = this;
    const ts = parametersOf(curve);
    const basis = rationalBasis(curve, ts);
    const multiplicity = new Map();
    for (const knot of this.knots) multiplicity.set(knot, (multiplicity.get(knot) ?? 0) + 1);
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="The factor of each point over t, with the knots below">
        ${[...multiplicity.keys()].map((knot) => svg`<path class="gridline" d="M${x(knot)} ${top}V${height - bottom}" />`)}
        <path class="axis" d="M${left} ${top}V${height - bottom}H${this.wide - right}" />
        <text class="quiet end" x=${left - 6} y=${top + 6}>1</text><text class="quiet end" x=${left - 6} y=${y(0) + 4}>0</text>
        ${this.points.map((_, i) =>
          polyline(
            i === 2 ? "curve" : i % 2 ? "level2" : "level1",
            ts.flatMap((t, k) => (t >= knots[i] && t <= knots[i + DEGREE + 1] ? [x(t), y(basis[i][k])] : [])),
          ),
        )}
        ${[...multiplicity].map(([knot, count]) =>
          Array.from(
            { length: count },
            (_, k) => svg`<circle class="off" cx=${x(knot)} cy=${y(0) + 9 * (k + 1)} r="4" />`,
          ),
        )}
      </svg>
    `;
  }

  render() {
    const knots = this.knots.map((knot) => short(knot)).join(", ");
    const set = (/** @type {"first" | "second"} */ name) => (/** @type {number} */ value) => {
      this[name] = value;
      if (this.first > this.second) this[name === "first" ? "second" : "first"] = value;
    };
    const range = { min: 0.05, max: 0.95, step: 0.01 };
    return html`
      <div class="frame">
        <div class="stage">${this.picture()}</div>
        <div class="stage">${this.plot()}</div>
        <p class="facts">Knots <b class="knots">${knots}</b>: 5 points and degree 2 need 5 + 2 + 1 = 8. The thick line is the factor of P2.</p>
        <div class="controls">
          ${slider({ name: html`<i>w</i>₂`, value: this.weight, min: 0.1, max: MAX_WEIGHT, step: 0.1, text: decimal(this.weight, 1), change: (weight) => (this.weight = weight) })}
          ${slider({ name: "first knot", value: this.first, ...range, text: decimal(this.first), change: set("first") })}
          ${slider({ name: "second knot", value: this.second, ...range, text: decimal(this.second), change: set("second") })}
        </div>
      </div>
    `;
  }
}

/** Parameters of a curve, with all joints among them. @param {NurbsCurve} curve */
function parametersOf(curve) {
  const joints = [...curve.joints()];
  const steps = joints.slice(1).flatMap((end, k) => {
    const start = joints[k];
    return Array.from({ length: STEPS }, (_, i) => start + ((end - start) * (i + 1)) / STEPS);
  });
  return [joints[0], ...steps];
}

customElements.define("fig-nurbs", FigNurbs);
