// The editor of a letter: outline, points, joints; what it looks like in small and in large; in and out as SVG.
import { css, html, svg } from "lit";
import { codeBox } from "../figures/code-box.js";
import { Figure } from "../figures/figure.js";
import { check, handle, list, polyline, slider } from "../figures/parts.js";
import { decimal, short } from "../figures/words.js";
import { EM, GLYPHS, GUIDES } from "./glyphs.js";
import { History } from "./history.js";
import { addRound, bendOrStraighten, countPoints, fromSvg, insert, MODES, movePoint, nodesOf, pathOf, remove, reverse, setMode, toCubics, toQuadratics } from "./outline.js";
import { fitted, panned, zoomed } from "./view.js";

const SIZES = [12, 18, 28, 44, 72, 112];
const SIDE_BEARING = 0.09;
const ZOOM_STEP = 1.5;
const PAN_KEY_PX = 40;
/** Farther outside of the picture a point has no handle. */
const HANDLE_MARGIN_PX = 12;
const PRECISION = 2;
/** Closer than this, arrow keys take small steps. */
const CLOSE_UNITS = 200;

/** @typedef {import("./outline.js").Outline} Outline */
/** @typedef {import("./outline.js").Place} Place */

/** What is true at a joint, in words. @param {import("./outline.js").Contour} contour @param {number} joint */
export function truth({ spline }, joint) {
  if (!spline.closed && (joint === 0 || joint === spline.segmentCount)) return "an open end";
  const { g1, c1, g2, c2, angle } = spline.continuity(joint);
  if (!g1) return `a corner of ${decimal((angle * 180) / Math.PI, 1)}°`;
  return ["G1", ...(c1 ? ["C1"] : []), ...(g2 ? ["G2"] : []), ...(c2 ? ["C2"] : [])].join(", ");
}

/** `<glyph-editor>` */
export class GlyphEditor extends Figure {
  static properties = {
    outline: { attribute: false }, chosen: { state: true }, view: { state: true }, tolerance: { state: true }, filled: { state: true }, ghost: { state: true }, problem: { state: true }, pointer: { state: true },
  };
  static styles = [Figure.styles, css`
    .ink { fill: var(--ink); fill-opacity: 0.16; stroke: none; fill-rule: nonzero; }
    .ink.solid { fill-opacity: 1; }
    .guide { stroke: var(--level1); stroke-width: 1; stroke-dasharray: 3 5; fill: none; }
    .rod { fill: none; stroke: var(--handle); stroke-width: 1.25; }
    .way { fill: var(--ink); stroke: var(--paper); stroke-width: 1; }
    .picked { fill: none; stroke: var(--accent); stroke-width: 2.5; }
    .sheet { cursor: grab; touch-action: pan-y; }
    .sheet:active { cursor: grabbing; }
    .sheet:focus-visible { outline-offset: -3px; }
    textarea { font: 0.8125rem/1.5 ui-monospace, Menlo, Consolas, monospace; inline-size: 100%; min-block-size: 7.5rem; color: inherit; background: var(--paper); border: 1px solid var(--field); border-radius: 7px; padding: 0.5rem 0.6rem; resize: vertical; }
    .in { display: block; padding: 0.7rem 0.9rem; }
    .in > span { display: block; font-weight: 600; }
    .proof { padding: 0.3rem 0.9rem 0.7rem; }
    .proof path { fill: var(--ink); }
  `];

