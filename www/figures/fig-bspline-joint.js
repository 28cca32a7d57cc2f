// Two pieces of a uniform cubic B-spline, and how their shared points place the joint.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure } from "./lib/figure.js";
import { polyline, square } from "./lib/parts.js";
import { drawn, handles, marks, planeOf, pointName } from "./lib/plane.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 130, height: 78 };
/** @type {Point[]} */
const POINTS = [
  [10, 64],
  [22, 16],
  [64, 10],
  [108, 20],
  [120, 66],
];

/** The fraction t of the way from a to b. @param {Point} a @param {Point} b @param {number} t @returns {Point} */
const lerp = (a, b, t) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];

/** `<fig-bspline-joint>` */
export class FigBsplineJoint extends Figure {
  static properties = { points: { state: true } };

  constructor() {
    super();
    this.points = POINTS;
  }

  /** The handles of the joint at P2, and the joint. @returns {[Point, Point, Point]} */
  get joint() {
    const [, p1, p2, p3] = this.points;
    const [h1, h2] = [lerp(p1, p2, 2 / 3), lerp(p2, p3, 1 / 3)];
    return [h1, lerp(h1, h2, 0.5), h2];
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const pieces = [0, 1].map((k) => Curve.fromBasis("b-spline", this.points.slice(k, k + 4)));
    const thirds = [0, 1, 2, 3].flatMap((k) =>
      [1 / 3, 2 / 3].map((t) => plane.place(lerp(this.points[k], this.points[k + 1], t))),
    );
    const [h1, joint, h2] = this.joint.map(plane.place);
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="Two pieces of a B-spline that share P1, P2 and P3">
            ${polyline("polygon", this.points.flatMap(plane.place))}
            ${thirds.map(([x, y]) => svg`<circle class="hollow" cx=${x} cy=${y} r="3.5" stroke="var(--quiet)" />`)}
            ${polyline("level1", [...h1, ...h2])}
            <path class="curve" d=${drawn(plane, pieces[0])} /><path class="curve" stroke-dasharray="9 6" d=${drawn(plane, pieces[1])} />
            ${[h1, h2].map(([x, y], k) => svg`${square(x, y, 4)}<text class="haloed middle" x=${x} y=${y - 11}>h${k + 1}</text>`)}
            <circle class="at" cx=${joint[0]} cy=${joint[1]} r="6" /><text class="strong haloed middle" x=${joint[0]} y=${joint[1] + 24}>joint</text>
            ${marks(plane, this.points, pointName, { kind: () => "off" })}
          </svg>
          ${handles(this, plane, this.points, { name: pointName, kind: () => "off", move: (points) => (this.points = points) })}
        </div>
        <p class="facts">Solid: the piece of P0, P1, P2, P3. Dashed: the piece of P1, P2, P3, P4.</p>
      </div>
    `;
  }
}

customElements.define("fig-bspline-joint", FigBsplineJoint);
