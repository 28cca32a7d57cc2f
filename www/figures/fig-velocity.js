// The velocity of a cubic as a vector, next to the curve that its tips draw (the derivative); or a cubic with its circle of curvature.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure, numeric } from "./lib/figure.js";
import { decimal, short } from "./lib/numbers.js";
import { diamond, polyline, slider, square } from "./lib/parts.js";
import { arrow, drawn, handles, marks, pairs, planeOf, pointName } from "./lib/plane.js";

/** @typedef {import("./lib/plane.js").Point} Point */

/** The arrow of the velocity has room in the first stage, and the circle of curvature alone in the larger picture. */
const [SIZE, LARGE_SIZE] = [
  { width: 80, height: 58 },
  { width: 100, height: 72 },
];
/** @type {Point[]} */
const POINTS = [
  [7, 55],
  [24, 52],
  [48, 42],
  [38, 32],
];
/** The same curve, 1.7 times as large. @type {Point[]} */
const LARGE_POINTS = [
  [14, 62],
  [43, 57],
  [84, 40],
  [67, 23],
];
/** The derivative is drawn in a box of its own, in this scale and around this origin. */
const DERIVATIVE = { scale: 0.6, origin: /** @type {Point} */ ([29, 42]) };
/** Two stages side by side need this width, in CSS pixels. */
const MIN_BOTH = 562;
/** Larger circles are nearly lines. */
const MAX_RADIUS = 400;

/** `<fig-velocity t="0">`; with `circle` the circle of curvature instead of the velocity */
export class FigVelocity extends Figure {
  static properties = {
    t: numeric({ least: 0, most: 1, otherwise: 0 }),
    moved: { state: true },
    circle: { type: Boolean },
  };

  constructor() {
    super();
    this.t = 0;
    /** @type {Point[] | null} */
    this.moved = null;
    this.circle = false;
  }

  get points() {
    return this.moved ?? (this.circle ? LARGE_POINTS : POINTS);
  }

  set points(to) {
    this.moved = to;
  }

  get curve() {
    return new Curve(this.points);
  }

  /** @param {number} wide */
  plane(wide) {
    return planeOf(wide, this.circle ? LARGE_SIZE : SIZE);
  }

  /** The curve, with its velocity at t divided into thirds or with the circle of curvature. @param {number} wide */
  curveStage(wide) {
    const plane = this.plane(wide);
    const { curve, t, circle, points } = this;
    const { x, y } = curve.eval(t);
    return html`
      <div class="stage">
        <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A cubic and its ${circle ? "circle of curvature" : "velocity"} at t = ${decimal(t)}">
          ${circle ? this.curvatureCircle(plane) : svg`<text class="strong" x="12" y="22">Curve</text>`}
          ${polyline("polygon", points.flatMap(plane.place))}<path class="curve" d=${drawn(plane, curve)} />
          ${marks(plane, points, pointName)}
          ${circle ? "" : this.velocityArrow(plane)}
          ${diamond(...plane.place([x, y]))}
        </svg>
        ${handles(this, plane, points, { name: pointName, move: (to) => (this.points = to) })}
      </div>
    `;
  }

  /** @param {import("./lib/plane.js").Plane} plane */
  velocityArrow(plane) {
    const [at, velocity] = [this.curve.eval(this.t), this.curve.derivativeAt(this.t)];
    const place = (/** @type {number} */ k) => plane.place([at.x + (k * velocity.x) / 3, at.y + (k * velocity.y) / 3]);
    return svg`
      ${arrow(place(0), place(3), "var(--handle)")}
      ${[1, 2].map((k) => {
        const [x, y] = place(k);
        return svg`<circle cx=${x} cy=${y} r="3.5" fill="var(--paper)" stroke="var(--handle)" stroke-width="2" />`;
      })}
    `;
  }

  /** @param {import("./lib/plane.js").Plane} plane */
  curvatureCircle(plane) {
    const radius = 1 / this.curve.curvature(this.t);
    if (!(Math.abs(radius) < MAX_RADIUS)) return "";
    const [at, normal] = [this.curve.eval(this.t), this.curve.normal(this.t)];
    const [cx, cy] = plane.place([at.x + radius * normal.x, at.y + radius * normal.y]);
    return svg`<circle class="ghost" cx=${cx} cy=${cy} r=${Math.abs(radius) * plane.scale} /><path class="gridline" d="M${cx} ${cy}L${plane.place([at.x, at.y]).join(" ")}" />`;
  }

  /** The derivative as a curve: velocities drawn from one origin. @param {number} wide */
  derivativeStage(wide) {
    const plane = this.plane(wide);
    const { scale, origin } = DERIVATIVE;
    const derivative = this.curve.derivative();
    const place = (/** @type {Point} */ [x, y]) => plane.place([origin[0] + scale * x, origin[1] + scale * y]);
    const [ox, oy] = place([0, 0]);
    const tip = derivative.eval(this.t);
    const control = pairs(derivative.controlPoints());
    const path = derivative.transform([scale, 0, 0, scale, ...origin]);
    return html`
      <div class="stage">
        <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="The derivative, a quadratic curve">
          <text class="strong" x="12" y="22">Derivative B′(t)</text>
          <path class="axis" d="M0 ${oy}H${plane.size[0]}M${ox} 32V${plane.size[1]}" />
          ${polyline("polygon", control.flatMap(place))}<path class="curve" d=${drawn(plane, path)} />
          ${control.map((point, i) => {
            const [x, y] = place(point);
            return svg`${square(x, y, 4)}<text class="haloed middle" x=${Math.min(Math.max(x, 40), plane.size[0] - 40)} y=${i === 0 ? y + 20 : y - 10}>3(P${i + 1}−P${i})</text>`;
          })}
          ${arrow([ox, oy], place([tip.x, tip.y]), "var(--handle)")}
        </svg>
      </div>
    `;
  }

  render() {
    const { circle } = this;
    const wide = this.wide >= MIN_BOTH && !circle ? Math.floor((this.wide - 1) / 2) : this.wide;
    const { x, y } = this.curve.derivativeAt(this.t);
    const curvature = this.curve.curvature(this.t);
    const radius = Math.abs(curvature) > 1e-6 ? decimal(1 / Math.abs(curvature), 1) : "∞";
    return html`
      <div class="frame">
        <div class="sides">${this.curveStage(wide)}${circle ? "" : this.derivativeStage(wide)}</div>
        <p class="facts">
          ${
            circle
              ? html`Curvature ${decimal(Math.abs(curvature), 4)}, radius of curvature <b>${radius}</b>.`
              : html`Velocity B′(${decimal(this.t)}) = <b class="line">(${short(x, 1)}, ${short(-y, 1)})</b> (y up), speed <b>${decimal(Math.hypot(x, y), 1)}</b>.`
          }
        </p>
        <div class="controls">
          ${slider({ name: html`<i>t</i>`, value: this.t, min: 0, max: 1, text: decimal(this.t), change: (t) => (this.t = t) })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-velocity", FigVelocity);
