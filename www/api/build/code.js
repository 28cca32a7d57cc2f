// Code as HTML: signatures with links to types, and samples whose inputs and printed lines can be changed by a live figure.
import { codeHighlighter, escapeHtml } from "../../build/highlight.js";
import { importLine, inputsOf } from "./sample.js";

const highlight = await codeHighlighter();

/** @param {string} code @param {"js" | "rust" | "ts"} language */
export const codeHtml = (code, language) => `<pre tabindex="0"><code>${highlight(code, language)}</code></pre>`;

const OUTPUT = /\/\/ → (.*)$/gm;

/** A JavaScript sample: inputs are marked with `data-input`, what is printed with `data-output`. @param {string} code */
export function sampleHtml(code) {
  const head = importLine(code);
  const inputs = inputsOf(code).map(({ name, start, end }) => ({ start, end, attribute: `data-input="${name}"` }));
  const outputs = Array.from(code.matchAll(OUTPUT), (match, k) => {
    const end = match.index + match[0].length;
    return { start: end - match[1].length, end, attribute: `data-output="${k}"` };
  });
  const marks = [...inputs, ...outputs].map((mark) => ({
    ...mark,
    start: mark.start + head.length,
    end: mark.end + head.length,
  }));
  return `<pre tabindex="0"><code>${highlight(head + code, "js", marks)}</code></pre>`;
}

const RUST_NAMES = [
  ...["Curve", "RationalCurve", "NurbsCurve", "Spline", "Path", "Patch", "RationalPatch", "NurbsSurface", "Surface"],
  ...["RationalSurface", "Mesh", "Easing"],
];

/** A Rust sample with the line that imports what it uses. @param {string} code */
export function rustSource(code) {
  const uses = (/** @type {string} */ name) => new RegExp(`(?<![\\w:])${name}\\b`).test(code.replace(/\/\/.*$/gm, ""));
  const imported = [...code.matchAll(/^use .*$/gm)].join("\n");
  const names = RUST_NAMES.filter((name) => uses(name) && !new RegExp(`\\b${name}\\b`).test(imported));
  const vectors = ["DAffine2", "DAffine3", "DMat4", "DVec2", "DVec3"].filter(
    (name) => uses(name) && !imported.includes(name),
  );
  if (vectors.length > 0) names.push(vectors.length === 1 ? `glam::${vectors[0]}` : `glam::{${vectors.join(", ")}}`);
  if (names.length === 0) return code;
  return `use casteljau::${names.length === 1 ? names[0] : `{${names.join(", ")}}`};\n${code}`;
}

/** @param {string} code */
export const rustHtml = (code) => codeHtml(rustSource(code), "rust");

/**
 * A type or a signature with links to the pages of the names in it.
 *
 * @param {string} text
 * @param {Map<string, string>} addresses
 */
export function linkedType(text, addresses) {
  return text
    .split(/\b([A-Za-z]+)\b/)
    .map((part, k) => {
      const address = k % 2 === 1 ? addresses.get(part) : undefined;
      return address ? `<a href="${address}">${part}</a>` : escapeHtml(part);
    })
    .join("");
}
