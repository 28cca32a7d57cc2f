// <ink-pad>: a drawing surface, and what perfect-freehand makes of the same samples.
import { Editor } from "#js/editor/editor.js";
import { capture } from "#js/ui/capture.js";
import { save } from "#js/ui/files.js";
import { InkStroke } from "casteljau";
import { css, html, svg } from "lit";
import { getStroke } from "perfect-freehand";
import { Figure } from "../figures/lib/figure.js";
import { decimal } from "../figures/lib/numbers.js";
import { check, slider } from "../figures/lib/parts.js";
import { toolStyle } from "../figures/lib/tool.js";
import { discsOf, distanceFromDiscs, freehandDiscs, outlinePoints, pathData, tapering } from "./compare.js";
import { hand } from "./samples.js";
import { keepDrawing, keptDrawing, rounded } from "./storage.js";

/**
 * @typedef {[x: number, y: number, pressure: number, time: number]} Sample
 * @typedef {{ device: boolean, samples: Sample[] }} Stroke `device`: whether the pressures are those of a pen
 * @typedef {{ d: string, nodes: string, count: number, error: number }} Outline
 * @typedef {{ strokes: readonly Stroke[], height: number }} Drawing `height`: of the highest surface it was drawn on, in units
 */

/** How many units are as wide as the surface, and its height by its width: more on a phone, where it is small. */
const WIDTH = 600;
const [ASPECT, NARROW_ASPECT, NARROW_PX] = [0.54, 0.9, 520];
const SETTINGS = { size: 12, thinning: 0.6, start: 0, end: 0, smoothing: 0.5, streamline: 0.5 };
/** Name, unit, range and step of each setting. @type {[keyof typeof SETTINGS, string, number, number, number][]} */
const SLIDERS = [
  ["size", "Size", 2, 40, 1],
  ["thinning", "Thinning", -1, 1, 0.05],
  ["smoothing", "Smoothing", 0, 1, 0.05],
  ["streamline", "Streamline", 0, 1, 0.05],
  ["start", "Taper at the start", 0, 200, 5],
  ["end", "Taper at the end", 0, 200, 5],
];

/**
 * Settings out of what an address says.
 *
 * @param {unknown} json
 * @returns {typeof SETTINGS}
 * @throws {RangeError} for anything else
 */
export function checkedSettings(json) {
  const given = /** @type {Record<string, unknown>} */ (json);
  const entries = SLIDERS.map(([key, , min, max]) => {
    const value = given[key];
    if (!(typeof value === "number" && value >= min && value <= max))
      throw new RangeError(`${key}: expected a number from ${min} to ${max}`);
    return [key, value];
  });
  return Object.fromEntries(entries);
}

/** `<ink-pad>` */
export class InkPad extends Figure {
  static properties = {
    settings: { state: true },
    live: { state: true },
    marked: { state: true },
  };
  static styles = [
    Figure.styles,
    toolStyle,
    css`
    .view { position: relative; }
    .view > b { position: absolute; inset: 0.5rem auto auto 0.8rem; font-size: 0.8125rem; font-weight: 400; color: var(--quiet); pointer-events: none; }
    .surface { margin: 0.5rem 0.5rem 0; border-radius: 10px; background: var(--raised); overflow: clip; }
    .peer { margin: 0.4rem 0.9rem 0.2rem; border-radius: 10px; background: var(--raised); overflow: clip; }
    .pad:focus-visible { outline-offset: -2px; }
    .pad { cursor: crosshair; touch-action: none; user-select: none; -webkit-user-select: none; }
    .ink { fill: var(--ink); }
    .outlined .ink { fill: var(--grid); stroke: var(--quiet); stroke-width: 0.75; }
    thead td { border-block-start: 0; }
    .nodes { fill: var(--handle); stroke: none; }
    .settings { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 15rem), 1fr)); gap: 0.3rem 1.4rem; }
    .settings .slider { display: grid; grid-template-columns: 9rem minmax(0, 1fr) 2.6em; }
    .settings .value { text-align: end; }
    th:first-child, td:first-child { min-inline-size: 0; }
    .note { margin: 0; padding: 0.6rem 0.9rem; color: var(--quiet); font-size: 0.8125rem; }
    @media (max-width: 30rem) {
      :host { max-inline-size: none; margin-inline: calc(-1 * var(--gap)); }
      .frame { border-radius: 0; }
      .surface { margin: 0; border-radius: 0; border-block-end: 1px solid var(--rim); background: none; }
    }
  `,
  ];

