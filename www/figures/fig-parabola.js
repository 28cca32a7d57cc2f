// y = t²: a graph, a moving point, and a quadratic Bézier curve with three control points.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure, numeric } from "./lib/figure.js";
import { check, diamond, disc, pathOf, polyline, slider, square } from "./lib/parts.js";
import { decimal, short, tuple } from "./lib/numbers.js";

/** The parabola for t from 0 to 1: (t, t²) in Bernstein form. Beyond, it goes on by itself. */
const PARABOLA = new Curve([
  [0, 0],
  [0.5, 0],
  [1, 1],
]);
/** What is shown. */
const X = /** @type {const} */ ([-1.6, 1.6]);
const Y = /** @type {const} */ ([-0.45, 2.3]);

/** `<fig-parabola t="0.7" from="0" to="1">` */
export class FigParabola extends Figure {
  static properties = {
    t: numeric({ least: -1.5, most: 1.5, otherwise: 0.7 }),
    from: numeric({ least: -1.5, most: 1.5, otherwise: 0 }),
    to: numeric({ least: -1.5, most: 1.5, otherwise: 1 }),
    bezier: { type: Boolean },
  };

  constructor() {
    super();
    this.t = 0.7;
    this.from = 0;
    this.to = 1;
    this.bezier = true;
  }

  picture() {
    const height = Math.min(420, Math.round((this.wide * (Y[1] - Y[0])) / (X[1] - X[0])));
    const scale = height / (Y[1] - Y[0]);
    const middle = this.wide / 2;
    const place = (/** @type {readonly [number, number]} */ [x, y]) => [
      middle + x * scale,
      height - (y - Y[0]) * scale,
    ];
    const onPaper = (/** @type {Curve} */ curve) =>
      curve.transform([scale, 0, 0, -scale, middle, height + Y[0] * scale]);
    const part = PARABOLA.subsegment(this.from, this.to);
    const at = PARABOLA.eval(this.t);
    const [px, py] = place([at.x, at.y]);
    const [ox, oy] = place([0, 0]);
    const drawn = onPaper(part);
    const control = [0, 1, 2].map((i) => drawn.controlPoints().slice(2 * i, 2 * i + 2));
    const [q0, q1, q2] = control;
    const ticks = [-1.5, -1, -0.5, 0.5, 1, 1.5].filter((x) => Math.abs(x) * scale < middle - 12);
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img"
        aria-label="The parabola y = t squared. At t = ${short(this.t)} the point is ${tuple([at.x, at.y], 4)}.${this.bezier ? ` The part from ${short(this.from)} to ${short(this.to)} has the control points ${this.pointWords(part)}.` : ""}">
        ${[0.5, 1, 1.5, 2].map((y) => svg`<path class="gridline" d="M0 ${place([0, y])[1]}H${this.wide}" />`)}
        ${ticks.map((x) => svg`<path class="gridline" d="M${place([x, 0])[0]} 0V${height}" />`)}
        <path class="axis" d="M0 ${oy}H${this.wide}M${ox} 0V${height}" />
        ${ticks.map((x) => svg`<text class="quiet middle" x=${place([x, 0])[0]} y=${oy + 17}>${short(x, 1)}</text>`)}
        ${[0.5, 1, 1.5, 2].map((y) => svg`<text class="quiet end" x=${ox - 6} y=${place([0, y])[1] + 4}>${short(y, 1)}</text>`)}
        <text class="math" x=${this.wide - 16} y=${oy - 7}>x</text><text class="math" x=${ox + 8} y="16">y</text>
        <path class="ghost" d=${onPaper(PARABOLA.subsegment(-1.52, 1.52)).toSVG({ precision: 2 })} />
        <path class="dropped" d=${pathOf([px, oy, px, py, ox, py])} />
        ${
          this.bezier
            ? svg`${polyline("polygon", drawn.controlPoints())}<path class="curve" d=${drawn.toSVG({ precision: 2 })} />
          ${disc(q0[0], q0[1])}${square(q1[0], q1[1])}${disc(q2[0], q2[1])}
          ${control.map(([x, y], i) => svg`<text class="strong haloed middle" x=${x + [-18, 0, 20][i]} y=${y + [-10, 36, 4][i]}>P${i}</text>`)}`
            : ""
        }
        ${diamond(px, py)}
      </svg>
    `;
  }

  /** @param {Curve} part */
  pointWords(part) {
    const points = part.controlPoints();
    return [0, 1, 2].map((i) => tuple(points.slice(2 * i, 2 * i + 2), 3)).join(", ");
  }

  render() {
    const at = PARABOLA.eval(this.t);
    const set = (/** @type {"t" | "from" | "to"} */ name) => (/** @type {number} */ value) => {
      this[name] = value;
      this.notifyChange();
    };
    const range = { min: -1.5, max: 1.5, step: 0.05 };
    return html`
      <div class="frame">
        <div class="stage">${this.picture()}</div>
        <p class="facts">
          At <i>t</i> = ${short(this.t)}: <i>y</i> = <i>t</i>² = <b>${decimal(at.y, 4)}</b>. Read with a parameter, <i>x</i>(<i>t</i>) = <i>t</i> and <i>y</i>(<i>t</i>) = <i>t</i>²: one
          <i>t</i> gives the point <b class="point">${tuple([at.x, at.y], 4)}</b>.
        </p>
        ${this.bezier ? html`<p class="facts">From <i>t</i> = ${short(this.from)} to ${short(this.to)} it is the quadratic Bézier curve of P0, P1, P2 = <span class="control">${this.pointWords(PARABOLA.subsegment(this.from, this.to))}</span>.</p>` : ""}
        <div class="controls">
          ${slider({ name: html`<i>t</i>`, value: this.t, ...range, step: 0.01, text: decimal(this.t), change: set("t") })}
          ${check({ name: "as a Bézier curve", value: this.bezier, change: (bezier) => (this.bezier = bezier) })}
          ${
            this.bezier
              ? html`
            ${slider({ name: "from", value: this.from, ...range, text: decimal(this.from), change: set("from") })}
            ${slider({ name: "to", value: this.to, ...range, text: decimal(this.to), change: set("to") })}`
              : ""
          }
        </div>
      </div>
    `;
  }
}

customElements.define("fig-parabola", FigParabola);
