// The controls below the picture: native form controls, in groups; what is used less is folded.
import { html, nothing } from "lit";
import { box, button, choice, icon, slider } from "../../ui/controls.js";
import { actionOf } from "../../editor/actions.js";
import { hasPart } from "../attribute-text.js";
import { once } from "../loading.js";
import { savings } from "./saving.js";
import { tools } from "./tools.js";
import { BASES, BASIS_NAMES, LABELS, LAYER_NAMES, MODES, rangeOfT, withLayer } from "../../editor/state.js";
import { jointWords, MODE_NAMES } from "../../editor/descriptions.js";
import { translated, translatedParts } from "../../editor/translations.js";
import type { ControlGroups } from "../attribute-text.js";
import type { ActionName } from "../../editor/actions.js";
import type { State } from "../../editor/state.js";

/** What the panel knows and does. */
export interface PanelPort {
  state: State;
  figure: import("../../editor/figure.js").Figure;
  joints: import("../../editor/descriptions.js").JointFacts[];
  modes: import("../../editor/state.js").JointMode[];
  /** The messages of the layers */
  messages: readonly { name: string; words: string }[];
  /** The layers that this figure can have */
  layers: readonly import("../../layers/index.js").SwitchableLayer[];
  /** The groups of controls that are wanted; none means all */
  groups: ControlGroups;
  /** Whether a group of controls is wanted */
  shows: (group: string) => boolean;
  /** Whether all groups are wanted: what is used less is then behind "More" */
  isComplete: boolean;
  readonly: boolean;
  playing: boolean;
  /** Whether taps move the selected point */
  tapping: boolean;
  /** The point that was touched last; −1 for none */
  selected: number;
  can: (name: ActionName) => boolean;
  run: (name: ActionName) => void;
  set: (change: (state: State) => State) => void;
  /** A field of the state */
  put: (name: string, value: unknown, done?: boolean) => void;
  act: import("./actions.js").Actions;
  hold: (joint: number, mode: string) => void;
  zoom: (factor: number) => void;
  code: string;
  language: string;
}

export function panel(port: PanelPort) {
  const { shows, readonly, isComplete } = port;
  const others = html`${shows("points") && !readonly ? actions(port) : nothing}
      ${shows("curve") ? kind(port) : nothing} ${shows("show") ? layers(port) : nothing}
      ${shows("coordinates") && !readonly ? coordinates() : nothing} ${shows("save") ? savings(port) : nothing}`;
  return html`${shows("joints") ? joints(port) : nothing}
    <div class="controls" part="controls">${shows("t") ? parameter(port) : nothing}
      ${isComplete ? html`<details class="more"><summary>${translated("More")}</summary><div class="body">${others}</div></details>` : others}
    </div>`;
}

/** A row for each joint: what is true there, and what is held. */
function joints({ joints: facts, modes, hold, readonly }: PanelPort) {
  if (!facts.length) return nothing;
  return html`<ul class="joints" part="joints">${facts.map(
    (each, k) => html`<li>
    <span class="verdict" data-verdict=${each.verdict}>${each.verdict}</span>
    ${modes[k] ? choice(translatedParts("At {0} hold", html`<b>${each.at}</b>`), MODES, modes[k], MODE_NAMES, (mode) => hold(k + 1, mode), readonly) : html`<span>${translatedParts("At {0}", html`<b>${each.at}</b>`)}</span>`}
    <span class="fact">${jointWords(each)}</span></li>`,
  )}</ul>`;
}

function parameter(port: PanelPort) {
  const { state, figure, playing, act, put, shows } = port;
  const [min, max] = rangeOfT(state);
  const count = figure.pieces.length + figure.rational.length;
  const segments = Array.from({ length: count }, (_, k) => String(k));
  const names = Object.fromEntries(segments.map((k) => [k, String(Number(k) + 1)]));
  const called = playing ? translated("Pause") : translated("Play t");
  return html`<div class="t">
    <button type="button" class="icon" aria-label=${called} title=${called} @click=${act.play}>${playing ? icon("M8 5v14M16 5v14") : icon("M7 4l13 8-13 8z", true)}</button>
    ${slider(html`<i>t</i>`, "t", state.t, { min, max, step: 0.01 }, (t, done) => put("t", t, done))}
    ${count > 1 ? choice(translated("segment"), segments, String(Math.min(state.segment, count - 1)), names, (k) => put("segment", Number(k))) : nothing}
    ${shows("zoom") ? tools(port) : nothing}
  </div>`;
}

