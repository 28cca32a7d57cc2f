// The controls below the picture: native form controls, in groups; what is used less is folded.
import { html, nothing } from "lit";
import { LAYERS } from "./layers/index.js";
import { box, button, choice, slider } from "./controls.js";
import { BASES, LABELS, LAYER_NAMES, MODES, rangeOfT, withLayer } from "./state.js";
import { BASIS_NAMES, jointWords, MODE_NAMES } from "./words.js";

/** @typedef {import("./state.js").State} State */

/**
 * What the panel knows and does.
 *
 * @typedef {object} PanelPort
 * @property {State} state
 * @property {import("./figure.js").Figure} figure
 * @property {import("./words.js").JointFacts[]} joints
 * @property {import("./state.js").JointMode[]} modes
 * @property {readonly { name: string, words: string }[]} tells what the layers tell
 * @property {(group: string) => boolean} shows whether a group of controls is wanted
 * @property {boolean} readonly
 * @property {boolean} playing
 * @property {{ undo: boolean, redo: boolean, insert: boolean }} can
 * @property {(change: (state: State) => State, done?: boolean) => void} set
 * @property {(name: string, value: unknown, done?: boolean) => void} put a field of the state
 * @property {Record<"play" | "undo" | "redo" | "reset" | "randomize" | "toggle" | "append" | "insert" | "help" | "home", () => void>} act
 * @property {(joint: number, mode: string) => void} hold
 * @property {(factor: number) => void} zoom
 * @property {() => void} home
 */

/** @param {PanelPort} port */
export function panel(port) {
  const { shows } = port;
  return html`${shows("joints") ? joints(port) : nothing}
    <div class="controls" part="controls">
      ${shows("t") ? parameter(port) : nothing} ${shows("points") ? actions(port) : nothing} ${shows("curve") ? kind(port) : nothing}
      ${shows("show") ? layers(port) : nothing}
    </div>`;
}

/**
 * A row for each joint: what is true there, and what is held.
 *
 * @param {PanelPort} port
 */
function joints({ joints: facts, modes, hold, readonly }) {
  if (!facts.length) return nothing;
  return html`<ul class="joints" part="joints">${facts.map((each, k) => html`<li>
    <span class="verdict" data-verdict=${each.verdict}>${each.verdict}</span><b>${each.at}</b>
    ${modes[k] ? choice(html`<span class="away">Hold at ${each.at}</span>`, MODES, modes[k], MODE_NAMES, (mode) => hold(k + 1, mode), readonly) : nothing}
    <span class="fact">${jointWords(each)}</span></li>`)}</ul>`;
}

/** @param {PanelPort} port */
function parameter({ state, figure, playing, act, put }) {
  const [least, most] = rangeOfT(state);
  const count = figure.pieces.length;
  const segments = Array.from({ length: count }, (_, k) => String(k));
  return html`<div class="t">
    <button type="button" class="icon" aria-label=${playing ? "Pause" : "Play t"} title=${playing ? "Pause" : "Play t"} @click=${act.play}>${playing ? "❚❚" : "▶"}</button>
    ${slider(html`<i>t</i>`, "t", state.t, { min: least, max: most, step: 0.01 }, (t, done) => put("t", t, done))}
    ${count > 1 ? choice("on segment", segments, String(Math.min(state.segment, count - 1)), Object.fromEntries(segments.map((k) => [k, String(Number(k) + 1)])), (k) => put("segment", Number(k))) : nothing}
  </div>`;
}

/** @param {PanelPort} port */
function actions({ state, act, can, readonly }) {
  if (readonly) return nothing;
  const all = state.shown === state.points.length;
  return html`<div class="row" role="group" aria-label="Points">
    ${button("Undo", act.undo, { off: !can.undo })} ${button("Redo", act.redo, { off: !can.redo })}
    ${button("Add a point", act.append)} ${button("Cut at t", act.insert, { key: "i", off: !can.insert })}
    ${button(all ? "Fewer points" : `All ${state.points.length} points`, act.toggle, { key: "m" })}
    ${button("Randomize", act.randomize, { key: "r" })} ${button("Reset", act.reset)} ${button("Keys", act.help, { key: "?" })}
  </div>`;
}

/** @param {PanelPort} port */
function kind({ state, put, readonly }) {
  const degrees = ["1", "2", "3", "4", "5", "6", "n"];
  const names = { n: "one curve" };
  const degree = String(state.degree);
  return html`<fieldset ?disabled=${readonly}><legend>Curve</legend>
    ${choice("Basis", BASES, state.basis, BASIS_NAMES, (basis) => put("basis", basis))}
    ${state.basis === "bezier" || state.basis === "b-spline" ? choice("Degree", degrees.includes(degree) ? degrees : [degree, ...degrees], degree, names, (n) => put("degree", n === "n" ? n : Number(n))) : nothing}
    ${choice("Names", LABELS, state.labels, { b0: "b₀", p0: "p0" }, (labels) => put("labels", labels))}
  </fieldset>`;
}

/** @param {PanelPort} port */
function layers({ state, set }) {
  const titles = Object.fromEntries(LAYERS.map(({ name, title }) => [name, title]));
  const layer = (/** @type {typeof LAYER_NAMES[number]} */ name) => box(titles[name] ?? name, state.layers.has(name), (on) => set((now) => withLayer(now, name, on)));
  return html`<fieldset class="wide"><legend>Show</legend><div class="layers">${LAYER_NAMES.map(layer)}</div></fieldset>`;
}
