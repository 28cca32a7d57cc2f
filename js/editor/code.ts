// Programs that make the same curve.
import { weightWords } from "./descriptions.js";
import type { Figure } from "./figure.js";
import type { State } from "./state.js";

export type Language = "js" | "rust" | "canvas";

/** A program that makes the same curve. */
export function codeOf(state: State, figure: Figure, language: Language): string {
  const write = { js: jsOf, rust: rustOf, canvas: canvasOf }[language];
  if (!write) throw new RangeError(`language: expected js, rust, canvas, got ${JSON.stringify(language)}`);
  return figure.pieces.length + figure.rational.length ? write(state, figure) : "// Too few points for a curve.\n";
}

const short = (x: number) => String(Number(x.toFixed(3)));
/** @param x as Rust writes it */
const float = (x: number) => (Number.isInteger(Number(short(x))) ? `${short(x)}.0` : short(x));
const floatWeight = (x: number) => weightWords(x).replace(/^\d+$/, "$&.0");

function pairsOf(flat: ArrayLike<number>): number[][] {
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
}

/** How the package makes the curve from the points themselves. */
const MAKERS: Partial<Record<State["basis"], (degree: number) => string>> = {
  bezier: (degree) => `new Spline(points, { degree: ${degree} })`,
  "b-spline": (degree) => `Spline.fromBSpline(points, { degree: ${degree} })`,
  natural: () => `Spline.interpolate(points, { kind: "natural" })`,
  centripetal: () => `Spline.interpolate(points, { kind: "catmull-rom" })`,
};

function jsOf({ basis, t, segment }: State, figure: Figure) {
  const { points, kinds, pieces, degree } = figure;
  const make = MAKERS[basis];
  const list = (places: readonly (readonly number[])[]) =>
    `[\n${places.map((place) => `  [${place.map(short).join(", ")}],`).join("\n")}\n]`;
  if (figure.rational.length) {
    const curves = figure.rational.map(
      ({ curve }) =>
        `new RationalCurve(${list(pairsOf(curve.controlPoints()))}, [${[...curve.weights()].map(weightWords).join(", ")}])`,
    );
    const at = Math.min(segment, curves.length - 1);
    return `import { RationalCurve } from "casteljau/nurbs";\n\nconst curves = [${curves.join(", ")}];\nconst { x, y } = curves[${at}].eval(${short(t)});\n`;
  }
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

function rustOf({ t, segment }: State, { pieces, rational }: Figure) {
  if (rational.length) {
    const curves = rational.map(({ curve }) => {
      const points = pairsOf(curve.controlPoints()).map((place) => `DVec2::new(${place.map(float).join(", ")})`);
      return `    RationalCurve::new(&[${points.join(", ")}], &[${[...curve.weights()].map(floatWeight).join(", ")}])?,`;
    });
    const at = Math.min(segment, curves.length - 1);
    return `use casteljau::{RationalCurve, glam::DVec2};\n\nlet curves = [\n${curves.join("\n")}\n];\nlet point = curves[${at}].eval(${float(t)});\n`;
  }
  const lists = pieces.map(
    ({ curve }) =>
      `    Curve::new(&[${pairsOf(curve.controlPoints())
        .map((place) => `DVec2::new(${place.map(float).join(", ")})`)
        .join(", ")}])?,`,
  );
  const at = Math.min(segment, pieces.length - 1);
  return `use casteljau::{Curve, glam::DVec2};\n\nlet curves = [\n${lists.join("\n")}\n];\nlet point = curves[${at}].eval(${float(t)});\n`;
}

function canvasOf(_: State, { pieces, rational, spline }: Figure) {
  const calls: string[] = [];
  const call =
    (name: string | symbol) =>
    (...numbers: number[]) =>
      calls.push(`ctx.${String(name)}(${numbers.map(short).join(", ")});`);
  const ctx = new Proxy({}, { get: (__, name) => call(name) }) as any;
  if (spline) spline.trace(ctx);
  else for (const { curve } of [...pieces, ...rational]) curve.trace(ctx);
  return ["ctx.beginPath();", ...calls, "ctx.stroke();", ""].join("\n");
}
