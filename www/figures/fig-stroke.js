// The outline of a stroke: width, joins and caps.
import { html } from "lit";
import { Figure } from "./lib/figure.js";
import { choice, slider } from "./lib/parts.js";
import { drawn, planeOf } from "./lib/plane.js";
import { Path } from "./modules/strokes.js";

const SIZE = { width: 120, height: 66 };
/** A curve with a corner. */
const LINE = Path.fromSVG("M14 52C22 8 46 2 60 14C66 20 62 44 54 46C74 52 96 52 106 16");
const TOLERANCE = 0.02;
/** The width of a brush: positions along the path, and parts of the greatest width. */
const BRUSH = [
  [0, 0.1],
  [0.3, 1],
  [0.6, 0.3],
  [0.85, 0.8],
  [1, 0],
];

/** `<fig-stroke>` */
export class FigStroke extends Figure {
  static properties = { width: { state: true }, shape: { state: true }, join: { state: true }, cap: { state: true } };

  constructor() {
    super();
    this.width = 12;
    /** @type {"constant" | "brush"} */
    this.shape = "constant";
    /** @type {"miter" | "round" | "bevel"} */
    this.join = "miter";
    /** @type {"butt" | "round" | "square"} */
    this.cap = "butt";
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const { width, shape, join, cap } = this;
    /** @type {import("casteljau").WidthProfile} */
    const brush = { stops: BRUSH.map(([position, part]) => [position, part * width]), interpolation: "smooth" };
    const outline = LINE.stroke(shape === "brush" ? brush : width, { join, cap, tolerance: TOLERANCE });
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="A path and the outline of its stroke">
            <path d=${drawn(plane, outline)} fill="var(--curve)" fill-opacity="0.2" stroke="var(--curve)" stroke-width="2" />
            <path class="polygon" stroke-dasharray="6 4" d=${drawn(plane, LINE)} />
          </svg>
        </div>
        <div class="controls">
          ${slider({ name: "Width", value: width, min: 1, max: 24, step: 0.5, text: String(width), change: (to) => (this.width = to) })}
          ${choice({
            name: "Shape",
            options: [
              ["constant", "constant"],
              ["brush", "brush"],
            ],
            value: shape,
            change: (to) => (this.shape = /** @type {typeof this.shape} */ (to)),
          })}
          ${choice({
            name: "Join",
            options: [
              ["miter", "miter"],
              ["round", "round"],
              ["bevel", "bevel"],
            ],
            value: join,
            change: (to) => (this.join = /** @type {typeof this.join} */ (to)),
          })}
          ${choice({
            name: "Cap",
            options: [
              ["butt", "butt"],
              ["round", "round"],
              ["square", "square"],
            ],
            value: cap,
            change: (to) => (this.cap = /** @type {typeof this.cap} */ (to)),
          })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-stroke", FigStroke);
