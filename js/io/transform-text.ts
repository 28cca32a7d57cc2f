// The `transform` attribute of SVG and the 2D functions of the CSS property of the same name.
import { describe } from "../geometry/describe.js";
import { directionOfDegrees } from "./svg-arc.js";

export type Affine = [number, number, number, number, number, number];

/** The numbers of arguments that each function accepts. */
const COUNTS: Record<string, readonly number[]> = {
  matrix: [6],
  translate: [1, 2],
  translateX: [1],
  translateY: [1],
  scale: [1, 2],
  scaleX: [1],
  scaleY: [1],
  rotate: [1, 3],
  skewX: [1],
  skewY: [1],
};

/** How many degrees a unit of angles is. */
const DEGREES: Record<string, number> = { deg: 1, rad: 180 / Math.PI, grad: 0.9, turn: 360 };

const FUNCTION = /\s*([A-Za-z]+)\s*\(([^()]*)\)\s*,?/y;
const ARGUMENT = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(px|deg|rad|grad|turn|%)?$/i;

/**
 * The affine map of a list of transform functions, the last of which is applied first. Angles are degrees unless they
 * have a unit of CSS.
 *
 * @internal
 * @returns the matrix a, b, c, d, e, f
 * @throws {RangeError} for any other text
 */
export function readTransform(text: string, name: string): Affine {
  let matrix: Affine = [1, 0, 0, 1, 0, 0];
  if (text.trim() === "none") return matrix;
  FUNCTION.lastIndex = 0;
  while (FUNCTION.lastIndex < text.trimEnd().length) {
    const start = FUNCTION.lastIndex;
    const found = FUNCTION.exec(text);
    const map = found && mapOf(found[1], found[2]);
    if (!map) {
      const expected = "functions such as translate(50 50) or rotate(30)";
      throw new RangeError(`${name}: expected ${expected} at offset ${start}, got ${describe(text.slice(start))}`);
    }
    matrix = product(matrix, map);
  }
  return matrix;
}

function mapOf(name: string, list: string): Affine | null {
  const words = list.trim() ? list.trim().split(/\s*,\s*|\s+/) : [];
  if (!Object.hasOwn(COUNTS, name) || !COUNTS[name].includes(words.length)) return null;
  const isAngle = (k: number) => name.startsWith("skew") || (name === "rotate" && k === 0);
  const isLength = (k: number) => name.startsWith("translate") || (name === "rotate" && k > 0);
  const n: number[] = [];
  for (const [k, word] of words.entries()) {
    const [, number, unit = ""] = ARGUMENT.exec(word) ?? [];
    const lower = unit.toLowerCase();
    const fits = !unit || (lower === "px" ? isLength(k) : lower === "%" ? name.startsWith("scale") : isAngle(k));
    if (number === undefined || !fits) return null;
    n.push(Number(number) * (lower === "%" ? 0.01 : (DEGREES[lower] ?? 1)));
  }
  switch (name) {
    case "matrix":
      return n as Affine;
    case "translate":
      return [1, 0, 0, 1, n[0], n[1] ?? 0];
    case "translateX":
      return [1, 0, 0, 1, n[0], 0];
    case "translateY":
      return [1, 0, 0, 1, 0, n[0]];
    case "scale":
      return [n[0], 0, 0, n[1] ?? n[0], 0, 0];
    case "scaleX":
      return [n[0], 0, 0, 1, 0, 0];
    case "scaleY":
      return [1, 0, 0, n[0], 0, 0];
    case "skewX":
      return [1, 0, tangent(n[0]), 1, 0, 0];
    case "skewY":
      return [1, tangent(n[0]), 0, 1, 0, 0];
    default: {
      const [x, y] = [n[1] ?? 0, n[2] ?? 0];
      const [cos, sin] = directionOfDegrees(n[0]);
      return [cos, sin, -sin, cos, x - cos * x + sin * y, y - sin * x - cos * y];
    }
  }
}

function tangent(degrees: number) {
  const [cos, sin] = directionOfDegrees(degrees);
  return sin / cos;
}

/**
 * @param n applied first
 */
function product([a, b, c, d, e, f]: Affine, [p, q, r, s, x, y]: Affine): Affine {
  return [a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, a * x + c * y + e, b * x + d * y + f];
}
