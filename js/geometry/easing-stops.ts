// The fewest stops of a CSS linear() within a tolerance of a timing function. src/easing/stops.rs performs the same
// operations in the same order.
import { linear, stepStops } from "./easing-piecewise.js";
import { approximate } from "./easing-polyline.js";
import type { Stop } from "./easing-piecewise.js";
import type { Timing } from "./easing-css.js";

/** The smallest tolerance, relative to the largest handle, or to 1 if that is larger. @internal */
export const MIN_TOLERANCE = 1e-4;
/** The part of the tolerance that is left to the distance between the function and its polyline. @internal */
export const POLYLINE_SHARE = 1 / 64;
/** The largest number of halvings of the parameter range. */
const MAX_DEPTH = 20;
/** The largest number of decimal places to which percentages are rounded; outputs have two more. */
const MAX_DECIMALS = 12;

/**
 * The fewest stops of a linear() within a tolerance; equal ones for steps().
 *
 * @internal
 * @throws {RangeError} for a tolerance that is too small
 */
export function fewestStops(timing: Timing, tolerance: number): readonly Stop[] {
  const [x1, y1, x2, y2] = "handles" in timing ? timing.handles : [0, 0, 1, 1];
  const given = "stops" in timing ? timing.stops : [];
  const scale = given.reduce(
    (largest, [, y]) => Math.max(largest, Math.abs(y)),
    Math.max(1, Math.abs(y1), Math.abs(y2)),
  );
  if (!(tolerance >= MIN_TOLERANCE * scale))
    throw new RangeError(`tolerance: expected at least ${MIN_TOLERANCE} of the largest output, got ${tolerance}`);
  if ("count" in timing) return stepStops(timing.count, timing.position);
  if ("stops" in timing) return runsOf(given).flatMap((run) => reduced(run, tolerance / scale, scale));
  const run: Stop[] = [[0, 0]];
  // Outputs are divided by their scale, so that no difference overflows.
  const relative = tolerance / scale;
  const share = relative * POLYLINE_SHARE;
  subdivide([0, 100 * x1, 100 * x2, 100], [0, y1 / scale, y2 / scale, 1 / scale], MAX_DEPTH, share, run);
  return stopsOfRun(run, relative, scale, 1);
}

/**
 * The fewest stops within a tolerance of a function that a polyline approximates within a part of the tolerance,
 * `POLYLINE_SHARE`.
 *
 * @internal
 * @param run percentages and outputs divided by `scale`
 * @param relative the tolerance divided by `scale`
 * @param end the last output
 */
export function stopsOfRun(run: readonly Stop[], relative: number, scale: number, end: number): Stop[] {
  const share = relative * POLYLINE_SHARE;
  return rounded(run, approximate(run, relative - 2 * share), relative - share, scale, end);
}

/** The stops from one jump to the next. */
function runsOf(stops: readonly Stop[]): Stop[][] {
  const runs: Stop[][] = [[]];
  for (const [k, stop] of stops.entries()) {
    if (k > 0 && !(stop[0] > stops[k - 1][0])) runs.push([]);
    runs[runs.length - 1].push(stop);
  }
  return runs;
}

/** A run with as few stops as the tolerance permits; its ends stay. */
function reduced(run: readonly Stop[], relative: number, scale: number): readonly Stop[] {
  const last = run.length - 1;
  if (last < 2) return run;
  const inUnit = divided(run, scale);
  const share = relative * POLYLINE_SHARE;
  const stops = approximate(inUnit, relative - share);
  const inner = rounded(inUnit, stops, relative, scale, run[last][1]).slice(1, -1);
  const result = [run[0], ...inner, run[last]];
  return result.length < run.length && areClose(inUnit, divided(result, scale), relative) ? result : run;
}

/**
 * Appends the vertices of a polyline along a cubic curve, except for its start.
 *
 * The vertical distance of the curve from its chord is a cubic polynomial whose inner Bernstein coefficients are the
 * distances of the handles; their weights add up to at most 3/4.
 *
 * @param x the control values, ascending in t
 */
function subdivide(x: readonly number[], y: readonly number[], depth: number, tolerance: number, run: Stop[]) {
  const slope = (y[3] - y[0]) / (x[3] - x[0]);
  const isClose = (k: number) => 0.75 * Math.abs(y[k] - y[0] - slope * (x[k] - x[0])) <= tolerance;
  if (depth === 0 || (isClose(1) && isClose(2))) run.push([x[3], y[3]]);
  else {
    const [xs, ys] = [halves(x), halves(y)];
    for (const k of [0, 3]) subdivide(xs.slice(k, k + 4), ys.slice(k, k + 4), depth - 1, tolerance, run);
  }
}

/** The control values of both halves, seven numbers. */
function halves([a, b, c, d]: readonly number[]) {
  const [ab, bc, cd] = [(a + b) / 2, (b + c) / 2, (c + d) / 2];
  const [abc, bcd] = [(ab + bc) / 2, (bc + cd) / 2];
  return [a, ab, abc, (abc + bcd) / 2, bcd, cd, d];
}

/**
 * The stops with outputs multiplied by `scale`, with as few decimal places as the tolerance permits.
 *
 * @param end the last output, which stays exact if nothing can be rounded
 */
function rounded(run: readonly Stop[], stops: readonly Stop[], tolerance: number, scale: number, end: number): Stop[] {
  for (let decimals = 0, unit = 1; decimals <= MAX_DECIMALS; decimals++, unit *= 10) {
    const result = stops.map(([x, y]) => [round(x, unit), round(y * scale, 100 * unit)] as Stop);
    if (areClose(run, divided(result, scale), tolerance)) return result;
  }
  const unrounded = stops.slice(0, -1).map(([x, y]) => [x, y * scale] as Stop);
  return [...unrounded, [100, end]];
}

function round(value: number, unit: number) {
  const scaled = value * unit;
  // Above 2⁵² there is nothing to round.
  return Math.abs(scaled) < 2 ** 52 ? Math.floor(scaled + 0.5) / unit + 0 : value;
}

const divided = (stops: readonly Stop[], scale: number) => stops.map(([x, y]) => [x, y / scale] as Stop);

/** Both are straight in between: the distance is greatest at one of the stops. */
const areClose = (a: readonly Stop[], b: readonly Stop[], tolerance: number) =>
  isWithin(a, linear(b), tolerance) && isWithin(b, linear(a), tolerance);

const isWithin = (stops: readonly Stop[], evaluate: (x: number) => number, tolerance: number) =>
  stops.every(([x, y]) => Math.abs(evaluate(x / 100) - y) <= tolerance);
