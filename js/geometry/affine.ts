// Affine maps as arguments.
import * as check from "./check.js";
import { readTransform } from "../io/transform-text.js";
import type { TransformLike } from "./check.js";

/**
 * The coefficients of a 3D affine map, as four columns of 3 numbers.
 *
 * @internal
 */
export function affine(matrix: TransformLike): number[] {
  const m = typeof matrix === "string" ? readTransform(matrix, "matrix") : check.matrixNumbers(matrix);
  if (m.length === 6) return [m[0], m[1], 0, m[2], m[3], 0, 0, 0, 1, m[4], m[5], 0];
  if (m[3] !== 0 || m[7] !== 0 || m[11] !== 0 || m[15] !== 1) {
    throw new RangeError(
      `matrix: expected an affine map (last row 0 0 0 1), got ${[m[3], m[7], m[11], m[15]].join(" ")}`,
    );
  }
  return [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10], m[12], m[13], m[14]];
}
