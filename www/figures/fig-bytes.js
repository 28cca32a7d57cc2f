// How little control points weigh: bytes of a curve and of the teapot, as points and as pieces.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure, numeric, oneOf } from "./lib/figure.js";
import { choice, slider } from "./lib/parts.js";
import { grouped } from "./lib/numbers.js";

const BYTES_PER_NUMBER = 4; // 32-bit floats on both sides
const BYTES_PER_INDEX = 2;
const MAX_SEGMENTS = 64;
/** The teapot, once a figure has asked for it: a page about curves does not load the module of surfaces. @type {import("casteljau/surfaces").Surface} */
let teapot;

/** @typedef {{ name: string, bytes: number }} Weight */

/**
 * A cubic in space: its four points, and the points of its polyline.
 *
 * @param {number} segments
 * @returns {Weight[]}
 */
function curveBytes(segments) {
  const curve = new Curve([
    [0, 2, 3],
    [2, 3, 5],
    [6, 7, 9],
    [3, 4, 5],
  ]);
  return [
    { name: "control points", bytes: curve.controlPoints().length * BYTES_PER_NUMBER },
    { name: "polyline", bytes: curve.sample(segments).length * BYTES_PER_NUMBER },
  ];
}

/**
 * The teapot: points and the lists of its patches; the mesh with and without normals.
 *
 * @param {number} segments
 * @returns {Weight[]}
 */
function teapotBytes(segments) {
  const mesh = teapot.tessellate({ segments, weld: "position" });
  const indices = teapot.patches.reduce((sum, patch) => sum + patch.length, 0);
  return [
    { name: "control points", bytes: teapot.vertices.length * BYTES_PER_NUMBER + indices * BYTES_PER_INDEX },
    { name: "mesh", bytes: mesh.positions.byteLength + mesh.indices.byteLength },
    { name: "mesh with normals", bytes: mesh.positions.byteLength + mesh.indices.byteLength + mesh.normals.byteLength },
  ];
}

/** `<fig-bytes model="teapot" segments="16">` */
export class FigBytes extends Figure {
  static properties = {
    model: oneOf(["teapot", "curve"]),
    segments: numeric({ least: 1, most: MAX_SEGMENTS, whole: true, otherwise: 16 }),
  };

  constructor() {
    super();
    this.model = "teapot";
    this.segments = 16;
  }

  /** Loads what the figure shows, before it is drawn. */
  async load() {
    if (this.model === "teapot") teapot ??= (await import("casteljau/surfaces")).Surface.teapot();
  }

  async scheduleUpdate() {
    await this.load();
    super.scheduleUpdate();
  }

  /** @param {Weight[]} weights */
  picture(weights) {
    const [left, right, line] = [140, 84, 40];
    const length = this.wide - left - right;
    const most = Math.max(...weights.map(({ bytes }) => bytes));
    const height = weights.length * line + 16;
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label=${weights.map(({ name, bytes }) => `${name}: ${bytes} bytes`).join("; ")}>
        ${weights.map(
          ({ name, bytes }, i) => svg`
          <text class="end" x=${left - 10} y=${i * line + 32}>${name}</text>
          <rect class="bar ${i === 0 ? "mine" : ""}" x=${left} y=${i * line + 14} width=${Math.max(1, (length * bytes) / most)} height="26" rx="2" />
          <text x=${left + Math.max(1, (length * bytes) / most) + 8} y=${i * line + 32} data-bytes=${bytes}>${grouped(bytes)} B</text>`,
        )}
      </svg>
    `;
  }

  render() {
    const weights = this.model === "teapot" ? teapotBytes(this.segments) : curveBytes(this.segments);
    const ratio = weights[1].bytes / weights[0].bytes;
    return html`
      <div class="frame">
        <div class="stage">${this.picture(weights)}</div>
        <p class="facts">
          ${
            this.model === "teapot"
              ? html`The teapot has ${teapot.vertices.length / 3} control points and ${teapot.patchCount} lists of 16 indices. With ${this.segments} ${this.segments === 1 ? "segment" : "segments"} in each direction of a patch, its mesh takes`
              : html`The curve has 4 control points. Its polyline with ${this.segments + 1} points takes`
          }
          <b>${ratio >= 10 ? Math.round(ratio) : ratio.toFixed(1)} times</b> as many bytes${ratio < 1 ? ", which is fewer" : ""}.
        </p>
        <div class="controls">
          ${slider({
            name: "Segments",
            value: this.segments,
            min: 1,
            max: MAX_SEGMENTS,
            step: 1,
            text: String(this.segments),
            change: (n) => {
              this.segments = n;
              this.notifyChange();
            },
          })}
          ${choice({
            name: "Of",
            options: [
              ["teapot", "the teapot"],
              ["curve", "a curve"],
            ],
            value: this.model,
            change: (model) => {
              this.model = model;
              this.notifyChange();
            },
          })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-bytes", FigBytes);
