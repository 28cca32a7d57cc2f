import { pathData } from "../brand.js";
import * as check from "../check.js";
import { intersectPathWith, selfIntersectPath } from "../intersections.js";
import { requireList } from "../points.js";
import { splineDataOf } from "../spline/spline-value.js";
import { readPathData } from "../../io/path-data.js";
import { readSvg } from "../../io/svg-read.js";
import { checkTolerance } from "../../io/svg-write.js";
import { packedPaths, packedSplines } from "../../wasm/packed-path.js";
import { packedShape, require2D } from "./packed-shape.js";
import { PathBuilder } from "./path-builder.js";
import { PathMeasures } from "./path-measures.js";
import * as shapes from "./path-shapes.js";
import { CheckedPath, coordinatesOf } from "./path-value.js";
import type { PointLike, PointsLike } from "../check.js";
import type { Intersection, PathIntersection } from "../intersections.js";
import type { PathSegment } from "../../io/path-data.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { CoreSpline } from "../spline/core-spline.js";
import type { SimplifyOptions } from "../spline/spline.js";
import type { SplineJSON } from "../spline/spline-value.js";
import type { PathPoint, PathTime } from "./path-queries.js";
import type { ArcOptions, RectOptions } from "./path-shapes.js";
import type { PathValue } from "./path-value.js";

/** What a path can be made of and intersected with, from any entry point of this package. */
export type Shape = PathValue | CoreSpline | CoreCurve;

/** What `Path.nearestOf` finds: the index of the path, and the nearest point on it. */
export type NearestPath = PathPoint & { index: number };

/** A class of paths, on which static methods are called. */
export type PathClass<P> = new (splines: ArrayLike<CoreSpline | CoreCurve>) => P;

/**
 * What the class `Path` has in every entry point: all but operations on regions. Static methods make paths of the class on
 * which they are called; `from` and `fromJSON`, which may be passed to `map`, are in the classes themselves.
 */
export class CorePath extends PathMeasures {
  /**
   * Parses the `d` attribute of an SVG `<path>` with all its commands, in time proportional to the length of the text.
   *
   * Arcs are approximated by as few cubics as possible within a tolerance, by default 1e-5 of the larger radius: 8 for
   * a circle. A moveto without a segment is ignored; "M1 1Z" is
   * a closed subpath with one line of length 0. The text "none", as in CSS, gives an empty path. `Z` adds a line to the start unless the current point is already there.
   *
   * @param d SVG path data
   * @throws {SvgError} a RangeError with `offset` and `path`, the path up to the error
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  static fromSVG<P extends CorePath>(this: PathClass<P>, d: string, options?: ArcOptions): P {
    if (typeof d !== "string") throw new TypeError(`d: expected a string, got ${check.describe(d)}`);
    const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
    const { packed, error } = readSvg(d, tolerance);
    const path = pathFrom(this, packed);
    if (error) throw Object.assign(new RangeError(error.message), { offset: error.offset, path });
    checkTolerance(packed, tolerance);
    return path;
  }

  /**
   * The path of segments of path data, as `getPathData` of SVG elements gives them: commands of SVG path data in any
   * form, with their numbers.
   *
   *     Path.fromPathData(document.querySelector("path").getPathData());
   *
   * @param segments `type`: the letter of a command; `values`: the numbers of one such command
   * @throws {RangeError} for an unknown command, and for a wrong number of values
   */
  static fromPathData<P extends CorePath>(
    this: PathClass<P>,
    segments: ArrayLike<PathSegment>,
    options?: ArcOptions,
  ): P {
    const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
    const packed = readPathData(segments, tolerance);
    checkTolerance(packed, tolerance);
    return pathFrom(this, packed);
  }

  /**
   * A builder with the methods of a canvas context, for code that draws on one.
   *
   *     const builder = Path.builder();
   *     d3.line().context(builder)(data); // or any other function that draws on a canvas
   *     const path = builder.build();
   *
   * @param options for `arc`, `arcTo`, `ellipse` and `roundRect`
   */
  static builder<P extends CorePath>(this: PathClass<P>, options?: ArcOptions): PathBuilder<P> {
    return new PathBuilder(check.optionalTolerance(check.options(options, ["tolerance"]).tolerance), (packed) =>
      pathFrom(this, packed),
    );
  }

