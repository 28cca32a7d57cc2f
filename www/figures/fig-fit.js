// A spline fitted to points with noise: the tolerance decides whether it follows the noise.
import { html, svg } from "lit";
import { Figure } from "./lib/figure.js";
import { ORIGINAL, fitOf, samplesOf } from "./lib/fitting.js";
import { decimal } from "./lib/numbers.js";
import { disc, slider } from "./lib/parts.js";
import { drawn, planeOf } from "./lib/plane.js";

const SIZE = { width: 128, height: 82 };
/** Exponents of 2 for the tolerance. */
const [FINE, COARSE] = [-2, 4];

/** `<fig-fit>` */
export class FigFit extends Figure {
  static properties = { exponent: { state: true }, noise: { state: true } };

  constructor() {
    super();
    this.exponent = 3;
    this.noise = 1.5;
  }

  get tolerance() {
    return 2 ** this.exponent;
  }

  get fit() {
    return fitOf(samplesOf(this.noise), this.tolerance);
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const samples = samplesOf(this.noise);
    const { spline, error, cubics } = fitOf(samples, this.tolerance);
    const joints = Array.from({ length: cubics + 1 }, (_, t) => spline.eval(t));
    const small = (/** @type {readonly [number, number]} */ point) => {
      const [x, y] = plane.place(point);
      return svg`<circle cx=${x} cy=${y} r="2.5" fill="var(--handle)" />`;
    };
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="img" aria-label="${samples.length} points and a spline of ${cubics} cubics">
            <path class="ghost" d=${drawn(plane, ORIGINAL)} />
            ${samples.map(small)}
            <path class="curve" d=${drawn(plane, spline)} />
            ${joints.map(({ x, y }) => disc(...plane.place([x, y]), 4.5))}
          </svg>
        </div>
        <p class="facts"><b>${cubics}</b> ${cubics === 1 ? "cubic" : "cubics"} for ${samples.length} points. The farthest point is <b>${decimal(error)}</b> away.</p>
        <div class="controls">
          ${slider({ name: "Tolerance", value: this.exponent, min: FINE, max: COARSE, step: 0.25, text: decimal(this.tolerance), change: (to) => (this.exponent = to) })}
          ${slider({ name: "Noise", value: this.noise, min: 0, max: 3, step: 0.25, text: decimal(this.noise), change: (to) => (this.noise = to) })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-fit", FigFit);
