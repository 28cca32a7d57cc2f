// Affine maps: the control points mapped and then drawn (a line), points of the old curve mapped one by one (dots).
import { html, svg } from "lit";
import { Figure } from "./lib/figure.js";
import { disc, polyline, slider, square } from "./lib/parts.js";
import { bothWays } from "./lib/affine.js";

const [WIDTH, HEIGHT] = [240, 170];

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
    const place = (/** @type {import("casteljau").Curve} */ curve) => curve.transform([scale, 0, 0, scale, cx, cy]);
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
      this.notifyChange();
    };
    return html`
      <div class="frame">
        <div class="stage">${this.picture(ways)}</div>
        <div class="controls">
          ${slider({ name: "Rotation", value: this.turn, min: -180, max: 180, step: 1, text: `${this.turn}°`, change: set("turn") })}
          ${slider({ name: "Shear", value: this.shear, min: -1, max: 1, text: this.shear.toFixed(2), change: set("shear") })}
          ${slider({ name: "Width", value: this.stretch, min: 0.3, max: 1.4, text: `${this.stretch.toFixed(2)} ×`, change: set("stretch") })}
        </div>
        <p class="facts">Greatest distance between the dots and the line at equal <i>t</i>: <b data-gap=${ways.gap}>${ways.gap < 1e-9 ? "0 up to rounding" : ways.gap.toFixed(3)}</b>.</p>
      </div>
    `;
  }
}

customElements.define("fig-affine", FigAffine);
