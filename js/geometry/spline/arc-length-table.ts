// The arc lengths of the segments of a spline. The sums are those of the core (`src/spline/length.rs`), so that a kept
// table gives the same times as the core's own.
import { curvesModule } from "../../wasm/curves-module.js";
import type { SegmentIndex } from "./segment-index.js";

/**
 * The arc length from the start of a spline to the start of each segment, and to the end.
 *
 * @internal
 */
export function arcLengthsOf(index: SegmentIndex): Float64Array {
  const ends = new Float64Array(index.count + 1);
  for (let k = 0; k < index.count; k++) {
    const points = index.pointsOf(k);
    curvesModule.write(points);
    const count = curvesModule.functions.curve_length(index.dimension, points.length / index.dimension, 0);
    ends[k + 1] = ends[k] + curvesModule.read(0, count)[0];
  }
  return ends;
}

/**
 * The segment in which an arc length s > 0 from the start ends, by bisection; the number of segments, if s is not below
 * the length of the spline.
 *
 * @internal
 * @param ends what `arcLengthsOf` returned
 */
export function segmentAtLength(ends: Float64Array, s: number): number {
  let [low, high] = [0, ends.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ends[middle + 1] <= s) low = middle + 1;
    else high = middle;
  }
  return low;
}
