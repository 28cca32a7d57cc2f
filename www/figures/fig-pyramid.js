// The pyramid of coefficients: every step to the left multiplies by 1 − t, every step to the right by t.
import { html, mathml, svg } from "lit";
import { Curve } from "casteljau";
import { Figure, numeric } from "./lib/figure.js";
import { choice, slider } from "./lib/parts.js";
import { decimal, subscript, superscript } from "./lib/numbers.js";

const DEGREES = /** @type {const} */ ([1, 2, 3, 4, 5, 6]);
const ROW = 62;
const TOP = 30;
const NODE_HEIGHT = 28;

/** @typedef {readonly (0 | 1)[]} Steps from the top down: 0 to the left, 1 to the right */

/**
 * All ways from the top to the node `index` of a level.
 *
 * @param {number} level
 * @param {number} index
 * @returns {Steps[]}
 */
export function waysTo(level, index) {
  if (index < 0 || index > level) return [];
  if (level === 0) return [[]];
  const left = waysTo(level - 1, index).map((way) => /** @type {Steps} */ ([...way, 0]));
  const right = waysTo(level - 1, index - 1).map((way) => /** @type {Steps} */ ([...way, 1]));
  return [...left, ...right];
}

/**
 * The product of the factors on a way.
 *
 * @param {Steps} way
 * @param {number} t
 */
export const product = (way, t) => way.reduce((/** @type {number} */ value, step) => value * (step ? t : 1 - t), 1);

/** `<fig-pyramid degree="3" t="0.5">` */
export class FigPyramid extends Figure {
  static properties = {
    degree: numeric({ least: 1, most: 6, whole: true, otherwise: 3 }),
    t: numeric({ least: 0, most: 1, otherwise: 0.5 }),
    chosen: { state: true },
    way: { state: true },
  };

  constructor() {
    super();
    this.degree = 3;
    this.t = 0.5;
    /** @type {[number, number]} level and index of the node whose ways are shown */
    this.chosen = [3, 1];
    /** @type {number | null} one of its ways */
    this.way = null;
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (!changed.has("degree")) return;
    this.chosen = [this.degree, Math.min(1, this.degree)];
    this.way = null;
  }

  /** @param {number} level @param {number} index */
  place(level, index) {
    const gap = this.wide / (this.degree + 1);
    return [this.wide / 2 + (index - level / 2) * gap, TOP + level * ROW];
  }

  /** @param {number} level @param {number} index */
  choose(level, index) {
    this.chosen = [level, index];
    this.way = null;
  }

