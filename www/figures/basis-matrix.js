// <basis-matrix for="id">: the basis matrix of an applet as sixteen fields.
import { Curve } from "casteljau";
import { element } from "../parts/dom.js";
import { LinkedFigure } from "./lib/linked-figure.js";
import { formatNumber, matrixSummary, parseNumber } from "./lib/matrix.js";

const ROWS = ["t³", "t²", "t", "1"];
/** The bases with a matrix of their own. */
const NAMED = ["bezier", "hermite", "b-spline", "catmull-rom"];

class BasisMatrix extends LinkedFigure {
  #fields = ROWS.flatMap((row, i) => [0, 1, 2, 3].map((k) => field(`Row ${row}, column P${k}`, 4 * i + k)));
  #summary = element("p", { className: "note" });

  build() {
    this.#summary.setAttribute("role", "status");
    this.append(table(this.#fields), this.#summary);
    this.addEventListener("input", () => this.#onInput());
  }

  follow() {
    const { basis, matrix } = this.target.figure;
    const numbers = NAMED.includes(basis) ? matrixOf(basis) : matrix;
    if (!numbers || this.contains(document.activeElement)) return; // what is being typed is not overwritten
    this.#fields.forEach((input, i) => (input.value = formatNumber(numbers[i])));
    this.#summary.textContent = matrixSummary(this.#numbers());
  }

  #numbers() {
    return this.#fields.map((input) => parseNumber(input.value));
  }

  #onInput() {
    const numbers = this.#numbers();
    const wrong = this.#fields.find((_, i) => !Number.isFinite(numbers[i]));
    this.#summary.textContent = wrong
      ? `${wrong.getAttribute("aria-label")}: expected a number, got “${wrong.value.trim()}”. The last valid matrix stays in use.`
      : matrixSummary(numbers);
    this.#fields.forEach((input) => input.setAttribute("aria-invalid", String(input === wrong)));
    if (!wrong) this.setTarget({ matrix: numbers.join(" "), basis: "matrix" }, "change");
  }
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

customElements.define("basis-matrix", BasisMatrix);
