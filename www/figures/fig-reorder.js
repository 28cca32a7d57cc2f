// Four places, and the 24 cubics that they give: the order of the control points is part of the curve.
import { html, svg } from "lit";
import { live } from "lit/directives/live.js";
import { Curve } from "casteljau";
import { Figure } from "./lib/figure.js";
import { disc, handle, polyline, square } from "./lib/parts.js";
import { short } from "./lib/numbers.js";

/** The places of the figure, in a box of 100 × 80. @type {[number, number][]} */
const PLACES = [
  [8, 64],
  [37, 16],
  [76, 28],
  [92, 51],
];
const BOX = /** @type {const} */ ({ min: [4, 4], max: [96, 76] });
const [WIDTH, HEIGHT] = [100, 80];

/**
 * All orders of 0 … n − 1, in alphabetical order.
 *
 * @param {number} n
 * @returns {number[][]}
 */
export function orders(n) {
  /** @type {(used: number[]) => number[][]} */
  const insert = (used) =>
    used.length === n
      ? [used]
      : Array.from({ length: n }, (_, k) => k)
          .filter((k) => !used.includes(k))
          .flatMap((k) => insert([...used, k]));
  return insert([]);
}

const ORDERS = orders(4);
/** For each order the number of the one that reads backwards. */
export const BACKWARDS = ORDERS.map((order) => ORDERS.findIndex((other) => other.every((k, i) => k === order[3 - i])));

/** `<fig-reorder>` */
export class FigReorder extends Figure {
  static properties = { places: { state: true }, chosen: { state: true } };

  constructor() {
    super();
    this.places = PLACES;
    this.chosen = 0;
  }

  /** @param {number} k */
  curve(k) {
    return new Curve(ORDERS[k].map((place) => this.places[place]));
  }

  big() {
    const height = Math.round(Math.min(380, this.wide * 0.62));
    const scale = Math.min(this.wide / WIDTH, height / HEIGHT);
    const origin = [(this.wide - WIDTH * scale) / 2, (height - HEIGHT * scale) / 2];
    const place = (/** @type {readonly [number, number]} */ [x, y]) =>
      /** @type {[number, number]} */ ([origin[0] + x * scale, origin[1] + y * scale]);
    const unplace = (/** @type {readonly [number, number]} */ [x, y]) =>
      /** @type {[number, number]} */ ([(x - origin[0]) / scale, (y - origin[1]) / scale]);
    const order = ORDERS[this.chosen];
    const drawn = this.curve(this.chosen).transform([scale, 0, 0, scale, ...origin]);
    const move = (/** @type {number} */ k) => (/** @type {[number, number]} */ to) =>
      (this.places = this.places.map((old, i) => (i === k ? to : old)));
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="The cubic that takes the four points in the order ${this.name(this.chosen)}">
        ${polyline("polygon", drawn.controlPoints())}<path class="curve" d=${drawn.toSVG({ precision: 2 })} />
        ${order.map((k, i) => {
          const [x, y] = place(this.places[k]);
          const below = this.places[k][1] > HEIGHT / 2;
          return svg`${i % 3 === 0 ? disc(x, y) : square(x, y)}<text class="strong haloed middle" x=${x} y=${y + (below ? 24 : -14)}>${"ABCD"[k]} · ${i + 1}</text>`;
        })}
      </svg>
      ${this.places.map((at, k) => handle({ name: `Point ${"ABCD"[k]}`, at, place, unplace, size: [this.wide, height], box: BOX, step: 1, say: (v) => short(v, 1), kind: order.indexOf(k) % 3 === 0 ? "on" : "off", move: move(k), done: () => this.notifyChange() }))}
    `;
  }

  /** The order as numbers, place by place. @param {number} k */
  name(k) {
    return ORDERS[k].map((place) => "ABCD"[place]).join(" ");
  }

  /** @param {number} k */
  thumb(k) {
    const curve = this.curve(k);
    const twin = k === BACKWARDS[this.chosen];
    return html`
      <label class="thumb" data-twin=${twin} title=${this.name(k)}>
        <input type="radio" name="order" .checked=${live(k === this.chosen)} @change=${() => {
          this.chosen = k;
          this.notifyChange();
        }} />
        <span class="away">${this.name(k)}</span>
        <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" aria-hidden="true">
          <path class="thin" d=${polylineOf(curve)} /><path class="curve" d=${curve.toSVG({ precision: 1 })} />
        </svg>
        <span class="order" aria-hidden="true">${this.name(k)}</span>
      </label>
    `;
  }

  render() {
    const twin = BACKWARDS[this.chosen];
    const same = this.curve(this.chosen).equals(this.curve(twin).reverse());
    return html`
      <div class="frame">
        <div class="stage">${this.big()}</div>
        <p class="facts">
          The order <b class="line">${this.name(this.chosen)}</b>, as numbered in the picture. The reverse order is <b class="line">${this.name(twin)}</b>: ${same ? "the same curve in the opposite direction" : "another curve"}.
          So 24 orders make 12 curves.
        </p>
        <div class="thumbs" role="radiogroup" aria-label="Order of the points">${ORDERS.map((_, k) => this.thumb(k))}</div>
      </div>
    `;
  }
}

/** @param {Curve} curve */
const polylineOf = (curve) => `M${Array.from(curve.controlPoints(), (value) => value.toFixed(1)).join(" ")}`;

customElements.define("fig-reorder", FigReorder);
