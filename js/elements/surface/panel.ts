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
import type { ControlGroups } from "../attribute-text.js";
import type { Settings, Part, Layer } from "./settings.js";

/** What the controls know and do. */
export interface PanelPort {
  settings: Settings;
  /** The groups of controls that are wanted; none means all, with what is used less behind "More" */
  groups: ControlGroups;
  /** The surface's radius */
  size: number;
  setDetail: (kind: "segments" | "tolerance" | "pixels" | "flatness") => void;
  /** Whether the surface is a model of the list */
  named: boolean;
  edited: boolean;
  set: (name: string, value: unknown, type: "input" | "change") => void;
  can: { undo: boolean; redo: boolean };
  step: (step: "undo" | "redo") => void;
  /** Takes back all moves */
  restore: () => void;
  savePicture: () => void;
  saveMesh: (kind: "obj" | "stl" | "glb") => void;
  open: (file: File) => void;
  backToModel: () => void;
  patches: number;
}

const KINDS = ["obj", "stl", "glb"] as const;
const UV_STEP = 0.01;
const DETAIL_KINDS = ["segments", "tolerance", "pixels", "flatness"];
/** The largest coordinate of a point in space, in radii of the surface. */
const MAX_PROBE_RADII = 1.5;
/** The range of the tolerance, in radii of the surface. */
const [FINEST, COARSEST] = [1e-4, 0.2];

/** The groups of controls by the words of the attribute `controls`. */
const GROUPS: Record<string, (port: PanelPort) => unknown> = {
  shape: (port) => (port.named ? shapeControl(port) : ownControls(port)),
  shading: (port) => shadingControl(port),
  place: (port) => placeControls(port),
  model: (port) => (port.named ? modelControls(port) : nothing),
  mesh: meshControls,
  show: layerControls,
  probe: probeControls,
  edit: editControls,
  files: fileControls,
};

export function panel(port: PanelPort) {
  if (port.groups.size) {
    const wanted = Object.entries(GROUPS).filter(([name]) => port.groups.has(name));
    return html`<div class="controls" part="controls">${wanted.map(([, group]) => group(port))}</div>`;
  }
  return html`<div class="controls" part="controls">
    <fieldset class="wide main"><legend class="away">${translated("Picture")}</legend>${GROUPS.shape(port)} ${shadingControl(port)}</fieldset> ${placeControls(port)}
    <details class="more"><summary>${translated("More")}</summary><div class="body">
      ${GROUPS.model(port)} ${meshControls(port)} ${layerControls(port)} ${probeControls(port)} ${editControls(port)} ${fileControls(port)}
    </div></details>
  </div>`;
}

function setting(
  name: string,
  label: string,
  words: readonly string[],
  selected: string,
  names: Record<string, string>,
  { set }: PanelPort,
) {
  return select(label, words, selected, names, (word) => set(name, word, "change"));
}

/** A slider that sets a property. */
function propertySlider(
  name: string,
  label: unknown,
  value: number,
  range: { min: number; max: number; step: number },
  { set }: PanelPort,
) {
  return slider(label, name, value, range, (to, done) => set(name, to, done ? "change" : "input"));
}

function shadingControl(port: PanelPort) {
  return setting("shading", translated("Shading"), SHADINGS, port.settings.shading, SHADING_NAMES, port);
}

function shapeControl(port: PanelPort) {
  return setting("model", translated("Shape"), MODELS, port.settings.model, MODEL_NAMES, port);
}

function ownControls(port: PanelPort) {
  return html`<p class="note">${port.patches === 1 ? translated("A surface of your own, of one patch.") : translated("A surface of your own, of {0} patches.", port.patches)}</p>
      <button type="button" @click=${port.backToModel}>${translated("Back to the {0}", MODEL_NAMES[port.settings.model].toLowerCase())}</button>`;
}

function modelControls(port: PanelPort) {
  const { settings, set } = port;
  const { model, parts } = settings;
  const has = (part: string) => hasPart(port.groups, "model", part);
  const part = (each: Part) =>
    checkbox(PART_NAMES[each], parts.has(each), (on) => set("parts", toggled(parts, PARTS, each, on), "change"));
  return html`<fieldset><legend>${translated("Model")}</legend>
    ${model === "teapot" && has("height") ? setting("height", translated("Height"), HEIGHTS, settings.height, HEIGHT_NAMES, port) : nothing}
    ${has("up") ? setting("up", translated("Upright"), AXES, settings.up, { z: "z", y: "y" }, port) : nothing}
    ${model === "teapot" && has("parts") ? PARTS.map(part) : nothing}
  </fieldset>`;
}

/** A slider on which equal ways are equal ratios. */
function decades(name: string, label: string, value: number, min: number, max: number, { set }: PanelPort) {
  const to = (type: "input" | "change") => (event: Event) =>
    set(name, Number((10 ** Number((event.target as HTMLInputElement).value)).toPrecision(2)), type);
  const position = Math.log10(value).toFixed(2);
  return html`<label class="line"><span>${label}</span>
    <input type="range" name=${name} min=${Math.log10(min).toFixed(2)} max=${Math.log10(max).toFixed(2)} step="0.01" .value=${position} aria-valuetext=${twoDigits(value)} @input=${to("input")} @change=${to("change")}>
    <span class="value" aria-hidden="true">${twoDigits(value)}</span></label>`;
}

