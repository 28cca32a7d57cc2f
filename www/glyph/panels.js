// What stands around the picture: tools, the chosen point, running sizes, quadratics.
import { html, svg } from "lit";
import { check, list, slider } from "../figures/lib/parts.js";
import { decimal, short } from "../figures/lib/numbers.js";
import { EM, GLYPHS } from "./glyphs.js";
import { bendOrStraighten, countPoints, MODES, reverse, setMode, toCubics } from "./outline.js";
import { offset, outlineStroke, removeOverlaps, unionOfContours } from "./regions.js";

/** @typedef {import("./glyph-editor.js").GlyphEditor} GlyphEditor */

const SIZES = [12, 18, 28, 44, 72, 112];
const SIDE_BEARING = 0.09;
const ZOOM_STEP = 1.5;
const CLOSE_UP = 8;
const PRECISION = 2;

/** What is true at a joint, in words. @param {import("./outline.js").Contour} contour @param {number} joint */
export function truth({ spline }, joint) {
  if (!spline.closed && (joint === 0 || joint === spline.segmentCount)) return "an open end";
  const { g1, c1, g2, c2, angle } = spline.continuity(joint);
  if (!g1) return `a corner of ${decimal((angle * 180) / Math.PI, 1)}°`;
  return ["G1", ...(c1 ? ["C1"] : []), ...(g2 ? ["G2"] : []), ...(c2 ? ["C2"] : [])].join(", ");
}

/** What stands below the picture: letters, undo, zoom. @param {GlyphEditor} editor */
export function tools(editor) {
  return html`
    <div class="controls">
      <div class="row" role="group" aria-label="Letters">${Object.entries(GLYPHS).map(([name, d]) => html`<button @click=${() => editor.import(d)}>${name}</button>`)}</div>
      <div class="row">
        <button ?disabled=${!editor.editor.canUndo} @click=${() => editor.undo()}>Undo</button><button ?disabled=${!editor.editor.canRedo} @click=${() => editor.redo()}>Redo</button>
      </div>
      <div class="row" role="group" aria-label="Zoom">
        <button aria-label="Zoom out" @click=${() => editor.zoom(1 / ZOOM_STEP)}>−</button><button aria-label="Zoom in" @click=${() => editor.zoom(ZOOM_STEP)}>+</button>
        <button @click=${() => editor.zoom(CLOSE_UP, editor.selected.node.at)}>Close-up of the point</button><button ?disabled=${editor.view === null} @click=${() => (editor.view = null)}>All</button>
      </div>
      ${check({ name: "filled", value: editor.filled, change: (on) => (editor.filled = on) })}
    </div>
  `;
}

/** @param {GlyphEditor} editor */
export function joint(editor) {
  const { contour, node } = editor.selected;
  const { c } = editor.chosen;
  const k = Math.min(node.joint, contour.spline.segmentCount - 1);
  const segment = contour.spline.segments()[k];
  const isLast = editor.outline.length === 1 && contour.spline.segmentCount <= 2;
  const clockwise = contour.spline.area() > 0; // y down: what turns clockwise as seen counts as positive
  return html`
    <p class="facts">
      ${node.on ? html`Point ${node.index} of contour ${c + 1}: <b class="truth">${truth(contour, node.joint)}</b>.` : html`Handle ${node.index} of contour ${c + 1}.`}
      It is at (${node.at.map((value) => short(value, 1)).join(", ")}). The contour runs <b class="direction">${clockwise ? "clockwise ↻" : "counter-clockwise ↺"}</b>.
      ${editor.pointer ? html`<span class="winding">The winding number at the pointer is ${decimal(editor.path.windingNumber(editor.pointer), 0)}.</span>` : ""}
    </p>
    <div class="group" role="group" aria-labelledby="group-point">
      <span class="name" id="group-point">Point</span>
      ${list({ name: "Joint", options: MODES.map((mode) => [mode, mode === "free" ? "free" : mode.toUpperCase().replace("AUTO", "auto")]), value: node.on ? contour.modes[node.joint] : "", disabled: !node.on, change: (mode) => editor.take(setMode(editor.outline, c, node.joint, /** @type {"free"} */ (mode))) })}
      <div class="row">
        <button @click=${() => editor.insertAfter()}>Insert after</button>
        <button ?disabled=${!node.on || isLast} @click=${() => editor.deleteChosen()}>Delete point</button>
        <button @click=${() => editor.take(bendOrStraighten(editor.outline, c, k))}>${segment.degree === 1 ? "Line to curve" : "Curve to line"}</button>
      </div>
    </div>
    <div class="group" role="group" aria-labelledby="group-contour">
      <span class="name" id="group-contour">Contour</span>
      <div class="row">
        <button @click=${() => editor.take(reverse(editor.outline, c))}>Reverse contour</button>
        <button ?disabled=${editor.outline.length < 2} @click=${() => editor.take(editor.outline.filter((_, k) => k !== c))}>Delete contour</button>
        <button @click=${() => editor.addContour()}>Add contour</button>
      </div>
    </div>
  `;
}