  /**
   * A circle, counter-clockwise (x right, y up; clockwise on a canvas), from the point to the right of the centre. It
   * consists of cubics that join at each quarter turn.
   *
   * By default, 8 cubics approximate it within 4.3e-6 of the radius. The largest distance of a cubic over the angle θ is
   * 2/27 sin⁶(θ/4) / cos²(θ/4) of the radius: a tolerance of 2.73e-4 · radius gives the usual four cubics.
   *
   * @param center the center
   * @param radius 0 gives a closed subpath that is a point
   * @throws {RangeError} for a negative radius, coordinates that overflow, and a tolerance not above 0 or below 4 ulps
   *   of the largest coordinate
   */
  static circle<P extends CorePath>(this: PathClass<P>, center: PointLike, radius: number, options?: ArcOptions): P {
    return pathFrom(this, shapes.circle(center, radius, options));
  }

  /**
   * An ellipse with the same direction and accuracy as `circle`, from the end of its first semi-axis.
   *
   * @param center the center
   * @param radiusX the length of the first semi-axis
   * @param radiusY the length of the second semi-axis
   * @param rotation the angle from the x-axis to the first semi-axis, in radians, counter-clockwise (y up)
   */
  static ellipse<P extends CorePath>(
    this: PathClass<P>,
    center: PointLike,
    radiusX: number,
    radiusY: number,
    rotation?: number,
    options?: ArcOptions,
  ): P {
    return pathFrom(this, shapes.ellipse(center, radiusX, radiusY, rotation, options));
  }

  /**
   * An arc of a circle as an open subpath, with the accuracy of `circle`: counter-clockwise (x right, y up; clockwise on
   * a canvas) if `endAngle` is greater than `startAngle`, otherwise clockwise.
   *
   *     Path.arc([0, 0], 1, 0, Math.PI / 2); // from (1, 0) to (0, 1)
   *
   * @param center the center
   * @param radius the radius, in the unit of the points
   * @param startAngle in radians, from the x-axis towards the y-axis
   * @param endAngle in radians; at most a full turn away from `startAngle`
   */
  static arc<P extends CorePath>(
    this: PathClass<P>,
    center: PointLike,
    radius: number,
    startAngle: number,
    endAngle: number,
    options?: ArcOptions,
  ): P {
    return pathFrom(this, shapes.circularArc(center, radius, startAngle, endAngle, options));
  }

  /**
   * A rectangle with sides parallel to the axes, counter-clockwise (x right, y up; clockwise on a canvas), from the
   * corner with the smallest coordinates (after its rounding).
   *
   * @param corner the corner with the smallest coordinates
   * @param width the width, at least 0
   * @param height the height, at least 0
   */
  static rect<P extends CorePath>(
    this: PathClass<P>,
    corner: PointLike,
    width: number,
    height: number,
    options?: RectOptions,
  ): P {
    return pathFrom(this, shapes.rect(corner, width, height, options));
  }

  /**
   * A polygon, or an open polyline, with the given corners in their order.
   *
   * @param points a flat array is read as x, y, x, y, …; at least 1 point, at least 2 if open
   * @param options `closed`: true by default
   */
  static polygon<P extends CorePath>(this: PathClass<P>, points: PointsLike, options?: { closed?: boolean }): P {
    requireList(points);
    return pathFrom(this, shapes.polygon(points, options));
  }

  /**
   * The path of a list that is nearest to a point, the first one of several, for hit testing: its index, the location on
   * it, the nearest point and its distance. Null if all are farther than `maxDistance`, and for empty paths.
   *
   *     const hit = Path.nearestOf(paths, [event.offsetX, event.offsetY], { maxDistance: 5 });
   *     if (hit) paths[hit.index]; // is under the pointer
   *
   * @param options `maxDistance`: by default there is no limit
   */
  static nearestOf(
    paths: ArrayLike<PathValue>,
    point: PointLike,
    options?: { maxDistance?: number },
  ): NearestPath | null {
    if (!Array.isArray(paths)) throw new TypeError(`paths: expected an array of paths, got ${check.describe(paths)}`);
    const { maxDistance = Infinity } = check.options(options, ["maxDistance"]);
    if (maxDistance !== Infinity) check.finite(maxDistance, "maxDistance");
    if (maxDistance < 0) throw new RangeError(`maxDistance: expected a number from 0, got ${maxDistance}`);
    const p = coordinatesOf(point);
    const all = Array.from(paths, (path, k) => measurable(path, `paths[${k}]`));
    const distances = all.map((path) => path._boxDistance(p));
    let limit = maxDistance;
    let best: NearestPath | null = null;
    const search = (index: number) => {
      if (!(distances[index] <= limit)) return;
      const found = all[index]._nearest(p, limit);
      if (!found || (best && found.distance === limit && index > best.index)) return;
      best = { index, ...found };
      limit = found.distance;
    };
    const first = distances.indexOf(distances.reduce((least, distance) => Math.min(least, distance), Infinity));
    if (first >= 0) search(first); // most others are farther than this one
    for (let index = 0; index < all.length; index++) if (index !== first) search(index);
    return best;
  }

