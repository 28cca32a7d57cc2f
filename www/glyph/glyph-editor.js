// <glyph-editor>: the outline of a letter with its points and joints, at all sizes; import and export as SVG.
import { arrowDirection } from "#js/ui/keys.js";
import { PressedPointers } from "#js/ui/pressed-pointers.js";
import { css, html } from "lit";
import { codeTabs } from "../figures/lib/code-box.js";
import { Figure } from "../figures/lib/figure.js";
import { short } from "../figures/lib/numbers.js";
import { PANES, toolStyle } from "../figures/lib/tool.js";
import { EM, GLYPHS } from "./glyphs.js";
import { Editor } from "#js/editor/editor.js";
import {
  addRound,
  bendOrStraighten,
  fromSvg,
  insert,
  MODES,
  nodesOf,
  pathOf,
  remove,
  setMode,
  toQuadratics,
} from "./outline.js";
import { hasOverlaps } from "./regions.js";
import { conversion, joint, proof, regionTools, tools } from "./panels.js";
import { outlineView } from "./outline-view.js";
import { fitted, panned, zoomed } from "./view.js";

const ZOOM_STEP = 1.5;
const PAN_KEY_PX = 40;
const PRECISION = 2;
/** The width of the pane beside the picture. */
const SIDE_PX = 424;
/** The part of the window's height that the bar, the heading and the tools need. */
const AROUND_PICTURE_PX = 272;
const MIN_HEIGHT_PX = 320;
/** A double click is on the outline within so many pixels. */
const NEAR_PX = 14;

/** @typedef {import("./outline.js").Outline} Outline */
/** @typedef {import("./outline.js").Place} Place */

/** `<glyph-editor>` */
export class GlyphEditor extends Figure {
  static properties = {
    outline: { attribute: false },
    chosen: { state: true },
    view: { state: true },
    tolerance: { state: true },
    strokeWidth: { state: true },
    offsetDistance: { state: true },
    filled: { state: true },
    ghost: { state: true },
    problem: { state: true },
    fieldProblem: { state: true },
    code: { state: true },
    pointer: { state: true },
  };
  static styles = [
    Figure.styles,
    toolStyle,
    css`
    :host { --side: ${SIDE_PX}px; }
    .ink { fill: var(--ink); fill-opacity: 0.16; stroke: none; fill-rule: nonzero; }
    .ink.solid { fill-opacity: 1; }
    .guide { stroke: var(--level1); stroke-width: 1; stroke-dasharray: 3 5; fill: none; }
    .rod { fill: none; stroke: var(--handle); stroke-width: 1.25; }
    .way { fill: var(--ink); stroke: var(--paper); stroke-width: 1; }
    .picked { fill: none; stroke: var(--accent); stroke-width: 2.5; }
    .outline-view { cursor: grab; touch-action: pan-y; }
    .outline-view:active { cursor: grabbing; }
    .outline-view:focus-visible { outline-offset: -3px; }
    textarea { font: 0.8125rem/1.5 ui-monospace, Menlo, Consolas, monospace; inline-size: 100%; min-block-size: 7.5rem; color: inherit; background: var(--paper); border: 1px solid var(--field); border-radius: 7px; padding: 0.5rem 0.6rem; resize: vertical; }
    .in { display: block; padding: 0.7rem 0.9rem; }
    .in > span { display: block; font-weight: 600; }
    .proof { padding: 0.3rem 0.9rem 0.7rem; }
    .operation { display: flex; align-items: center; gap: 0.8rem; }
    .operation .slider { flex: 1; display: grid; grid-template-columns: 6.5rem minmax(0, 1fr) 2em; }
    .operation .slider input { min-inline-size: 0; }
    .operation button { min-inline-size: 8.2rem; }
    @media (max-width: 30rem) { .operation { flex-wrap: wrap; } .operation > * { flex: 1 1 100% !important; } }
    .group { display: grid; gap: 0.5rem; padding: 0.3rem 0.9rem 0.6rem; }
    .group .name { color: var(--quiet); font-size: 0.8125rem; font-weight: 600; }
    .group .problem { padding-inline-end: 0; border-block-start: 0; }
    .frame + .say { margin-block-start: 1.5rem; }
    .keys { padding: 0.4rem 0.9rem 0.6rem; }
    .keys summary { cursor: pointer; min-block-size: 24px; }
    .keys p { margin: 0.3rem 0 0; text-wrap: pretty; }
    kbd { font: 600 0.8em/1 ui-monospace, Menlo, Consolas, monospace; border: 1px solid var(--field); border-radius: 4px; padding: 0.1em 0.35em; }
    .proof path { fill: var(--ink); }
  `,
  ];

