// A live figure as it stands in the page before its script runs: the first picture, its handles, and controls for its other inputs.
import { handlesOf } from "../live/handles.js";
import { inspect } from "../live/inspect.js";
import { viewOf } from "../live/projection.js";
import { escapeHtml } from "../../build/highlight.js";
import { runEntry } from "./run.js";

/**
 * @import { Entry } from "./entries.js"
 * @import { Input } from "./sample.js"
 */

/**
 * What a figure shows at first.
 *
 * @param {Entry} entry
 */
export async function firstPicture(entry) {
  const { inputs, drawing, printed } = await runEntry(entry);
  const values = Object.fromEntries(inputs.map((/** @type {Input} */ input) => [input.name, input.value]));
  const handles = handlesOf(inputs, values);
  const info = entry.draw?.info ?? "";
  const inSpace = drawing.extent.some(([, , z]) => z !== 0) || handles.some(({ point }) => point.length === 3);
  const space = inSpace || info.includes("space");
  const extent = [
    ...drawing.extent,
    ...handles.map(({ point }) => /** @type {any} */ ([point[0], point[1], point[2] ?? 0])),
  ];
  const view = viewOf(extent, { down: info.includes("down"), space });
  return { inputs, values, handles, view, drawing, printed };
}

/** @param {string} page @param {string} id @param {Entry} entry */
export async function figureHtml(page, id, entry) {
  const { inputs, view, drawing } = await firstPicture(entry);
  const controls = inputs.map(controlHtml).join("") + (view.space ? turnHtml(view.turn) : "");
  const hint = entry.figure ? `<p class="hint">${escapeHtml(entry.figure)}</p>` : "";
  return `<live-figure data-page="${page}" data-entry="${id}" data-view="${escapeHtml(JSON.stringify(view))}" data-inputs="${escapeHtml(JSON.stringify(inputs))}">
<div class="view" style="aspect-ratio: ${view.width} / ${view.height}">${drawing.toSVG(view)}</div>
${controls ? `<div class="inputs">${controls}</div>` : ""}${hint}</live-figure>`;
}

/** @param {Input} input */
function controlHtml({ name, kind, value, min, max, step, options = [] }) {
  if (kind === "number") {
    return `<label><code>${name}</code> <input type="range" name="${name}" min="${min}" max="${max}" step="${step}" value="${value}" disabled> <output>${inspect(value)}</output></label>`;
  }
  if (kind !== "choice") return "";
  const items = options.map((option) => `<option>${escapeHtml(String(option))}</option>`);
  return `<label><code>${name}</code> <select name="${name}" disabled>${items.join("")}</select></label>`;
}

/** @param {number} turn */
const turnHtml = (turn) =>
  `<label>turn (°) <input type="range" data-turn min="-180" max="180" step="5" value="${turn}" disabled> <output>${turn}</output></label>`;
