import type { SplineData } from "../brand.js";

/**
 * Where the segments of a spline are in its list of points. It is made once for each spline that is asked for a segment.
 *
 * @internal
 */
export class SegmentIndex {
  dimension: 2 | 3;
  count: number;
  closed: boolean;

  /** All coordinates; for a closed spline, those of the first point again at the end. */
  flat;
  /** For each segment the index of its first coordinate. */
  starts;
  /** For each segment the index after its last coordinate. */
  ends;

  constructor({ flat, dimension, degrees, closed }: SplineData) {
    this.dimension = dimension;
    this.count = degrees.length;
    this.closed = closed;
    this.flat = flat;
    if (closed) {
      this.flat = new Float64Array(flat.length + dimension);
      this.flat.set(flat);
      this.flat.set(flat.subarray(0, dimension), flat.length);
    }
    this.starts = new Uint32Array(degrees.length);
    this.ends = new Uint32Array(degrees.length);
    for (let k = 0, at = 0; k < degrees.length; k++) {
      this.starts[k] = at;
      at += degrees[k] * dimension;
      this.ends[k] = at + dimension;
    }
  }

  /**
   * The coordinates of the control points of segment k, not copied.
   *
   * @param k the number of the segment, from 0
   */
  pointsOf(k: number): Float64Array {
    return this.pointsFrom(k, k + 1);
  }

  /**
   * The coordinates of the control points of the segments from one index to the one before another, not copied.
   *
   * @param from the first segment
   * @param to the segment after the last one
   */
  pointsFrom(from: number, to: number): Float64Array {
    return this.flat.subarray(this.starts[from], this.ends[to - 1]);
  }
}
