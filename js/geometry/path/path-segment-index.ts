import { extents } from "../../wasm/packed-path.js";
import type { PathTime } from "./path-queries.js";
import type { Segments } from "../segment-tree.js";

/**
 * Where the segments of all subpaths of a path are in its list of points. It is made once for each path that is asked for
 * a segment.
 *
 * @internal
 */
export class PathSegmentIndex {
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

  constructor(packed: Float64Array) {
    let length = 0;
    for (const { segments, closed, points, end } of extents(packed)) {
      this.#first.push(this.count);
      this.count += segments;
      length += end - points + (closed ? 2 : 0);
    }
    this.flat = new Float64Array(length);
    this.starts = new Uint32Array(this.count);
    this.ends = new Uint32Array(this.count);
    let [k, at] = [0, 0];
    for (const { closed, degrees, points, end } of extents(packed)) {
      this.flat.set(packed.subarray(points, end), at);
      if (closed) this.flat.set(packed.subarray(points, points + 2), at + end - points);
      for (let i = degrees; i < points; i++) {
        this.starts[k] = at;
        at += 2 * packed[i];
        this.ends[k++] = at + 2;
      }
      at += 2;
    }
  }

  /** The number of subpaths. */
  get subpaths(): number {
    return this.#first.length;
  }

  /** The segments of one subpath. */
  subpath(k: number): Segments {
    const [from, to] = [this.#first[k], this.#first[k + 1] ?? this.count];
    return {
      dimension: 2,
      count: to - from,
      flat: this.flat,
      starts: this.starts.subarray(from, to),
      ends: this.ends.subarray(from, to),
    };
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