  constructor() {
    super();
    /** @type {Outline} what is shown; while a point is dragged, ahead of the editor */
    this.outline = fromSvg(GLYPHS.a);
    this.editor = new Editor({ outline: this.outline });
    this.path = pathOf(this.outline);
    /** Which outline the quadratics are of. @type {Outline | null} */
    this.measured = null;
    /** @type {{ outline: Outline, error: number }} */
    this.quadratic = { outline: [], error: 0 };
    /** @type {{ c: number, index: number }} contour and control point */
    this.chosen = { c: 0, index: 5 };
    /** @type {import("./view.js").View | null} null: all of it */
    this.view = null;
    this.tolerance = 1;
    this.strokeWidth = 24;
    this.offsetDistance = 12;
    this.filled = false;
    this.ghost = false;
    /** Why an operation was refused, and why a text was. */
    this.problem = "";
    this.fieldProblem = "";
    this.code = 0;
    this.hasOverlaps = false;
    /** @type {Place | null} */
    this.pointer = null;
    /** Those on the picture. */
    this.pointers = new PressedPointers({ move: (before, after) => this.panTo(before, after) });
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has("outline")) {
      this.path = pathOf(this.outline);
      const contour = this.outline[this.chosen.c];
      if (!contour) this.chosen = { c: 0, index: 0 };
      else if (this.chosen.index >= contour.spline.controlPoints().length / 2)
        this.chosen = { c: this.chosen.c, index: 0 };
    }
    // Measuring is for finished drags: it takes longer than a frame may.
    if (this.editor.state.outline !== this.measured || changed.has("tolerance")) {
      this.measured = this.editor.state.outline;
      this.quadratic = toQuadratics(this.measured, this.tolerance);
      this.hasOverlaps = hasOverlaps(this.measured);
    }
  }

  updated() {
    // A button that is disabled now would lose the focus, and with it the keys.
    const root = /** @type {ShadowRoot} */ (this.renderRoot);
    if (root.activeElement?.matches(":disabled"))
      /** @type {SVGElement} */ (root.querySelector(".outline-view")).focus({ preventScroll: true });
  }

  /** Takes an outline for good: one step of undo. @param {Outline} outline */
  take(outline) {
    if (outline.length === 0) {
      this.problem = "The last contour cannot be deleted.";
      this.outline = this.editor.state.outline;
      return;
    }
    this.problem = this.fieldProblem = "";
    this.outline = outline;
    if (outline !== this.editor.state.outline) {
      this.editor.dispatch(() => ({ outline }), { by: "page" });
      this.notifyChange();
    }
    this.requestUpdate();
  }

  /** Replaces the outline by what an operation makes of it: one step of undo. @param {(outline: Outline) => Outline} operation */
  change(operation) {
    try {
      const outline = operation(this.outline);
      if (outline.length === 0) this.problem = "Nothing would be left of the outline, so it is kept.";
      else this.take(outline);
    } catch (error) {
      this.problem = `The outline is kept: ${/** @type {Error} */ (error).message}.`;
    }
  }

  /** @param {string} d @param {boolean} [fit] */
  import(d, fit = true) {
    try {
      this.take(fromSvg(d));
      if (fit) this.view = null;
    } catch (error) {
      const { message, offset } = /** @type {Error & { offset?: number }} */ (error);
      this.fieldProblem = `Not taken: ${message}${offset === undefined ? "" : ` (at character ${offset})`}. The last good outline is kept.`;
    }
  }

  undo() {
    this.editor.undo();
    this.outline = this.editor.state.outline;
    this.notifyChange();
  }

  redo() {
    this.editor.redo();
    this.outline = this.editor.state.outline;
    this.notifyChange();
  }

  get selected() {
    const contour = this.outline[this.chosen.c];
    const node = nodesOf(contour.spline)[this.chosen.index];
    return { contour, node };
  }

  /** The width of the picture in CSS pixels. */
  get pictureWidth() {
    return this.wide < PANES ? this.wide : this.wide - SIDE_PX;
  }

  /** Height by width of the picture, which fits into the window. */
  get aspect() {
    const available = Math.max(MIN_HEIGHT_PX, innerHeight - AROUND_PICTURE_PX);
    return Math.min(this.wide < 520 ? 1.05 : 0.72, available / this.pictureWidth);
  }

  get seen() {
    const box = /** @type {NonNullable<ReturnType<import("casteljau").Path["controlBounds"]>>} */ (
      this.path.controlBounds()
    );
    return this.view ?? fitted(box, this.aspect);
  }

  /** From units to pixels and back. */
  scales() {
    const { x, y, units } = this.seen;
    const scale = this.pictureWidth / units;
    return {
      scale,
      height: Math.round(this.pictureWidth * this.aspect),
      matrix: [scale, 0, 0, scale, -x * scale, -y * scale],
      place: (/** @type {readonly number[]} */ [px, py]) => /** @type {Place} */ ([(px - x) * scale, (py - y) * scale]),
      unplace: (/** @type {readonly number[]} */ [px, py]) => /** @type {Place} */ ([x + px / scale, y + py / scale]),
    };
  }

  /** @param {number} factor @param {Place} [around] */
  zoom(factor, around) {
    const { unplace, height } = this.scales();
    this.view = zoomed(this.seen, factor, around ?? unplace([this.pictureWidth / 2, height / 2]), this.pictureWidth);
  }

  /** Where an event is, in units. @param {{ clientX: number, clientY: number }} event @returns {Place} */
  locate(event) {
    const rect = /** @type {Element} */ (this.renderRoot.querySelector(".outline-view")).getBoundingClientRect();
    return this.scales().unplace([
      ((event.clientX - rect.left) * this.pictureWidth) / rect.width,
      ((event.clientY - rect.top) * this.pictureWidth) / rect.width,
    ]);
  }

  /** One finger or the mouse moves the picture, two fingers zoom. @param {PointerEvent} event */
  pan(event) {
    if (event.button === 0) this.pointers.add(event);
  }

  /**
   * @param {import("#js/ui/pressed-pointers.js").Span} before
   * @param {import("#js/ui/pressed-pointers.js").Span} after
   */
  panTo(before, after) {
    this.view = panned(this.seen, after.clientX - before.clientX, after.clientY - before.clientY, this.pictureWidth);
    if (before.width > 0 && after.width > 0) this.zoom(after.width / before.width, this.locate(after));
  }

  /** A pinch, or Ctrl and the wheel; the wheel alone scrolls the page. @param {WheelEvent} event */
  wheel(event) {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    this.zoom(Math.exp(-event.deltaY / 200), this.locate(event));
  }

  /** @param {KeyboardEvent} event */
  onKey(event) {
    /** @type {Record<string, () => void>} */
    const keys = {
      "+": () => this.zoom(ZOOM_STEP),
      "=": () => this.zoom(ZOOM_STEP),
      "-": () => this.zoom(1 / ZOOM_STEP),
      0: () => (this.view = null),
    };
    const arrow = arrowDirection(event);
    if (!(arrow || keys[event.key]) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    if (arrow) this.view = panned(this.seen, -arrow[0] * PAN_KEY_PX, -arrow[1] * PAN_KEY_PX, this.pictureWidth);
    else keys[event.key]();
  }

  /** Keys of the whole editor, but not while text is written. @param {KeyboardEvent} event */
  key(event) {
    const target = /** @type {HTMLElement} */ (event.composedPath()[0]);
    if (target.localName === "textarea") return;
    const control = event.ctrlKey || event.metaKey;
    const name = event.key.toLowerCase();
    if (control && name === "z" && !event.shiftKey) this.undo();
    else if (control && (name === "y" || (name === "z" && event.shiftKey))) this.redo();
    else if (!control && (event.key === "Delete" || event.key === "Backspace") && target.closest(".handle"))
      this.deleteChosen();
    else if (!control && name === "i" && target.closest(".handle")) this.insertAfter();
    else if (!control && event.key === "Enter" && target.closest(".handle")) this.nextMode();
    else return;
    event.preventDefault();
  }

  deleteChosen() {
    const { node } = this.selected;
    if (node.on) this.take(remove(this.outline, this.chosen.c, node.joint));
    else this.take(bendOrStraighten(this.outline, this.chosen.c, node.joint));
  }

  /** The next mode for the chosen joint. */
  nextMode() {
    const { contour, node } = this.selected;
    if (node.on)
      this.take(
        setMode(
          this.outline,
          this.chosen.c,
          node.joint,
          MODES[(MODES.indexOf(contour.modes[node.joint]) + 1) % MODES.length],
        ),
      );
  }

  insertAfter() {
    const { contour, node } = this.selected;
    const k = Math.min(node.joint, contour.spline.segmentCount - 1);
    this.take(insert(this.outline, this.chosen.c, k + 0.5));
  }

  /** Twice clicked on the outline: a point there. @param {MouseEvent} event */
  insertHere(event) {
    const near = this.path.nearest(this.locate(event));
    if (!near || near.distance * this.scales().scale > NEAR_PX) return;
    this.take(insert(this.outline, near.subpath, near.t));
  }

  addContour() {
    const { unplace, height } = this.scales();
    const next = addRound(
      this.outline,
      /** @type {Place} */ (unplace([this.pictureWidth / 2, height / 2]).map(Math.round)),
      Math.max(1, Math.round(this.seen.units / 10)),
    );
    this.take(next);
    this.chosen = { c: next.length - 1, index: 0 };
  }

  render() {
    const d = this.path.toSVG({ precision: PRECISION });
    const { min, max } = /** @type {{ min: { x: number, y: number }, max: { x: number, y: number } }} */ (
      this.path.bounds()
    );
    const box = [
      Math.floor(min.x),
      Math.floor(min.y),
      Math.ceil(max.x - Math.floor(min.x)),
      Math.ceil(max.y - Math.floor(min.y)),
    ];
    return html`
      <div @keydown=${this.key}>
        <div class="frame panes">
          <div class="pane">
            <div class="stage">${outlineView(this)}</div>
            ${tools(this)}
          </div>
          <div class="pane side">
            ${joint(this)}
            ${regionTools(this)}
            <details class="keys">
              <summary>Keys</summary>
              <p>
                On a point: arrows move it (<kbd>Shift</kbd> ten steps, <kbd>Alt</kbd> a tenth), <kbd>Enter</kbd> next kind of joint, <kbd>i</kbd> a point behind it, <kbd>Delete</kbd> away with it,
                <kbd>Esc</kbd> takes a drag back. On the picture: <kbd>+</kbd> <kbd>−</kbd> zoom, arrows move, <kbd>0</kbd> shows all. Everywhere: <kbd>Ctrl</kbd>+<kbd>Z</kbd> undo, <kbd>Ctrl</kbd>+<kbd>Y</kbd> redo.
              </p>
            </details>
          </div>
        </div>
        <p class="say">
          Discs are points on the outline; squares are control points off it. A contour fills the area inside it, in whichever direction it runs. A contour inside another one that runs in the opposite direction cuts a hole, because
          the two winding numbers, 1 and −1, add up to 0. The address of this page contains your outline, so you can share it.
        </p>
        <h2>Sizes</h2>
        <p class="say">One outline is used for all sizes. It consists of curves, so it stays smooth however far you zoom in.</p>
        <div class="frame"><div class="stage proof">${proof(this)}</div></div>
        <h2>Quadratic or cubic?</h2>
        <p class="say">
          TrueType fonts contain only lines and quadratic curves; PostScript fonts contain cubics. Every quadratic curve can be written as a cubic exactly. A cubic is approximated by as many quadratic curves as the
          tolerance requires. The em of these letters has ${EM} units. The distance in the table is measured.
        </p>
        ${conversion(this)}
        <h2>Import and export</h2>
        <div class="frame">
          <label class="in"><span>SVG path data: change it, or paste your own</span>
            <textarea spellcheck="false" .value=${d} aria-describedby="field-problem" @change=${(/** @type {Event} */ event) => this.import(/** @type {HTMLTextAreaElement} */ (event.target).value)}></textarea></label>
          <p class="problem" id="field-problem" role="alert">${this.fieldProblem}</p>
          ${codeTabs({
            tabs: [
              {
                name: "SVG",
                text: `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box.join(" ")}">\n  <path d="${d}"/>\n</svg>`,
              },
              {
                name: "JavaScript",
                text: `import { Path } from "casteljau";\n\nconst letter = Path.fromSVG("${d}");\nletter.area(); // ${this.path.area()}\nletter.bounds(); // x ${short(min.x)} to ${short(max.x)}, y ${short(min.y)} to ${short(max.y)}`,
              },
            ],
            selected: this.code,
            select: (index) => (this.code = index),
          })}
        </div>
      </div>
    `;
  }
}
