// Families of splines on the same points: one is chosen, and after a point has moved, what the spline was before is dashed.
import { html, svg } from "lit";
import { Figure } from "./lib/figure.js";
import { FAMILIES, continuityOf, farthest, splineOf } from "./lib/families.js";
import { decimal } from "./lib/numbers.js";
import { choice, polyline, ring, slider } from "./lib/parts.js";
import { drawn, handles, marks, planeOf, pointName } from "./lib/plane.js";

/** @typedef {import("./lib/plane.js").Point} Point */
/** @typedef {import("./lib/families.js").Family} Family */

const SIZE = { width: 128, height: 84 };
/** @type {Point[]} */
const POINTS = [
  [10, 72],
  [30, 18],
  [56, 64],
  [84, 14],
  [118, 58],
];
/** A point counts as passed when it is closer than this, in units. */
const ON = 1e-6;

/** `<fig-families>` */
export class FigFamilies extends Figure {
  static properties = {
    family: { state: true },
    points: { state: true },
    tension: { state: true },
    previous: { state: true },
  };

  #moving = false;

  constructor() {
    super();
    /** @type {Family} */
    this.family = "natural";
    this.points = POINTS;
    this.tension = 0.5;
    /** The points before the last one was moved. @type {Point[] | null} */
    this.previous = null;
    this.addEventListener("change", () => (this.#moving = false));
  }

  get spline() {
    return splineOf(this.family, this.points, this.tension);
  }

  /** @param {Point[]} points */
  #move(points) {
    if (!this.#moving) this.previous = this.points;
    this.#moving = true;
    this.points = points;
  }

  /** @param {Family} family */
  #choose(family) {
    this.family = family;
    this.previous = null;
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const { family, points, tension, spline, previous } = this;
    const off = farthest(spline, points);
    const joints = off < ON ? [] : Array.from({ length: spline.segmentCount + 1 }, (_, t) => spline.eval(t));
    const crossings = spline.selfIntersections().length;
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="Five points and a spline">
            ${polyline("gridline", points.flatMap(plane.place))}
            ${previous ? svg`<path class="ghost" d=${drawn(plane, splineOf(family, previous, tension))} />` : ""}
            <path class="curve" d=${drawn(plane, spline)} />
            ${joints.map(({ x, y }) => ring(...plane.place([x, y]), "var(--curve)", 4.5))}
            ${marks(plane, points, pointName, { kind: () => "off" })}
          </svg>
          ${handles(this, plane, points, { name: pointName, kind: () => "off", move: (to) => this.#move(to) })}
        </div>
        <p class="facts">
          ${off < ON ? html`Through <b>all</b> points` : html`Up to <b>${decimal(off, 1)}</b> from a point`},
          ${family === "bezier" ? "one piece" : html`joints <b>${continuityOf(spline)}</b>`},
          ${crossings ? html`<b>crosses itself</b>` : "does not cross itself"}.
        </p>
        <div class="controls">
          ${choice({ name: "Family", options: FAMILIES, value: family, change: (to) => this.#choose(to) })}
          ${family === "cardinal" ? slider({ name: "Tension", value: tension, min: 0, max: 1, step: 0.05, text: decimal(tension), change: (to) => (this.tension = to) }) : ""}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-families", FigFamilies);
