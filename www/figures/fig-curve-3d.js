// The lecture's cubic in space, its shadows on the coordinate planes, de Casteljau's construction and its box.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { numeric } from "./lib/figure.js";
import { OrbitFigure, RADIANS } from "./lib/orbit-figure.js";
import { check, diamond, disc, polyline, ring, square } from "./lib/parts.js";
import { decimal, short, subscript, tuple } from "./lib/numbers.js";

const POINTS = /** @type {const} */ ([
  [0, 2, 3],
  [2, 3, 5],
  [6, 7, 9],
  [3, 4, 5],
]);
/** The corner of the coordinate planes that is opposite to the origin. */
const FAR = /** @type {const} */ ([7, 8, 10]);
/** Nearly that of the ball around the planes. */
const RADIUS = (0.97 * Math.hypot(...FAR)) / 2;
/** @param {ArrayLike<number>} flat @returns {number[][]} */
const triples = (flat) =>
  Array.from({ length: flat.length / 3 }, (_, i) => [flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]]);

/** `<fig-curve-3d t="0.5" turn="-42" tilt="22">` */
export class FigCurve3d extends OrbitFigure {
  static properties = {
    t: numeric({ least: 0, most: 1, otherwise: 0.5 }),
    construction: { state: true },
    shadows: { state: true },
    box: { state: true },
  };

  constructor() {
    super();
    this.t = 0.5;
    this.construction = true;
    this.shadows = true;
    this.box = false;
    this.curve = new Curve(POINTS);
  }

  /** A curve's picture is the curve of its control points' pictures: seen from far away, the map is affine. */
  flat(/** @type {Curve} */ curve, /** @type {(point: ArrayLike<number>) => [number, number]} */ place) {
    return new Curve(triples(curve.controlPoints()).flatMap(place), { dimension: 2 });
  }

  /** Where the three planes are: each on the far side of the box, so that it is never in front of the curve. */
  behind() {
    const towards = [Math.cos(this.turn * RADIANS), Math.sin(this.turn * RADIANS), Math.sin(this.tilt * RADIANS)];
    return towards.map((part, axis) => (part >= 0 ? 0 : FAR[axis]));
  }

  planes(/** @type {(point: ArrayLike<number>) => [number, number]} */ place) {
    const planes = this.behind();
    const lines = [0, 1, 2].flatMap((along) =>
      [0, 1, 2]
        .filter((across) => across !== along)
        .flatMap((across) => {
          const fixed = 3 - along - across; // the plane's own axis
          return Array.from({ length: FAR[across] + 1 }, (_, i) =>
            [0, FAR[along]].flatMap((end) => {
              const point = [0, 0, 0];
              [point[along], point[across], point[fixed]] = [end, i, planes[fixed]];
              return place(point);
            }),
          );
        }),
    );
    const axes = ["x", "y", "z"].map((name, axis) => {
      const at = (/** @type {number} */ value) =>
        place([0, 1, 2].map((k) => (k === axis ? value : k === 2 || axis === 2 ? planes[k] : FAR[k] - planes[k])));
      const [x, y] = at(FAR[axis] / 2);
      const away = axis === 2 ? [-16, 0] : [0, 16];
      return svg`<text class="middle math quiet" x=${x + away[0]} y=${y + 4 + away[1]}>${name}</text>`;
    });
    return svg`${lines.map((line) => polyline("gridline", line))}${axes}`;
  }

  shadow(/** @type {(point: ArrayLike<number>) => [number, number]} */ place) {
    const at = this.curve.eval(this.t);
    const planes = this.behind();
    return [0, 1, 2].map((axis) => {
      const onto = (/** @type {ArrayLike<number>} */ p) => place(Array.from(p, (v, k) => (k === axis ? planes[k] : v)));
      const [x, y] = onto([at.x, at.y, at.z]);
      return svg`<path class="ghost" d=${this.flat(this.curve, onto).toSVG({ precision: 2 })} />
        ${polyline("dropped", [...place([at.x, at.y, at.z]), x, y])}${ring(x, y, "var(--quiet)")}`;
    });
  }

  bounds(/** @type {(point: ArrayLike<number>) => [number, number]} */ place) {
    const { min, max } = this.curve.bounds();
    const corner = (/** @type {number} */ k) =>
      place([k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z]);
    const edges = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((k) =>
      [1, 2, 4].filter((bit) => !(k & bit)).map((bit) => [k, k | bit]),
    );
    return edges.map(([p, q]) => polyline("edge", [...corner(p), ...corner(q)]));
  }

  picture() {
    const { height, place } = this.view(
      FAR.map((side) => side / 2),
      RADIUS,
      0.68,
    );
    const drawn = this.flat(this.curve, place);
    const control = POINTS.map(place);
    const at = this.curve.eval(this.t);
    const levels = this.curve.deCasteljau(this.t).map((level) => triples(level).map(place));
    return this.turned(
      height,
      "A cubic in space",
      `At t = ${decimal(this.t)} the point is ${tuple([at.x, at.y, at.z], 3)}`,
      svg`
        ${this.planes(place)}
        ${this.shadows ? this.shadow(place) : ""}
        ${this.box ? this.bounds(place) : ""}
        ${polyline("polygon", drawn.controlPoints())}
        <path class="curve" d=${drawn.toSVG({ precision: 2 })} />
        ${this.construction ? levels.slice(1, -1).map((level, k) => [polyline(`level${k + 1}`, level.flat()), level.map(([x, y]) => ring(x, y, `var(--level${k + 1})`))]) : ""}
        ${control.map(([x, y], i) => svg`${i % 3 === 0 ? disc(x, y) : square(x, y)}<text class="haloed middle math strong" x=${x} y=${y - 12}>P${subscript(i)}</text>`)}
        ${diamond(...place([at.x, at.y, at.z]))}`,
    );
  }

  render() {
    const at = this.curve.eval(this.t);
    const { min, max } = this.curve.bounds();
    const range = (/** @type {"x" | "y" | "z"} */ axis) =>
      html`<i>${axis}</i> from ${short(min[axis], 3)} to ${short(max[axis], 3)}`;
    return html`
      <div class="frame">
        <div class="stage">${this.picture()}</div>
        <p class="facts">
          <span class="math">B</span>(${decimal(this.t)}) = <b class="point">${tuple([at.x, at.y, at.z], 4)}</b> of the control points
          ${POINTS.map((p, i) => html`${i ? ", " : ""}<span class="math">P${subscript(i)}</span> ${tuple(p)}`)}.
        </p>
        <p class="facts">Bounding box of the curve: ${range("x")}, ${range("y")}, ${range("z")}. Length ${decimal(this.curve.length(), 4)}.</p>
        <div class="controls">
          ${this.sliderOfT(this.t, (t) => (this.t = t))}
          ${this.angles()}
          ${check({ name: "construction", value: this.construction, change: (on) => (this.construction = on) })}
          ${check({ name: "shadows on the planes", value: this.shadows, change: (on) => (this.shadows = on) })}
          ${check({ name: "bounding box", value: this.box, change: (on) => (this.box = on) })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-curve-3d", FigCurve3d);
