// <reyes-dicing>: the steps of the REYES algorithm on the teapot: bound, split, dice, shade.
import { css, html } from "lit";
import { Surface } from "casteljau/surfaces";
import { boundingSphereOf, HOME, cameraMatricesOf } from "#js/elements/surface/camera.js";
import { dice, screenBounds, splitPatch } from "./lib/dicing.js";
import { Figure } from "./lib/figure.js";
import { grouped } from "./lib/numbers.js";
import { choice, slider } from "./lib/parts.js";

/** @typedef {"bound" | "split" | "dice" | "shade"} Step */

/** @type {[Step, string][]} */
const STEPS = [
  ["bound", "1 Bound"],
  ["split", "2 Split"],
  ["dice", "3 Dice"],
  ["shade", "4 Shade"],
];
/** Height by width of the picture, and the radius of the surface by its width. */
const [ASPECT, FILLED] = [0.62, 0.46];
/** In the coordinates of the eye: x to the right, y up, z towards it. */
const LIGHT = [-0.4, 0.62, 0.68];
/** Neighbouring parts get colours far apart: the golden angle, in degrees. */
const HUE_STEP = 137.5;

export class ReyesDicing extends Figure {
  static properties = {
    step: { state: true },
    size: { state: true },
    zoom: { state: true },
    isNear: { state: true },
    counts: { state: true },
  };
  static styles = [Figure.styles, css`canvas { display: block; inline-size: 100%; aspect-ratio: 1 / ${ASPECT}; }`];

  /** @type {IntersectionObserver | null} */
  #watch = null;
  /** @type {import("casteljau/surfaces").Patch[]} */
  #patches = [];
  /** @type {import("#js/elements/surface/camera.js").BoundingSphere | null} */
  #sphere = null;

  constructor() {
    super();
    this.step = /** @type {Step} */ ("dice");
    this.size = 16;
    this.zoom = 1;
    this.isNear = false;
    this.counts = { parts: 0, micropolygons: 0 };
  }

  /** What the figure shows, for tasks. */
  get figure() {
    return { step: this.step, size: this.size, zoom: this.zoom, ...this.counts };
  }

  /** The number of micropolygons at a zoom. @param {number} zoom */
  countAt(zoom) {
    return this.#dice(zoom).micropolygons.length;
  }

  connectedCallback() {
    super.connectedCallback();
    this.#watch = new IntersectionObserver((entries) => (this.isNear ||= entries.some((each) => each.isIntersecting)), {
      rootMargin: "200px",
    });
    this.#watch.observe(this);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", this.#redraw);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#watch?.disconnect();
    matchMedia("(prefers-color-scheme: dark)").removeEventListener("change", this.#redraw);
  }

  #redraw = () => this.requestUpdate();

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    if (this.isNear && !(changed.size === 1 && changed.has("counts"))) this.#draw();
  }

  #build() {
    const teapot = Surface.teapot();
    this.#patches = teapot.patches.map((_, k) => teapot.patch(k));
    this.#sphere = boundingSphereOf(teapot.vertices, "z");
  }

  /** The parts of all patches and their micropolygons. @param {number} zoom */
  #dice(zoom) {
    if (!this.#sphere) this.#build();
    const { project, toEye } = this.#camera(this.wide, Math.round(ASPECT * this.wide), zoom);
    const parts = this.#patches.flatMap((patch, patchIndex) =>
      splitPatch(patch, project, this.size).map((part) => ({ part, patchIndex })),
    );
    const micropolygons = parts.flatMap(({ part, patchIndex }, partIndex) =>
      dice(part, project, this.size).map((each) => ({ ...each, patchIndex, partIndex })),
    );
    return { parts, micropolygons, project, toEye };
  }

  #draw() {
    const canvas = /** @type {HTMLCanvasElement} */ (this.renderRoot.querySelector("canvas"));
    const [width, height] = [this.wide, Math.round(ASPECT * this.wide)];
    [canvas.width, canvas.height] = [width * devicePixelRatio, height * devicePixelRatio];
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.scale(devicePixelRatio, devicePixelRatio);
    const { parts, micropolygons, project, toEye } = this.#dice(this.zoom);
    micropolygons.sort((a, b) => b.depth - a.depth);
    const colours = getComputedStyle(this);
    const [ink, paper] = ["--ink", "--paper"].map((name) => colours.getPropertyValue(name));
    if (this.step === "dice") drawGrid(context, micropolygons, paper, ink);
    else
      drawFilled(context, micropolygons, (each) =>
        this.step === "shade"
          ? shade(toEye(each.normal))
          : hue(this.step === "split" ? each.partIndex : each.patchIndex),
      );
    if (this.step === "bound") drawBounds(context, this.#patches, project, ink);
    this.counts = { parts: parts.length, micropolygons: micropolygons.length };
  }

  /** A parallel projection in the direction of the elements' first view. @param {number} width @param {number} height @param {number} zoom */
  #camera(width, height, zoom) {
    const sphere = /** @type {import("#js/elements/surface/camera.js").BoundingSphere} */ (this.#sphere);
    const { right, upward, forward } = cameraMatricesOf(HOME, sphere, width, height);
    const scale = (zoom * FILLED * width) / sphere.radius;
    const along = (/** @type {ArrayLike<number>} */ p, /** @type {number[]} */ axis) =>
      axis.reduce((sum, a, k) => sum + a * (p[k] - sphere.centre[k]), 0);
    /** @type {import("./lib/dicing.js").Projection} */
    const project = (p) => [
      width / 2 + scale * along(p, right),
      height / 2 - scale * along(p, upward),
      along(p, forward),
    ];
    const toEye = (/** @type {number[]} */ n) =>
      [right, upward, forward.map((c) => -c)].map((axis) => axis.reduce((sum, a, k) => sum + a * n[k], 0));
    return { project, toEye };
  }

  render() {
    const set = (/** @type {Record<string, unknown>} */ properties) => {
      Object.assign(this, properties);
      this.notifyChange();
    };
    const { parts, micropolygons } = this.counts;
    return html`
      <div class="frame">
        <div class="stage"><canvas role="img" aria-label="The teapot in one step of the REYES algorithm"></canvas></div>
        <p class="facts" role="status">32 patches, <b data-parts=${parts}>${grouped(parts)}</b> parts, <b data-micropolygons=${micropolygons}>${grouped(micropolygons)}</b> micropolygons</p>
        <div class="controls">
          ${choice({ name: "Step", options: STEPS, value: this.step, change: (step) => set({ step }) })}
          ${slider({ name: "Micropolygon size", value: this.size, min: 6, max: 32, step: 1, text: `${this.size} px`, change: (size) => set({ size }) })}
          ${slider({ name: "Zoom", value: this.zoom, min: 0.3, max: 1.5, step: 0.05, text: `${this.zoom.toFixed(2)} ×`, change: (zoom) => set({ zoom }) })}
        </div>
      </div>
    `;
  }
}

