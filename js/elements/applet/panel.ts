// The controls below the picture: native form controls, in groups; what is used less is folded.
import { html, nothing } from "lit";
import { button, checkbox, select, icon, slider } from "../../ui/controls.js";
import { actionOf } from "../../editor/actions.js";
import { modesOf } from "../../editor/commands.js";
import { jointsOf } from "../../editor/joints.js";
import { switchable } from "../../layers/index.js";
import { hasPart } from "../attribute-text.js";
import { once } from "../loading.js";
import { exportPanel } from "./saving.js";
import { tools } from "./tools.js";
import { BASES, BASIS_NAMES, LABELS, LAYER_NAMES, MODES, rangeOfT, withLayer } from "../../editor/state.js";
import { jointWords, MODE_NAMES } from "../../editor/descriptions.js";
import { translated, translatedParts } from "../../editor/translations.js";
import type { AppletController } from "./controller.js";
import type { ActionName } from "../../editor/actions.js";

export function panel(controller: AppletController) {
  const { groups } = controller;
  const { readonly } = controller.host;
  const shows = (group: string) => !groups.size || groups.has(group);
  const others = html`${shows("points") && !readonly ? actions(controller) : nothing}
      ${shows("curve") ? kind(controller) : nothing} ${shows("show") ? layers(controller) : nothing}
      ${shows("coordinates") && !readonly ? coordinates() : nothing} ${shows("save") ? exportPanel(controller) : nothing}`;
  return html`${shows("joints") ? joints(controller) : nothing}
    <div class="controls" part="controls">${shows("t") ? parameter(controller, shows("zoom")) : nothing}
      ${!groups.size ? html`<details class="more"><summary>${translated("More")}</summary><div class="body">${others}</div></details>` : others}
    </div>`;
}

/** A row for each joint: what is true there, and what is held. */
function joints(controller: AppletController) {
  const { host, model } = controller;
  const [facts, modes] = [jointsOf(model.figure), modesOf(model.state)];
  if (!facts.length) return nothing;
  return html`<ul class="joints" part="joints">${facts.map(
    (each, k) => html`<li>
    <span class="verdict" data-verdict=${each.verdict}>${each.verdict}</span>
    ${modes[k] ? select(translatedParts("At {0} hold", html`<b>${each.at}</b>`), MODES, modes[k], MODE_NAMES, (mode) => controller.holdJoint(k + 1, mode), host.readonly) : html`<span>${translatedParts("At {0}", html`<b>${each.at}</b>`)}</span>`}
    <span class="fact">${jointWords(each)}</span></li>`,
  )}</ul>`;
}

function parameter(controller: AppletController, hasZoom: boolean) {
  const { state, figure } = controller.model;
  const { playing } = controller.player;
  const [min, max] = rangeOfT(state);
  const count = figure.pieces.length + figure.rational.length;
  const segments = Array.from({ length: count }, (_, k) => String(k));
  const names = Object.fromEntries(segments.map((k) => [k, String(Number(k) + 1)]));
  const called = playing ? translated("Pause") : translated("Play t");
  return html`<div class="t">
    <button type="button" class="icon" aria-label=${called} title=${called} @click=${() => controller.togglePlayer()}>${playing ? icon("M8 5v14M16 5v14") : icon("M7 4l13 8-13 8z", true)}</button>
    ${slider(html`<i>t</i>`, "t", state.t, { min, max, step: 0.01 }, (t, done) => controller.put("t", t, done))}
    ${count > 1 ? select(translated("segment"), segments, String(Math.min(state.segment, count - 1)), names, (k) => controller.put("segment", Number(k))) : nothing}
    ${hasZoom ? tools(controller) : nothing}
  </div>`;
}

function actions(controller: AppletController) {
  const { model, selected, isTapping } = controller;
  const { state } = model;
  const all = state.shown === state.points.length;
  const name = model.figure.names[selected];
  const action = (each: ActionName, label: unknown = actionOf(each).label()) =>
    button(label, () => controller.run(each), { key: actionOf(each).key, off: !controller.canRun(each) });
  const picture = (each: ActionName, d: string) =>
    button(icon(d), () => controller.run(each), { name: actionOf(each).label(), off: !controller.canRun(each) });
  return html`<div class="row" role="group" aria-label=${translated("Points")}>
    ${picture("undo", "M4 9h11a5 5 0 0 1 0 10h-4M4 9l5-5M4 9l5 5")} ${picture("redo", "M20 9H9a5 5 0 0 0 0 10h4M20 9l-5-5M20 9l-5 5")}
    ${action("append")} ${button(name ? translated("Remove {0}", name) : translated("Remove"), () => void controller.remove(selected), { off: !name })}
    ${action("insert")} ${all ? action("toggle") : action("toggle", translated("All {0} points", state.points.length))}
    ${action("randomize")} ${button(translated("Move by taps"), () => controller.toggleTapping(), { pressed: isTapping })}
    ${action("reset")} ${button(translated("Keys"), () => controller.showKeys(), { key: "?" })}
  </div>`;
}

