// Small drawings in SVG.

const SPACE = "http://www.w3.org/2000/svg";

/**
 * @param {string} tag
 * @param {Record<string, string | number>} [attributes]
 * @param {...(Node | string)} children
 * @returns {SVGElement}
 */
export function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.append(...children);
  return made;
}

/** The points of a polyline as SVG has them. @param {[number, number][]} points */
export const chain = (points) => points.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(" ");

/**
 * A slider with its label and its value, as in <attribute-slider>.
 *
 * @param {string} label
 * @param {{ min: number, max: number, step: number, value: number, name: string }} range
 * @param {(value: number, type: "input" | "change") => void} act
 */
export function slider(label, range, act) {
  const input = Object.assign(document.createElement("input"), { type: "range", ...range, value: String(range.value) });
  const output = Object.assign(document.createElement("output"), { textContent: String(range.value) });
  for (const type of /** @type {const} */ (["input", "change"])) {
    input.addEventListener(type, () => {
      output.textContent = input.value;
      act(input.valueAsNumber, type);
    });
  }
  const line = Object.assign(document.createElement("label"), { className: "line" });
  line.append(Object.assign(document.createElement("span"), { textContent: label }), input, output);
  return { line, input, output };
}
