// The bar below the picture: native form controls that call the applet and are set from its state.
import { append, randomize, redo, toggle, undo } from "../editor/actions.js";
import { translated, translatedTable } from "../editor/translations.js";
import { element } from "../ui/dom.js";
import { JOINT_MODES, LAYER_NAMES, MIN_POINTS } from "./changes.js";
import type { Action } from "../editor/actions.js";
import type { State } from "../editor/state.js";
import type { JointMode, Layers } from "./changes.js";

/** What the controls do. */
export interface ControlPort {
  run: (action: Action) => void;
  setJoint: (mode: JointMode) => void;
  setLayer: (name: keyof Layers, on: boolean) => void;
  setT: (t: number) => void;
  /** Completes what `setT` has begun */
  commit: () => void;
}

export interface Controls {
  update: (state: State, can: Can) => void;
  /** Whether `r` and `m` count on the whole page */
  pageWide: () => boolean;
}

/** Whether there are steps to undo and to redo. */
export type Can = { canUndo: boolean; canRedo: boolean };

const JOINT_NAMES: Record<JointMode, string> = translatedTable({ free: "Free", g1: "G1", c1: "C1" });
const JOINT_TITLES: Record<JointMode, string> = translatedTable({
  free: "Points move alone",
  g1: "P2, P3 and P4 stay aligned",
  c1: "P2, P3 and P4 stay aligned, and P3 stays half-way",
});
const LAYER_TITLES: Record<keyof Layers, string> = translatedTable({
  polygon: "control polygon",
  hull: "hull",
  construction: "de Casteljau at t",
  halves: "two halves at t",
});
const T_STEP = 0.01;
/** Up to so many points P3 is the only joint. */
const TWO_CUBICS = 7;

/** Fills the bar. */
export function createControls(bar: HTMLElement, port: ControlPort): Controls {
  const page = bar.ownerDocument;
  const [joints, layers, t, buttons] = [
    jointSwitch(page, port),
    layerBoxes(page, port),
    tSlider(page, port),
    pointButtons(page, port),
  ];
  const keys = element(page, "input", { type: "checkbox", checked: true });
  const hint = element(
    page,
    "p",
    { className: "hint" },
    translated("Drag a point. A double click adds a point."),
    element(page, "span", { className: "keys" }, translated("Keys: Tab to a point, then the arrow keys.")),
    element(page, "label", { className: "keys" }, keys, translated("r and m on the whole page")),
  );
  bar.append(buttons.row, joints.group, t.label, layers.group, hint);
  const update = (state: State, can: Can) => [joints, layers, t, buttons].forEach((part) => part.update(state, can));
  return { update, pageWide: () => keys.checked };
}

function pointButtons(page: Document, port: ControlPort) {
  const button = (action: Action, shortcut = action.key, ...words: Node[]) =>
    element(
      page,
      "button",
      { type: "button", onclick: () => port.run(action), ...(shortcut && { "aria-keyshortcuts": shortcut }) },
      ...(words.length ? words : [action.label()]),
      ...(action.key ? [" ", element(page, "kbd", {}, action.key)] : []),
    );
  const label = element(page, "span");
  const toggler = button(toggle, toggle.key, label);
  const steps = [button(undo, "Control+Z"), button(redo, "Control+Y")];
  const row = element(page, "div", { className: "row" }, button(randomize), toggler, button(append), ...steps);
  const update = ({ points, shown }: State, { canUndo, canRedo }: Can) => {
    steps[0].disabled = !canUndo;
    steps[1].disabled = !canRedo;
    label.textContent = translated("Show {0} points", shown === MIN_POINTS ? points.length : MIN_POINTS);
    toggler.disabled = points.length === MIN_POINTS;
  };
  return { row, update };
}

function jointSwitch(page: Document, port: ControlPort) {
  const radios = JOINT_MODES.map((mode) =>
    element(page, "input", { type: "radio", name: "joint", value: mode, onchange: () => port.setJoint(mode) }),
  );
  const labels = JOINT_MODES.map((mode, i) =>
    element(page, "label", { title: JOINT_TITLES[mode] }, radios[i], JOINT_NAMES[mode]),
  );
  const legend = element(page, "legend", {}, translated("At P3 hold"));
  const group = element(page, "fieldset", {}, legend, ...labels);
  const update = (state: State) => {
    legend.textContent = state.shown > TWO_CUBICS ? translated("At every joint hold") : translated("At P3 hold");
    for (const radio of radios) radio.checked = radio.value === state.joints[0];
  };
  return { group, update };
}

function tSlider(page: Document, port: ControlPort) {
  const slider = element(page, "input", { type: "range", min: "0", max: "1", step: String(T_STEP), "aria-label": "t" });
  slider.addEventListener("input", () => port.setT(Number(slider.value)));
  slider.addEventListener("change", () => port.commit());
  const output = element(page, "span", { className: "value", "aria-hidden": "true" }); // the slider announces its value itself
  const label = element(page, "label", { className: "t" }, element(page, "i", {}, "t"), slider, output);
  const update = ({ t }: State) => {
    slider.value = String(t);
    output.textContent = t.toFixed(2);
  };
  return { label, update };
}

function layerBoxes(page: Document, port: ControlPort) {
  const boxes = LAYER_NAMES.map((name) => {
    const box = element(page, "input", { type: "checkbox", name });
    box.addEventListener("change", () => port.setLayer(name, box.checked));
    return box;
  });
  const labels = LAYER_NAMES.map((name, i) => element(page, "label", {}, boxes[i], LAYER_TITLES[name]));
  const group = element(page, "fieldset", {}, element(page, "legend", {}, translated("Show")), ...labels);
  const update = ({ layers }: State) => LAYER_NAMES.forEach((name, i) => (boxes[i].checked = layers.has(name)));
  return { group, update };
}
