// Joins at the corners of strokes and offset curves.
import * as check from "./check.js";

/** What corners of a stroke look like: the outer sides extended to their intersection, an arc, or a straight line. */
export type StrokeJoin = "miter" | "round" | "bevel";

/** In the order of `offset_join` in src/wasm/offset.rs */
const JOINS: readonly StrokeJoin[] = ["round", "miter", "bevel"];

/**
 * The core's code for a join.
 *
 * @internal
 */
export function joinCode(join: StrokeJoin): number {
  return JOINS.indexOf(check.oneOf(join, "join", JOINS));
}
