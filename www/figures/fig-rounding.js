// What 32 bits leave of a curve: four ways to the same point, and how far each of them lands from it.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { bernstein, casteljau, horner, powers, SINGLE } from "./lib/evaluators.js";
import { Figure, oneOf } from "./lib/figure.js";
import { check, list, pathOf } from "./lib/parts.js";
import { decimal, scientific, superscript } from "./lib/numbers.js";

/** Each place of the plot shows the greatest error at so many neighbouring values of t. */
const PER_PLACE = 24;
const PLACES = 96;

export const METHODS = /** @type {const} */ ([
  { key: "bernstein", name: "Bernstein weights", evaluate: bernstein, mark: "curve", dash: "" },
  { key: "powers", name: "Basis matrix, powers of t", evaluate: powers, mark: "handle", dash: "2 4" },
  { key: "horner", name: "Basis matrix, Horner", evaluate: horner, mark: "level2", dash: "7 4" },
  { key: "casteljau", name: "De Casteljau", evaluate: casteljau, mark: "level1", dash: "12 4 2 4" },
]);

/** A wave of control points that repeats on no machine number. @param {number} n @param {number} centre */
const wave = (n, centre = 0) =>
  Array.from(
    { length: n + 1 },
    (_, i) => /** @type {[number, number]} */ ([centre + i / n, centre + Math.sin(2.4 * i + 0.7)]),
  );

/** @type {Record<string, { words: string, points: [number, number][] }>} */
export const CASES = {
  near: { words: "a cubic near the origin", points: wave(3) },
  far: { words: "the same cubic, 10 000 from the origin", points: wave(3, 10000) },
  eight: { words: "degree 8", points: wave(8) },
  sixteen: { words: "degree 16", points: wave(16) },
  twentyfour: { words: "degree 24", points: wave(24) },
  "far-eight": { words: "degree 8, 10 000 from the origin", points: wave(8, 10000) },
};

/**
 * The errors of a method, measured against 64 bits: the same 32-bit control points and parameters, evaluated by the
 * package, whose own error is half a billion times smaller than a 32-bit one.
 *
 * @param {typeof METHODS[number]["evaluate"]} evaluate
 * @param {[number, number][]} points
 * @returns {Float64Array} the greatest error at each place
 */
export function errors(evaluate, points) {
  const rounded = points.map((point) => point.map(Math.fround));
  const ts = Float64Array.from({ length: PLACES * PER_PLACE }, (_, i) => Math.fround((i + 0.5) / (PLACES * PER_PLACE)));
  const exact = new Curve(rounded.flat(), { dimension: 2 }).evalAt(ts);
  const axes = [0, 1].map((k) => rounded.map((point) => point[k]));
  const greatest = new Float64Array(PLACES);
  ts.forEach((t, i) => {
    const at = axes.map((axis) => evaluate(SINGLE, axis, t));
    const error = Math.hypot(at[0] - exact[2 * i], at[1] - exact[2 * i + 1]);
    const place = Math.floor(i / PER_PLACE);
    greatest[place] = Math.max(greatest[place], error);
  });
  return greatest;
}

/** The distance of neighbouring 32-bit numbers at the size of the largest coordinate. @param {[number, number][]} points */
export const ulp = (points) => 2 ** (Math.floor(Math.log2(Math.max(...points.flat().map(Math.abs)))) - 23);

/** @type {Map<string, Float64Array[]>} what was measured does not change */
const measured = new Map();

/** @param {string} name */
function measure(name) {
  const known = measured.get(name) ?? METHODS.map(({ evaluate }) => errors(evaluate, CASES[name].points));
  measured.set(name, known);
  return known;
}

/** `<fig-rounding case="far">` */
export class FigRounding extends Figure {
  static properties = { case: oneOf(Object.keys(CASES)), muted: { state: true } };

  constructor() {
    super();
    this.case = "near";
    /** @type {ReadonlySet<string>} */
    this.muted = new Set();
  }