  constructor() {
    super();
    this.settings = SETTINGS;
    /** @type {Drawing} */
    const drawing = keptDrawing() ?? { strokes: [{ device: false, samples: hand(260, 2) }], height: 0 };
    this.editor = new Editor(drawing);
    /** How many strokes the browser keeps. */
    this.kept = drawing.strokes.length;
    this.editor.subscribe(() => {
      this.kept = keepDrawing(this.editor.state);
      this.requestUpdate();
    });
    this.marked = false;
    /** What is being drawn. @type {{ stroke: Stroke, settled: string[], open: string, peer: string } | null} */
    this.live = null;
    this.frame = 0;
    /** @type {(() => void) | null} */
    this.stop = null;
    /** The outlines of each stroke with the present settings. @type {WeakMap<Stroke, { settings: object, ours: Outline, theirs: Outline }>} */
    this.outlines = new WeakMap();
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.cancel();
  }

  updated() {
    // A button that is disabled now would lose the focus, and with it the keys.
    const root = /** @type {ShadowRoot} */ (this.renderRoot);
    if (root.activeElement?.matches(":disabled")) this.pad.focus({ preventScroll: true });
  }

  get pad() {
    return /** @type {HTMLElement} */ (/** @type {unknown} */ (this.renderRoot.querySelector(".pad")));
  }

  /** The height of the surface in units: a drawing that was made on a higher one is shown as a whole. */
  get height() {
    return Math.max(WIDTH * (this.wide < NARROW_PX ? NARROW_ASPECT : ASPECT), this.editor.state.height);
  }

  /** @param {Stroke} stroke */
  inkOf({ device, samples }) {
    const { start, end, ...rest } = this.settings;
    const ink = new InkStroke({ ...rest, taper: { start, end }, pressure: device ? "device" : "simulated" });
    for (const [x, y, pressure, time] of samples) ink.append(x, y, { pressure, time });
    return ink;
  }

  /** The options of perfect-freehand. @param {Stroke} stroke */
  freehandOptions({ device }) {
    const { start, end, ...rest } = this.settings;
    const ends = { start: { taper: start, easing: tapering }, end: { taper: end, easing: tapering } };
    return { ...rest, ...ends, simulatePressure: !device, last: true };
  }

  /** @param {Stroke} stroke */
  outlinesOf(stroke) {
    const known = this.outlines.get(stroke);
    if (known?.settings === this.settings) return known;
    const ink = this.inkOf(stroke);
    const outline = ink.outline();
    const options = this.freehandOptions(stroke);
    const polygon = getStroke(stroke.samples, options);
    const made = {
      settings: this.settings,
      ours: {
        d: outline.toSVG({ precision: 2 }),
        nodes: nodesOf(outline.subpaths.flatMap((spline) => spline.segments().map((curve) => curve.eval(0)))),
        count: outline.subpaths.reduce((sum, { segmentCount }) => sum + segmentCount, 0),
        error: distanceFromDiscs(outlinePoints(outline), discsOf(ink)),
      },
      theirs: {
        d: pathData(polygon),
        nodes: nodesOf(polygon.map(([x, y]) => ({ x, y }))),
        count: polygon.length,
        error: distanceFromDiscs(outlinePoints(polygon), freehandDiscs(stroke.samples, options)),
      },
    };
    this.outlines.set(stroke, made);
    return made;
  }

  /** @param {(drawing: Drawing) => Drawing} change */
  change(change) {
    this.editor.dispatch(change, { by: "user" });
    this.notifyChange();
  }

