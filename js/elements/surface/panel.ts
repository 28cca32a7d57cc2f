// The controls below the picture: native form controls that set the element's properties.
import { html, nothing } from "lit";
import { hasPart } from "../attribute-text.js";
import { button, checkbox, select, slider } from "../../ui/controls.js";
import {
  AXES,
  EVALUATIONS,
  HEIGHTS,
  LAYERS,
  MODELS,
  MAX_LINES,
  MAX_SEGMENTS,
  PARTS,
  SHADINGS,
  STEPS,
  toggled,
} from "./settings.js";
import {
  EVALUATION_NAMES,
  twoDigits,
  DETAIL_NAMES,
  HEIGHT_NAMES,
  LAYER_NAMES,
  MODEL_NAMES,
  PART_NAMES,
  SHADING_NAMES,
  STEP_WORDS,
} from "./words.js";
import { translated } from "../../editor/translations.js";
import type { SurfaceController } from "./controller.js";
import type { Part, Layer } from "./settings.js";

const KINDS = ["obj", "stl", "glb"] as const;
const UV_STEP = 0.01;
const DETAIL_KINDS = ["segments", "tolerance", "pixels", "flatness"];
/** The largest coordinate of a point in space, in radii of the surface. */
const MAX_PROBE_RADII = 1.5;
/** The range of the tolerance, in radii of the surface. */
const [FINEST, COARSEST] = [1e-4, 0.2];

/** The groups of controls by the words of the attribute `controls`. */
const GROUPS: Record<string, (controller: SurfaceController) => unknown> = {
  shape: (controller) => (controller.hasModel ? shapeControl(controller) : ownControls(controller)),
  shading: (controller) => shadingControl(controller),
  place: (controller) => placeControls(controller),
  model: (controller) => (controller.hasModel ? modelControls(controller) : nothing),
  mesh: meshControls,
  show: layerControls,
  probe: probeControls,
  edit: editControls,
  files: fileControls,
};

export function panel(controller: SurfaceController) {
  if (controller.groups.size) {
    const wanted = Object.entries(GROUPS).filter(([name]) => controller.groups.has(name));
    return html`<div class="controls" part="controls">${wanted.map(([, group]) => group(controller))}</div>`;
  }
  return html`<div class="controls" part="controls">
    <fieldset class="wide main"><legend class="away">${translated("Picture")}</legend>${GROUPS.shape(controller)} ${shadingControl(controller)}</fieldset> ${placeControls(controller)}
    <details class="more"><summary>${translated("More")}</summary><div class="body">
      ${GROUPS.model(controller)} ${meshControls(controller)} ${layerControls(controller)} ${probeControls(controller)} ${editControls(controller)} ${fileControls(controller)}
    </div></details>
  </div>`;
}

function setting(
  name: string,
  label: string,
  words: readonly string[],
  selected: string,
  names: Record<string, string>,
  controller: SurfaceController,
) {
  return select(label, words, selected, names, (word) => controller.set(name, word));
}

/** A slider that sets a property. */
function propertySlider(
  name: string,
  label: unknown,
  value: number,
  range: { min: number; max: number; step: number },
  controller: SurfaceController,
) {
  return slider(label, name, value, range, (to, done) => controller.set(name, to, done));
}

function shadingControl(controller: SurfaceController) {
  return setting("shading", translated("Shading"), SHADINGS, controller.settings.shading, SHADING_NAMES, controller);
}

function shapeControl(controller: SurfaceController) {
  return setting("model", translated("Shape"), MODELS, controller.settings.model, MODEL_NAMES, controller);
}

function ownControls(controller: SurfaceController) {
  return html`<p class="note">${controller.scene.surface.patchCount === 1 ? translated("A surface of your own, of one patch.") : translated("A surface of your own, of {0} patches.", controller.scene.surface.patchCount)}</p>
      <button type="button" @click=${() => controller.backToModel()}>${translated("Back to the {0}", MODEL_NAMES[controller.settings.model].toLowerCase())}</button>`;
}

function modelControls(controller: SurfaceController) {
  const { settings } = controller;
  const { model, parts } = settings;
  const has = (part: string) => hasPart(controller.groups, "model", part);
  const part = (each: Part) =>
    checkbox(PART_NAMES[each], parts.has(each), (on) => controller.set("parts", toggled(parts, PARTS, each, on)));
  return html`<fieldset><legend>${translated("Model")}</legend>
    ${model === "teapot" && has("height") ? setting("height", translated("Height"), HEIGHTS, settings.height, HEIGHT_NAMES, controller) : nothing}
    ${has("up") ? setting("up", translated("Upright"), AXES, settings.up, { z: "z", y: "y" }, controller) : nothing}
    ${model === "teapot" && has("parts") ? PARTS.map(part) : nothing}
  </fieldset>`;
}

/** A slider on which equal ways are equal ratios. */
function decades(name: string, label: string, value: number, min: number, max: number, controller: SurfaceController) {
  const to = (isDone: boolean) => (event: Event) =>
    controller.set(name, Number((10 ** Number((event.target as HTMLInputElement).value)).toPrecision(2)), isDone);
  const position = Math.log10(value).toFixed(2);
  return html`<label class="line"><span>${label}</span>
    <input type="range" name=${name} min=${Math.log10(min).toFixed(2)} max=${Math.log10(max).toFixed(2)} step="0.01" .value=${position} aria-valuetext=${twoDigits(value)} @input=${to(false)} @change=${to(true)}>
    <span class="value" aria-hidden="true">${twoDigits(value)}</span></label>`;
}

