// A companion that stands alone: what its attributes say.
import { Curve } from "../../index.js";
import { readNumber, readPoints } from "./numbers.js";
import { withTangents } from "./subject.js";
import { BASES, MATRIX_DEGREE, MOST_DEGREE } from "./weights.js";

/**
 * @import { Place, Subject } from "./subject.js"
 * @import { Basis } from "./weights.js"
 */

/** @typedef {<T>(name: string, value: T, usable: boolean, expected: string, fallback: T) => T} Check */

/** The first curve of the applet. @type {Place[]} */
export const FIRST_POINTS = [[70, 330], [110, 90], [235, 120], [325, 230]];
const FIRST_T = 0.5;

/**
 * @param {{ given: PointsLike, t: number, degree: number | null, basis: string, matrix: string }} attributes
 * @param {Check} check
 * @returns {Subject}
 */
export function ownSubject({ given: points, t: given, degree, basis: word, matrix: numbers }, check) {
  const matrix = ownMatrix(numbers);
  const known = BASES.some((name) => name === word) || (word === "matrix" && matrix !== null);
  const basis = /** @type {Basis} */ (check("basis", word, known, `one of ${BASES.join(", ")}, or matrix and 16 numbers in matrix`, BASES[0]));
  const t = check("t", given, Number.isFinite(given), "a number", FIRST_T);
  const all = ownPoints(points, check);
  const free = basis === "bezier" || basis === "b-spline";
  const most = Math.min(all.length - 1, MOST_DEGREE);
  const wanted = degree ?? (free ? most : MATRIX_DEGREE);
  const count = check("degree", wanted, Number.isInteger(wanted) && wanted >= 1 && wanted <= most, `a whole number from 1 to ${most}, for ${all.length} points`, most);
  const chosen = free ? all.slice(0, count + 1) : all.length > MATRIX_DEGREE ? all.slice(0, MATRIX_DEGREE + 1) : FIRST_POINTS;
  const names = chosen.map((_, i) => `P${i}`);
  const geometry = basis === "hermite" ? withTangents(chosen, names) : { points: chosen, names };
  return { basis, degree: chosen.length - 1, matrix, t, ...geometry, curve: curveOf(basis, geometry.points, matrix), indices: [] };
}

/**
 * @param {Basis} basis
 * @param {Place[]} points
 * @param {number[] | null} matrix
 */
function curveOf(basis, points, matrix) {
  if (basis === "bezier") return new Curve(points);
  if (points.length !== MATRIX_DEGREE + 1) return null;
  return Curve.fromBasis(basis === "matrix" ? matrix ?? [] : basis, points);
}

/**
 * The points of an attribute or a property, two at least; else the first curve's.
 *
 * @param {PointsLike} given
 * @param {Check} check
 * @returns {Place[]}
 */
export function ownPoints(given, check) {
  if (given === null || given === "") return FIRST_POINTS;
  try {
    const points = readPoints(pointsText(given));
    if (points.length > 1) return points;
  } catch {
    // what is wrong is said below
  }
  check("points", pointsText(given), false, "at least two points x,y x,y …", FIRST_POINTS.join(" "));
  return FIRST_POINTS;
}

/** Points as text or as pairs. @typedef {string | ArrayLike<number>[] | null} PointsLike */

/** As the attribute has them. @param {PointsLike} given */
export function pointsText(given) {
  return typeof given === "string" ? given : Array.from(given ?? [], (point) => Array.from(point).join(",")).join(" ");
}

/**
 * Sixteen numbers, or null.
 *
 * @param {string | null} text
 */
export function ownMatrix(text) {
  const numbers = (text ?? "").split(/[\s,;]+/).filter(Boolean).map(readNumber);
  return numbers.length === 16 && !numbers.some(Number.isNaN) ? numbers : null;
}
