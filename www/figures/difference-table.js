// <difference-table>: a cubic evaluated by additions, and the rounding error.
import { element } from "../parts/dom.js";
import { chain, slider, svg } from "./lib/svg.js";
import { LinkedFigure } from "./lib/linked-figure.js";

/** Heights of a cubic: its control points. */
const HEIGHTS = [0.1, 1.1, 1.9, 0.3];
const [WIDTH, HEIGHT, MARGIN] = [420, 190, 46];
/** The plot begins with so many steps, and each next point has twice as many: no powers of two, with which nothing is rounded. */
const [FEWEST, OCTAVES] = [6, 10];
/** The plot's decades. */
const [LEAST, MOST] = [-17, -3];

/** @param {number} t */
export const cubic = (t) => HEIGHTS.reduce((sum, h, i) => sum + h * [1, 3, 3, 1][i] * t ** i * (1 - t) ** (3 - i), 0);

/** The first value and its three differences for n steps, from the coefficients of the powers. @param {number} n */
export function start(n) {
  const [h0, h1, h2, h3] = HEIGHTS;
  const [a, b, c] = [h3 - 3 * h2 + 3 * h1 - h0, 3 * (h2 - 2 * h1 + h0), 3 * (h1 - h0)];
  const step = 1 / n;
  return [h0, a * step ** 3 + b * step ** 2 + c * step, 6 * a * step ** 3 + 2 * b * step ** 2, 6 * a * step ** 3];
}

/**
 * All rows: the value and its differences at each step.
 *
 * @param {number} n
 * @param {(x: number) => number} round what the machine makes of a number
 */
export function rows(n, round = (x) => x) {
  const found = [start(n).map(round)];
  while (found.length <= n) {
    const [f, d1, d2, d3] = /** @type {number[]} */ (found.at(-1));
    found.push([round(f + d1), round(d1 + d2), round(d2 + d3), d3]);
  }
  return found;
}

/** The greatest error on the way. @param {number} n @param {(x: number) => number} round */
export const drift = (n, round = (x) => x) =>
  rows(n, round).reduce((most, [f], i) => Math.max(most, Math.abs(f - cubic(i / n))), 0);

class DifferenceTable extends LinkedFigure {
  #steps = 4;
  #body = element("tbody");
  #words = element("p", { className: "note" });

  build() {
    const head = element(
      "tr",
      {},
      ...["k", "value", "first", "second", "third", "exact"].map((word) =>
        Object.assign(element("th", { textContent: word }), { scope: "col" }),
      ),
    );
    const caption = element(
      "p",
      { className: "note" },
      "From k = 1 on, each value, first and second difference is the sum of the number above it and the one to the right of that. The column “exact” has the values of the cubic itself.",
    );
    const control = slider("Steps", { min: 2, max: 16, step: 1, value: this.#steps, name: "steps" }, (n, type) => {
      this.#steps = n;
      this.#fill();
      this.dispatchEvent(new Event(type, { bubbles: true }));
    });
    this.#words.setAttribute("role", "status");
    const scroll = element(
      "div",
      { className: "scroll", tabIndex: "0", role: "group", ariaLabel: "Table of differences" },
      element("table", {}, element("thead", {}, head), this.#body),
    );
    this.append(control.line, caption, scroll, this.#words, plot());
    this.#fill();
  }

  get figure() {
    return { steps: this.#steps, rows: rows(this.#steps), drift: drift(this.#steps, Math.fround) };
  }

  #fill() {
    const { steps, rows, drift } = this.figure;
    const cell = (/** @type {number} */ x) => element("td", { textContent: x.toFixed(4).replace("-", "−") });
    this.#body.replaceChildren(
      ...rows.map((row, i) =>
        element("tr", {}, element("td", { textContent: String(i) }), ...row.map(cell), cell(cubic(i / steps))),
      ),
    );
    this.#words.textContent = `${steps} steps take ${3 * steps} additions. With 32-bit floating-point numbers the largest error is ${drift.toExponential(1)}.`;
  }
}

/** Error against the number of steps, both by decades and octaves, for numbers of 32 and of 64 bits. */
function plot() {
  const octaves = Array.from({ length: OCTAVES + 1 }, (_, k) => k);
  const steps = (/** @type {number} */ k) => FEWEST * 2 ** k;
  const x = (/** @type {number} */ k) => MARGIN + (k / OCTAVES) * (WIDTH - MARGIN - 14);
  const y = (/** @type {number} */ error) =>
    HEIGHT - MARGIN - ((Math.max(Math.log10(error), LEAST) - LEAST) / (MOST - LEAST)) * (HEIGHT - MARGIN - 12);
  const line = (/** @type {string} */ name, /** @type {(x: number) => number} */ round) =>
    svg("polyline", { class: name, points: chain(octaves.map((k) => [x(k), y(drift(steps(k), round))])) });
  const ticks = [-16, -12, -8, -4].map((d) =>
    svg(
      "g",
      {},
      svg("path", { class: "grid", d: `M${MARGIN} ${y(10 ** d)}H${WIDTH - 8}` }),
      svg("text", { x: MARGIN - 5, y: y(10 ** d) + 4, "text-anchor": "end" }, `1e${String(d).replace("-", "−")}`),
    ),
  );
  const below = octaves
    .filter((k) => k % 2 === 0)
    .map((k) => svg("text", { x: x(k), y: HEIGHT - MARGIN + 16, "text-anchor": "middle" }, String(steps(k))));
  const names = [
    svg(
      "text",
      { x: x(OCTAVES), y: y(drift(steps(OCTAVES), Math.fround)) - 9, "text-anchor": "end", class: "single" },
      "32 bits",
    ),
    svg("text", { x: x(OCTAVES), y: y(drift(steps(OCTAVES))) + 18, "text-anchor": "end", class: "double" }, "64 bits"),
  ];
  const labels = [
    svg("text", { x: (MARGIN + WIDTH) / 2, y: HEIGHT - 3, "text-anchor": "middle" }, "steps"),
    svg("text", { x: MARGIN + 6, y: 12 }, "largest error"),
  ];
  return svg(
    "svg",
    {
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      class: "plot",
      role: "img",
      "aria-label":
        "The error grows with the number of steps: in 32 bits from 1e−7 to 1e−5 and beyond, in 64 bits it stays below 1e−12.",
    },
    ...ticks,
    ...below,
    ...labels,
    line("single", Math.fround),
    line("double", (v) => v),
    ...names,
  );
}

customElements.define("difference-table", DifferenceTable);
