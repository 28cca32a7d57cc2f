// A stroke of varying width as the union of discs, and the points at which its sides touch one of them.
import { html, svg } from "lit";
import { Figure } from "./lib/figure.js";
import { decimal } from "./lib/numbers.js";
import { polyline, ring, slider } from "./lib/parts.js";
import { drawn, handles, marks, planeOf, pointName } from "./lib/plane.js";
import { discAt } from "./lib/taper.js";
import { Curve, Path } from "./modules/strokes.js";

/** @typedef {import("./lib/plane.js").Point} Point */

const SIZE = { width: 128, height: 84 };
/** A line of length 60. @type {Point[]} */
const POINTS = [
  [30, 42],
  [50, 42],
  [70, 42],
  [90, 42],
];
const DISCS = 9;
const MAX_RADIUS = 38;
const TOLERANCE = 0.02;

/** `<fig-taper>` */
export class FigTaper extends Figure {
  static properties = { points: { state: true }, first: { state: true }, last: { state: true }, t: { state: true } };

  constructor() {
    super();
    this.points = POINTS;
    this.first = 4;
    this.last = 16;
    this.t = 0.6;
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const { points, first, last, t } = this;
    const centre = Path.from(new Curve(points));
    const stops = /** @type {[number, number][]} */ ([
      [0, 2 * first],
      [1, 2 * last],
    ]);
    const outline = centre.stroke({ stops }, { cap: "round", tolerance: TOLERANCE });
    const radii = /** @type {[number, number]} */ ([first, last]);
    const disc = discAt(points, radii, t);
    const circle = (/** @type {string} */ className, /** @type {ReturnType<typeof discAt>} */ { center, radius }) => {
      const [cx, cy] = plane.place(center);
      return svg`<circle class=${className} cx=${cx} cy=${cy} r=${radius * plane.scale} />`;
    };
    const all = Array.from({ length: DISCS }, (_, k) => discAt(points, radii, k / (DISCS - 1)));
    const [cx, cy] = plane.place(disc.center);
    const sides = disc.contacts.map(plane.place);
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="Discs along a curve and the outline around them">
            <path d=${drawn(plane, outline)} fill="var(--curve)" fill-opacity="0.18" stroke="var(--curve)" stroke-width="2.5" />
            <g stroke-opacity="0.45">${all.map((each) => circle("axis", each))}</g>
            ${polyline("polygon", points.flatMap(plane.place))}<path class="ghost" d=${drawn(plane, centre)} />
            ${circle("level2", disc)}
            ${sides.map(([x, y]) => svg`<path class="level2" d="M${cx} ${cy}L${x} ${y}" />${ring(x, y, "var(--level2)", 5)}`)}
            ${marks(plane, points, pointName)}
          </svg>
          ${handles(this, plane, points, { name: pointName, move: (to) => (this.points = to) })}
        </div>
        <p class="facts">
          Length of the centre line: ${decimal(centre.length(), 1)}. The radius changes by <b>${decimal(disc.slope)}</b> for each unit of length.
          ${sides.length ? "" : "One disc covers all the others: there are no sides."}
        </p>
        <div class="controls">
          ${slider({ name: "First radius", value: first, min: 0, max: MAX_RADIUS, step: 0.5, text: decimal(first, 1), change: (to) => (this.first = to) })}
          ${slider({ name: "Last radius", value: last, min: 0, max: MAX_RADIUS, step: 0.5, text: decimal(last, 1), change: (to) => (this.last = to) })}
          ${slider({ name: html`<i>t</i>`, value: t, min: 0, max: 1, text: decimal(t), change: (to) => (this.t = to) })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-taper", FigTaper);