function meshControls(port: PanelPort) {
  const { settings } = port;
  const { detail } = settings;
  const has = (part: string) => hasPart(port.groups, "mesh", part);
  const [kind] = Object.keys(detail);
  const kinds = DETAIL_KINDS.filter((each) => each === kind || has(each));
  return html`<fieldset><legend>${translated("Mesh")}</legend>
    ${kinds.length > 1 ? select(translated("Fineness"), kinds, kind, DETAIL_NAMES, (kind) => port.setDetail(kind as Parameters<typeof port.setDetail>[0])) : nothing}
    ${"segments" in detail ? propertySlider("segments", translated("Segments"), settings.segments, { min: 1, max: MAX_SEGMENTS, step: 1 }, port) : nothing}
    ${"tolerance" in detail ? decades("tolerance", translated("Tolerance"), detail.tolerance, port.size * FINEST, port.size * COARSEST, port) : nothing}
    ${"pixels" in detail ? decades("pixels", translated("Pixels"), detail.pixels, 0.1, 30, port) : nothing}
    ${"flatness" in detail ? decades("flatness", translated("Flatness"), detail.flatness, port.size * FINEST, port.size * COARSEST, port) : nothing}
    ${"segments" in detail && has("evaluation") ? setting("evaluation", translated("Computed"), EVALUATIONS, settings.evaluation, EVALUATION_NAMES, port) : nothing}
  </fieldset>`;
}

function layerControls(port: PanelPort) {
  const {
    settings: { layers, lines },
    set,
  } = port;
  const has = (part: string) => hasPart(port.groups, "show", part);
  const layer = (each: Layer) =>
    checkbox(LAYER_NAMES[each], layers.has(each), (on) => set("show", toggled(layers, LAYERS, each, on), "change"));
  return html`<fieldset><legend>${translated("Show")}</legend>${LAYERS.filter(has).map(layer)}
    ${has("lines") && ["isocurves", "tubes", "ribbons"].some((each) => layers.has(each as any)) ? propertySlider("lines", translated("Strips"), lines, { min: 1, max: MAX_LINES, step: 1 }, port) : nothing}</fieldset>`;
}

/** The sliders of u and v, where something is shown at them. */
function placeControls(port: PanelPort) {
  const { layers, swept, u, v } = port.settings;
  const steps = layers.has("casteljau");
  if (!steps && !layers.has("derivatives") && !layers.has("place") && !swept) return nothing;
  const unit = { min: 0, max: 1, step: UV_STEP };
  const has = (part: string) => hasPart(port.groups, "place", part);
  return html`<fieldset class="wide"><legend>${steps ? translated("De Casteljau on the grid") : translated("Place")}</legend>
    ${has("u") ? propertySlider("u", html`<i>u</i>`, u, unit, port) : nothing}
    ${has("v") ? propertySlider("v", html`<i>v</i>`, v, unit, port) : nothing}
    ${steps && has("step") ? stepper(port) : nothing}
  </fieldset>`;
}

function stepper({ settings: { step }, set }: PanelPort) {
  return html`<div class="row">
      <button type="button" ?disabled=${step === 1} @click=${() => set("step", step - 1, "change")}>${translated("Step back")}</button>
      <button type="button" ?disabled=${step === STEPS} @click=${() => set("step", step + 1, "change")}>${translated("Next step")}</button>
    </div>
    <p class="note" role="status">${step}/${STEPS}: ${STEP_WORDS[step - 1]()}</p>`;
}

/** The sliders of a point in space. */
function probeControls({ settings: { probe }, size, set }: PanelPort) {
  if (!probe) return nothing;
  const unit = 10 ** Math.floor(Math.log10(size));
  const max = Math.ceil((MAX_PROBE_RADII * size) / unit) * unit;
  const range = { min: -max, max, step: unit / 20 };
  const moved = (k: number) => (to: number, done: boolean) =>
    set("probe", probe.map((x, i) => (i === k ? to : x)).join(" "), done ? "change" : "input");
  const axis = (name: string, k: number) => slider(html`<i>${name}</i>`, name, probe[k], range, moved(k));
  return html`<fieldset class="wide"><legend>${translated("Point")}</legend>${["x", "y", "z"].map(axis)}</fieldset>`;
}

function editControls({ edited, can, step, restore }: PanelPort) {
  return html`<fieldset><legend>${translated("Changes")}</legend><div class="row">
    ${button(translated("Undo"), () => step("undo"), { off: !can.undo })} ${button(translated("Redo"), () => step("redo"), { off: !can.redo })}
    ${button(translated("Undo all moves"), restore, { off: !edited })}
  </div></fieldset>`;
}

function fileControls({ savePicture, saveMesh, open }: PanelPort) {
  const openSelected = (event: Event) => {
    const input = event.target as HTMLInputElement;
    if (input.files?.[0]) open(input.files[0]);
    input.value = ""; // the same file can be selected again
  };
  return html`<fieldset><legend>${translated("Files")}</legend><div class="row">
    <label class="file">${translated("Open a patch file")}<input type="file" accept=".bpt,.txt,text/plain" @change=${openSelected}></label>
  </div><div class="row" role="group" aria-label=${translated("Save as")}>
    <button type="button" @click=${savePicture}>PNG</button>
    ${KINDS.map((kind) => html`<button type="button" @click=${() => saveMesh(kind)}>${kind.toUpperCase()}</button>`)}
  </div></fieldset>`;
}
