// The velocity of a cubic as a vector, next to the curve that its tips draw (the derivative), and the circle of curvature.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure, numeric } from "./lib/figure.js";
import { decimal, short } from "./lib/numbers.js";
import { check, diamond, polyline, slider, square } from "./lib/parts.js";
import { arrow, drawn, handles, marks, pairs, planeOf, pointName } from "./lib/plane.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 100, height: 72 };
/** @type {Point[]} */
const POINTS = [
  [12, 61],
  [29, 58],
  [53, 48],
  [43, 38],
];
/** The derivative is drawn in a box of its own, in this scale and around this origin. */
const DERIVATIVE = { scale: 0.75, origin: /** @type {Point} */ ([36, 52]) };
/** Two stages side by side need this width, in CSS pixels. */
const MIN_BOTH = 562;
/** Larger circles are nearly lines. */
const MAX_RADIUS = 400;

/** `<fig-velocity t="0">`, and `circle` for the circle of curvature */
export class FigVelocity extends Figure {
  static properties = {
    t: numeric({ least: 0, most: 1, otherwise: 0 }),
    points: { state: true },
    circle: { type: Boolean },
  };

  constructor() {
    super();
    this.t = 0;
    this.points = POINTS;
    this.circle = false;
  }

  get curve() {
    return new Curve(this.points);
  }

  /** @param {number} wide */
  plane(wide) {
    return planeOf(wide, SIZE);
  }

  /** The curve, its velocity at t divided into thirds, and the circle of curvature. @param {number} wide */
  curveStage(wide) {
    const plane = this.plane(wide);
    const { curve, t } = this;
    const [at, velocity] = [curve.eval(t), curve.derivativeAt(t)];
    const tip = /** @type {Point} */ ([at.x + velocity.x, at.y + velocity.y]);
    const thirds = [1, 2].map((k) => plane.place([at.x + (k * velocity.x) / 3, at.y + (k * velocity.y) / 3]));
    const [x, y] = plane.place([at.x, at.y]);
    return html`
      <div class="stage">
        <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A cubic and its velocity at t = ${decimal(t)}">
          <text class="strong" x="12" y="22">Curve</text>
          ${this.circle ? this.curvatureCircle(plane) : ""}
          ${polyline("polygon", this.points.flatMap(plane.place))}<path class="curve" d=${drawn(plane, curve)} />
          ${marks(plane, this.points, pointName)}
          ${arrow([x, y], plane.place(tip), "var(--handle)")}
          ${thirds.map(([px, py]) => svg`<circle cx=${px} cy=${py} r="3.5" fill="var(--paper)" stroke="var(--handle)" stroke-width="2" />`)}
          ${diamond(x, y)}
        </svg>
        ${handles(this, plane, this.points, { name: pointName, move: (points) => (this.points = points) })}
      </div>
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
    const wide = this.wide >= MIN_BOTH ? Math.floor((this.wide - 1) / 2) : this.wide;
    const { x, y } = this.curve.derivativeAt(this.t);
    const curvature = this.curve.curvature(this.t);
    return html`
      <div class="frame">
        <div class="sides">${this.curveStage(wide)}${this.derivativeStage(wide)}</div>
        <p class="facts">
          Velocity B′(${decimal(this.t)}) = <b class="line">(${short(x, 1)}, ${short(-y, 1)})</b> (y up), speed <b>${decimal(Math.hypot(x, y), 1)}</b>,
          curvature ${decimal(Math.abs(curvature), 4)}, radius of curvature <b>${Math.abs(curvature) > 1e-6 ? decimal(1 / Math.abs(curvature), 1) : "∞"}</b>.
        </p>
        <div class="controls">
          ${slider({ name: html`<i>t</i>`, value: this.t, min: 0, max: 1, text: decimal(this.t), change: (t) => (this.t = t) })}
          ${check({ name: "circle of curvature", value: this.circle, change: (circle) => (this.circle = circle) })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-velocity", FigVelocity);
