import * as check from "../check.js";
import { BoxTree } from "../box-tree.js";
import { showInNode } from "../inspected.js";
import { writePoint } from "../points.js";
import { isEvenOdd } from "./fill-rule.js";
import type { PointLike } from "../check.js";
import type { Bounds } from "../points.js";
import type { RegionOptions } from "./fill-rule.js";
import type { PathPoint } from "./path-queries.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** What is asked of each path. */
interface IndexedPath {
  bounds: () => Bounds<2> | null;
  controlBounds: () => Bounds<2> | null;
  contains: (point: PointLike, options?: RegionOptions) => boolean;
  _nearest: (point: Float64Array, maxDistance: number) => PathPoint | null;
}

/** What `PathIndex.nearest` finds: the index of the path, and the nearest point on it. */
export type NearestPath = PathPoint & { index: number };

/**
 * An index of paths by their place, for hit testing and selections in drawings: made once by `Path.index`, it is asked as
 * often as the pointer moves. Of paths that are painted one after the other, the last one is on top.
 */
export class PathIndex {
  #paths;
  /** The indices of the paths that are not empty */
  #items: number[];
  #boxes;

  /**
   * `Path.index` calls it.
   *
   * @internal
   */
  constructor(paths: readonly IndexedPath[]) {
    if (!isShown) isShown = showInNode(PathIndex.prototype, "PathIndex", (value) => ({ paths: value.#paths.length }));
    const boxes = paths.map((path) => path.controlBounds());
    this.#paths = paths;
    this.#items = boxes.flatMap((box, index) => (box ? [index] : []));
    const numbers = boxes.flatMap((box) => (box ? [box.min.x, box.min.y, box.max.x, box.max.y] : []));
    this.#boxes = BoxTree.ofPlane(Float64Array.from(numbers));
  }

  /**
   * The path nearest to a point, the first one of several: its index, the location on it, the nearest point and its
   * distance. Null if all are farther than `maxDistance`, and without paths.
   *
   *     const hit = index.nearest([event.offsetX, event.offsetY], { maxDistance: 5 });
   *     if (hit) paths[hit.index]; // is under the pointer
   *
   * @param options `maxDistance`: by default there is no limit
   */
  nearest(point: PointLike, options?: { maxDistance?: number }): NearestPath | null {
    const { maxDistance = Infinity } = check.options(options, ["maxDistance"]);
    if (maxDistance !== Infinity) check.nonNegative(maxDistance, "maxDistance");
    const p = coordinates(point, "point");
    let best: NearestPath | null = null;
    this.#boxes.nearest(p, maxDistance, (item) => {
      const limit = best?.distance ?? maxDistance;
      const index = this.#items[item];
      const found = this.#paths[index]._nearest(p, limit);
      if (found && (!best || found.distance < limit || index < best.index)) best = { index, ...found };
      return best?.distance ?? limit;
    });
    return best;
  }

  /**
   * The indices of the paths that contain a point when they are filled, the topmost (last) one first.
   *
   * @param point the point, in the unit of the points
   */
  containing(point: PointLike, options?: RegionOptions): number[] {
    isEvenOdd(options);
    const p = coordinates(point, "point");
    const found: number[] = [];
    this.#boxes.around(p[0], p[1], (item) => {
      if (this.#paths[this.#items[item]].contains(p, options)) found.push(this.#items[item]);
    });
    return found.sort((a, b) => b - a);
  }

  /**
   * The indices, in ascending order, of the paths that lie within a box, as for a selection by a rectangle. Empty paths lie
   * nowhere.
   *
   * @param box as `bounds()` returns it
   */
  within(box: { min: PointLike; max: PointLike }): number[] {
    check.object(box, "box");
    const [min, max] = [coordinates(box.min, "box.min"), coordinates(box.max, "box.max")];
    const isInside = (inner: Bounds<2>) =>
      min[0] <= inner.min.x && min[1] <= inner.min.y && inner.max.x <= max[0] && inner.max.y <= max[1];
    const found: number[] = [];
    this.#boxes.overlapping(min[0], min[1], max[0], max[1], (item) => {
      const index = this.#items[item];
      if (isInside(this.#paths[index].bounds() as Bounds<2>)) found.push(index);
    });
    return found.sort((a, b) => a - b);
  }
}

function coordinates(point: PointLike, name: string): Float64Array {
  const result = new Float64Array(2);
  writePoint(result, 0, point, 2, name);
  return result;
}
