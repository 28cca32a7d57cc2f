// Makes a function of a sample: its inputs (the constants that a reader may drag) become an argument, so that the code that is shown is
// the code that runs.

/** What samples use without importing it; the import is added where a sample is shown. */
export const NAMES = ["Curve", "Spline", "Path", "InkStroke", "Patch", "Surface", "Mesh", "easing", "init"];

/** The same from `casteljau/nurbs`. */
export const NURBS_NAMES = ["RationalCurve", "NurbsCurve", "RationalPatch", "NurbsSurface", "RationalSurface"];

/**
 * @typedef {{ name: string, kind: "point" | "points" | "number" | "choice", value: any, start: number, end: number, min?: number, max?: number, step?: number, options?: any[] }} Input
 *   start and end: the position of the literal in the code
 */

const CONSTANT = /^const (\w+) = ([-\d[][-[\]\d\s.,e+]*|"[^"]*"|true|false);(?: \/\/ (.*))?$/gm;
const RANGE = /^(-?[\d.]+) to (-?[\d.]+)(?: step ([\d.]+))?$/;

/**
 * The inputs of a sample: constants that are a point, a list of points, a number whose comment is a range ("0 to 1"), or a text or
 * true/false whose comment lists the others. The comment "fixed" makes a constant of it.
 *
 * @param {string} code
 * @returns {Input[]}
 */
export function inputsOf(code) {
  const inputs = [];
  for (const match of code.matchAll(CONSTANT)) {
    const [, name, literal, comment = ""] = match;
    const value = JSON.parse(literal.replace(/,(\s*\])/g, "$1"));
    const described = comment === "fixed" ? undefined : describe(value, comment);
    const start = match.index + `const ${name} = `.length;
    if (described) inputs.push({ name, value, ...described, start, end: start + literal.length });
  }
  return inputs;
}

/** @param {any} value @param {string} comment */
function describe(value, comment) {
  if (isPoint(value)) return { kind: /** @type {const} */ ("point") };
  if (Array.isArray(value)) return value.every(isPoint) ? { kind: /** @type {const} */ ("points") } : undefined;
  if (typeof value === "number") {
    const range = RANGE.exec(comment);
    if (!range) return undefined;
    const [min, max] = [Number(range[1]), Number(range[2])];
    return { kind: /** @type {const} */ ("number"), min, max, step: Number(range[3] ?? (max - min) / 100) };
  }
  const others = comment.match(/"[^"]*"|true|false/g);
  return others
    ? { kind: /** @type {const} */ ("choice"), options: [value, ...others.map((text) => JSON.parse(text))] }
    : undefined;
}

/** @param {unknown} value */
const isPoint = (value) =>
  Array.isArray(value) && (value.length === 2 || value.length === 3) && value.every((x) => typeof x === "number");

/** The names of the package that a sample uses. @param {string} code */
export const usedNames = (code) =>
  [...NAMES, ...NURBS_NAMES].filter((name) => new RegExp(`(?<![.\\w"'])${name}\\b`).test(withoutComments(code)));

/** @param {string} code */
const withoutComments = (code) => code.replace(/\/\/.*$/gm, "");

/** The lines that import what a sample uses; empty if the sample has them. @param {string} code */
export const importLine = (code) => (code.includes('from "casteljau"') ? "" : importsOf(usedNames(code)));

/** The lines that import names of the package. @param {string[]} names */
export function importsOf(names) {
  const line = (/** @type {string[]} */ list, /** @type {string} */ entry) => {
    const used = list.filter((name) => names.includes(name));
    return used.length === 0 ? "" : `import { ${used.join(", ")} } from "${entry}";\n`;
  };
  return line(NAMES, "casteljau") + line(NURBS_NAMES, "casteljau/nurbs");
}

/**
 * The source of an object `{ inputs, run(inputs, console, draw) }`.
 *
 * @param {string} code the sample
 * @param {string} [draw] statements that draw, after the sample
 * @param {string[]} [more] expressions; `run` returns functions that evaluate them
 */
export function sampleSource(code, draw = "", more = []) {
  const inputs = inputsOf(code);
  const names = inputs.map(({ name }) => name).join(", ");
  let body = code.replace(/^import .*\n/gm, "");
  for (const { name } of inputs) body = body.replace(declarationOf(name), "");
  const given = JSON.stringify(inputs.map(({ start, end, ...input }) => input));
  const later = more.map((expression) => `() => (${expression.replace(/;$/, "")})`).join(", ");
  return `{ inputs: ${given},\nrun({ ${names} }, console, draw) {\n${body}\n${draw}\nreturn [${later}];\n} }`;
}

/** @param {string} name */
const declarationOf = (name) => new RegExp(`^const ${name} = [^;]*;.*\\n?`, "m");
