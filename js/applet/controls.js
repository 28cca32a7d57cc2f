// The bar below the picture: native form controls that call the applet and are set from its state.
import { element } from "./dom.js";
import { FEWEST_POINTS, JOINT_MODES, pointCount } from "./state.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./state.js").JointMode} JointMode */
/** @typedef {import("./state.js").Layers} Layers */

/**
 * What the controls do.
 *
 * @typedef {object} ControlPort
 * @property {() => void} randomize
 * @property {() => void} toggle
 * @property {() => void} append
 * @property {(mode: JointMode) => void} setJoint
 * @property {(t: number, done: boolean) => void} setT
 * @property {(name: keyof Layers, on: boolean) => void} setLayer
 */

/**
 * @typedef {object} Controls
 * @property {(state: State) => void} update
 * @property {() => boolean} pageWide whether `r` and `m` count on the whole page
 */

/** @type {Record<JointMode, string>} */
const JOINT_NAMES = { free: "Free", g1: "G1", c1: "C1" };
/** @type {Record<JointMode, string>} */
const JOINT_TITLES = {
  free: "Points move alone",
  g1: "P2, P3 and P4 stay aligned",
  c1: "P2, P3 and P4 stay aligned, and P3 stays half-way",
};
/** @type {Record<keyof Layers, string>} */
const LAYER_NAMES = {
  polygon: "control polygon",
  hull: "hull",
  construction: "de Casteljau at t",
  halves: "two halves at t",
};
const T_STEP = 0.01;
/** Up to so many points P3 is the only joint. */
const TWO_CUBICS = 7;

/**
 * Fills the bar.
 *
 * @param {HTMLElement} bar
 * @param {ControlPort} port
 * @returns {Controls}
 */
export function createControls(bar, port) {
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
    "Drag a point, or Tab to it and use the arrow keys. A double click adds a point.",
    element(page, "label", {}, keys, "r and m on the whole page"),
  );
  bar.append(buttons.row, joints.group, t.label, layers.group, hint);
  const update = (/** @type {State} */ state) => [joints, layers, t, buttons].forEach((part) => part.update(state));
  return { update, pageWide: () => keys.checked };
}

/**
 * @param {Document} page
 * @param {ControlPort} port
 */
function pointButtons(page, port) {
  const button = (
    /** @type {string} */ key,
    /** @type {() => void} */ onclick,
    /** @type {(Node | string)[]} */ ...words
  ) => element(page, "button", { type: "button", onclick, ...(key && { "aria-keyshortcuts": key }) }, ...words);
  const key = (/** @type {string} */ letter) => element(page, "kbd", {}, letter);
  const label = element(page, "span");
  const toggle = button("m", port.toggle, label, " ", key("m"));
  const randomize = button("r", port.randomize, "Randomize ", key("r"));
  const row = element(page, "div", { className: "row" }, randomize, toggle, button("", port.append, "Add a point"));
  const update = (/** @type {State} */ state) => {
    const most = pointCount(state);
    label.textContent = state.shown === FEWEST_POINTS ? `Show ${most} points` : `Show ${FEWEST_POINTS} points`;
    toggle.disabled = most === FEWEST_POINTS;
  };
  return { row, update };
}

/**
 * @param {Document} page
 * @param {ControlPort} port
 */
function jointSwitch(page, port) {
  const radios = JOINT_MODES.map((mode) =>
    element(page, "input", { type: "radio", name: "joint", value: mode, onchange: () => port.setJoint(mode) }),
  );
  const labels = JOINT_MODES.map((mode, i) =>
    element(page, "label", { title: JOINT_TITLES[mode] }, radios[i], JOINT_NAMES[mode]),
  );
  const legend = element(page, "legend", {}, "At P3 hold");
  const group = element(page, "fieldset", {}, legend, ...labels);
  const update = (/** @type {State} */ state) => {
    legend.textContent = state.shown > TWO_CUBICS ? "At every joint hold" : "At P3 hold";
    for (const radio of radios) radio.checked = radio.value === state.joint;
  };
  return { group, update };
}

/**
 * @param {Document} page
 * @param {ControlPort} port
 */
function tSlider(page, port) {
  const slider = element(page, "input", { type: "range", min: "0", max: "1", step: String(T_STEP), "aria-label": "t" });
  slider.addEventListener("input", () => port.setT(Number(slider.value), false));
  slider.addEventListener("change", () => port.setT(Number(slider.value), true));
  const output = element(page, "span", { className: "value", "aria-hidden": "true" }); // the slider tells its value itself
  const label = element(page, "label", { className: "t" }, element(page, "i", {}, "t"), slider, output);
  const update = (/** @type {State} */ { t }) => {
    slider.value = String(t);
    output.textContent = t.toFixed(2);
  };
  return { label, update };
}

/**
 * @param {Document} page
 * @param {ControlPort} port
 */
function layerBoxes(page, port) {
  const names = /** @type {(keyof Layers)[]} */ (Object.keys(LAYER_NAMES));
  const boxes = names.map((name) => {
    const box = element(page, "input", { type: "checkbox", name });
    box.addEventListener("change", () => port.setLayer(name, box.checked));
    return box;
  });
  const labels = names.map((name, i) => element(page, "label", {}, boxes[i], LAYER_NAMES[name]));
  const group = element(page, "fieldset", {}, element(page, "legend", {}, "Show"), ...labels);
  const update = (/** @type {State} */ { layers }) => names.forEach((name, i) => (boxes[i].checked = layers[name]));
  return { group, update };
}
