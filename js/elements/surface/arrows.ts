// The two derivatives at a place of a patch, and the normal on both, as arrows.

import type { Patch } from "../../surfaces.js";

export type Vector = [number, number, number];

/** The longest arrow in radii of the surface, and no longer than so many of the patch; heads in arrows. */
const [LONGEST, LONGEST_OF_PATCH, HEAD] = [0.55, 0.65, 0.13];

/**
 * Straight pieces: the derivatives in one scale, the normal as long as the longer of them. Where both vanish there are
 * pieces without a length.
 *
 * @param radius of the surface
 */
export function arrowsAt(patch: Patch, u: number, v: number, radius: number) {
  const at = vector(patch.eval(u, v));
  const partials = patch.partials(u, v);
  const [alongU, alongV] = [vector(partials.u), vector(partials.v)];
  const length = Math.min(LONGEST * radius, LONGEST_OF_PATCH * radiusOf(patch));
  const scale = length / (Math.max(Math.hypot(...alongU), Math.hypot(...alongV)) || 1);
  const normal = times(vector(patch.normal(u, v)), length);
  const head = HEAD * length;
  return {
    u: arrow(at, times(alongU, scale), normal, head),
    v: arrow(at, times(alongV, scale), normal, head),
    normal: arrow(at, normal, alongU, head),
    at: Float32Array.from(at),
  };
}

/** Half the diagonal of the control points' box. */
function radiusOf(patch: Patch) {
  const points = patch.controlPoints();
  const sides = [0, 1, 2].map((axis) => {
    const along = points.filter((_, i) => i % 3 === axis);
    return Math.max(...along) - Math.min(...along);
  });
  return Math.hypot(...sides) / 2;
}

/** A shaft and two strokes at its tip, which lie in the plane of the arrow and another vector. */
function arrow(from: Vector, way: Vector, aside: Vector, head: number) {
  const tip = plus(from, way);
  const length = Math.hypot(...way);
  if (length === 0) return new Float32Array();
  const back = times(way, -Math.min(head / length, 0.5));
  const across = times(aside, (0.4 * Math.hypot(...back)) / (Math.hypot(...aside) || 1));
  const strokes = [1, -1].flatMap((side) => [...tip, ...plus(plus(tip, back), times(across, side))]);
  return Float32Array.from([...from, ...tip, ...strokes]);
}

const vector = ({ x, y, z = 0 }: { x: number; y: number; z?: number }): Vector => [x, y, z];
const times = ([x, y, z]: Vector, k: number): Vector => [k * x, k * y, k * z];
const plus = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
