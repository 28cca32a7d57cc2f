// The point of a curve that is nearest to Q, and the distance from Q as a function of t.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure } from "./lib/figure.js";
import { distances, feet } from "./lib/nearest.js";
import { decimal } from "./lib/numbers.js";
import { polyline, ring } from "./lib/parts.js";
import { drawn, handles, marks, planeOf } from "./lib/plane.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 134, height: 84 };
/** P0 … P3 and Q. @type {Point[]} */
const POINTS = [
  [36, 72],
  [24, 6],
  [112, 6],
  [98, 74],
  [54, 60],
];
const NAMES = ["P0", "P1", "P2", "P3", "Q"];
/** On narrow screens the plot is lower: so picture, plot and words fit beside a task. */
const PLOT = { maxHeight: 150, ratio: 0.3, left: 44, right: 12, top: 14, bottom: 26 };

const nameOf = (/** @type {number} */ i) => NAMES[i];
const kindOf = (/** @type {number} */ i) => /** @type {const} */ (["on", "off", "off", "on", "off"])[i];

/** `<fig-nearest>` */
export class FigNearest extends Figure {
  static properties = { points: { state: true } };

  constructor() {
    super();
    this.points = POINTS;
  }

  get curve() {
    return new Curve(this.points.slice(0, 4));
  }

  /** The point Q. */
  get q() {
    return this.points[4];
  }

  set q(to) {
    this.points = this.points.with(4, to);
  }

  /** @param {import("./lib/nearest.js").Foot[]} found */
  picture(found) {
    const plane = planeOf(this.wide, SIZE);
    const [qx, qy] = plane.place(this.q);
    return html`
      <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A cubic, a point Q, and the nearest point of the curve">
        ${polyline("polygon", this.points.slice(0, 4).flatMap(plane.place))}<path class="curve" d=${drawn(plane, this.curve)} />
        ${found.map(({ point }, k) => {
          const [x, y] = plane.place([point.x, point.y]);
          return svg`<path class=${k === 0 ? "level1" : "dropped"} d="M${qx} ${qy}L${x} ${y}" />${k === 0 ? svg`<circle class="at" cx=${x} cy=${y} r="6" />` : ring(x, y, "var(--quiet)", 5)}`;
        })}
        ${marks(plane, this.points, nameOf, { kind: kindOf, count: 4 })}
      </svg>
      ${handles(this, plane, this.points, { name: nameOf, kind: kindOf, move: (points) => (this.points = points) })}
    `;
  }

  /** @param {import("./lib/nearest.js").Foot[]} found */
  plot(found) {
    const { maxHeight, ratio, left, right, top, bottom } = PLOT;
    const height = Math.min(maxHeight, Math.round(ratio * this.wide));
    const all = distances(this.curve, this.q);
    const most = Math.max(...all.map(({ distance }) => distance));
    const x = (/** @type {number} */ t) => left + t * (this.wide - left - right);
    const y = (/** @type {number} */ distance) => height - bottom - (distance / most) * (height - top - bottom);
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="The distance from Q over t">
        <path class="axis" d="M${left} ${top}V${height - bottom}H${this.wide - right}" />
        <text class="quiet end" x=${left - 6} y=${top + 6}>${decimal(most, 0)}</text><text class="quiet end" x=${left - 6} y=${height - bottom + 4}>0</text>
        <text class="quiet middle" x=${x(0)} y=${height - 8}>0</text><text class="quiet middle" x=${x(1)} y=${height - 8}>1</text><text class="math middle" x=${x(0.5)} y=${height - 8}>t</text>
        ${polyline(
          "curve",
          all.flatMap(({ t, distance }) => [x(t), y(distance)]),
        )}
        ${found.map(({ t, distance }, k) => (k === 0 ? svg`<circle class="at" cx=${x(t)} cy=${y(distance)} r="6" />` : ring(x(t), y(distance), "var(--quiet)", 5)))}
      </svg>
    `;
  }

  render() {
    const found = feet(this.curve, this.q);
    const [best, second] = found;
    return html`
      <div class="frame">
        <div class="stage">${this.picture(found)}</div>
        <div class="stage">${this.plot(found)}</div>
        <p class="facts">
          Nearest point: <i>t</i> = <b>${decimal(best.t, 3)}</b>, distance <b>${decimal(best.distance, 1)}</b>.
          ${second ? html`Another local minimum: <i>t</i> = ${decimal(second.t, 3)}, distance ${decimal(second.distance, 1)}.` : ""}
        </p>
      </div>
    `;
  }
}

customElements.define("fig-nearest", FigNearest);
