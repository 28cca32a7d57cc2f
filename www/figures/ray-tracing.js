// <ray-tracing for="id">: the view of a <bezier-surface>, ray traced from its patches in a Web Worker.
import { css, html } from "lit";
import { boundingSphereOf, cameraMatricesOf } from "#js/elements/surface/camera.js";
import { Figure } from "./lib/figure.js";
import { check } from "./lib/parts.js";

/** A larger picture would take too long. */
const MAX_SIDE_PX = 400;

/** @typedef {"idle" | "running" | "done" | "cancelled" | "failed"} TraceState */

/** @type {Record<TraceState, string>} */
const STATE_WORDS = {
  idle: "Not traced yet.",
  running: "",
  done: "Finished.",
  cancelled: "Cancelled.",
  failed: "The Web Worker could not be started.",
};

export class RayTracing extends Figure {
  static properties = {
    for: {},
    state: { state: true },
    progress: { state: true },
    hasShadows: { state: true },
    isOutdated: { state: true },
  };
  static styles = [
    Figure.styles,
    css`
      :host { margin-block: 0; }
      .stage { aspect-ratio: 1; }
      canvas, .stage ::slotted(*), .lines { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; }
      .lines svg { block-size: 100%; opacity: 0.7; }
      progress { flex: 1 1 8rem; min-inline-size: 5rem; accent-color: var(--accent); }
    `,
  ];

  /** @type {Worker | null} */
  #worker = null;
  /** The view that was traced. */
  #tracedView = "";

  constructor() {
    super();
    this.for = "";
    this.state = /** @type {TraceState} */ ("idle");
    this.progress = 0;
    this.hasShadows = true;
    this.isOutdated = false;
  }

  /** The element whose view is traced. @returns {any} */
  get target() {
    return document.getElementById(this.for);
  }

  /** What the figure shows, for tasks. */
  get figure() {
    return { state: this.state, progress: this.progress, segments: this.target?.segments ?? null };
  }

  connectedCallback() {
    super.connectedCallback();
    for (const type of ["input", "change"]) this.target?.addEventListener(type, this.#onTargetChange);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#end();
    if (this.state === "running") this.state = "cancelled";
    for (const type of ["input", "change"]) this.target?.removeEventListener(type, this.#onTargetChange);
  }

  #onTargetChange = () => {
    this.isOutdated = this.state !== "idle" && JSON.stringify(this.target.view) !== this.#tracedView;
  };

  #end() {
    this.#worker?.terminate();
    this.#worker = null;
  }

  start() {
    this.#end();
    const { target } = this;
    const canvas = /** @type {HTMLCanvasElement} */ (this.renderRoot.querySelector("canvas"));
    const side = Math.max(1, Math.min(MAX_SIDE_PX, Math.round(canvas.clientWidth)));
    [canvas.width, canvas.height] = [side, side];
    this.#tracedView = JSON.stringify(target.view);
    Object.assign(this, { state: "running", progress: 0, isOutdated: false });
    const { vertices } = target.surface;
    const sphere = boundingSphereOf(vertices, target.up);
    const matrices = cameraMatricesOf(target.view, sphere, side, side);
    const [front, back] = ["--bz-front", "--bz-back"].map((name) => colourOf(target, name));
    this.#worker = new Worker(new URL("./lib/trace-worker.js", import.meta.url), { type: "module" });
    this.#worker.onmessage = ({ data }) => this.#show(canvas, data);
    this.#worker.onerror = () => this.#finish("failed");
    const view = { matrices, radius: sphere.radius, front, back, hasShadows: this.hasShadows };
    this.#worker.postMessage({ surface: target.surface.toJSON(), view });
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {import("./lib/trace-worker.js").TraceProgress} data
   */
  #show(canvas, { image, progress }) {
    canvas.getContext("2d")?.putImageData(new ImageData(image, canvas.width), 0, 0);
    this.progress = progress;
    if (progress === 1) this.#finish("done");
  }

  /** @param {TraceState} state */
  #finish(state) {
    this.#end();
    this.state = state;
    this.notifyChange();
  }

  render() {
    const isRunning = this.state === "running";
    const percent = Math.floor(100 * this.progress);
    const words = isRunning ? `${percent} %` : STATE_WORDS[this.state];
    return html`
      <div class="frame">
        <div class="stage">
          ${this.state === "idle" ? html`<div class="lines" aria-hidden="true">${linesOf(this.target)}</div>` : ""}
          <canvas role="img" aria-label="The same view of the teapot, ray traced" width="1" height="1"></canvas>
        </div>
        <div class="controls">
          <button type="button" @click=${() => (isRunning ? this.#finish("cancelled") : this.start())}>${isRunning ? "Cancel" : "Trace this view"}</button>
          ${check({ name: "Shadows", value: this.hasShadows, change: (value) => (this.hasShadows = value) })}
          <progress max="1" .value=${this.progress} aria-label="Progress"></progress>
        </div>
        <p class="facts" role="status">${words}${this.isOutdated ? " The view has changed since then." : ""}</p>
      </div>
    `;
  }
}

/** The drawing that the page holds for the target: it is shown until a picture is traced. @param {Element | null} target */
function linesOf(target) {
  return target?.querySelector("svg")?.cloneNode(true) ?? "";
}

/** A custom property of an element as red, green and blue from 0 to 1. @param {Element} element @param {string} name */
function colourOf(element, name) {
  const context = /** @type {CanvasRenderingContext2D} */ (document.createElement("canvas").getContext("2d"));
  context.fillStyle = getComputedStyle(element).getPropertyValue(name).trim();
  context.fillRect(0, 0, 1, 1);
  return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)].map((c) => c / 255);
}

customElements.define("ray-tracing", RayTracing);
