// How far lines are from the curve: recursive halving to a tolerance, and the greatest distance, measured.

import type { Curve } from "../index.js";
import type { Figure } from "../editor/figure.js";
import type { State } from "../editor/state.js";

export type Node = ReturnType<Curve["subdivide"]>;

/** The smallest tolerance, as a fraction of the length of a piece's control polygon: it bounds the time. */
const FINEST = 1e-5;
/** Steps between two vertices at which the distance is measured. */
const STEPS = 8;

/**
 * @returns `error`: the greatest distance between the curve and the lines, measured
 */
export function treeOf(
  { pieces }: Figure,
  state: State,
): { roots: Node[]; leaves: { chord: number[]; depth: number }[]; segments: number; error: number; tolerance: number } {
  let [error, segments] = [0, 0];
  let tolerance = state.tolerance;
  const leaves: { chord: number[]; depth: number }[] = [];
  const roots = pieces.map(({ curve }) => {
    const wanted = Math.max(state.tolerance, FINEST * reach(curve));
    const root = curve.subdivide(wanted);
    const ts = [0];
    walk(root, 0, (leaf, depth) => {
      leaves.push({ chord: ends(leaf.curve), depth });
      ts.push(leaf.t1);
    });
    error = Math.max(error, deviation(curve, ts));
    segments += ts.length - 1;
    tolerance = Math.max(tolerance, wanted);
    return root;
  });
  return { roots, leaves, segments, error, tolerance };
}

function walk(node: Node, depth: number, visit: (leaf: Node, depth: number) => void) {
  if (!node.halves) return visit(node, depth);
  for (const half of node.halves) walk(half, depth + 1, visit);
}

function ends(curve: Curve) {
  const flat = curve.controlPoints();
  return [flat[0], flat[1], flat[flat.length - 2], flat[flat.length - 1]];
}

/** The largest extent of the control points, and as much as lets their numbers be told apart. */
function reach(curve: Curve) {
  const { min, max } = curve.controlBounds();
  return Math.max(
    max.x - min.x,
    max.y - min.y,
    1e-9 * Math.max(Math.abs(min.x), Math.abs(max.x), Math.abs(min.y), Math.abs(max.y)),
  );
}

/**
 * The greatest distance of a curve from the polyline through its points at some parameters, measured between them; the
 * peak by the parabola through the farthest sample and its neighbours.
 *
 * @param ts ascending
 */
export function deviation(curve: Curve, ts: ArrayLike<number>): number {
  if (curve.degree === 1) return 0;
  const steps = new Float64Array(STEPS * (ts.length - 1) + 1);
  for (let i = 0; i < steps.length; i++) {
    const [k, share] = [Math.floor(i / STEPS), (i % STEPS) / STEPS];
    steps[i] = share ? ts[k] + share * (ts[k + 1] - ts[k]) : ts[k];
  }
  const p = curve.evalAt(steps);
  let max = 0;
  const distances = new Float64Array(STEPS + 1);
  for (let from = 0; from + STEPS < steps.length; from += STEPS) {
    for (let j = 1; j < STEPS; j++) distances[j] = distance(p, from + j, from, from + STEPS);
    max = Math.max(max, peak(distances));
  }
  return max;
}

/** The distance of a point from the line between two others. */
function distance(p: Float64Array, at: number, from: number, to: number) {
  const [dx, dy] = [p[2 * to] - p[2 * from], p[2 * to + 1] - p[2 * from + 1]];
  const [x, y] = [p[2 * at] - p[2 * from], p[2 * at + 1] - p[2 * from + 1]];
  const square = dx * dx + dy * dy;
  const along = square > 0 ? Math.min(Math.max((x * dx + y * dy) / square, 0), 1) : 0;
  return Math.hypot(x - along * dx, y - along * dy);
}

function peak(values: Float64Array): number {
  let k = 1;
  for (let i = 2; i < values.length - 1; i++) if (values[i] > values[k]) k = i;
  const [before, here, after] = [values[k - 1], values[k], values[k + 1]];
  const bend = 2 * here - before - after;
  return bend > 0 && here >= before && here >= after ? here + (after - before) ** 2 / (8 * bend) : here;
}