  /**
   * A path of fewer lines and cubics: each subpath is simplified as by `Spline.simplify`, so the Hausdorff distance of a
   * subpath from its original is at most the tolerance.
   *
   *     Path.fromSVG(traced).simplify(0.5).toSVG({ precision: 2 });
   *
   * @param tolerance the largest distance, in the unit of the path
   */
  simplify(tolerance: number, options?: SimplifyOptions): this {
    check.positive(tolerance, "tolerance");
    const splines = this.subpaths.map((spline) => spline.simplify(tolerance, options));
    return this._pathOf(packedPaths(splines.map((spline) => packedShape(spline, "splines"))));
  }

  /**
   * All intersections with another path, a spline or a curve. `t` is a location {subpath, t} on this path; `u` is a
   * location on another path, or the t of a spline or a curve. They are sorted by the subpath of this path, the subpath
   * of the other one, t and u.
   *
   * An intersection at a joint or at the start of a closed subpath is reported once, and so is an end point that both
   * have in common. Subpaths are intersected separately: a point that lies on two of them is reported for each. The
   * lines that would close open subpaths do not count.
   *
   * Pairs of segments are found with a tree of boxes, in about n log n time for n segments. In the worst case each pair
   * of segments is compared, with the limits of `Curve.intersections`.
   *
   * @param other a curve, a spline or a path
   */
  intersections<S extends Shape>(
    other: S,
    ...surplus: never[]
  ): Intersection<PathTime, S extends PathValue ? PathTime : number>[] {
    check.noSurplus(surplus, "intersections", 1);
    return intersectPathWith(this._packed, other) as any;
  }

  /**
   * The points that the path passes twice, on one subpath or on two: at the location `t` and at the later location `u`.
   * Each pair is reported once.
   */
  selfIntersections(...surplus: never[]): PathIntersection[] {
    check.noSurplus(surplus, "selfIntersections", 0);
    return selfIntersectPath(this._packed);
  }
}

/**
 * @internal
 * @throws {TypeError} for a static method that was called without its class
 */
export function pathFrom<P>(Class: PathClass<P>, packed: Float64Array): P {
  if (typeof Class !== "function")
    throw new TypeError("expected a call of a static method on its class, as Path.circle(…)");
  return new Class(new CheckedPath(packed) as any);
}

/**
 * The packed path of what `Path.from` accepts.
 *
 * @internal
 */
export function packedFrom(shapes: Shape | ArrayLike<Shape>, surplus: never[]): Float64Array {
  // A number is the index that `map` passes.
  if (typeof surplus[0] !== "number") check.noSurplus(surplus, "from", 1, "from([a, b])");
  if (!Array.isArray(shapes)) return packedShape(shapes, "shapes");
  return packedPaths(Array.from(shapes, (shape, k) => packedShape(shape, `shapes[${k}]`)));
}

/**
 * The packed path of what `toJSON` returned.
 *
 * @internal
 */
export function packedFromJSON(json: { subpaths: SplineJSON[] }): Float64Array {
  if (typeof json !== "object" || json === null || !Array.isArray(json.subpaths)) {
    throw new TypeError(`json: expected an object with subpaths, got ${check.describe(json)}`);
  }
  return packedSplines(Array.from(json.subpaths, (subpath, k) => require2D(splineDataOf(subpath), `subpaths[${k}]`)));
}

/** A path of any entry point as one that can be searched. */
function measurable(path: unknown, name: string): CorePath {
  return path instanceof CorePath ? path : pathFrom(CorePath, pathData(path, name));
}
