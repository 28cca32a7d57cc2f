// A circle made of cubic arcs: the length of the handles, and the distance from the true circle.
import { html, svg } from "lit";
import { Figure } from "./lib/figure.js";
import { arcOf, radialErrors, standardHandle } from "./lib/circle.js";
import { decimal } from "./lib/numbers.js";
import { choice, disc, polyline, slider, square } from "./lib/parts.js";
import { drawn, pairs, planeOf } from "./lib/plane.js";

const SIZE = { width: 110, height: 84 };
const [CENTER, RADIUS] = [[55, 42], 34];
const PLOT = { height: 150, left: 72, right: 12, top: 16, bottom: 26 };
/** The plot shows at least this range, as a share of the radius. */
const MIN_RANGE = 0.0005;
/** Handles between these shares of the standard length. */
const [SHORTEST, LONGEST] = [0.9, 1.1];

/** `<fig-circle>` */
export class FigCircle extends Figure {
  static properties = { arcs: { state: true }, length: { state: true } };

  constructor() {
    super();
    this.arcs = 4;
    this.length = 0.52;
  }

  picture() {
    const plane = planeOf(this.wide, SIZE);
    const { arcs } = this;
    const [cx, cy] = plane.place(/** @type {[number, number]} */ (CENTER));
    const first = arcOf(arcs, this.length);
    const all = Array.from({ length: arcs }, (_, k) => {
      const [c, s] = [Math.cos((2 * Math.PI * k) / arcs), Math.sin((2 * Math.PI * k) / arcs)];
      return first.transform([RADIUS * c, -RADIUS * s, -RADIUS * s, -RADIUS * c, CENTER[0], CENTER[1]]);
    });
    return html`
      <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="${arcs} cubic arcs and a circle">
        <circle class="ghost" cx=${cx} cy=${cy} r=${RADIUS * plane.scale} />
        ${all.map((curve) => {
          const points = pairs(curve.controlPoints()).map(plane.place);
          return svg`<path class="curve" d=${drawn(plane, curve)} />${polyline("polygon", [...points[0], ...points[1]])}${polyline("polygon", [...points[2], ...points[3]])}${square(...points[1])}${square(...points[2])}${disc(...points[0])}`;
        })}
        <text class="quiet middle" x=${cx} y=${cy + 4}>radius 1</text>
      </svg>
    `;
  }

  /** A length that is typed: what is not in the range changes nothing. @param {HTMLInputElement} input @param {{ min: number, max: number }} range */
  #type({ valueAsNumber }, { min, max }) {
    if (valueAsNumber >= min && valueAsNumber <= max) this.length = valueAsNumber;
  }

  /** @param {number[]} errors */
  plot(errors) {
    const { height, left, right, top, bottom } = PLOT;
    const range = Math.max(MIN_RANGE, ...errors.map(Math.abs));
    const x = (/** @type {number} */ t) => left + t * (this.wide - left - right);
    const y = (/** @type {number} */ error) => top + ((range - error) / (2 * range)) * (height - top - bottom);
    const percent = (/** @type {number} */ error) => `${decimal(100 * error, 2)} %`;
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="The distance from the circle over t">
        <path class="axis" d="M${left} ${top}V${height - bottom}M${left} ${y(0)}H${this.wide - right}" />
        <text class="quiet end" x=${left - 6} y=${top + 6}>+${percent(range)}</text><text class="quiet end" x=${left - 6} y=${y(0) + 4}>0</text><text class="quiet end" x=${left - 6} y=${height - bottom + 4}>${percent(-range)}</text>
        <text class="quiet middle" x=${x(0)} y=${height - 8}>0</text><text class="quiet middle" x=${x(1)} y=${height - 8}>1</text><text class="math middle" x=${x(0.5)} y=${height - 8}>t</text>
        ${polyline(
          "curve",
          errors.flatMap((error, i) => [x(i / (errors.length - 1)), y(error)]),
        )}
      </svg>
    `;
  }

  render() {
    const errors = radialErrors(this.arcs, this.length);
    const standard = standardHandle(this.arcs);
    const [min, max] = [SHORTEST, LONGEST].map((share) => Number((share * standard).toFixed(4)));
    const range = { min, max, step: 0.0001 };
    return html`
      <div class="frame">
        <div class="stage">${this.picture()}</div>
        <div class="stage">${this.plot(errors)}</div>
        <p class="facts">Greatest distance from the circle: <b>${decimal(100 * Math.max(...errors.map(Math.abs)), 4)} %</b> of the radius.</p>
        <div class="controls">
          ${slider({ name: html`<i>h</i>`, value: this.length, ...range, text: decimal(this.length, 4), change: (length) => (this.length = length) })}
          <label><span><i>h</i>, exactly</span><input type="number" min=${range.min} max=${range.max} step=${range.step} .value=${String(this.length)}
            @input=${(/** @type {Event} */ event) => this.#type(/** @type {HTMLInputElement} */ (event.target), range)}
            @change=${(/** @type {Event} */ event) => Object.assign(/** @type {HTMLInputElement} */ (event.target), { value: String(this.length) })} /></label>
          ${choice({
            name: "Arcs",
            options: [2, 3, 4, 6, 8].map((n) => /** @type {[number, number]} */ ([n, n])),
            value: this.arcs,
            change: (arcs) => {
              this.arcs = arcs;
              this.length = Number(standardHandle(arcs).toFixed(4));
              this.notifyChange();
            },
          })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-circle", FigCircle);
