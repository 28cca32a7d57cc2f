import { extents } from "../../wasm/packed-path.js";
import type { PathTime } from "./path-queries.js";

/**
 * Where the segments of all subpaths of a path are in its list of points. It is made once for each path that is asked for
 * a segment.
 *
 * @internal
 */
export class PathSegmentIndex {
  dimension: 2 = 2;
  /** The number of segments. */
  count = 0;
  /** All coordinates; those of the first point again at the end of a closed subpath. */
  flat;
  /** For each segment the index of its first coordinate. */
  starts;
  /** For each segment the index after its last coordinate. */
  ends;
  /** For each subpath the number of its first segment. */
  #first: number[] = [];

  /**
   * @param asFilled whether open subpaths are closed by a line, which is a segment then
   */
  constructor(packed: Float64Array, asFilled = false) {
    let length = 0;
    for (const { segments, closed, points, end } of extents(packed)) {
      this.#first.push(this.count);
      this.count += segments + (asFilled && !closed ? 1 : 0);
      length += end - points + (closed || asFilled ? 2 : 0);
    }
    this.flat = new Float64Array(length);
    this.starts = new Uint32Array(this.count);
    this.ends = new Uint32Array(this.count);
    let [k, at] = [0, 0];
    const add = (degree: number) => {
      this.starts[k] = at;
      at += 2 * degree;
      this.ends[k++] = at + 2;
    };
    for (const { closed, degrees, points, end } of extents(packed)) {
      this.flat.set(packed.subarray(points, end), at);
      if (closed || asFilled) this.flat.set(packed.subarray(points, points + 2), at + end - points);
      for (let i = degrees; i < points; i++) add(packed[i]);
      if (asFilled && !closed) add(1);
      at += 2;
    }
  }

  /** The location at a parameter on segment k. */
  location(k: number, t: number): PathTime {
    let [low, high] = [0, this.#first.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.#first[middle] <= k) low = middle;
      else high = middle - 1;
    }
    return { subpath: low, t: k - this.#first[low] + t };
  }
}
