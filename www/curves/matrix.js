// The basis matrix as sixteen fields that can be typed into.
import { Curve } from "casteljau";

const ROWS = ["t³", "t²", "t", "1"];
/** The bases with a matrix of their own. */
const NAMED = ["bezier", "hermite", "b-spline", "catmull-rom"];

/**
 * @typedef {HTMLElement & { figure: { basis: string, matrix: ArrayLike<number> } }} Applet
 */

/**
 * @param {HTMLElement} place
 * @param {Applet} applet
 */
export function matrixEditor(place, applet) {
  const fields = ROWS.flatMap((row, i) => [0, 1, 2, 3].map((k) => field(`Row ${row}, column P${k}`, 4 * i + k)));
  const words = Object.assign(document.createElement("p"), { className: "words" });
  words.setAttribute("role", "status");
  place.append(table(fields), words);
  place.addEventListener("input", () => {
    const wrong = fields.find((input) => !Number.isFinite(numberIn(input.value)));
    words.textContent = wrong
      ? `${wrong.getAttribute("aria-label")}: ${wrong.value.trim() || "nothing"} is no number. The last matrix holds.`
      : tell(fields.map((input) => numberIn(input.value)));
    fields.forEach((input) => input.setAttribute("aria-invalid", String(input === wrong)));
    if (wrong) return;
    applet.setAttribute("matrix", fields.map((input) => numberIn(input.value)).join(" "));
    applet.setAttribute("basis", "matrix");
    applet.dispatchEvent(new Event("change", { bubbles: true, composed: true })); // a reader did this, with the figure's own points
  });
  const show = () => {
    const { basis } = applet.figure;
    const numbers = NAMED.includes(basis) ? matrixOf(basis) : applet.figure.matrix;
    if (!numbers || place.contains(document.activeElement)) return; // nobody's typing is overwritten
    fields.forEach((input, i) => (input.value = written(numbers[i])));
    words.textContent = tell([...fields].map((input) => numberIn(input.value)));
  };
  applet.addEventListener("update", show);
  show();
}

/** For the applet Hermite's handles are the velocities: P1 − P0 and P3 − P2. @param {string} basis @returns {ArrayLike<number>} */
function matrixOf(basis) {
  const own = Curve.basisMatrix(/** @type {any} */ (basis));
  if (basis !== "hermite") return own;
  return ROWS.flatMap((_, i) => {
    const [p0, p1, m0, m1] = own.slice(4 * i, 4 * i + 4);
    return [p0 - m0, m0, -m1, p1 + m1];
  });
}

/** What the numbers mean for the curve. @param {number[]} matrix */
export function tell(matrix) {
  const sums = ROWS.map((_, i) => matrix.slice(4 * i, 4 * i + 4).reduce((sum, x) => sum + x, 0));
  const near = (/** @type {number} */ a, /** @type {number} */ b) => Math.abs(a - b) < 1e-6;
  const mixture = near(sums[3], 1) && sums.slice(0, 3).every((sum) => near(sum, 0));
  return mixture
    ? "At every t the weights add up to 1: a mixture of the points."
    : "The weights do not add up to 1: move the whole figure, and the curve does not move along.";
}

/** "−1/6" or "0.5" as a number. @param {string} text */
export function numberIn(text) {
  const [top, bottom, ...more] = text
    .replace("−", "-")
    .split("/")
    .map((part) => (part.trim() === "" ? NaN : Number(part)));
  return more.length > 0 ? NaN : bottom === undefined ? top : top / bottom;
}

/** Sixths are written as people do. @param {number} value */
export function written(value) {
  const sixths = Math.round(6 * value);
  if (Math.abs(value - sixths / 6) > 1e-12 || sixths % 3 === 0) return signed(String(value));
  return signed(sixths % 2 === 0 ? `${sixths / 2}/3` : `${sixths}/6`);
}

/** @param {string} text */
const signed = (text) => text.replace("-", "−");

/** @param {string} name @param {number} index */
function field(name, index) {
  const input = Object.assign(document.createElement("input"), {
    type: "text",
    inputMode: "text",
    autocomplete: "off",
    spellcheck: false,
  });
  input.setAttribute("aria-label", name);
  input.dataset.index = String(index);
  return input;
}

/** @param {HTMLInputElement[]} fields */
function table(fields) {
  const made = document.createElement("table");
  const cell = (/** @type {string} */ tag, /** @type {string | Node} */ inside, scope = "") => {
    const node = document.createElement(tag);
    if (scope) /** @type {HTMLTableCellElement} */ (node).scope = scope;
    node.append(inside);
    return node;
  };
  const head = document.createElement("tr");
  head.append(cell("td", ""), ...["P0", "P1", "P2", "P3"].map((name) => cell("th", name, "col")));
  made.append(head);
  ROWS.forEach((row, i) => {
    const line = document.createElement("tr");
    line.append(cell("th", row, "row"), ...fields.slice(4 * i, 4 * i + 4).map((input) => cell("td", input)));
    made.append(line);
  });
  return made;
}