  constructor() {
    super();
    /** @type {Outline} what is shown; while a point is dragged, ahead of the history */
    this.outline = fromSvg(GLYPHS.a);
    this.history = new History(this.outline);
    /** @type {{ c: number, index: number }} contour and control point */
    this.chosen = { c: 0, index: 5 };
    /** @type {import("./view.js").View | null} null: all of it */
    this.view = null;
    this.tolerance = 1;
    this.filled = false;
    this.ghost = false;
    this.problem = "";
    /** @type {Place | null} */
    this.pointer = null;
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has("outline")) {
      this.path = pathOf(this.outline);
      const contour = this.outline[this.chosen.c];
      if (!contour) this.chosen = { c: 0, index: 0 };
      else if (this.chosen.index >= contour.spline.controlPoints().length / 2) this.chosen = { c: this.chosen.c, index: 0 };
    }
    // Measuring is for finished drags: it takes longer than a frame may.
    if (this.history.now !== this.measured || changed.has("tolerance")) {
      this.measured = this.history.now;
      this.quadratic = toQuadratics(this.measured, this.tolerance);
    }
  }

  /** Takes an outline for good: one step of undo. @param {Outline} outline */
  take(outline) {
    if (outline.length === 0) {
      this.problem = "The last contour stays: a letter needs one.";
      this.outline = this.history.now;
      return;
    }
    this.problem = "";
    this.outline = outline;
    if (this.history.push(outline)) this.tell();
    this.requestUpdate();
  }

  /** @param {string} d @param {boolean} [fit] */
  import(d, fit = true) {
    try {
      this.take(fromSvg(d));
      if (fit) this.view = null;
    } catch (error) {
      const { message, offset } = /** @type {Error & { offset?: number }} */ (error);
      this.problem = `Not taken: ${message}${offset === undefined ? "" : ` (at character ${offset})`}. The last good outline is kept.`;
    }
  }

  undo() {
    this.outline = this.history.undo();
    this.tell();
  }

  redo() {
    this.outline = this.history.redo();
    this.tell();
  }

  get selected() {
    const contour = this.outline[this.chosen.c];
    const node = nodesOf(contour.spline)[this.chosen.index];
    return { contour, node };
  }

  get aspect() {
    return this.wide < 520 ? 1.05 : 0.72;
  }

  get seen() {
    const box = /** @type {NonNullable<ReturnType<import("casteljau").Path["controlBounds"]>>} */ (this.path.controlBounds());
    return this.view ?? fitted(box, this.aspect);
  }

  /** From units to pixels and back. */
  scales() {
    const { x, y, units } = this.seen;
    const scale = this.wide / units;
    return {
      scale,
      height: Math.round(this.wide * this.aspect),
      matrix: [scale, 0, 0, scale, -x * scale, -y * scale],
      place: (/** @type {readonly number[]} */ [px, py]) => /** @type {Place} */ ([(px - x) * scale, (py - y) * scale]),
      unplace: (/** @type {readonly number[]} */ [px, py]) => /** @type {Place} */ ([x + px / scale, y + py / scale]),
    };
  }

  /** @param {number} factor @param {Place} [around] */
  zoom(factor, around) {
    const { unplace, height } = this.scales();
    this.view = zoomed(this.seen, factor, around ?? unplace([this.wide / 2, height / 2]), this.wide);
  }

  /** Where an event is, in units. @param {MouseEvent} event @returns {Place} */
  locate(event) {
    const rect = /** @type {Element} */ (this.renderRoot.querySelector(".sheet")).getBoundingClientRect();
    return this.scales().unplace([((event.clientX - rect.left) * this.wide) / rect.width, ((event.clientY - rect.top) * this.wide) / rect.width]);
  }

  /** @param {PointerEvent} start */
  pan(start) {
    if (start.button !== 0) return;
    const target = /** @type {Element} */ (start.currentTarget);
    target.setPointerCapture(start.pointerId);
    const view = this.seen;
    const ends = new AbortController();
    const move = (/** @type {any} */ event) => (this.view = panned(view, event.clientX - start.clientX, event.clientY - start.clientY, this.wide));
    target.addEventListener("pointermove", move, { signal: ends.signal });
    for (const type of ["pointerup", "pointercancel"]) target.addEventListener(type, () => ends.abort(), { signal: ends.signal });
  }

  /** A pinch, or Ctrl and the wheel; the wheel alone scrolls the page. @param {WheelEvent} event */
  wheel(event) {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    this.zoom(Math.exp(-event.deltaY / 200), this.locate(event));
  }

  /** @param {KeyboardEvent} event */
  sheetKey(event) {
    /** @type {Record<string, () => void>} */
    const keys = {
      "+": () => this.zoom(ZOOM_STEP), "=": () => this.zoom(ZOOM_STEP), "-": () => this.zoom(1 / ZOOM_STEP), 0: () => (this.view = null),
      ArrowLeft: () => (this.view = panned(this.seen, PAN_KEY_PX, 0, this.wide)), ArrowRight: () => (this.view = panned(this.seen, -PAN_KEY_PX, 0, this.wide)),
      ArrowUp: () => (this.view = panned(this.seen, 0, PAN_KEY_PX, this.wide)), ArrowDown: () => (this.view = panned(this.seen, 0, -PAN_KEY_PX, this.wide)),
    };
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    keys[event.key]();
  }

  /** Keys of the whole editor, but not while text is written. @param {KeyboardEvent} event */
  key(event) {
    const target = /** @type {HTMLElement} */ (event.composedPath()[0]);
    if (target.localName === "textarea") return;
    const control = event.ctrlKey || event.metaKey;
    const name = event.key.toLowerCase();
    if (control && name === "z" && !event.shiftKey) this.undo();
    else if (control && (name === "y" || (name === "z" && event.shiftKey))) this.redo();
    else if (!control && (event.key === "Delete" || event.key === "Backspace") && target.closest(".handle")) this.deleteChosen();
    else if (!control && name === "i" && target.closest(".handle")) this.insertAfter();
    else return;
    event.preventDefault();
  }

  deleteChosen() {
    const { node } = this.selected;
    if (node.on) this.take(remove(this.outline, this.chosen.c, node.joint));
    else this.take(bendOrStraighten(this.outline, this.chosen.c, node.joint));
  }

  insertAfter() {
    const { contour, node } = this.selected;
    const k = Math.min(node.joint, contour.spline.segmentCount - 1);
    this.take(insert(this.outline, this.chosen.c, k + 0.5));
  }

  /** Twice clicked on the outline: a point there. @param {MouseEvent} event */
  insertHere(event) {
    const near = this.path.nearest(this.locate(event));
    if (!near || near.distance * this.scales().scale > 14) return;
    this.take(insert(this.outline, near.subpath, near.t));
  }

  /** An arrow in the middle of every contour's longest segment. */
  ways(/** @type {(point: readonly number[]) => Place} */ place) {
    return this.outline.map(({ spline }) => {
      const segments = spline.segments();
      const longest = segments.reduce((best, segment) => (segment.length() > best.length() ? segment : best));
      const { x, y } = longest.eval(0.5);
      const tangent = longest.tangent(0.5);
      const [px, py] = place([x, y]);
      const [dx, dy] = [tangent.x, tangent.y];
      return svg`<path class="way" d="M${px + 10 * dx} ${py + 10 * dy}L${px - 6 * dx - 7 * dy} ${py - 6 * dy + 7 * dx}L${px - 6 * dx + 7 * dy} ${py - 6 * dy - 7 * dx}Z" />`;
    });
  }

  sheet() {
    const { place, unplace, height, matrix } = this.scales();
    const visible = ([x, y] = /** @type {Place} */ ([0, 0])) => x > -HANDLE_MARGIN_PX && y > -HANDLE_MARGIN_PX && x < this.wide + HANDLE_MARGIN_PX && y < height + HANDLE_MARGIN_PX;
    const nodes = this.outline.flatMap(({ spline }, c) => nodesOf(spline).map((node) => ({ ...node, c })));
    const shown = nodes.filter((node) => visible(place(node.at)));
    const rods = this.outline.flatMap(({ spline }) => spline.segments().flatMap((segment) => {
      const flat = segment.transform(matrix).controlPoints();
      const n = flat.length;
      return segment.degree > 1 ? [polyline("rod", flat.subarray(0, 4)), polyline("rod", flat.subarray(n - 4))] : [];
    }));
    const reach = this.seen.units * 4;
    const box = { min: [this.seen.x - reach, this.seen.y - reach], max: [this.seen.x + reach, this.seen.y + reach] };
    const [sx, sy] = place(this.selected.node.at);
    const counts = countPoints(this.outline);
    return html`
      <svg class="sheet" viewBox="0 0 ${this.wide} ${height}" role="img" tabindex="0" @pointerdown=${this.pan} @wheel=${this.wheel} @keydown=${this.sheetKey} @dblclick=${this.insertHere}
        @pointermove=${(/** @type {PointerEvent} */ event) => (this.pointer = this.locate(event))} @pointerleave=${() => (this.pointer = null)}
        aria-label="The outline: ${this.outline.length} contours, ${counts.on} points on it and ${counts.off} beside it. Plus and minus zoom, arrow keys move the picture, zero shows all">
        ${GUIDES.map(([name, y]) => svg`<path class="guide" d="M0 ${place([0, y])[1]}H${this.wide}" /><text class="quiet" x="8" y=${place([0, y])[1] - 4}>${name}</text>`)}
        <path class="ink ${this.filled ? "solid" : ""}" d=${this.path.transform(matrix).toSVG({ precision: PRECISION })} />
        ${this.ghost ? svg`<path class="ghost" d=${pathOf(this.quadratic.outline).transform(matrix).toSVG({ precision: PRECISION })} />` : ""}
        <path class="curve" d=${this.path.transform(matrix).toSVG({ precision: PRECISION })} stroke-width="2" />
        ${rods}${this.ways(place)}
        ${this.ghost ? this.quadratic.outline.flatMap(({ spline }) => nodesOf(spline).map(({ at, on }) => {
          const [x, y] = place(at);
          return visible([x, y]) ? svg`<circle class="hollow" cx=${x} cy=${y} r=${on ? 4 : 2.5} stroke="var(--quiet)" />` : "";
        })) : ""}
        ${shown.map(({ at, on }) => {
          const [x, y] = place(at);
          return on ? svg`<circle class="on" cx=${x} cy=${y} r="5.5" />` : svg`<rect class="off" x=${x - 4.5} y=${y - 4.5} width="9" height="9" />`;
        })}
        <circle class="picked" cx=${sx} cy=${sy} r="11" />
      </svg>
      ${shown.map(({ at, on, index, c }) => handle({
        name: `Contour ${c + 1}, ${on ? "point" : "handle"} ${index}`, kind: on ? "on" : "off", at, place, unplace, size: [this.wide, height], box: /** @type {any} */ (box), step: this.seen.units < CLOSE_UNITS ? 0.1 : 1,
        say: (value) => short(value, 1), move: (to) => (this.outline = movePoint(this.history.now, c, index, to)), done: () => this.take(this.outline), cancel: () => (this.outline = this.history.now), focus: () => (this.chosen = { c, index }),
      }))}
    `;
  }

  joint() {
    const { contour, node } = this.selected;
    const { c } = this.chosen;
    const segment = contour.spline.segments()[Math.min(node.joint, contour.spline.segmentCount - 1)];
    const clockwise = contour.spline.area() > 0; // y down: what turns clockwise as seen counts as positive
    return html`
      <p class="facts chosen">
        ${node.on ? html`Point ${node.index} of contour ${c + 1}: <b class="truth">${truth(contour, node.joint)}</b>.` : html`Handle ${node.index} of contour ${c + 1}.`}
        It is at (${node.at.map((value) => short(value, 1)).join(", ")}). The contour runs <b class="direction">${clockwise ? "clockwise ↻" : "counter-clockwise ↺"}</b>.
        ${this.pointer ? html`<span class="winding">Around the pointer the outline winds ${decimal(this.path.winding(this.pointer), 0)} times.</span>` : ""}
      </p>
      <div class="controls">
        ${node.on ? list({ name: "Joint", options: MODES.map((mode) => [mode, mode === "free" ? "free" : mode.toUpperCase().replace("AUTO", "auto")]), value: contour.modes[node.joint], change: (mode) => this.take(setMode(this.outline, c, node.joint, /** @type {"free"} */ (mode))) }) : ""}
        <div class="row">
          <button @click=${this.insertAfter}>Add a point behind</button>
          <button @click=${this.deleteChosen}>${node.on ? "Delete the point" : "Straighten"}</button>
          ${node.on ? html`<button @click=${() => this.take(bendOrStraighten(this.outline, c, Math.min(node.joint, contour.spline.segmentCount - 1)))}>${segment.degree === 1 ? "Line to curve" : "Curve to line"}</button>` : ""}
          <button @click=${() => this.take(reverse(this.outline, c))}>Turn contour round</button>
          <button ?disabled=${this.outline.length < 2} @click=${() => this.take(this.outline.filter((_, k) => k !== c))}>Delete contour</button>
          <button @click=${() => this.addContour()}>Add contour</button>
        </div>
      </div>
    `;
  }

  addContour() {
    const { unplace, height } = this.scales();
    const next = addRound(this.outline, /** @type {Place} */ (unplace([this.wide / 2, height / 2]).map(Math.round)), Math.max(1, Math.round(this.seen.units / 10)));
    this.take(next);
    this.chosen = { c: next.length - 1, index: 0 };
  }

  tools() {
    return html`
      <div class="controls first">
        <div class="row" role="group" aria-label="Letters">${Object.entries(GLYPHS).map(([name, d]) => html`<button @click=${() => this.import(d)}>${name}</button>`)}</div>
        <div class="row">
          <button ?disabled=${!this.history.canUndo} @click=${this.undo}>Undo</button><button ?disabled=${!this.history.canRedo} @click=${this.redo}>Redo</button>
        </div>
        <div class="row" role="group" aria-label="Zoom">
          <button aria-label="Zoom out" @click=${() => this.zoom(1 / ZOOM_STEP)}>−</button><button aria-label="Zoom in" @click=${() => this.zoom(ZOOM_STEP)}>+</button>
          <button @click=${() => this.zoom(8, this.selected.node.at)}>Close-up of the point</button><button @click=${() => (this.view = null)}>All</button>
        </div>
        ${check({ name: "filled", value: this.filled, change: (on) => (this.filled = on) })}
      </div>
    `;
  }

  /** The letter in running sizes. */
  proof() {
    const box = /** @type {{ min: { x: number, y: number }, max: { x: number, y: number } }} */ (this.path.bounds());
    const advance = box.max.x - box.min.x + 2 * SIDE_BEARING * EM;
    const d = this.path.toSVG({ precision: PRECISION });
    /** @type {unknown[]} */
    const letters = [];
    let [x, line, base] = [6, 0, 96];
    for (const size of SIZES) {
      for (let i = 0; i < 3; i++) {
        const width = (advance * size) / EM;
        if (x + width > this.wide - 6) [x, line, base] = [6, line + 1, base + size * 1.15];
        letters.push(svg`<path d=${d} transform="translate(${x + SIDE_BEARING * size} ${base}) scale(${size / EM}) translate(${-box.min.x} -800)" />`);
        x += width;
      }
    }
    const below = Math.max(8, ((box.max.y - 800) * SIZES[SIZES.length - 1]) / EM + 6);
    return html`<svg viewBox="0 0 ${this.wide} ${base + below}" role="img" aria-label="The letter at ${SIZES.join(", ")} pixels">${letters}</svg>`;
  }

  conversion() {
    const { outline, error } = this.quadratic;
    const [mine, theirs] = [countPoints(this.history.now), countPoints(outline)];
    return html`
      <div class="frame">
        <div class="table first" tabindex="0" role="region" aria-label="Points of both outlines">
          <table>
            <thead><tr><th>Outline</th><th>points on it</th><th>beside it</th><th>together</th><th>distance</th></tr></thead>
            <tbody>
              <tr><th scope="row">As it is</th><td>${mine.on}</td><td>${mine.off}</td><td class="mine">${mine.all}</td><td>0</td></tr>
              <tr><th scope="row">As quadratics</th><td>${theirs.on}</td><td>${theirs.off}</td><td class="theirs">${theirs.all}</td><td class="error" data-error=${error}>${decimal(error, 3)}</td></tr>
            </tbody>
          </table>
        </div>
        <div class="controls">
          ${slider({ name: "Tolerance", value: Math.log10(this.tolerance), min: -2, max: 1.5, step: 0.05, text: `${short(this.tolerance, 3)} units`, change: (power) => (this.tolerance = Number((10 ** power).toPrecision(3))) })}
          ${check({ name: "show the quadratics", value: this.ghost, change: (on) => (this.ghost = on) })}
          <div class="row">
            <button @click=${() => this.take(outline)}>Make it quadratic</button>
            <button @click=${() => this.take(toCubics(this.outline))}>Make it cubic</button>
          </div>
        </div>
      </div>
    `;
  }

  render() {
    const d = this.path.toSVG({ precision: PRECISION });
    const { min, max } = /** @type {{ min: { x: number, y: number }, max: { x: number, y: number } }} */ (this.path.bounds());
    const box = [Math.floor(min.x), Math.floor(min.y), Math.ceil(max.x - Math.floor(min.x)), Math.ceil(max.y - Math.floor(min.y))];
    return html`
      <div @keydown=${this.key}>
        <div class="frame">
          ${this.tools()}
          <div class="stage">${this.sheet()}</div>
          <p class="problem" role="alert">${this.problem}</p>
          ${this.joint()}
        </div>
        <h2>In small and in large</h2>
        <p class="say">One outline serves all sizes. Zoom in above as far as you like: an outline has no pixels and no facets.</p>
        <div class="frame"><div class="stage proof">${this.proof()}</div></div>
        <h2>Quadratic or cubic?</h2>
        <p class="say">
          Fonts of the TrueType kind know lines and quadratic curves only; those of the PostScript kind have cubics. A quadratic is always a cubic too. The other way, a cubic becomes as many quadratics as it takes to
          keep within a tolerance. The em of these letters has ${EM} units. The distance in the table is measured.
        </p>
        ${this.conversion()}
        <h2>In and out</h2>
        <div class="frame">
          <label class="in"><span>SVG path data: change it, or paste your own</span>
            <textarea spellcheck="false" .value=${d} @change=${(/** @type {Event} */ event) => this.import(/** @type {HTMLTextAreaElement} */ (event.target).value)}></textarea></label>
          ${codeBox({ name: "SVG", text: `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box.join(" ")}">\n  <path d="${d}"/>\n</svg>` })}
          ${codeBox({ name: "JavaScript", text: `import { Path } from "casteljau";\n\nconst letter = Path.fromSVG("${d}");\nletter.area(); // ${this.path.area()}\nletter.bounds(); // x ${short(min.x)} to ${short(max.x)}, y ${short(min.y)} to ${short(max.y)}` })}
        </div>
      </div>
    `;
  }
}
