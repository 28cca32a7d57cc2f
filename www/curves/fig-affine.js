// Affine maps: the control points mapped and then drawn (a line), points of the old curve mapped one by one (dots).
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure } from "../figures/figure.js";
import { disc, polyline, slider, square } from "../figures/parts.js";

/** About the middle of the figure, y down. @type {[number, number][]} */
const POINTS = [[-60, 46], [-46, -52], [44, -58], [62, 30]];
const [WIDTH, HEIGHT] = [240, 170];
/** Dots on the curve. */
const DOTS = 16;

/**
 * A turn, then a shear, then a stretch of the width, as an SVG matrix.
 *
 * @param {{ turn: number, shear: number, width: number }} map turn in degrees
 * @returns {[number, number, number, number, number, number]}
 */
export function matrixOf({ turn, shear, width }) {
  const [c, s] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)];
  return [width * (c + shear * s), s, width * (shear * c - s), c, 0, 0];
}

/**
 * The two ways, and how far they are apart.
 *
 * @param {Parameters<typeof matrixOf>[0]} map
 */
export function bothWays(map) {
  const [a, b, c, d, e, f] = matrixOf(map);
  const before = new Curve(POINTS);
  const after = before.transform([a, b, c, d, e, f]);
  const dots = Array.from({ length: DOTS + 1 }, (_, i) => before.eval(i / DOTS)).map(({ x, y }) => /** @type {[number, number]} */ ([a * x + c * y + e, b * x + d * y + f]));
  const gap = Math.max(...dots.map(([x, y], i) => Math.hypot(x - after.eval(i / DOTS).x, y - after.eval(i / DOTS).y)));
  return { before, after, dots, gap };
}

/** `<fig-affine>` */
export class FigAffine extends Figure {
  static properties = { turn: { state: true }, shear: { state: true }, stretch: { state: true } };

  constructor() {
    super();
    this.turn = 25;
    this.shear = 0.3;
    this.stretch = 1;
  }

  /** @param {ReturnType<typeof bothWays>} ways */
  picture({ before, after, dots }) {
    const height = Math.round(Math.min(400, (this.wide * HEIGHT) / WIDTH));
    const scale = height / HEIGHT;
    const [cx, cy] = [this.wide / 2, height / 2];
    const place = (/** @type {Curve} */ curve) => curve.transform([scale, 0, 0, scale, cx, cy]);
    const [old, now] = [place(before), place(after)];
    const flat = now.controlPoints();
    const at = (/** @type {number} */ i) => /** @type {[number, number]} */ ([flat[2 * i], flat[2 * i + 1]]);
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="A cubic curve before and after an affine map">
        ${polyline("polygon", old.controlPoints())}<path class="curve" opacity="0.35" d=${old.toSVG({ precision: 2 })} />
        ${polyline("polygon", flat)}<path class="curve" d=${now.toSVG({ precision: 2 })} />
        ${dots.map(([x, y]) => svg`<circle class="hollow" cx=${cx + scale * x} cy=${cy + scale * y} r="4.5" stroke="var(--handle)" />`)}
        ${[0, 3].map((i) => disc(...at(i)))}${[1, 2].map((i) => square(...at(i)))}
      </svg>
    `;
  }

  render() {
    const ways = bothWays({ turn: this.turn, shear: this.shear, width: this.stretch });
    const set = (/** @type {"turn" | "shear" | "stretch"} */ name) => (/** @type {number} */ value) => {
      this[name] = value;
      this.tell();
    };
    return html`
      <div class="frame">
        <div class="stage">${this.picture(ways)}</div>
        <div class="controls">
          ${slider({ name: "Turn", value: this.turn, min: -180, max: 180, step: 1, text: `${this.turn}°`, change: set("turn") })}
          ${slider({ name: "Shear", value: this.shear, min: -1, max: 1, text: this.shear.toFixed(2), change: set("shear") })}
          ${slider({ name: "Width", value: this.stretch, min: 0.3, max: 1.4, text: `${this.stretch.toFixed(2)} ×`, change: set("stretch") })}
        </div>
        <p class="facts">Greatest distance between both ways: <b data-gap=${ways.gap}>${ways.gap < 1e-9 ? "0, but for rounding" : ways.gap.toFixed(3)}</b>.</p>
      </div>
    `;
  }
}

if (!customElements.get("fig-affine")) customElements.define("fig-affine", FigAffine);