function actions({ state, figure, act, can, run, selected, tapping }: PanelPort) {
  const all = state.shown === state.points.length;
  const name = figure.names[selected];
  const action = (each: ActionName, label: unknown = actionOf(each).label()) =>
    button(label, () => run(each), { key: actionOf(each).key, off: !can(each) });
  const picture = (each: ActionName, d: string) =>
    button(icon(d), () => run(each), { name: actionOf(each).label(), off: !can(each) });
  return html`<div class="row" role="group" aria-label=${translated("Points")}>
    ${picture("undo", "M4 9h11a5 5 0 0 1 0 10h-4M4 9l5-5M4 9l5 5")} ${picture("redo", "M20 9H9a5 5 0 0 0 0 10h4M20 9l-5-5M20 9l-5 5")}
    ${action("append")} ${button(name ? translated("Remove {0}", name) : translated("Remove"), act.removeSelected, { off: !name })}
    ${action("insert")} ${all ? action("toggle") : action("toggle", translated("All {0} points", state.points.length))}
    ${action("randomize")} ${button(translated("Move by taps"), act.tapping, { pressed: tapping })}
    ${action("reset")} ${button(translated("Keys"), act.help, { key: "?" })}
  </div>`;
}

function kind({ state, put, readonly }: PanelPort) {
  const degrees = ["1", "2", "3", "4", "5", "6", "n"];
  const degree = String(state.degree);
  return html`<fieldset ?disabled=${readonly}><legend class="away">${translated("Curve")}</legend>
    ${choice(translated("Basis"), BASES, state.basis, BASIS_NAMES, (basis) => put("basis", basis))}
    ${state.basis === "bezier" || state.basis === "b-spline" ? choice(translated("Degree"), degrees.includes(degree) ? degrees : [degree, ...degrees], degree, { n: translated("n: one curve") }, (n) => put("degree", n === "n" ? n : Number(n))) : nothing}
    ${choice(translated("Names"), LABELS, state.labels, { P0: "P0 P1 …", P1: "P1 P2 …", b0: "b₀ b₁ …", p0: "p0 p1 …", none: translated("none") }, (labels) => put("labels", labels))}
    ${state.basis === "matrix" ? matrix(state, put) : nothing}
  </fieldset>`;
}

function matrix({ matrix: numbers }: State, put: PanelPort["put"]) {
  const entry = (x: number, i: number) => {
    const changed = (event: Event) =>
      put(
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

function layers({ state, set, put, messages, groups, layers }: PanelPort) {
  const titles = Object.fromEntries(layers.map(({ name, title }) => [name, title()]));
  const layer = (name: (typeof LAYER_NAMES)[number]) =>
    box(titles[name], state.layers.has(name), (on) => set((now) => withLayer(now, name, on)));
  const measures = Object.entries(MEASURES).filter(
    ([layerName]) => titles[layerName] && state.layers.has(layerName as any),
  );
  return html`<fieldset><legend>${translated("Show")}</legend><div class="layers">${LAYER_NAMES.filter((name) => titles[name] && hasPart(groups, "show", name)).map(layer)}</div>
    <div class="measure">${measures.map(([, [label, name, range]]) => slider(label(), name, state[name], range, (value, done) => put(name, value, done)))}</div>
    ${messages.length ? html`<ul class="messages">${messages.map(({ words }) => html`<li>${words}</li>`)}</ul>` : nothing}
  </fieldset>`;
}

const loadCoordinates = once(() => import("../define/coordinates.js"), "BezierCoordinates");

/** A table of the page's own, or ours, whose code is loaded when it is opened. */
const coordinates = () =>
  html`<details @toggle=${() => loadCoordinates().catch(() => {})}><summary>${translated("Coordinates")}</summary><slot name="coordinates"><bezier-coordinates for=":host"></bezier-coordinates></slot></details>`;
