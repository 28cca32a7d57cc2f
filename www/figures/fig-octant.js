// A patch of nine control points with weights, and the eighth of a sphere that it is for one of them.
import { html, svg } from "lit";
import { Curve } from "casteljau/surfaces";
import { decimal } from "./lib/numbers.js";
import { OrbitFigure } from "./lib/orbit-figure.js";
import { disc, polyline, slider, square } from "./lib/parts.js";

const [MIN_WEIGHT, MAX_WEIGHT] = [0.3, 1.5];
const LINES = 6;
const STEPS = 24;
/** A ball around everything that is drawn. */
const CENTER = [0.5, 0.5, 0.5];
const RADIUS = 0.95;

/** `<fig-octant turn="30" tilt="26">` */
export class FigOctant extends OrbitFigure {
  static properties = { weight: { state: true } };

  constructor() {
    super();
    this.weight = 1;
    this.turn = 30;
    this.tilt = 26;
  }

  /** The profile, and the arc that each of its points runs through, in homogeneous coordinates: (w x, w y, w). */
  get arc() {
    const w = this.weight;
    return new Curve([
      [1, 0, 1],
      [w, w, w],
      [0, 1, 1],
    ]);
  }

  /** Points of the patch, row by row: a point (r, z) of the profile and the arc times r. @param {number} rows @param {number} columns */
  grid(rows, columns) {
    const at = (/** @type {number} */ count) => {
      const flat = this.arc.sample(count);
      return Array.from({ length: count + 1 }, (_, i) => {
        const [x, y, w] = flat.subarray(3 * i, 3 * i + 3);
        return [x / w, y / w];
      });
    };
    const across = at(columns);
    return at(rows).map(([r, z]) => across.map(([x, y]) => [r * x, r * y, z]));
  }

  /** The largest distance from the sphere. */
  get error() {
    return Math.max(
      ...this.grid(STEPS, STEPS)
        .flat()
        .map((point) => Math.abs(Math.hypot(...point) - 1)),
    );
  }

  picture() {
    const { height, place } = this.view(CENTER, RADIUS, 0.62);
    const line = (/** @type {ArrayLike<number>[]} */ points) => points.flatMap((point) => place(point));
    const rows = this.grid(LINES, STEPS);
    const columns = this.grid(STEPS, LINES);
    const legs = [
      [1, 0],
      [1, 1],
      [0, 1],
    ];
    const net = legs.map(([r, z]) => legs.map(([x, y]) => [r * x, r * y, z]));
    const names = ["1", "w", "w²"];
    const circle = (/** @type {(c: number, s: number) => number[]} */ at) =>
      line(
        Array.from({ length: STEPS + 1 }, (_, i) => {
          const angle = (Math.PI * i) / (2 * STEPS);
          return at(Math.cos(angle), Math.sin(angle));
        }),
      );
    return this.turned(
      height,
      "A patch with nine control points and weights, and the outline of an eighth of a sphere",
      `The weight w is ${decimal(this.weight)}`,
      svg`
        ${rows.map((row) => polyline("level1", line(row)))}
        ${Array.from({ length: LINES + 1 }, (_, k) => polyline("level1", line(columns.map((row) => row[k]))))}
        ${net.map((row) => polyline("polygon", line(row)))}
        ${[0, 1, 2].map((k) => polyline("polygon", line(net.map((row) => row[k]))))}
        ${[circle((c, s) => [c, s, 0]), circle((c, s) => [c, 0, s]), circle((c, s) => [0, c, s])].map((each) => polyline("ghost", each))}
        ${net.flatMap((row, j) =>
          row.map((point, i) => {
            const isPole = j === 2 && i > 0; // the first point of this row is drawn for all three
            const [x, y] = place(point);
            const isCorner = i !== 1 && j !== 1;
            const words = j === 2 ? "1, w, 1" : names[Number(i === 1) + Number(j === 1)];
            return isPole
              ? ""
              : svg`${isCorner ? disc(x, y) : square(x, y)}<text class="haloed middle strong" x=${x} y=${y - 12}>${words}</text>`;
          }),
        )}`,
    );
  }

  render() {
    return html`
      <div class="frame">
        <div class="stage">${this.picture()}</div>
        <p class="facts">The largest distance of the patch from the sphere is <b class="error">${decimal(this.error, 4)}</b>.</p>
        <div class="controls">
          ${slider({ name: html`<i>w</i>`, value: this.weight, min: MIN_WEIGHT, max: MAX_WEIGHT, text: decimal(this.weight), change: (weight) => (this.weight = weight) })}
          ${this.angles()}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-octant", FigOctant);
