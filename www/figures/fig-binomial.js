// ((1 − t) + t)ⁿ = 1, multiplied out: each term is a Bernstein polynomial, the whole numbers are a row of Pascal's triangle.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure, numeric } from "./lib/figure.js";
import { choice, slider } from "./lib/parts.js";
import { decimal, superscript } from "./lib/numbers.js";

const DEGREES = /** @type {const} */ ([1, 2, 3, 4, 5, 6, 7, 8]);
const LINE = 30;
const TRIANGLE_LINE = 27;

/**
 * The rows 0 to n of Pascal's triangle, each number the sum of the two above it.
 *
 * @param {number} n
 * @returns {number[][]}
 */
export function pascal(n) {
  const rows = [[1]];
  for (let k = 1; k <= n; k++)
    rows.push(Array.from({ length: k + 1 }, (_, i) => (rows[k - 1][i - 1] ?? 0) + (rows[k - 1][i] ?? 0)));
  return rows;
}

/** `<fig-binomial degree="3" t="0.4">` */
export class FigBinomial extends Figure {
  static properties = {
    degree: numeric({ least: 1, most: 8, whole: true, otherwise: 3 }),
    t: numeric({ least: 0, most: 1, otherwise: 0.4 }),
  };

  constructor() {
    super();
    this.degree = 3;
    this.t = 0.4;
  }

  triangle() {
    const rows = pascal(this.degree);
    const gap = Math.min(46, this.wide / (this.degree + 2));
    const height = rows.length * TRIANGLE_LINE + 18;
    const place = (/** @type {number} */ row, /** @type {number} */ i) => [
      this.wide / 2 + (i - row / 2) * gap,
      24 + row * TRIANGLE_LINE,
    ];
    const last = rows.length - 1;
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="Pascal's triangle down to row ${last}: ${rows[last].join(", ")}">
        <rect class="row" x=${this.wide / 2 - ((last + 1) * gap) / 2} y=${place(last, 0)[1] - 17} width=${(last + 1) * gap} height="25" rx="8" />
        ${rows.map((row, k) =>
          row.map((number, i) => {
            const [x, y] = place(k, i);
            return svg`<text class="middle ${k === last ? "strong" : "quiet"}" x=${x} y=${y}>${number}</text>`;
          }),
        )}
      </svg>
    `;
  }

  /** The factors of a term, in words. @param {number} i @param {number} binomial */
  term(i, binomial) {
    const power = (/** @type {string} */ base, /** @type {number} */ exponent) =>
      exponent === 0 ? "" : exponent === 1 ? base : base + superscript(exponent);
    return [binomial === 1 ? "" : String(binomial), power("(1−t)", this.degree - i), power("t", i)]
      .filter(Boolean)
      .join(" ");
  }

  bars() {
    const weights = Curve.bernstein(this.degree, this.t);
    const row = pascal(this.degree)[this.degree];
    const left = 116;
    const right = 74;
    const length = this.wide - left - right;
    const height = (this.degree + 2) * LINE + 30;
    const starts = Array.from(weights, (_, i) => weights.slice(0, i).reduce((sum, w) => sum + w, 0));
    const words = Array.from(weights, (weight, i) => `${this.term(i, row[i])} = ${decimal(weight, 3)}`).join(", ");
    return html`
      <svg class="bars" viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="The terms at t = ${decimal(this.t)}: ${words}; together 1">
        ${Array.from(weights, (weight, i) => {
          const y = 14 + i * LINE;
          return svg`
            <text class="end math" x=${left - 10} y=${y + 15}>${this.term(i, row[i])}</text>
            <path class="axis" d="M${left} ${y - 4}V${y + LINE - 4}" />
            <rect class="bar bar${i % 2}" x=${left + starts[i] * length} y=${y + 1} width=${weight * length} height="18" data-weight=${weight} />
            <text class="end" x=${this.wide - 10} y=${y + 15}>${decimal(weight, 4)}</text>`;
        })}
        ${((y) => svg`
          <path class="axis" d="M${left} ${y - 4}H${this.wide - 8}" />
          <text class="end" x=${left - 10} y=${y + 18}>sum</text>
          ${Array.from(weights, (weight, i) => svg`<rect class="bar bar${i % 2}" x=${left + starts[i] * length} y=${y + 4} width=${weight * length} height="18" />`)}
          <text class="end strong" x=${this.wide - 10} y=${y + 18}>${decimal(
            weights.reduce((sum, w) => sum + w, 0),
            4,
          )}</text>`)(18 + (this.degree + 1) * LINE)}
      </svg>
    `;
  }

  render() {
    return html`
      <div class="frame">
        <div class="stage">${this.triangle()}</div>
        <p class="facts">
          <span class="math">((1−t) + t)${superscript(this.degree)}</span> = 1${superscript(this.degree)} = 1, for every <i>t</i>. Multiplied out it has ${this.degree + 1} terms.
          Their whole numbers are the last row above:
        </p>
        <div class="stage">${this.bars()}</div>
        <div class="controls">
          ${slider({
            name: html`<i>t</i>`,
            value: this.t,
            min: 0,
            max: 1,
            text: decimal(this.t),
            change: (t) => {
              this.t = t;
              this.notifyChange();
            },
          })}
          ${choice({
            name: "Degree",
            options: DEGREES.map((n) => [n, n]),
            value: this.degree,
            change: (n) => {
              this.degree = n;
              this.notifyChange();
            },
          })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-binomial", FigBinomial);