/** Operations on the filled region. @param {GlyphEditor} editor */
export function regionTools(editor) {
  const { strokeWidth, offsetDistance } = editor;
  return html`
    <div class="group" role="group" aria-labelledby="group-shape">
      <span class="name" id="group-shape">Shape</span>
      <div class="row">
        <button ?disabled=${editor.outline.length < 2} @click=${() => editor.change(unionOfContours)}>Union of contours</button>
        <button ?disabled=${!editor.hasOverlaps} @click=${() => editor.change(removeOverlaps)}>Remove overlaps</button>
      </div>
      <div class="operation">
        ${slider({ name: "Stroke width", value: strokeWidth, min: 2, max: 120, step: 1, text: short(strokeWidth, 0), change: (width) => (editor.strokeWidth = width) })}
        <button @click=${() => editor.change((outline) => outlineStroke(outline, strokeWidth))}>Outline stroke</button>
      </div>
      <div class="operation">
        ${slider({ name: "Offset distance", value: offsetDistance, min: -60, max: 60, step: 1, text: short(offsetDistance, 0), change: (distance) => (editor.offsetDistance = distance) })}
        <button ?disabled=${offsetDistance === 0} @click=${() => editor.change((outline) => offset(outline, offsetDistance))}>Offset</button>
      </div>
      <p class="problem" role="alert">${editor.problem}</p>
    </div>
  `;
}

/** @param {import("./outline.js").Outline} outline @param {number} degree */
const hasDegree = (outline, degree) => outline.some(({ spline }) => spline.degrees.includes(degree));

/** The letter in running sizes. @param {GlyphEditor} editor */
export function proof(editor) {
  const box = /** @type {{ min: { x: number, y: number }, max: { x: number, y: number } }} */ (editor.path.bounds());
  const advance = box.max.x - box.min.x + 2 * SIDE_BEARING * EM;
  const d = editor.path.toSVG({ precision: PRECISION });
  /** @type {unknown[]} */
  const letters = [];
  let [x, line, base] = [6, 0, 96];
  for (const size of SIZES) {
    for (let i = 0; i < 3; i++) {
      const width = (advance * size) / EM;
      if (x + width > editor.wide - 6) [x, line, base] = [6, line + 1, base + size * 1.15];
      letters.push(
        svg`<path d=${d} transform="translate(${x + SIDE_BEARING * size} ${base}) scale(${size / EM}) translate(${-box.min.x} -800)" />`,
      );
      x += width;
    }
  }
  const below = Math.max(8, ((box.max.y - 800) * SIZES[SIZES.length - 1]) / EM + 6);
  return html`<svg viewBox="0 0 ${editor.wide} ${base + below}" role="img" aria-label="The letter at ${SIZES.join(", ")} pixels">${letters}</svg>`;
}

/** @param {GlyphEditor} editor */
export function conversion(editor) {
  const { outline, error } = editor.quadratic;
  const [mine, theirs] = [countPoints(editor.editor.state.outline), countPoints(outline)];
  return html`
    <div class="frame">
      <div class="table first" tabindex="0" role="region" aria-label="Points of both outlines">
        <table>
          <thead><tr><th>Outline</th><th>points on the curve</th><th>control points off it</th><th>total</th><th>distance</th></tr></thead>
          <tbody>
            <tr><th scope="row">Current</th><td>${mine.on}</td><td>${mine.off}</td><td class="mine">${mine.all}</td><td>0</td></tr>
            <tr><th scope="row">Quadratic</th><td>${theirs.on}</td><td>${theirs.off}</td><td class="theirs">${theirs.all}</td><td class="error" data-error=${error}>${decimal(error, 3)}</td></tr>
          </tbody>
        </table>
      </div>
      <div class="controls">
        ${slider({ name: "Tolerance", value: Math.log10(editor.tolerance), min: -2, max: 1.5, step: 0.05, text: `${short(editor.tolerance, 3)} units`, change: (power) => (editor.tolerance = Number((10 ** power).toPrecision(3))) })}
        ${check({ name: "show the quadratic curves", value: editor.ghost, change: (on) => (editor.ghost = on) })}
        <div class="row">
          <button ?disabled=${!hasDegree(editor.outline, 3)} @click=${() => editor.take(outline)}>Convert to quadratic</button>
          <button ?disabled=${!hasDegree(editor.outline, 2)} @click=${() => editor.take(toCubics(editor.outline))}>Convert to cubic</button>
        </div>
      </div>
    </div>
  `;
}
