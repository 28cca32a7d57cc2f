// Curves and splines divided at several parameters.
import * as check from "./check.js";

/**
 * The parts from 0 to `end` between the given parameters in ascending order.
 *
 * @internal
 */
export function partsAt<T extends { subsegment(t0: number, t1: number): T }>(
  whole: T,
  ts: ArrayLike<number>,
  end: number,
): T[] {
  const ends = [...check.numbers(ts, "ts").sort(), end];
  return ends.map((t, k) => whole.subsegment(k ? ends[k - 1] : 0, t));
}
