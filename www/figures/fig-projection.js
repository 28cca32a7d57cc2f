// A quarter of a circle as the projection of a parabola: the homogeneous curve on a cone, and its picture in the plane w = 1.
import { html, svg } from "lit";
import { Curve } from "casteljau/nurbs";
import { numeric } from "./lib/figure.js";
import { decimal, tuple } from "./lib/numbers.js";
import { OrbitFigure } from "./lib/orbit-figure.js";
import { diamond, disc, polyline, ring, square } from "./lib/parts.js";

/** Points (w x, w y, w) for x, y = (1, 0), (1, 1), (0, 1) and the weights 1, 1, 2. */
const POINTS = [
  [1, 0, 1],
  [1, 1, 1],
  [0, 2, 2],
];
/** The curve in space: (1 − t², 2 t, 1 + t²). */
const PARABOLA = new Curve(POINTS);
/** What is drawn of the parabola beyond the arc. */
const [FIRST, LAST] = [-1.05, 1.05];
const TOP = 2.15;
const STEPS = 72;

/** A ball around everything that is drawn. */
const CENTER = [0, 0, 1.3];
const RADIUS = 2.25;

/** A circle of the cone at a height. @param {number} w */
const circleAt = (w) =>
  Array.from({ length: STEPS + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / STEPS;
    return [w * Math.cos(angle), w * Math.sin(angle), w];
  });

/** @param {number} t @returns {[number, number, number]} */
function pointAt(t) {
  const { x, y, z } = /** @type {{ x: number, y: number, z: number }} */ (PARABOLA.eval(t));
  return [x, y, z];
}

/** `<fig-projection t="0.75" turn="62" tilt="24">` */
export class FigProjection extends OrbitFigure {
  static properties = { t: numeric({ least: 0, most: 1, otherwise: 0.75 }) };

  constructor() {
    super();
    this.t = 0.75;
    this.turn = 62;
    this.tilt = 24;
  }

  /** The point on the circle. @returns {[number, number]} */
  get point() {
    const [x, y, w] = pointAt(this.t);
    return [x / w, y / w];
  }

  picture() {
    const { height, place } = this.view(CENTER, RADIUS, 0.64);
    const line = (/** @type {ArrayLike<number>[]} */ points) => points.flatMap((point) => place(point));
    const along = (/** @type {number} */ from, /** @type {number} */ to) =>
      Array.from({ length: STEPS + 1 }, (_, i) => pointAt(from + ((to - from) * i) / STEPS));
    const onPlane = (/** @type {number[]} */ [x, y, w]) => [x / w, y / w, 1];
    const side = 1.35;
    const corners = [
      [side, side, 1],
      [-side, side, 1],
      [-side, -side, 1],
      [side, -side, 1],
    ];
    const at = pointAt(this.t);
    const [ax, ay] = place(at);
    const [qx, qy] = place(onPlane(at));
    const [ox, oy] = place([0, 0, 0]);
    const [px, py] = place([side, -side, 1]);
    return this.turned(
      height,
      "A parabola on a cone and the arc of a circle in the plane w = 1",
      `At t = ${decimal(this.t)} the point of the circle is ${tuple(this.point, 3)}`,
      svg`
        <path class="plane" d="${`M${line(corners).join(" ")}Z`}" />
        ${Array.from({ length: 12 }, (_, k) => {
          const angle = (Math.PI * k) / 6;
          return polyline(
            "gridline",
            line([
              [0, 0, 0],
              [TOP * Math.cos(angle), TOP * Math.sin(angle), TOP],
            ]),
          );
        })}
        ${polyline("gridline", line(circleAt(TOP)))}
        ${polyline("ghost", line(circleAt(1)))}
        ${polyline("ghost", line(along(FIRST, LAST)))}
        ${polyline("polygon", line(POINTS))}
        ${polyline("level1", line(along(0, 1)))}
        ${polyline("curve", line(along(0, 1).map(onPlane)))}
        ${polyline("edge", [ox, oy, ax, ay, qx, qy])}
        ${POINTS.map((point, i) => {
          const [x, y] = place(point);
          return svg`${i === 1 ? square(x, y) : disc(x, y)}<text class="haloed middle strong" x=${x} y=${y + (i === 1 ? 20 : -12)}>P${i}</text>`;
        })}
        ${ring(ox, oy, "var(--quiet)")}<text class="quiet haloed middle" x=${ox} y=${oy + 18}>0</text>
        ${diamond(ax, ay)}${ring(qx, qy, "var(--ink)", 5)}
        <text class="quiet haloed middle" x=${px} y=${py + 17}><tspan class="math">w</tspan> = 1</text>`,
    );
  }

  render() {
    const at = pointAt(this.t);
    return html`
      <div class="frame">
        <div class="stage">${this.picture()}</div>
        <p class="facts">
          The point in space is <b>${tuple(at, 4)}</b>. Divided by its height <i>w</i> = ${decimal(at[2], 4)} it is the point <b class="point">${tuple(this.point, 4)}</b> of the circle.
        </p>
        <div class="controls">
          ${this.sliderOfT(this.t, (t) => (this.t = t))}
          ${this.angles()}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-projection", FigProjection);
