// Projective maps as arguments.
import * as check from "../check.js";
import type { TransformLike } from "../check.js";

/** The numbers of an affine map, of a projective map of the plane, and of one of space. */
const COUNTS = [6, 9, 16];

/**
 * The 4×4 numbers of a projective map, column by column.
 *
 * @internal
 * @returns undefined for an affine map, which `affine` reads
 * @throws {RangeError} for a map of the plane and a curve in space
 */
export function projective(matrix: TransformLike, dimension: 2 | 3): Float64Array | undefined {
  if (typeof matrix === "string") return undefined;
  const m = check.matrixNumbers(matrix, "matrix", COUNTS);
  if (m.length === 9) {
    if (dimension === 3) throw new RangeError("matrix: expected 6 or 16 numbers for a curve in space, got 9");
    return Float64Array.of(m[0], m[1], 0, m[2], m[3], m[4], 0, m[5], 0, 0, 1, 0, m[6], m[7], 0, m[8]);
  }
  return m.length === 6 || (m[3] === 0 && m[7] === 0 && m[11] === 0 && m[15] === 1) ? undefined : m;
}