function meshControls(controller: SurfaceController) {
  const { settings } = controller;
  const { detail } = settings;
  const { radius } = controller.scene.sphere;
  const has = (part: string) => hasPart(controller.groups, "mesh", part);
  const [kind] = Object.keys(detail);
  const kinds = DETAIL_KINDS.filter((each) => each === kind || has(each));
  return html`<fieldset><legend>${translated("Mesh")}</legend>
    ${kinds.length > 1 ? select(translated("Fineness"), kinds, kind, DETAIL_NAMES, (kind) => controller.setDetail(kind)) : nothing}
    ${"segments" in detail ? propertySlider("segments", translated("Segments"), settings.segments, { min: 1, max: MAX_SEGMENTS, step: 1 }, controller) : nothing}
    ${"tolerance" in detail ? decades("tolerance", translated("Tolerance"), detail.tolerance, radius * FINEST, radius * COARSEST, controller) : nothing}
    ${"pixels" in detail ? decades("pixels", translated("Pixels"), detail.pixels, 0.1, 30, controller) : nothing}
    ${"flatness" in detail ? decades("flatness", translated("Flatness"), detail.flatness, radius * FINEST, radius * COARSEST, controller) : nothing}
    ${"segments" in detail && has("evaluation") ? setting("evaluation", translated("Computed"), EVALUATIONS, settings.evaluation, EVALUATION_NAMES, controller) : nothing}
  </fieldset>`;
}

function layerControls(controller: SurfaceController) {
  const { layers, lines } = controller.settings;
  const has = (part: string) => hasPart(controller.groups, "show", part);
  const layer = (each: Layer) =>
    checkbox(LAYER_NAMES[each], layers.has(each), (on) => controller.set("show", toggled(layers, LAYERS, each, on)));
  return html`<fieldset><legend>${translated("Show")}</legend>${LAYERS.filter(has).map(layer)}
    ${has("lines") && ["isocurves", "tubes", "ribbons"].some((each) => layers.has(each as any)) ? propertySlider("lines", translated("Strips"), lines, { min: 1, max: MAX_LINES, step: 1 }, controller) : nothing}</fieldset>`;
}

/** The sliders of u and v, where something is shown at them. */
function placeControls(controller: SurfaceController) {
  const { layers, swept, u, v } = controller.settings;
  const steps = layers.has("casteljau");
  if (!steps && !layers.has("derivatives") && !layers.has("place") && !swept) return nothing;
  const unit = { min: 0, max: 1, step: UV_STEP };
  const has = (part: string) => hasPart(controller.groups, "place", part);
  return html`<fieldset class="wide"><legend>${steps ? translated("De Casteljau on the grid") : translated("Place")}</legend>
    ${has("u") ? propertySlider("u", html`<i>u</i>`, u, unit, controller) : nothing}
    ${has("v") ? propertySlider("v", html`<i>v</i>`, v, unit, controller) : nothing}
    ${steps && has("step") ? stepper(controller) : nothing}
  </fieldset>`;
}

function stepper(controller: SurfaceController) {
  const { step } = controller.settings;
  return html`<div class="row">
      <button type="button" ?disabled=${step === 1} @click=${() => controller.set("step", step - 1)}>${translated("Step back")}</button>
      <button type="button" ?disabled=${step === STEPS} @click=${() => controller.set("step", step + 1)}>${translated("Next step")}</button>
    </div>
    <p class="note" role="status">${step}/${STEPS}: ${STEP_WORDS[step - 1]()}</p>`;
}

/** The sliders of a point in space. */
function probeControls(controller: SurfaceController) {
  const { probe } = controller.settings;
  const { radius } = controller.scene.sphere;
  if (!probe) return nothing;
  const unit = 10 ** Math.floor(Math.log10(radius));
  const max = Math.ceil((MAX_PROBE_RADII * radius) / unit) * unit;
  const range = { min: -max, max, step: unit / 20 };
  const moved = (k: number) => (to: number, isDone: boolean) =>
    controller.set("probe", probe.map((x, i) => (i === k ? to : x)).join(" "), isDone);
  const axis = (name: string, k: number) => slider(html`<i>${name}</i>`, name, probe[k], range, moved(k));
  return html`<fieldset class="wide"><legend>${translated("Point")}</legend>${["x", "y", "z"].map(axis)}</fieldset>`;
}

function editControls(controller: SurfaceController) {
  const { editor, state } = controller.subject;
  return html`<fieldset><legend>${translated("Changes")}</legend><div class="row">
    ${button(translated("Undo"), () => controller.step("undo"), { off: !editor.canUndo })} ${button(translated("Redo"), () => controller.step("redo"), { off: !editor.canRedo })}
    ${button(translated("Undo all moves"), () => controller.restore(), { off: !state.moves.size })}
  </div></fieldset>`;
}

function fileControls(controller: SurfaceController) {
  const openSelected = (event: Event) => {
    const input = event.target as HTMLInputElement;
    if (input.files?.[0]) controller.open(input.files[0]);
    input.value = ""; // the same file can be selected again
  };
  return html`<fieldset><legend>${translated("Files")}</legend><div class="row">
    <label class="file">${translated("Open a patch file")}<input type="file" accept=".bpt,.txt,text/plain" @change=${openSelected}></label>
  </div><div class="row" role="group" aria-label=${translated("Save as")}>
    <button type="button" @click=${() => controller.savePicture()}>PNG</button>
    ${KINDS.map((kind) => html`<button type="button" @click=${() => controller.saveMesh(kind)}>${kind.toUpperCase()}</button>`)}
  </div></fieldset>`;
}
