// Queries of the single coordinates of a spline: extrema, and parameters of given values.
import { requestedCoordinate } from "../curve-queries.js";
import type { Extrema } from "../curve-queries.js";
import type { SegmentIndex } from "./segment-index.js";

/** What is asked of each segment. */
interface Segment {
  _flat: Float64Array;
  dimension: 2 | 3;
  extrema: () => Extrema;
  timesAtCoordinate: (where: { x: number } | { y: number } | { z: number }) => Float64Array;
}

const AXES = ["x", "y", "z"] as const;

/**
 * The parameters of the local extrema of each coordinate.
 *
 * @internal
 */
export function splineExtrema(index: SegmentIndex, segments: readonly Segment[]): Extrema {
  const inside = segments.map((segment) => segment.extrema());
  const timesOf = (axis: number) => {
    const isExtremum = jointExtrema(index, axis);
    const ts = inside.flatMap((extrema, k) => {
      const times = Array.from(extrema[AXES[axis]] ?? [], (t) => k + t);
      return isExtremum[k] ? [k, ...times] : times;
    });
    return Float64Array.from(new Set(ts)); // k + t may be rounded to a joint
  };
  const [x, y] = [timesOf(0), timesOf(1)];
  return index.dimension === 2 ? { x, y } : { x, y, z: timesOf(2) };
}

/** For the start of each segment, whether a coordinate changes there between rising and falling. */
function jointExtrema(index: SegmentIndex, axis: number): boolean[] {
  const directions = Array.from({ length: index.count }, (_, k) => directionsOf(index, k, axis));
  const before = carried(
    directions.map(([, end]) => end),
    index.closed,
  );
  const after = carried(directions.map(([start]) => start).reverse(), index.closed).reverse();
  return directions.map((_, k) => {
    const previous = k > 0 ? before[k - 1] : index.closed ? before[index.count - 1] : 0;
    return previous * after[k] < 0;
  });
}

/** Whether a coordinate of segment k rises (1), falls (−1) or is constant (0) at its start and at its end. */
function directionsOf(index: SegmentIndex, k: number, axis: number): [start: number, end: number] {
  const values = index.pointsOf(k).filter((_, i) => i % index.dimension === axis);
  const start = firstDirection(values);
  return [start, -firstDirection(values.reverse())];
}

/**
 * The sign of the first difference from the first value that is not zero up to rounding, as in src/curve/extrema.rs.
 */
function firstDirection(values: Float64Array): number {
  const rounding = Number.EPSILON * values.reduce((largest, value) => Math.max(largest, Math.abs(value)), 0);
  return Math.sign((values.find((value) => Math.abs(value - values[0]) > rounding) ?? values[0]) - values[0]);
}

/** Directions with each 0 replaced by the direction before it, in a closed spline also across its start. */
function carried(directions: number[], closed: boolean): number[] {
  let current = closed ? ([...directions].reverse().find((direction) => direction !== 0) ?? 0) : 0;
  return directions.map((direction) => {
    current = direction || current;
    return current;
  });
}

/**
 * The parameters at which a coordinate has a value.
 *
 * @internal
 */
export function splineTimesAtCoordinate(
  segments: readonly Segment[],
  where: { x: number } | { y: number } | { z: number },
  closed: boolean,
): Float64Array {
  const [axis, value] = requestedCoordinate(where, segments[0].dimension);
  const ts = segments.flatMap((segment, k) =>
    mayContain(segment, axis, value) ? Array.from(segment.timesAtCoordinate(where), (t) => k + t) : [],
  );
  const times = new Set(ts); // a joint is the end of one segment and the start of the next
  if (closed && times.has(0)) times.delete(segments.length);
  return Float64Array.from(times);
}

/** Whether a value lies in the range of a coordinate of the control points. */
function mayContain({ _flat, dimension }: Segment, axis: number, value: number) {
  let [min, max] = [Infinity, -Infinity];
  for (let k = axis; k < _flat.length; k += dimension) {
    min = Math.min(min, _flat[k]);
    max = Math.max(max, _flat[k]);
  }
  return min <= value && value <= max;
}
