import { pathData } from "../brand.js";
import { affine } from "../affine.js";
import * as check from "../check.js";
import { showInNode } from "../inspected.js";
import { samePoints, writePoint } from "../points.js";
import { checkedSplineData } from "./packed-shape.js";
import { splineOf } from "../spline/spline.js";
import { cssOf, pathDataOf } from "../../io/path-data.js";
import { findArcs } from "../../io/svg-arcs.js";
import { svgOf, traceOn } from "../../io/svg-write.js";
import { extents, packedSplines } from "../../wasm/packed-path.js";
import type { TransformLike, PointLike } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { Curve } from "../curve/curve.js";
import type { CoreSpline } from "../spline/core-spline.js";
import type { Spline } from "../spline/spline.js";
import type { CssOptions, PathSegment } from "../../io/path-data.js";
import type { PathSvgOptions } from "../../io/svg-write.js";

/** Longer path data is cut off in Node's console, as Node does with long arrays. */
const MAX_SHOWN_LENGTH = 1000;

/** Whether Node knows how to show the instances. */
let isShown = false;

/**
 * The subpaths of a path, their control points, and what the classes that extend this one need to pass them to the core;
 * about the members with an underscore see `CurveValue`.
 */
export class PathValue {
  /** See `packed-path.js` */
  #packed: Float64Array;
  #subpaths: readonly Spline[] | null = null;
  /** The segments of the subpaths that were asked for */
  #segments: (readonly Curve[])[] = [];

  /**
   * The path with the given splines and curves as its subpaths, in their order.
   *
   * @param splines 2D
   * @throws {TypeError} for values that are not splines or curves, and for 3D ones
   */
  constructor(splines: ArrayLike<CoreSpline | CoreCurve>) {
    if (!isShown) isShown = showInNode(PathValue.prototype, "Path", shownData);
    const checked = splines as unknown;
    if (checked instanceof CheckedPath) {
      this.#packed = checked.packed;
      return;
    }
    if (!Array.isArray(splines)) {
      const hint = typeof splines === "string" ? "; did you mean Path.fromSVG?" : "";
      throw new TypeError(`splines: expected an array of splines, got ${check.describe(splines)}${hint}`);
    }
    this.#packed = packedSplines(Array.from(splines, (spline, k) => checkedSplineData(spline, `splines[${k}]`)));
  }

  /** The number of subpaths. */
  get subpathCount() {
    return this.#packed[0];
  }

  /** The subpaths, a frozen array. */
  get subpaths() {
    this.#subpaths ??= Object.freeze(unpack(this.#packed));
    return this.#subpaths;
  }

