// Positions on paths, read from the arena.
import { curvesModule } from "../../wasm/curves-module.js";
import type { Point } from "../points.js";

/** A position on a path: the index of the subpath, and the parameter on it. */
export type PathTime = { subpath: number; t: number };

/** A position on a path with its point and the distance from the query point. */
export type PathPoint = PathTime & { point: Point<2>; distance: number };

/** A position on a path with its point, unit tangent and unit normal. */
export type PathPointAtLength = PathTime & { point: Point<2>; tangent: Point<2>; normal: Point<2> };

/**
 * Reads positions from the arena, two numbers each.
 *
 * @internal
 */
export function readTimes(length: number): PathTime[] {
  const numbers = curvesModule.read(0, length);
  return Array.from({ length: numbers.length / 2 }, (_, k) => ({ subpath: numbers[2 * k], t: numbers[2 * k + 1] }));
}

/**
 * The point of a packed path that is nearest to another one.
 *
 * @internal
 */
export function nearestOnPath(packed: Float64Array, point: Float64Array): PathPoint | null {
  curvesModule.write(packed, 2).set(point, packed.length);
  const [subpath, t, x, y, distance] = curvesModule.read(0, curvesModule.functions.path_nearest());
  return subpath === undefined ? null : { subpath, t, point: { x, y }, distance };
}