  /** @param {Stroke} stroke */
  add(stroke) {
    this.change(({ strokes }) => ({ strokes: [...strokes, stroke], height: this.height }));
  }

  undo() {
    this.cancel();
    this.editor.undo();
  }

  redo() {
    this.cancel();
    this.editor.redo();
  }

  /** Gives up the stroke that is being drawn. */
  cancel() {
    this.stop?.();
    this.stop = null;
    this.live = null;
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  /** @param {PointerEvent} start */
  draw(start) {
    if (start.button !== 0 || this.stop) return;
    start.preventDefault();
    this.pad.focus({ preventScroll: true });
    /** @type {Stroke} */
    const stroke = { device: start.pointerType === "pen", samples: [] };
    const ink = this.inkOf(stroke);
    const pad = /** @type {SVGSVGElement} */ (start.currentTarget);
    const { left, top, width } = pad.getBoundingClientRect();
    const sample = (/** @type {PointerEvent} */ { clientX, clientY, pressure, timeStamp }) =>
      rounded([
        ((clientX - left) / width) * WIDTH,
        ((clientY - top) / width) * WIDTH,
        pressure,
        timeStamp - start.timeStamp,
      ]);
    const take = (/** @type {PointerEvent[]} */ events) => {
      for (const each of events.map(sample)) {
        stroke.samples.push(each);
        ink.append(each[0], each[1], { pressure: each[2], time: each[3] });
      }
    };
    /** @type {Sample[]} */
    let predicted = [];
    const show = () => {
      this.frame = 0;
      const { settled, open } = ink.changes(predicted.map(([x, y]) => [x, y]));
      const contours = this.live?.settled ?? [];
      this.live = {
        stroke,
        settled: settled.subpathCount ? [...contours, settled.toSVG({ precision: 2 })] : contours,
        open: open.toSVG({ precision: 2 }),
        peer: pathData(getStroke(stroke.samples, { ...this.freehandOptions(stroke), last: false })),
      };
    };
    take([start]);
    show();
    this.stop = capture(start, {
      move: (event) => {
        const all = event.getCoalescedEvents?.() ?? [];
        take(all.length ? all : [event]);
        predicted = (event.getPredictedEvents?.() ?? []).map(sample);
        if (!this.frame) this.frame = requestAnimationFrame(show);
      },
      end: (_, released) => {
        this.cancel();
        if (released) this.add(stroke);
      },
    });
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.key === "Escape" && this.stop) this.cancel();
    else if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    else if (event.key.toLowerCase() === "z") event.shiftKey ? this.redo() : this.undo();
    else if (event.key.toLowerCase() === "y") this.redo();
    else return;
    event.preventDefault();
  }

  /** The drawing as an SVG file. */
  get svg() {
    const paths = this.editor.state.strokes.map((stroke) => `<path d="${this.outlinesOf(stroke).ours.d}"/>`);
    return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${this.height}">${paths.join("")}</svg>\n`;
  }

  download() {
    save(document, "ink.svg", new Blob([this.svg], { type: "image/svg+xml" }));
  }

  /** @param {Outline[]} outlines @param {unknown} live */
  strokes(outlines, live) {
    return svg`
      ${outlines.map(({ d }) => svg`<path class="ink" d=${d} />`)}${live}
      ${this.marked ? svg`<path class="nodes" d=${outlines.map(({ nodes }) => nodes).join("")} />` : ""}
    `;
  }

