import { nearest } from "./curve-queries.js";
import { core } from "../wasm/init.js";
import { writeArguments } from "../wasm/transfer.js";
import type { Nearest } from "./curve-queries.js";

/**
 * The segments of a spline or a path.
 *
 * @internal
 */
export interface Segments {
  dimension: 2 | 3;
  count: number;
  /** Coordinates */
  flat: Float64Array;
  /** For each segment the index of its first coordinate */
  starts: Uint32Array;
  /** For each segment the index after its last coordinate */
  ends: Uint32Array;
}

/** How many boxes of consecutive segments have a common box on the next level. */
const FANOUT = 8;

/**
 * A tree of boxes of consecutive segments, for the nearest point and the winding number of a spline or a path that is
 * asked again. The core (`src/spline/nearest.rs`, `src/path/winding.rs`) gives the same answers.
 *
 * @internal
 */
export class SegmentTree {
  #segments;
  /** For each level, from the segments up to one box, the smallest and then the largest coordinates of its boxes. */
  #levels: Float64Array[] = [];

  /** @param segments at least one */
  constructor(segments: Segments) {
    const d = segments.dimension;
    this.#segments = segments;
    let corners = new Float64Array(2 * d * segments.count);
    const { flat, starts, ends } = segments;
    for (let k = 0; k < segments.count; k++) {
      for (let axis = 0; axis < d; axis++) setRange(corners, 2 * d * k + axis, d, flat, starts[k] + axis, ends[k]);
    }
    this.#levels.push(corners);
    while (corners.length > 2 * d) {
      const count = Math.ceil(corners.length / (2 * d * FANOUT));
      const next = new Float64Array(2 * d * count);
      for (let k = 0; k < count; k++) {
        const [from, to] = [2 * d * FANOUT * k, Math.min(2 * d * FANOUT * (k + 1), corners.length)];
        for (let axis = 0; axis < d; axis++) setRange(next, 2 * d * k + axis, d, corners, from + axis, to);
      }
      this.#levels.push(next);
      corners = next;
    }
  }

  /**
   * The segment with the nearest point, and that point on it; of several, the first one.
   *
   * @param maxDistance points at a greater distance are not searched
   */
  nearest(p: Float64Array, maxDistance: number = Infinity): { k: number; found: Nearest } | undefined {
    let best: { k: number; found: Nearest } | undefined;
    let limit = maxDistance;
    const search = (level: number, k: number) => {
      if (level === 0) {
        const found = nearest(this.#pointsOf(k), this.#segments.dimension, p);
        const isFirst = found.distance === limit && (!best || k < best.k);
        if (found.distance < limit || isFirst) [best, limit] = [{ k, found }, found.distance];
        return;
      }
      const from = FANOUT * k;
      const to = Math.min(from + FANOUT, this.#levels[level - 1].length / (2 * this.#segments.dimension));
      const distances: number[] = [];
      for (let child = from; child < to; child++) distances.push(this.#distance(level - 1, child, p));
      for (;;) {
        let next = 0;
        for (let i = 1; i < distances.length; i++) if (distances[i] < distances[next]) next = i;
        if (!(distances[next] <= limit) || distances[next] === Infinity) return;
        distances[next] = Infinity;
        search(level - 1, from + next);
      }
    };
    search(this.#levels.length - 1, 0);
    return best;
  }

  /**
   * The number of upward minus downward crossings of all segments, in the plane, with the ray from a point to the right;
   * src/path/winding.rs explains it.
   */
  crossings(x: number, y: number): number {
    const { flat, starts, ends } = this.#segments;
    const count = (level: number, k: number): number => {
      const corners = this.#levels[level];
      const at = 4 * k;
      if (!(corners[at + 2] > x && corners[at + 3] > y) || corners[at + 1] > y) return 0;
      if (level > 0) {
        const to = Math.min(FANOUT * (k + 1), this.#levels[level - 1].length / 4);
        let sum = 0;
        for (let child = FANOUT * k; child < to; child++) sum += count(level - 1, child);
        return sum;
      }
      if (corners[at] > x) return +(flat[ends[k] - 1] > y) - +(flat[starts[k] + 1] > y);
      const points = this.#pointsOf(k);
      writeArguments(points);
      return core().curve_crossings(points.length / 2, x, y);
    };
    return count(this.#levels.length - 1, 0);
  }

  /** The distance of a point from the box of all segments. */
  distance(p: Float64Array) {
    return this.#distance(this.#levels.length - 1, 0, p);
  }

  #pointsOf(k: number) {
    return this.#segments.flat.subarray(this.#segments.starts[k], this.#segments.ends[k]);
  }

  #distance(level: number, k: number, p: Float64Array) {
    const d = this.#segments.dimension;
    const corners = this.#levels[level];
    const outside = (axis: number) => {
      const at = 2 * d * k + axis;
      return Math.max(corners[at] - p[axis], p[axis] - corners[at + d], 0);
    };
    const [x, y, z] = [outside(0), outside(1), d === 3 ? outside(2) : 0];
    const square = x * x + y * y + z * z;
    // Math.hypot is slow, but its sum of squares neither overflows nor underflows.
    return square === 0 || (square > 1e-280 && square < 1e280) ? Math.sqrt(square) : Math.hypot(x, y, z);
  }
}

/**
 * Writes the smallest and the largest coordinate on one axis.
 *
 * @param d the dimension
 */
function setRange(corners: Float64Array, at: number, d: number, points: Float64Array, from: number, to: number) {
  let [min, max] = [points[from], points[from]];
  for (let i = from + d; i < to; i += d) {
    const x = points[i];
    if (x < min) min = x;
    else if (x > max) max = x;
  }
  corners[at] = min;
  corners[at + d] = max;
}
