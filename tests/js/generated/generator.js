// The program of tests/generator, which makes the cases for both languages.
import { execFileSync } from "node:child_process";

/** The lines that a program writes, without empty ones. */
function linesOf(program, words) {
  const stdio = /** @type {["ignore", "pipe", "inherit"]} */ (["ignore", "pipe", "inherit"]);
  const text = execFileSync(program, words, { encoding: "utf8", maxBuffer: 2 ** 30, stdio });
  return text.split("\n").filter(Boolean);
}

/** Builds the program and gives its path. CASTELJAU_GENERATOR may name one that is built already. */
export function generatorPath() {
  if (process.env.CASTELJAU_GENERATOR) return process.env.CASTELJAU_GENERATOR;
  const build = "build --quiet --package casteljau-generator --message-format json".split(" ");
  const messages = linesOf("cargo", build).map((line) => JSON.parse(line));
  const path = messages.findLast(({ executable }) => executable)?.executable;
  if (!path) throw new Error("cargo built no program casteljau-generator");
  return path;
}

/** The lines of some cases. @param {string} path @param {(string | number)[]} request seed, function, first, count */
export const lines = (path, ...request) => linesOf(path, request.map(String));

/** Functions without a row of their own, and those whose cases they take. @type {Record<string, string>} */
const SAME_CASES = {
  "Curve.points": "Curve.controlPoints",
  "Curve.toString": "Curve.toJSON",
  "Curve.toThree": "Curve.pointAtLength",
  "RationalCurve.toString": "RationalCurve.toJSON",
  "NurbsCurve.toString": "NurbsCurve.toJSON",
  "RationalPatch.toString": "RationalPatch.toJSON",
  "NurbsSurface.toString": "NurbsSurface.toJSON",
  "Spline.points": "Spline.controlPoints",
  "Spline.toString": "Spline.toJSON",
  "Spline.toThree": "Spline.pointAtLength",
  "InkStroke.constructor": "InkStroke.outline",
  "InkStroke.append": "InkStroke.outline",
  "InkStroke.changes": "InkStroke.outline",
  "InkStroke.spline": "InkStroke.outline",
  "InkStroke.widths": "InkStroke.outline",
  "Path.toString": "Path.toJSON",
  "Path.lengthAt": "Path.eval",
  "Path.splitAt": "Path.split",
  "Path.index": "Path.nearest",
  "Path.toThree": "Path.removeOverlaps",
  "Path.toCSS": "Path.toSVG",
  "Path.toPathData": "Path.toPath2D",
  "Path.fromPathData": "Path.toPath2D",
  "Path.builder": "Path.toPath2D",
};

/** The name of a function in the generator's table. */
export const rowOf = (name) =>
  (SAME_CASES[name] ?? name)
    .replace("constructor", "new")
    .replace(/\.equals$/, ".approx_eq")
    .replace(/^easing$/, "Easing.eval")
    .replace(/^Easing\.toLinear$/, "Easing.to_linear");