  /** @param {KeyboardEvent} event */
  async key(event) {
    const [level, index] = this.chosen;
    /** @type {Record<string, [number, number]>} */
    const moves = {
      ArrowLeft: [level, index - 1],
      ArrowRight: [level, index + 1],
      ArrowUp: [level - 1, Math.min(index, level - 1)],
      ArrowDown: [level + 1, index],
    };
    const to = moves[event.key];
    if (!to || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    if (to[0] < 0 || to[0] > this.degree || to[1] < 0 || to[1] > to[0]) return;
    this.choose(...to);
    await this.updateComplete;
    /** @type {SVGElement | null} */ (this.renderRoot.querySelector(".node[tabindex='0']"))?.focus();
  }

  /** Whether the arrow from a node, to the left or the right, lies on what is shown. */
  lit(
    /** @type {number} */ level,
    /** @type {number} */ index,
    /** @type {0 | 1} */ step,
    /** @type {Steps[]} */ ways,
  ) {
    const shown = this.way === null ? ways : [ways[this.way]];
    const at = (/** @type {Steps} */ way) => way.slice(0, level).reduce((/** @type {number} */ sum, s) => sum + s, 0);
    return shown.some((way) => way.length > level && at(way) === index && way[level] === step);
  }

  arrow(
    /** @type {number} */ level,
    /** @type {number} */ index,
    /** @type {0 | 1} */ step,
    /** @type {Steps[]} */ ways,
  ) {
    const [x0, y0] = this.place(level, index);
    const [x1, y1] = this.place(level + 1, index + step);
    const from = [x0 + (x1 - x0) * 0.26, y0 + (y1 - y0) * 0.26];
    const to = [x0 + (x1 - x0) * 0.72, y0 + (y1 - y0) * 0.72];
    const length = Math.hypot(x1 - x0, y1 - y0);
    const [dx, dy] = [(x1 - x0) / length, (y1 - y0) / length];
    const head = `M${to[0] - 7 * dx + 4 * dy} ${to[1] - 7 * dy - 4 * dx}L${to[0]} ${to[1]}L${to[0] - 7 * dx - 4 * dy} ${to[1] - 7 * dy + 4 * dx}`;
    const lit = this.lit(level, index, step, ways);
    const roomy = Math.abs(x1 - x0) > 34;
    const [lx, ly] = [(from[0] + to[0]) / 2 + (step ? 10 : -10), (from[1] + to[1]) / 2 - 3];
    return svg`<g class="arrow ${step ? "right" : "left"} ${lit ? "lit" : ""}">
      <path d="M${from[0]} ${from[1]}L${to[0]} ${to[1]}" /><path class="head" d=${head} />
      ${roomy ? svg`<text class="factor" text-anchor=${step ? "start" : "end"} x=${lx} y=${ly}>${step ? "t" : "1−t"}</text>` : ""}
    </g>`;
  }

  node(/** @type {number} */ level, /** @type {number} */ index) {
    const [x, y] = this.place(level, index);
    const value = Curve.bernstein(level, this.t)[index];
    const chosen = level === this.chosen[0] && index === this.chosen[1];
    const shown = decimal(value, this.wide / (this.degree + 1) < 48 ? 2 : 3);
    const width = Math.min(58, this.wide / (this.degree + 1) - 4);
    return svg`<g class="node ${chosen ? "chosen" : ""}" role="button" tabindex=${chosen ? 0 : -1} aria-pressed=${chosen}
        aria-label=${`level ${level}, coefficient ${index}: ${shown}`}
        @click=${() => this.choose(level, index)} @pointerenter=${(/** @type {PointerEvent} */ event) => event.pointerType === "mouse" && this.choose(level, index)}>
      <rect x=${x - width / 2} y=${y - NODE_HEIGHT / 2} width=${width} height=${NODE_HEIGHT} rx="6" />
      <text class="middle" x=${x} y=${y + 4.5}>${shown}</text>
    </g>
    ${level === this.degree ? svg`<text class="middle math" x=${x} y=${y + NODE_HEIGHT / 2 + 17} aria-hidden="true">P${subscript(index)}</text>` : ""}`;
  }

  picture(/** @type {Steps[]} */ ways) {
    const { degree } = this;
    const height = TOP + degree * ROW + 48;
    const levels = Array.from({ length: degree + 1 }, (_, level) => level);
    const arrows = levels
      .slice(0, -1)
      .flatMap((level) =>
        levels
          .slice(0, level + 1)
          .flatMap((index) => [this.arrow(level, index, 0, ways), this.arrow(level, index, 1, ways)]),
      );
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="group" aria-label="Pyramid of coefficients of degree ${degree}; arrow keys go from one to the next" @keydown=${this.key}>
        ${arrows}${levels.map((level) => levels.slice(0, level + 1).map((index) => this.node(level, index)))}
      </svg>
    `;
  }

  sum(/** @type {Steps[]} */ ways) {
    const [level, index] = this.chosen;
    const value = Curve.bernstein(level, this.t)[index];
    const each = product(ways[0], this.t);
    const power = (/** @type {string} */ base, /** @type {number} */ exponent) =>
      exponent === 0 ? "" : exponent === 1 ? base : `${base}${superscript(exponent)}`;
    const formula = [power("(1−t)", level - index), power("t", index)].filter(Boolean).join(" ") || "1";
    return html`
      <p class="facts" data-sum=${value}>
        <math>${mathml`<msubsup><mi>B</mi><mn>${index}</mn><mn>${level}</mn></msubsup><mo>(</mo><mi>t</mi><mo>)</mo>`}</math>
        = ${ways.length} ${ways.length === 1 ? "path" : "paths"} × <span class="math">${formula}</span> = ${ways.length} × ${decimal(each, 4)} = <b>${decimal(value, 4)}</b>
      </p>
    `;
  }

  ways(/** @type {Steps[]} */ ways) {
    const show = (/** @type {number | null} */ k) => () => (this.way = k);
    const words = (/** @type {Steps} */ way) => way.map((step) => (step ? "t" : "(1−t)")).join(" · ") || "1";
    return html`
      <div class="ways" role="group" aria-label="The paths to this coefficient" @pointerleave=${show(null)} @focusout=${show(null)}>
        ${ways.map(
          (way, k) => html`
          <button aria-pressed=${this.way === k} @pointerenter=${show(k)} @focus=${show(k)} @click=${show(k)}><span class="math">${words(way)}</span> = ${decimal(product(way, this.t), 3)}</button>
        `,
        )}
      </div>
    `;
  }

  render() {
    const ways = waysTo(...this.chosen);
    return html`
      <div class="frame">
        <div class="stage">${this.picture(ways)}</div>
        ${this.sum(ways)}${this.ways(ways)}
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

customElements.define("fig-pyramid", FigPyramid);