  /**
   * The path as the `d` attribute of an SVG `<path>`; segments of higher degree become cubics.
   *
   * Without `precision`: "M0,0 L1,0.5 Z", each number with the fewest digits that round-trip, so that `fromSVG` reads
   * an equal path. With it: the shortest form, "M0 0 1 .5Z", with at most that many digits after the decimal point.
   * Cubics that `fromSVG` makes of an arc are written as the arc, so a circle takes two commands; arcs are read up to
   * rounding.
   */
  toSVG(options?: PathSvgOptions): string {
    return svgOf(this.#packed, options, findArcs);
  }

  /**
   * The path as segments of path data, as `getPathData` of SVG elements gives them, with absolute commands M, L, Q, C
   * and Z; segments of higher degree become cubics.
   *
   *     Path.fromSVG("M0 0H4").toPathData(); // [{ type: "M", values: [0, 0] }, { type: "L", values: [4, 0] }]
   *
   * @param options `tolerance`: for degrees above 3, the largest distance of the cubics
   */
  toPathData(options?: { tolerance?: number }): PathSegment[] {
    return pathDataOf(this.#packed, options);
  }

  /**
   * The path as the function `shape()` of CSS, for `clip-path`, `offset-path` and `shape-outside`, in pixels; an empty
   * path gives "none".
   *
   *     Path.fromSVG("M0 0H4V4Z").toCSS(); // "shape(from 0px 0px, line to 4px 0px, line to 4px 4px, close)"
   */
  toCSS(options?: CssOptions): string {
    return cssOf(this.#packed, options);
  }

  /**
   * Whether both have the same structure and each control point lies within a distance of its counterpart.
   *
   * @param other the value to compare with
   * @param tolerance the largest distance of two control points, by default 0
   */
  equals(other: PathValue, tolerance = 0): boolean {
    const [a, b] = [this.#packed, pathData(other, "other")];
    samePoints(new Float64Array(0), new Float64Array(0), 2, tolerance); // checks the tolerance
    if (a.length !== b.length || a[0] !== b[0]) return false;
    for (const { degrees, points, end } of extents(a)) {
      for (let k = degrees - 2; k < points; k++) if (a[k] !== b[k]) return false;
      if (!samePoints(a.subarray(points, end), b.subarray(points, end), 2, tolerance)) return false;
    }
    return true;
  }

  /**
   * The path transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform(matrix: TransformLike): this {
    const [a, b, , c, d, , , , , e, f] = affine(matrix);
    const packed = this.#packed.slice();
    let index = 0;
    for (const { points, end } of extents(packed)) {
      for (let k = points; k < end; k += 2, index++) {
        const [x, y] = [packed[k], packed[k + 1]];
        packed[k] = a * x + c * y + e;
        packed[k + 1] = b * x + d * y + f;
        const bad = [packed[k], packed[k + 1]].find((number) => !check.isCoordinate(number));
        if (bad !== undefined) check.coordinate(bad, `image[${index}]`);
      }
    }
    return this._pathOf(packed);
  }

  /**
   * The same path with each subpath reversed; the order of the subpaths and the first points of closed ones are kept.
   */
  reverse(): this {
    const packed = this.#packed.slice();
    for (const { closed, degrees, points, end } of extents(packed)) {
      packed.subarray(degrees, points).reverse();
      const first = closed ? points + 2 : points;
      // Reversing the array also exchanges x and y of each point.
      packed.subarray(first, end).reverse();
      for (let k = first; k < end; k += 2) [packed[k], packed[k + 1]] = [packed[k + 1], packed[k]];
    }
    return this._pathOf(packed);
  }

  /**
   * Draws the path on a canvas context or a Path2D.
   *
   * @param target a canvas context or a Path2D
   * @param options `tolerance`: for degrees above 3, which are drawn as cubics
   */
  trace(
    target: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D,
    options?: { tolerance?: number },
  ) {
    traceOn(this.#packed, target, options);
  }

  /**
   * A new Path2D of the path, for `fill`, `stroke`, `clip` and `isPointInPath` of a canvas context. In environments
   * without Path2D (Node, for example) it throws an Error; `trace` draws on any context.
   *
   * @param options `tolerance`: for degrees above 3, which are drawn as cubics
   */
  toPath2D(options?: { tolerance?: number }): Path2D {
    if (typeof Path2D !== "function") throw new Error("toPath2D: expected an environment with Path2D, got none");
    const target = new Path2D();
    this.trace(target, options);
    return target;
  }

  /** The path as an object for JSON, from which `Path.fromJSON` makes an equal path. */
  toJSON(): { subpaths: ReturnType<Spline["toJSON"]>[] } {
    return { subpaths: this.subpaths.map((spline) => spline.toJSON()) };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "path" {
    return "path";
  }

  /**
   * The packed path, not copied.
   *
   * @internal
   */
  casteljauData(): Float64Array {
    return this.#packed;
  }

  /**
   * The packed path, not copied.
   *
   * @internal
   */
  get _packed() {
    return this.#packed;
  }

  /**
   * The segments of a subpath.
   *
   * @internal
   */
  _segments(subpath: number): readonly Curve[] {
    this.#segments[subpath] ??= this.subpaths[subpath].segments();
    return this.#segments[subpath];
  }

  /**
   * A path of the same class. The class `Path` implements it.
   *
   * @internal
   */
  _pathOf(packed: Float64Array): this {
    throw new TypeError(`expected a class that makes paths of ${packed.length} numbers`);
  }
}

/**
 * A packed path that is already checked: the constructor accepts it from inside the package.
 *
 * @internal
 */
export class CheckedPath {
  packed: Float64Array;

  constructor(packed: Float64Array) {
    this.packed = packed;
  }
}

/**
 * @internal
 */
export function coordinatesOf(point: PointLike): Float64Array {
  const coordinates = new Float64Array(2);
  writePoint(coordinates, 0, point, 2, "point");
  return coordinates;
}

function unpack(packed: Float64Array): Spline[] {
  return Array.from(extents(packed), ({ closed, degrees, points, end }) =>
    splineOf({ flat: packed.slice(points, end), dimension: 2, degrees: [...packed.subarray(degrees, points)], closed }),
  );
}

function shownData(path: PathValue): string {
  const text = path.toSVG();
  return text.length > MAX_SHOWN_LENGTH ? `${text.slice(0, MAX_SHOWN_LENGTH)}…` : text || "(empty)";
}
