import { curvesModule } from "../../wasm/curves-module.js";
import { BoxTree, writeBox } from "../box-tree.js";
import { SegmentTree } from "../segment-tree.js";
import type { PathSegmentIndex } from "./path-segment-index.js";
import type { PathPoint } from "./path-queries.js";

/**
 * A tree of the boxes of the subpaths, each with a tree of its segments, for the nearest point and the winding number of a
 * path that is asked again.
 *
 * @internal
 */
export class PathTree {
  #index;
  #boxes;
  /** The trees of the subpaths that were examined */
  #parts: SegmentTree[] = [];

  constructor(index: PathSegmentIndex) {
    const boxes = new Float64Array(4 * index.subpaths);
    for (let k = 0; k < index.subpaths; k++) {
      const { flat, starts, ends, count } = index.subpath(k);
      writeBox(boxes, 4 * k, 2, flat, starts[0], ends[count - 1]);
    }
    this.#index = index;
    this.#boxes = BoxTree.ofPlane(boxes);
  }

  /** The nearest point within a distance; of several, the first one. */
  nearest(p: Float64Array, maxDistance: number): PathPoint | null {
    let best: PathPoint | null = null;
    this.#boxes.nearest(p, maxDistance, (subpath) => {
      const limit = best?.distance ?? maxDistance;
      const nearest = this.#part(subpath).nearest(p, limit);
      if (!nearest) return limit;
      const { k, found } = nearest;
      if (!best || found.distance < limit || subpath < best.subpath) best = { subpath, ...found, t: k + found.t };
      return best.distance;
    });
    return best;
  }

  /** The winding number around a point; a subpath whose box does not contain the point does not wind around it. */
  windingNumber(x: number, y: number): number {
    let sum = 0;
    this.#boxes.around(x, y, (subpath) => {
      sum += this.#part(subpath).crossings(x, y) + this.#closingCrossings(subpath, x, y);
    });
    return sum;
  }

  /** The crossings of the line from the end of a subpath to its start, by which it is closed. */
  #closingCrossings(subpath: number, x: number, y: number) {
    const { flat, starts, ends, count } = this.#index.subpath(subpath);
    const [start, end] = [starts[0], ends[count - 1] - 2];
    if (flat[start] === flat[end] && flat[start + 1] === flat[end + 1]) return 0;
    curvesModule.write(Float64Array.of(flat[end], flat[end + 1], flat[start], flat[start + 1]));
    return curvesModule.functions.curve_crossings(2, x, y);
  }

  #part(subpath: number) {
    this.#parts[subpath] ??= new SegmentTree(this.#index.subpath(subpath));
    return this.#parts[subpath];
  }
}