/** @typedef {import("./lib/dicing.js").Micropolygon & { patchIndex: number, partIndex: number }} Cell */

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import("casteljau/surfaces").Patch[]} patches
 * @param {import("./lib/dicing.js").Projection} project
 * @param {string} ink
 */
function drawBounds(context, patches, project, ink) {
  [context.strokeStyle, context.lineWidth] = [ink, 1];
  for (const patch of patches) {
    const { left, top, right, bottom } = screenBounds(patch, project);
    context.strokeRect(left, top, right - left, bottom - top);
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Cell[]} cells far ones first
 * @param {string} paper
 * @param {string} ink
 */
function drawGrid(context, cells, paper, ink) {
  [context.fillStyle, context.strokeStyle, context.lineWidth] = [paper, ink, 0.5];
  for (const { corners } of cells) {
    tracePolygon(context, corners);
    context.fill();
    context.stroke();
  }
}

/**
 * One colour for each micropolygon. It is stroked, too, so that no gap shows between neighbours.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Cell[]} cells far ones first
 * @param {(cell: Cell) => string} colourOf
 */
function drawFilled(context, cells, colourOf) {
  context.lineWidth = 0.75;
  for (const cell of cells) {
    context.fillStyle = context.strokeStyle = colourOf(cell);
    tracePolygon(context, cell.corners);
    context.fill();
    context.stroke();
  }
}

/** @param {number} index */
const hue = (index) => `hsl(${Math.round(index * HUE_STEP) % 360} 50% 70%)`;

/** The colour for a normal in the coordinates of the eye: blue for the front, orange for the back. @param {number[]} n */
function shade(n) {
  const sign = n[2] < 0 ? -1 : 1; // the side that is seen
  const cosine = (sign * LIGHT.reduce((sum, l, k) => sum + l * n[k], 0)) / (Math.hypot(...n) || 1);
  return `hsl(${sign > 0 ? 205 : 25} 60% ${Math.round(32 + 50 * Math.max(cosine, 0))}%)`;
}

/** @param {CanvasRenderingContext2D} context @param {number[][]} corners */
function tracePolygon(context, corners) {
  context.beginPath();
  for (const [x, y] of corners) context.lineTo(x, y);
  context.closePath();
}

customElements.define("reyes-dicing", ReyesDicing);
