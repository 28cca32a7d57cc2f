// Straight pieces as numbers: six for each, its two ends.
import { Curve } from "../../surfaces.js";
import { patchesOf } from "./patches.js";
import type { RationalCurve } from "../../nurbs.js";
import type { Mesh, Patch, Surface } from "../../surfaces.js";

/** Straight pieces for each curve. */
const PIECES = 24;

/** The sides of a mesh's triangles, each once. */
export function edges({ positions, indices }: Mesh): Float32Array {
  const count = positions.length / 3;
  const pairs = new Set<number>();
  for (let i = 0; i < indices.length; i++) {
    const [a, b] = [indices[i], indices[i % 3 === 2 ? i - 2 : i + 1]];
    pairs.add(Math.min(a, b) * count + Math.max(a, b));
  }
  const pieces = new Float32Array(6 * pairs.size);
  let at = 0;
  for (const pair of pairs) {
    const [a, b] = [3 * Math.floor(pair / count), 3 * (pair % count)];
    pieces.set(positions.subarray(a, a + 3), at);
    pieces.set(positions.subarray(b, b + 3), at + 3);
    at += 6;
  }
  return pieces;
}

/** A chain of points as pieces. */
function chain(points: ArrayLike<number>): number[] {
  const pieces: number[] = [];
  for (let i = 0; i + 3 < points.length; i += 3) for (let k = 0; k < 6; k++) pieces.push(points[i + k]);
  return pieces;
}

/**
 * Points of a curve at equal steps of its parameter. Those of a curve with weights are quotients of two curves without: its own
 * functions are in a module that the element does not load.
 */
function sampled(curve: Curve | RationalCurve<3>, segments: number): Float64Array {
  if (!("weights" in curve)) return curve.sample(segments);
  const largest = Math.max(...curve.weights());
  const weights = Array.from(curve.weights(), (weight) => weight / largest);
  const at = (points: ArrayLike<number>) => new Curve(points, { dimension: 3 }).sample(segments);
  const numerator = at(curve.controlPoints().map((coordinate, i) => weights[Math.floor(i / 3)] * coordinate));
  const denominator = at(weights.flatMap((weight) => [weight, 0, 0]));
  return numerator.map((value, i) => value / denominator[3 * Math.floor(i / 3)]);
}

/**
 * Curves of constant u and v of all patches.
 *
 * @param count strips along each direction of a patch
 */
export function isocurves(surface: Surface, count: number): Float32Array {
  return Float32Array.from(surface.isocurves({ lines: count }).flatMap((curve) => chain(sampled(curve, PIECES))));
}

/** The four sides of a patch. */
export function outline(patch: Patch): Float32Array {
  const curves = [0, 1].flatMap((end) => [patch.isocurveAtU(end), patch.isocurveAtV(end)]);
  return Float32Array.from(curves.flatMap((curve) => chain(sampled(curve, PIECES))));
}

/** The curves of constant u and of constant v through a place of a patch, and the place. */
export function place(patch: Patch, u: number, v: number) {
  const at = patch.eval(u, v);
  const pieces = (curve: Curve) => Float32Array.from(chain(sampled(curve, 2 * PIECES)));
  return {
    ofU: pieces(patch.isocurveAtU(u)),
    ofV: pieces(patch.isocurveAtV(v)),
    at: Float32Array.of(at.x, at.y, at.z ?? 0),
  };
}

/** The control nets: of one patch, or of all. */
export function nets(surface: Surface, only: number | null): Float32Array {
  const patches = patchesOf(surface);
  return Float32Array.from((only === null ? patches : [patches[only]]).flatMap(net));
}

function net(patch: Patch) {
  const points = patch.controlPoints();
  const [rows, columns] = linesOf(patch, points);
  return [...rows, ...columns].flatMap(chain);
}

/** The rows (along u) and columns of a patch's net. */
function linesOf({ degreeU, degreeV }: Patch, points: Float64Array): [Float64Array[], Float64Array[]] {
  const width = 3 * (degreeU + 1);
  const rows = Array.from({ length: degreeV + 1 }, (_, j) => points.slice(j * width, (j + 1) * width));
  const columns = Array.from({ length: degreeU + 1 }, (_, i) =>
    Float64Array.from(rows.flatMap((row) => [...row.subarray(3 * i, 3 * i + 3)])),
  );
  return [rows, columns];
}

/**
 * De Casteljau's way to a point of a patch: along u in every row of the net, and then along v through what came out.
 */
export interface Construction {
  /** The dividing lines in the rows */
  rowLines: Float32Array;
  rowCurves: Float32Array;
  /** One on each */
  rowPoints: Float32Array;
  /** The dividing lines between the rows' points */
  columnLines: Float32Array;
  columnCurve: Float32Array;
  point: Float32Array;
}

/** As much as the step shows: 1 the first row, 2 all rows, 3 the curve that their points control, 4 its point. */
export function casteljau(patch: Patch, u: number, v: number, step: number): Construction {
  const rows = linesOf(patch, patch.controlPoints())[0].map((row) => new Curve(row, { dimension: 3 }));
  const column = patch.isocurveAtU(u);
  const from = (min: number, make: () => number[]) => Float32Array.from(step >= min ? make() : []);
  const at = patch.eval(u, v);
  const shownRows = step === 1 ? rows.slice(0, 1) : rows;
  return {
    rowLines: from(1, () => shownRows.flatMap((row) => dividing(row, u))),
    rowCurves: from(1, () => shownRows.flatMap((row) => chain(row.sample(PIECES)))),
    rowPoints: from(1, () => [...column.controlPoints().subarray(0, 3 * shownRows.length)]),
    columnLines: from(3, () => [...chain(column.controlPoints()), ...(step > 3 ? dividing(column, v) : [])]),
    columnCurve: from(3, () => chain(column.sample(2 * PIECES))),
    point: from(4, () => [at.x, at.y, at.z ?? 0]),
  };
}

/** The levels of a curve's construction above its control polygon. */
function dividing(curve: Curve, t: number) {
  return curve.deCasteljau(t).slice(1).flatMap(chain);
}
