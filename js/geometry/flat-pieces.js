// Recursive subdivision of a surface into flat pieces.
import { core, take, trim } from "../wasm/surfaces-transfer.js";
import * as check from "./check.js";

/**
 * A piece of a patch that counts as flat: where it lies in u and v, and the points S(u0, v0), S(u1, v0), S(u1, v1),
 * S(u0, v1), three numbers each. The recursion draws the triangles 0 1 2 and 0 2 3 of these corners.
 *
 * @typedef {{ patch: number, u0: number, u1: number, v0: number, v1: number, corners: Float64Array }} FlatPiece
 */

/** The numbers of a flat piece: patch, u0, u1, v0, v1, four corners. */
const HEAD_LENGTH = 5;
const PIECE_LENGTH = HEAD_LENGTH + 12;

/**
 * @internal
 * @param {() => unknown} load
 * @param {number} tolerance
 * @returns {FlatPiece[]}
 */
export function subdivide(load, tolerance) {
  check.positive(tolerance, "tolerance");
  load();
  const numbers = take(0, core().surface_subdivide(tolerance));
  trim();
  return Array.from({ length: numbers.length / PIECE_LENGTH }, (_, k) => {
    const at = k * PIECE_LENGTH;
    const [patch, u0, u1, v0, v1] = numbers.subarray(at, at + HEAD_LENGTH);
    return { patch, u0, u1, v0, v1, corners: numbers.slice(at + HEAD_LENGTH, at + PIECE_LENGTH) };
  });
}
