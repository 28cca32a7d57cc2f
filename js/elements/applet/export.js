// The figure as a picture or as code.
import { drawFigure } from "./layers/index.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./figure.js").Figure} Figure */
/** @typedef {Record<import("./layers/index.js").Role, string>} Theme */

/**
 * The picture as PNG, as sharp as the page shows it.
 *
 * @param {State} state
 * @param {Figure} figure
 * @param {Theme} theme
 * @returns {Promise<Blob | null>}
 */
export function blobOf(state, figure, theme) {
  const scale = Math.max(1, devicePixelRatio);
  const canvas = Object.assign(document.createElement("canvas"), {
    width: state.box.width * scale,
    height: state.box.height * scale,
  });
  const ctx = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  ctx.scale(scale, scale);
  drawFigure({ ctx, theme, px: 1 }, state, figure);
  ctx.globalCompositeOperation = "destination-over"; // the paper lies below
  ctx.fillStyle = theme.paper;
  ctx.fillRect(0, 0, state.box.width, state.box.height);
  return new Promise((done) => canvas.toBlob(done));
}

/** @typedef {"js" | "rust" | "canvas"} Language */

/**
 * A program that makes the same curve.
 *
 * @param {State} state
 * @param {Figure} figure
 * @param {Language} language
 * @returns {string}
 */
export function codeOf(state, figure, language) {
  const write = { js: jsOf, rust: rustOf, canvas: canvasOf }[language];
  if (!write) throw new RangeError(`language: expected js, rust, canvas, got ${JSON.stringify(language)}`);
  return figure.pieces.length ? write(state, figure) : "// Too few points for a curve.\n";
}

/** @param {number} x */
const short = (x) => String(Number(x.toFixed(3)));
/** @param {number} x as Rust writes it */
const float = (x) => (Number.isInteger(Number(short(x))) ? `${short(x)}.0` : short(x));

/**
 * @param {ArrayLike<number>} flat
 * @returns {number[][]}
 */
function pairsOf(flat) {
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
}

/** How the package makes the curve from the points themselves. @type {Partial<Record<State["basis"], (degree: number) => string>>} */
const MAKERS = {
  bezier: (degree) => `new Spline(points, { degree: ${degree} })`,
  "b-spline": (degree) => `Spline.fromBSpline(points, { degree: ${degree} })`,
  natural: () => `Spline.interpolate(points, { kind: "natural" })`,
  centripetal: () => `Spline.interpolate(points, { kind: "catmull-rom" })`,
};

/**
 * @param {State} state
 * @param {Figure} figure
 */
function jsOf({ basis, t, segment }, figure) {
  const { points, kinds, pieces, degree } = figure;
  const make = MAKERS[basis];
  const list = (/** @type {readonly (readonly number[])[]} */ places) =>
    `[\n${places.map((place) => `  [${place.map(short).join(", ")}],`).join("\n")}\n]`;
  if (make) {
    const used = points.filter((_, i) => kinds[i] !== "wait");
    const at = Math.min(segment, pieces.length - 1);
    const beyond = t < 0 || t > 1; // a spline would go on in the neighbour
    const place = beyond ? `spline.segments()[${at}].eval(${short(t)})` : `spline.eval(${short(at + t)})`;
    return `import { Spline } from "casteljau";\n\nconst points = ${list(used)};\nconst spline = ${make(degree)};\nconst { x, y } = ${place};\n`;
  }
  const curves = pieces.map(({ curve }) => `new Curve(${list(pairsOf(curve.controlPoints()))})`);
  return `import { Curve } from "casteljau";\n\nconst curves = [${curves.join(", ")}];\nconst { x, y } = curves[${Math.min(segment, pieces.length - 1)}].eval(${short(t)});\n`;
}

/**
 * @param {State} state
 * @param {Figure} figure
 */
function rustOf({ t, segment }, { pieces }) {
  const lists = pieces.map(
    ({ curve }) =>
      `    Curve::new(&[${pairsOf(curve.controlPoints())
        .map((place) => `DVec2::new(${place.map(float).join(", ")})`)
        .join(", ")}])?,`,
  );
  const at = Math.min(segment, pieces.length - 1);
  return `use casteljau::{Curve, glam::DVec2};\n\nlet curves = [\n${lists.join("\n")}\n];\nlet point = curves[${at}].eval(${float(t)});\n`;
}

/**
 * @param {State} _
 * @param {Figure} figure
 */
function canvasOf(_, { pieces, spline }) {
  /** @type {string[]} */
  const calls = [];
  const call =
    (/** @type {string | symbol} */ name) =>
    (/** @type {number[]} */ ...numbers) =>
      calls.push(`ctx.${String(name)}(${numbers.map(short).join(", ")});`);
  const ctx = /** @type {any} */ (new Proxy({}, { get: (__, name) => call(name) }));
  if (spline) spline.trace(ctx);
  else for (const { curve } of pieces) curve.trace(ctx);
  return ["ctx.beginPath();", ...calls, "ctx.stroke();", ""].join("\n");
}
