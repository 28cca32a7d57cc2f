// A companion that stands alone: what its attributes say.
import { Curve } from "../../geometry/curve/curve.js";
import { readNumber } from "../../ui/numbers.js";
import { FIRST_POINTS, ownPoints, pointsText } from "./points.js";
import { withTangents } from "./subject.js";
import { BASES, MATRIX_DEGREE, MAX_DEGREE } from "./weights.js";
import type { Check, Point2, PointsLike } from "./points.js";
import type { Subject } from "./subject.js";
import type { Basis } from "./weights.js";

const FIRST_T = 0.5;

export function standaloneCurve(
  {
    given: points,
    t: given,
    degree,
    basis: word,
    matrix: numbers,
  }: { given: PointsLike; t: number; degree: number | null; basis: string; matrix: string },
  check: Check,
): Subject {
  const matrix = ownMatrix(numbers);
  const known = BASES.some((name) => name === word) || (word === "matrix" && matrix !== null);
  const basis = check(
    "basis",
    word,
    known,
    `one of ${BASES.join(", ")}, or matrix and 16 numbers in matrix`,
    BASES[0],
  ) as Basis;
  const t = check("t", given, Number.isFinite(given), "a number", FIRST_T);
  const all = ownPoints(points, check);
  const free = basis === "bezier" || basis === "b-spline";
  const max = Math.min(all.length - 1, MAX_DEGREE);
  const wanted = degree ?? max;
  const count = check(
    "degree",
    wanted,
    Number.isInteger(wanted) && wanted >= 1 && wanted <= max,
    `a whole number from 1 to ${max}, for ${all.length} points`,
    max,
  );
  const needed = MATRIX_DEGREE + 1;
  const enough = free || all.length >= needed;
  if (!enough) check("points", pointsText(points), false, `${needed} points for ${basis}`, pointsText(FIRST_POINTS));
  const selected = enough ? all.slice(0, free ? count + 1 : needed) : FIRST_POINTS;
  const names = selected.map((_, i) => `P${i}`);
  const geometry = basis === "hermite" ? withTangents(selected, names) : { points: selected, names };
  return {
    basis,
    degree: selected.length - 1,
    matrix,
    t,
    ...geometry,
    curve: curveOf(basis, geometry.points, matrix),
    indices: [],
  };
}

function curveOf(basis: Basis, points: Point2[], matrix: number[] | null) {
  if (basis === "bezier") return new Curve(points);
  if (points.length !== MATRIX_DEGREE + 1) return null;
  return Curve.fromBasis(basis === "matrix" ? (matrix ?? []) : basis, points);
}

/** Sixteen numbers, or null. */
export function ownMatrix(text: string | null) {
  const numbers = (text ?? "")
    .split(/[\s,;]+/)
    .filter(Boolean)
    .map(readNumber);
  return numbers.length === 16 && !numbers.some(Number.isNaN) ? numbers : null;
}
