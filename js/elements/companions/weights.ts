// What each control point counts for at t.
import { Curve } from "../../geometry/curve/curve.js";

/** The bases that a companion knows by itself. */
export const BASES = ["bezier", "hermite", "b-spline", "catmull-rom"] as const;
export const MAX_DEGREE = 64;
/** Those bases act on four points, through their matrix. */
export const MATRIX_DEGREE = 3;

export type Basis = (typeof BASES)[number] | "matrix";

/**
 * The weights of the degree + 1 points; those of a rational curve are its basis functions wᵢ Bᵢ(t) / Σ wⱼ Bⱼ(t).
 *
 * @param weights wᵢ, of a rational curve
 */
export function weightsAt(
  {
    basis,
    degree,
    matrix,
    weights,
  }: { basis: Basis; degree: number; matrix: ArrayLike<number> | null; weights?: readonly number[] | null },
  t: number,
): number[] {
  if (weights) {
    const products = Curve.bernstein(degree, t).map((value, i) => value * weights[i]);
    const sum = products.reduce((total, each) => total + each, 0);
    return Array.from(products, (each) => each / sum);
  }
  if (basis === "bezier") return [...Curve.bernstein(degree, t)];
  if (basis === "b-spline" && degree !== MATRIX_DEGREE) return uniformWeights(degree, t);
  return throughMatrix(matrixOf(basis, degree, matrix) ?? [], t);
}

/**
 * [tⁿ … t 1] · M.
 *
 * @param matrix square, row-major
 */
export function throughMatrix(matrix: number[], t: number): number[] {
  const size = Math.sqrt(matrix.length);
  const columns = Array.from({ length: size }, (_, k) => k);
  return columns.map((column) => columns.reduce((sum, row) => sum * t + matrix[row * size + column], 0));
}

/** The matrix of a basis, whose rows belong to tⁿ … t, 1; null where it has none. */
export function matrixOf(basis: Basis, degree: number, matrix: ArrayLike<number> | null): number[] | null {
  if (basis === "matrix") return matrix && Array.from(matrix);
  if (basis === "bezier" && degree !== MATRIX_DEGREE) return bernsteinMatrix(degree);
  return degree === MATRIX_DEGREE ? [...Curve.basisMatrix(basis)] : null;
}

/** The coefficient of tʲ in the Bernstein polynomial i is (−1)^(j−i) · C(n, j) · C(j, i). */
function bernsteinMatrix(n: number) {
  const powers = Array.from({ length: n + 1 }, (_, row) => n - row);
  return powers.flatMap((j) => powers.map((_, i) => (i > j ? 0 : (-1) ** (j - i) * binomial(n, j) * binomial(j, i))));
}

/** n over k, exact up to n = 56 and rounded above. */
export function binomial(n: number, k: number) {
  let value = 1;
  for (let i = 1; i <= Math.min(k, n - k); i++) value = (value * (n - i + 1)) / i;
  return Math.round(value);
}

/**
 * The weights of a uniform B-spline between two of its knots, by the Cox-de Boor recursion.
 *
 * Source: C. de Boor, "On calculating with B-splines", Journal of Approximation Theory 6 (1972).
 */
function uniformWeights(degree: number, t: number) {
  let weights = [1];
  for (let n = 1; n <= degree; n++) {
    const before = weights;
    weights = Array.from(
      { length: n + 1 },
      (_, i) => ((t + n - i) * (before[i - 1] ?? 0) + (i + 1 - t) * (before[i] ?? 0)) / n,
    );
  }
  return weights;
}
