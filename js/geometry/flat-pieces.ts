// Recursive subdivision of a surface into flat pieces.
import { surfacesModule } from "../wasm/surfaces-module.js";
import * as check from "./check.js";

/**
 * A part of a patch that counts as flat: its range of u and v, and its corners S(u0, v0), S(u1, v0), S(u1, v1), S(u0,
 * v1), three numbers each. It is drawn as the triangles 0 1 2 and 0 2 3 of these corners.
 */
export type FlatPiece = { patch: number; u0: number; u1: number; v0: number; v1: number; corners: Float64Array };

/** The numbers of a flat piece: patch, u0, u1, v0, v1, four corners. */
const HEADER_LENGTH = 5;
const PIECE_LENGTH = HEADER_LENGTH + 12;

/**
 * The pieces of `Surface.subdivide`.
 *
 * @internal
 * @param writeSurface writes the surface to the arena
 */
export function subdivide(writeSurface: () => unknown, tolerance: number): FlatPiece[] {
  check.positive(tolerance, "tolerance");
  writeSurface();
  const numbers = surfacesModule.read(0, surfacesModule.functions.surface_subdivide(tolerance));
  surfacesModule.release();
  return Array.from({ length: numbers.length / PIECE_LENGTH }, (_, k) => {
    const at = k * PIECE_LENGTH;
    const [patch, u0, u1, v0, v1] = numbers.subarray(at, at + HEADER_LENGTH);
    return { patch, u0, u1, v0, v1, corners: numbers.slice(at + HEADER_LENGTH, at + PIECE_LENGTH) };
  });
}
