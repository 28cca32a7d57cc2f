// The CSS timing functions steps() and linear(). src/easing/piecewise.rs performs the same operations in the same order.
import { clampToFinite } from "./easing-number.js";

export type StepPosition = "jump-start" | "jump-end" | "jump-none" | "jump-both";

/** A control point of linear(): x = percentage/100 */
export type Stop = readonly [percentage: number, y: number];

/** The largest number of stops that replace a step function. */
const MAX_STOPS = 65_536;

/**
 * Whether the output jumps at x = 0 and at x = 1.
 *
 * @internal
 */
export const JUMPS: Record<StepPosition, readonly [atStart: number, atEnd: number]> = {
  "jump-start": [1, 0],
  "jump-end": [0, 1],
  "jump-none": [0, 0],
  "jump-both": [1, 1],
};

/**
 * The timing function `steps(count, position)`.
 *
 * Source: CSS Easing Functions Level 2, "Step easing functions".
 *
 * @internal
 * @param count the number of intervals
 * @returns for finite numbers
 */
export function steps(count: number, position: StepPosition): (x: number) => number {
  const [atStart, atEnd] = JUMPS[position];
  const jumps = count - 1 + atStart + atEnd;
  return (x) => {
    let step = Math.floor(x * count) + atStart;
    if (x >= 0) step = Math.max(step, 0);
    if (x <= 1) step = Math.min(step, jumps);
    return clampToFinite(step / jumps) + 0; // turns −0 into 0
  };
}

/**
 * The stops of the linear() that is equal to `steps(count, position)`.
 *
 * @internal
 * @throws {RangeError} for too many
 */
export function stepStops(count: number, position: StepPosition): Stop[] {
  const [atStart, atEnd] = JUMPS[position];
  const needed = 2 * count + atEnd;
  if (needed > MAX_STOPS) throw new RangeError(`stops: expected at most ${MAX_STOPS}, this needs ${needed}`);
  const jumps = count - 1 + atStart + atEnd;
  return Array.from({ length: needed }, (_, k) => [
    (100 * Math.ceil(k / 2)) / count,
    (Math.floor(k / 2) + atStart) / jumps,
  ]);
}

/**
 * The timing function `linear(…)`: polylines through stops with ascending percentages; at a jump the last stop holds.
 *
 * Source: CSS Easing Functions Level 2, "Output of a linear easing function".
 *
 * @internal
 * @param stops at least two
 * @returns for finite numbers
 */
export function linear(stops: readonly Stop[]): (x: number) => number {
  const xs = stops.map(([percentage]) => percentage / 100);
  const ys = stops.map(([, y]) => y + 0); // turns −0 into 0
  const last = stops.length - 1;
  return (x) => {
    const passed = countUpTo(xs, x);
    if (passed > 0 && xs[passed - 1] === x) return ys[passed - 1];
    const a = Math.min(Math.max(passed - 1, 0), last - 1);
    if (xs[a] === xs[a + 1]) return ys[a + 1];
    // Differences are halved, so that they do not overflow.
    const rise = ys[a + 1] / 2 - ys[a] / 2;
    const width = xs[a + 1] / 2 - xs[a] / 2;
    if (rise === 0 || width === 0) return ys[a];
    return clampToFinite(ys[a] + 2 * (rise * ((x / 2 - xs[a] / 2) / width))) + 0;
  };
}

/** How many of some ascending numbers are at most x. */
function countUpTo(xs: readonly number[], x: number) {
  let [low, high] = [0, xs.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (xs[middle] <= x) low = middle + 1;
    else high = middle;
  }
  return low;
}