function kind(controller: AppletController) {
  const { state } = controller.model;
  const degrees = ["1", "2", "3", "4", "5", "6", "n"];
  const degree = String(state.degree);
  return html`<fieldset ?disabled=${controller.host.readonly}><legend class="away">${translated("Curve")}</legend>
    ${select(translated("Basis"), BASES, state.basis, BASIS_NAMES, (basis) => controller.put("basis", basis))}
    ${state.basis === "bezier" || state.basis === "b-spline" ? select(translated("Degree"), degrees.includes(degree) ? degrees : [degree, ...degrees], degree, { n: translated("n: one curve") }, (n) => controller.put("degree", n === "n" ? n : Number(n))) : nothing}
    ${select(translated("Names"), LABELS, state.labels, { P0: "P0 P1 …", P1: "P1 P2 …", b0: "b₀ b₁ …", p0: "p0 p1 …", none: translated("none") }, (labels) => controller.put("labels", labels))}
    ${state.basis === "matrix" ? matrix(controller) : nothing}
  </fieldset>`;
}

function matrix(controller: AppletController) {
  const { matrix: numbers } = controller.model.state;
  const entry = (x: number, i: number) => {
    const changed = (event: Event) =>
      controller.put(
        "matrix",
        numbers.map((old, k) => (k === i ? (event.target as HTMLInputElement).valueAsNumber : old)),
      );
    return html`<input class="number" type="number" step="any" aria-label=${translated("row {0}, column {1}", Math.floor(i / 4) + 1, (i % 4) + 1)} .value=${String(Number(x.toFixed(4)))} @change=${changed}>`;
  };
  return html`<div class="matrix" role="group" aria-label=${translated("Basis matrix")}>${numbers.map(entry)}</div>`;
}

/** Layers with a number of their own. */
const MEASURES: Record<
  string,
  [() => string, "tolerance" | "segments" | "offset" | "ticks", { min: number; max: number; step: number }]
> = {
  tree: [() => translated("Tolerance, px"), "tolerance", { min: 0.1, max: 20, step: 0.1 }],
  segments: [() => translated("Even steps"), "segments", { min: 1, max: 50, step: 1 }],
  offset: [() => translated("Offset curve at"), "offset", { min: -150, max: 150, step: 1 }],
  ticks: [() => translated("Equal lengths"), "ticks", { min: 1, max: 50, step: 1 }],
};

function layers(controller: AppletController) {
  const { messages, groups } = controller;
  const { state } = controller.model;
  const titles = Object.fromEntries(switchable(controller.layers).map(({ name, title }) => [name, title()]));
  const layer = (name: (typeof LAYER_NAMES)[number]) =>
    checkbox(titles[name], state.layers.has(name), (on) => void controller.change((now) => withLayer(now, name, on)));
  const measures = Object.entries(MEASURES).filter(
    ([layerName]) => titles[layerName] && state.layers.has(layerName as any),
  );
  return html`<fieldset><legend>${translated("Show")}</legend><div class="layers">${LAYER_NAMES.filter((name) => titles[name] && hasPart(groups, "show", name)).map(layer)}</div>
    <div class="measure">${measures.map(([, [label, name, range]]) => slider(label(), name, state[name], range, (value, done) => controller.put(name, value, done)))}</div>
    ${messages.length ? html`<ul class="messages">${messages.map(({ words }) => html`<li>${words}</li>`)}</ul>` : nothing}
  </fieldset>`;
}

const loadCoordinates = once(() => import("../define/coordinates.js"), "BezierCoordinates");

/** A table of the page's own, or ours, whose code is loaded when it is opened. */
const coordinates = () =>
  html`<details @toggle=${() => loadCoordinates().catch(() => {})}><summary>${translated("Coordinates")}</summary><slot name="coordinates"><bezier-coordinates for=":host"></bezier-coordinates></slot></details>`;