  /** @param {Outline[]} ours @param {Outline[]} theirs */
  table(ours, theirs) {
    const sum = (/** @type {Outline[]} */ all, /** @type {(outline: Outline) => number} */ of) =>
      all.reduce((total, outline) => total + of(outline), 0);
    const largest = (/** @type {Outline[]} */ all) => Math.max(0, ...all.map(({ error }) => error));
    const row = (/** @type {string} */ name, /** @type {(all: Outline[]) => string} */ text) =>
      html`<tr><th scope="row">${name}</th><td>${text(ours)}</td><td>${text(theirs)}</td></tr>`;
    return html`
      <div class="table"><table>
        <thead><tr><td></td><th scope="col">casteljau</th><th scope="col">perfect-freehand</th></tr></thead>
        <tbody>
          ${row("Curves of the outline", (all) => String(sum(all, ({ count }) => count)))}
          ${row("Path data", (all) => `${decimal(sum(all, ({ d }) => d.length) / 1000, 1)} kB`)}
          ${row("Greatest distance from the pen", (all) => decimal(largest(all)))}
        </tbody>
      </table></div>
    `;
  }

  /** What of the drawing is there after a reload. */
  keptInWords() {
    const { length } = this.editor.state.strokes;
    if (this.kept === length) return "The drawing is kept in this browser.";
    return this.kept > 0
      ? `Only the last ${this.kept} are kept in this browser.`
      : "This browser does not keep the drawing.";
  }

  render() {
    const { strokes } = this.editor.state;
    const outlines = strokes.map((stroke) => this.outlinesOf(stroke));
    const [ours, theirs] = [outlines.map(({ ours }) => ours), outlines.map(({ theirs }) => theirs)];
    const samples = strokes.reduce((sum, stroke) => sum + stroke.samples.length, 0);
    const box = `0 0 ${WIDTH} ${this.height}`;
    const { live } = this;
    const wet = live && [...live.settled, live.open].map((d) => svg`<path class="ink" d=${d} />`);
    return html`
      <div class="frame panes ${this.marked ? "outlined" : ""}" @keydown=${this.key}>
        <div class="pane">
          <div class="view surface"><b>Draw here</b>
            <svg class="pad" viewBox=${box} tabindex="0" role="img" aria-label="Drawing surface with ${strokes.length} strokes"
              @pointerdown=${this.draw}>${this.strokes(ours, wet)}</svg>
          </div>
          <div class="controls">
            <div class="row">
              <button ?disabled=${!this.editor.canUndo} @click=${this.undo}>Undo</button>
              <button ?disabled=${!this.editor.canRedo} @click=${this.redo}>Redo</button>
              <button ?disabled=${!strokes.length} @click=${() => this.change(() => ({ strokes: [], height: 0 }))}>Clear</button>
              <button @click=${() => this.add({ device: false, samples: hand(260, 1 + strokes.length) })}>Add a sample stroke</button>
              <button ?disabled=${!strokes.length} @click=${this.download}>Download SVG</button>
            </div>
            ${check({ name: "Show the points", value: this.marked, change: (marked) => (this.marked = marked) })}
          </div>
          <p class="facts" role="status">${strokes.length} ${strokes.length === 1 ? "stroke" : "strokes"}, ${samples} samples. ${this.keptInWords()}</p>
        </div>
        <div class="pane side">
          <div class="controls settings">
            ${SLIDERS.map(([key, name, min, max, step]) =>
              slider({
                name,
                value: this.settings[key],
                min,
                max,
                step,
                text: step < 1 ? decimal(this.settings[key]) : String(this.settings[key]),
                change: (value) => (this.settings = { ...this.settings, [key]: value }),
              }),
            )}
          </div>
          <div class="view peer"><b>perfect-freehand</b>
            <svg viewBox=${box} role="img" aria-label="The same strokes by perfect-freehand">
              ${this.strokes(theirs, live && svg`<path class="ink" d=${live.peer} />`)}</svg>
          </div>
          ${this.table(ours, theirs)}
          <p class="note">
            Without a pen, the widths of the two differ: casteljau computes the speed from the positions and the times of the samples, perfect-freehand from the positions alone, as if samples always came at the
            same rate.
          </p>
        </div>
      </div>
    `;
  }
}

/** Small squares, as path data. @param {{ x: number, y: number }[]} points */
function nodesOf(points) {
  return points.map(({ x, y }) => `M${(x - 1).toFixed(1)},${(y - 1).toFixed(1)}h2v2h-2z`).join("");
}
