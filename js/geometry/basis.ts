import { curvesModule } from "../wasm/curves-module.js";
import { numbers, oneOf, options as checkedOptions } from "./check.js";
import { flatten } from "./points.js";
import type { ControlPoints } from "./brand.js";
import type { PointsLike } from "./check.js";

/** The name of a basis of cubics. */
export type BasisName = "bezier" | "hermite" | "b-spline" | "catmull-rom";

/** A basis by name, or a 4×4 matrix, row-major: 16 numbers or 4 rows of 4. */
export type BasisLike = BasisName | ArrayLike<number> | ArrayLike<ArrayLike<number>>;

/**
 * The names, in the order of the core's codes.
 *
 * @internal
 */
export const BASES: readonly BasisName[] = ["bezier", "hermite", "b-spline", "catmull-rom"];

/**
 * The matrix of a basis, 16 numbers.
 *
 * @internal
 */
export function basisNumbers(basis: BasisLike): Float64Array {
  if (typeof basis === "string") {
    return curvesModule.read(0, curvesModule.functions.basis_matrix(BASES.indexOf(oneOf(basis, "basis", BASES))));
  }
  const rows = Array.isArray(basis) && Array.isArray(basis[0]) ? basis.flat() : basis;
  const matrix = numbers(rows, "basis");
  if (matrix.length !== 16) throw new RangeError(`basis: expected 16 numbers (4×4), got ${matrix.length}`);
  return matrix;
}

/**
 * The control points of the cubic of four geometry points in a basis.
 *
 * @internal
 */
export function pointsInBasis(basis: BasisLike, points: PointsLike, options?: { dimension?: 2 | 3 }): ControlPoints {
  const matrix = basisNumbers(basis);
  const { flat, dimension } = flatten(points, checkedOptions(options, ["dimension"]).dimension, 2);
  if (flat.length !== 4 * dimension) {
    throw new RangeError(`points: expected 4 points, got ${flat.length / dimension}`);
  }
  curvesModule.write(flat, 16).set(matrix, flat.length);
  return { flat: curvesModule.read(0, curvesModule.functions.curve_from_basis(dimension)), dimension };
}
