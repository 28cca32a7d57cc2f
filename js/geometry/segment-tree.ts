import { curvesModule } from "../wasm/curves-module.js";
import { BoxTree, writeBox } from "./box-tree.js";
import { nearest } from "./curve-queries.js";
import type { Nearest } from "./curve-queries.js";

/**
 * Consecutive segments, as those of a spline.
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

/**
 * A tree of boxes of consecutive segments, for the nearest point and the winding number of a spline that is asked again. The
 * core (`src/spline/nearest.rs`, `src/path/winding.rs`) gives the same answers.
 *
 * @internal
 */
export class SegmentTree {
  #segments;
  #boxes;

  /** @param segments at least one */
  constructor(segments: Segments) {
    const { dimension: d, count, flat, starts, ends } = segments;
    this.#segments = segments;
    const boxes = new Float64Array(2 * d * count);
    for (let k = 0; k < count; k++) writeBox(boxes, 2 * d * k, d, flat, starts[k], ends[k]);
    this.#boxes = new BoxTree(d, boxes);
  }

  /**
   * The segment with the nearest point, and that point on it; of several, the first one.
   *
   * @param maxDistance points at a greater distance are not searched
   */
  nearest(p: Float64Array, maxDistance: number = Infinity): { k: number; found: Nearest } | undefined {
    let best: { k: number; found: Nearest } | undefined;
    let limit = maxDistance;
    this.#boxes.nearest(p, limit, (k) => {
      const found = nearest(this.#pointsOf(k), this.#segments.dimension, p);
      const isFirst = found.distance === limit && (!best || k < best.k);
      if (found.distance < limit || isFirst) [best, limit] = [{ k, found }, found.distance];
      return limit;
    });
    return best;
  }

  /**
   * The number of upward minus downward crossings of all segments, in the plane, with the ray from a point to the right;
   * src/path/winding.rs explains it.
   */
  crossings(x: number, y: number): number {
    const { flat, starts, ends } = this.#segments;
    let sum = 0;
    this.#boxes.descend((boxes, at, from, to) => {
      if (!(boxes[at + 2] > x && boxes[at + 3] > y) || boxes[at + 1] > y) return false;
      // To the right of the point the ends decide: at the joints between them the crossings cancel each other.
      if (boxes[at] > x) sum += +(flat[ends[to - 1] - 1] > y) - +(flat[starts[from] + 1] > y);
      else if (to - from > 1) return true;
      else {
        const points = this.#pointsOf(from);
        curvesModule.write(points);
        sum += curvesModule.functions.curve_crossings(points.length / 2, x, y);
      }
      return false;
    });
    return sum;
  }

  #pointsOf(k: number) {
    return this.#segments.flat.subarray(this.#segments.starts[k], this.#segments.ends[k]);
  }
}
