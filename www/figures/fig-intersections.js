// Two cubics to drag, and where they intersect.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure } from "./lib/figure.js";
import { decimal } from "./lib/numbers.js";
import { polyline } from "./lib/parts.js";
import { drawn, handles, marks, planeOf } from "./lib/plane.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 120, height: 80 };
/** P0 … P3, then Q0 … Q3. @type {Point[]} */
const POINTS = [
  [14, 60],
  [30, 14],
  [84, 10],
  [106, 56],
  [20, 22],
  [40, 44],
  [70, 66],
  [100, 72],
];
const nameOf = (/** @type {number} */ i) => `${i < 4 ? "P" : "Q"}${i % 4}`;
const kindOf = (/** @type {number} */ i) => (i % 4 === 0 || i % 4 === 3 ? "on" : "off");

/** `<fig-intersections>` */
export class FigIntersections extends Figure {
  static properties = { points: { state: true } };

  constructor() {
    super();
    this.points = POINTS;
  }

  /** Both curves. */
  get curves() {
    return [new Curve(this.points.slice(0, 4)), new Curve(this.points.slice(4))];
  }

  /** Where they intersect, in the order of t on the first curve. */
  get found() {
    const [p, q] = this.curves;
    return p.intersections(q);
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const { found, curves } = this;
    const overlaps = found.some(({ kind }) => kind === "overlap");
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="Two cubics with ${found.length} intersections">
            ${[0, 1].map(
              (k) => svg`${polyline("polygon", this.points.slice(4 * k, 4 * k + 4).flatMap(plane.place))}
                <path class="curve" stroke-dasharray=${k === 1 ? "9 5" : ""} d=${drawn(plane, curves[k])} />`,
            )}
            ${marks(plane, this.points, nameOf, { kind: kindOf, count: 4 })}
            ${found.map(({ point }) => {
              const [x, y] = plane.place([point.x, point.y]);
              return svg`<circle class="hollow" cx=${x} cy=${y} r="7" stroke="var(--ink)" stroke-width="2.5" />`;
            })}
          </svg>
          ${handles(this, plane, this.points, { name: nameOf, kind: kindOf, move: (points) => (this.points = points) })}
        </div>
        <p class="facts" role="status">
          ${overlaps ? "The curves share a piece." : html`<b>${found.length}</b> ${found.length === 1 ? "intersection" : "intersections"}${found.length > 0 ? ", at " : "."}`}
          ${found.map(({ t, u }, i) => html`<span class="line">(${decimal(t)}, ${decimal(u)})${i < found.length - 1 ? "," : "."}</span> `)}
        </p>
      </div>
    `;
  }
}

customElements.define("fig-intersections", FigIntersections);