  picture() {
    const all = measure(this.case);
    const unit = ulp(CASES[this.case].points);
    const greatest = Math.max(...all.map((list) => Math.max(...list)));
    const [low, high] = [Math.floor(Math.log10(unit / 8)), Math.ceil(Math.log10(greatest * 1.2))];
    const [left, top, bottom, right] = [54, 14, 34, 12];
    const height = Math.max(260, Math.min(340, this.wide * 0.55));
    const y = (/** @type {number} */ error) =>
      top + ((high - Math.max(Math.log10(error || 1e-300), low)) / (high - low)) * (height - top - bottom);
    const x = (/** @type {number} */ t) => left + t * (this.wide - left - right);
    const decades = Array.from({ length: high - low + 1 }, (_, k) => low + k);
    const every = Math.ceil(decades.length / 9);
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="Error over t, logarithmic, of four methods in 32-bit arithmetic; the table has the greatest values">
        ${decades.filter((_, k) => k % every === 0).map((k) => svg`<path class="gridline" d="M${left} ${y(10 ** k)}H${this.wide - right}" /><text class="quiet end" x=${left - 7} y=${y(10 ** k) + 4}>10${superscript(k)}</text>`)}
        ${[0, 0.25, 0.5, 0.75, 1].map((t) => svg`<path class="gridline" d="M${x(t)} ${top}V${height - bottom}" /><text class="quiet middle" x=${Math.min(x(t), this.wide - 16)} y=${height - 14}>${t}</text>`)}
        <path class="axis" stroke-dasharray="3 4" d="M${left} ${y(unit)}H${this.wide - right}" />
        ${METHODS.map(({ key, mark, dash }, k) =>
          this.muted.has(key)
            ? ""
            : svg`
          <path data-method=${key} fill="none" stroke="var(--${mark})" stroke-width="2.25" stroke-dasharray=${dash} stroke-linejoin="round"
            d=${pathOf(Array.from(all[k], (error, i) => [x((i + 0.5) / PLACES), y(error)]).flat())} />`,
        )}
        <text class="haloed quiet end" x=${this.wide - right - 4} y=${y(unit) - 22}>last place of a 32-bit float</text>
        <text class="math" x=${x(0.5) + 26} y=${height - 14}>t</text>
      </svg>
    `;
  }

  table() {
    const all = measure(this.case).map((list) => Math.max(...list));
    const unit = ulp(CASES[this.case].points);
    const best = Math.min(...all);
    const toggle = (/** @type {string} */ key) => (/** @type {boolean} */ shown) => {
      const hidden = new Set(this.muted);
      if (shown) hidden.delete(key);
      else hidden.add(key);
      this.muted = hidden;
    };
    return html`
      <div class="table" tabindex="0" role="region" aria-label="Greatest errors">
        <table>
          <thead><tr><th>Method</th><th>Greatest error</th><th>in units of the last place</th><th>relative to the best</th></tr></thead>
          <tbody>
            ${METHODS.map(
              ({ key, name, mark, dash }, k) => html`
              <tr data-method=${key}>
                <th scope="row"><div class="key">
                  <svg viewBox="0 0 34 12" aria-hidden="true"><path d="M1 6H33" stroke="var(--${mark})" stroke-width="2.5" stroke-dasharray=${dash} /></svg>
                  ${check({ name, value: !this.muted.has(key), change: toggle(key) })}
                </div></th>
                <td data-error=${all[k]}>${scientific(all[k])}</td><td>${decimal(all[k] / unit, 1)}</td><td>${decimal(all[k] / best, 1)} ×</td>
              </tr>`,
            )}
          </tbody>
        </table>
      </div>
    `;
  }

  render() {
    const options = Object.entries(CASES).map(([key, { words }]) => /** @type {const} */ ([key, words]));
    return html`
      <div class="frame">
        <div class="controls first">${list({
          name: "Control points",
          options,
          value: this.case,
          change: (name) => {
            this.case = name;
            this.notifyChange();
          },
        })}</div>
        <div class="stage">${this.picture()}</div>
        ${this.table()}
        <p class="facts">
          Shown: ${CASES[this.case].words}. Every operation is rounded to 32 bits. The result is compared with 64-bit numbers. Each place of the plot shows the greatest error of ${PER_PLACE} neighbouring
          <i>t</i>. The coefficients of the basis matrix are rounded as well.
        </p>
      </div>
    `;
  }
}

customElements.define("fig-rounding", FigRounding);
