import { pathData } from "../brand.js";
import * as check from "../check.js";
import { requireList } from "../points.js";
import { PathRegions } from "./path-regions.js";
import { intersectPathWith, selfIntersectPath } from "../intersections.js";
import * as regions from "./path-boolean.js";
import * as shapes from "./path-shapes.js";
import { packedShape, require2D } from "./packed-shape.js";
import { CheckedPath, coordinatesOf } from "./path-value.js";
import { splineDataOf } from "../spline/spline-value.js";
import { PathBuilder } from "./path-builder.js";
import { readPathData } from "../../io/path-data.js";
import { readSvg } from "../../io/svg-read.js";
import { checkTolerance } from "../../io/svg-write.js";
import { packedPaths, packedSplines } from "../../wasm/packed-path.js";

/**
 * @import { PointLike, PointsLike } from "../check.js"
 * @import { CoreCurve } from "../curve/core-curve.js"
 * @import { BooleanOperation } from "./path-boolean.js"
 * @import { RegionOptions } from "./path-measures.js"
 * @import { ArcOptions, RectOptions } from "./path-shapes.js"
 * @import { PathPoint, PathTime } from "./path-queries.js"
 * @import { Intersection, PathIntersection } from "../intersections.js"
 * @import { PathValue } from "./path-value.js"
 * @import { CoreSpline } from "../spline/core-spline.js"
 * @import { PathSegment } from "../../io/path-data.js"
 * @import { SimplifyOptions } from "../spline/spline.js"
 * @import { SplineJSON } from "../spline/spline-value.js"
 */

/**
 * The error that `Path.fromSVG` throws: a RangeError with the offset of the error in the text, in characters, and the
 * path up to the error (which viewers are to render, according to the SVG specification).
 *
 * @typedef {RangeError & { offset: number, path: Path }} SvgError
 */

/**
 * What a path can be made of and intersected with, from any entry point of this package.
 *
 * @typedef {PathValue | CoreSpline | CoreCurve} Shape
 */

/**
 * A face of `Path.faces`: an outer contour with its holes, and for each path whether it contains the face.
 *
 * @typedef {{ path: Path, inside: boolean[] }} Face
 */

/**
 * What `Path.nearestOf` finds: the index of the path, and the nearest point on it.
 *
 * @typedef {PathPoint & { index: number }} NearestPath
 */

/**
 * A list of 2D splines, open or closed: outlines with holes, icons, anything that SVG path data can describe. It may be
 * empty.
 *
 *     const ring = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
 *     ring.contains([0.5, 2]); // true
 *     ring.contains([2, 2]); // false
 */
export class Path extends PathRegions {
  /**
   * Parses the `d` attribute of an SVG `<path>` with all its commands, in time proportional to the length of the text.
   *
   * Arcs are approximated by as few cubics as possible within a tolerance, by default 1e-5 of the larger radius: 8 for
   * a circle. A moveto without a segment is ignored; "M1 1Z" is
   * a closed subpath with one line of length 0. The text "none", as in CSS, gives an empty path. `Z` adds a line to the start unless the current point is already there.
   *
   * @param {string} d SVG path data
   * @param {ArcOptions} [options]
   * @returns {Path}
   * @throws {SvgError} a RangeError with `offset` and `path`, the path up to the error
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  static fromSVG(d, options) {
    if (typeof d !== "string") throw new TypeError(`d: expected a string, got ${check.describe(d)}`);
    const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
    const { packed, error } = readSvg(d, tolerance);
    const path = pathOf(packed);
    if (error) throw Object.assign(new RangeError(error.message), { offset: error.offset, path });
    checkTolerance(packed, tolerance);
    return path;
  }

  /**
   * The path that `toJSON` described.
   *
   * @param {{ subpaths: SplineJSON[] }} json what `toJSON` returned
   * @returns {Path}
   */
  static fromJSON(json) {
    if (typeof json !== "object" || json === null || !Array.isArray(json.subpaths)) {
      throw new TypeError(`json: expected an object with subpaths, got ${check.describe(json)}`);
    }
    return pathOf(
      packedSplines(Array.from(json.subpaths, (subpath, k) => require2D(splineDataOf(subpath), `subpaths[${k}]`))),
    );
  }

  /**
   * The path of a curve, a spline, a path, or an array of these; the subpaths of paths are copied.
   *
   * @param {Shape | ArrayLike<Shape>} shapes curves, splines and paths in the plane
   * @param {never[]} surplus
   * @returns {Path}
   * @throws {TypeError} for other values, and for 3D ones
   */
  static from(shapes, ...surplus) {
    if (typeof surplus[0] !== "number")
      // as map passes
      check.noSurplus(surplus, "from", 1, "from([a, b])");
    if (!Array.isArray(shapes)) return pathOf(packedShape(shapes, "shapes"));
    return pathOf(packedPaths(Array.from(shapes, (shape, k) => packedShape(shape, `shapes[${k}]`))));
  }

  /**
   * The path of segments of path data, as `getPathData` of SVG elements gives them: commands of SVG path data in any
   * form, with their numbers.
   *
   *     Path.fromPathData(document.querySelector("path").getPathData());
   *
   * @param {ArrayLike<PathSegment>} segments `type`: the letter of a command; `values`: the numbers of one such command
   * @param {ArcOptions} [options]
   * @returns {Path}
   * @throws {RangeError} for an unknown command, and for a wrong number of values
   */
  static fromPathData(segments, options) {
    const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
    const packed = readPathData(segments, tolerance);
    checkTolerance(packed, tolerance);
    return pathOf(packed);
  }

  /**
   * A builder with the methods of a canvas context, for code that draws on one.
   *
   *     const builder = Path.builder();
   *     d3.line().context(builder)(data); // or any other function that draws on a canvas
   *     const path = builder.build();
   *
   * @param {ArcOptions} [options] for `arc`, `arcTo`, `ellipse` and `roundRect`
   * @returns {PathBuilder}
   */
  static builder(options) {
    return new PathBuilder(check.optionalTolerance(check.options(options, ["tolerance"]).tolerance), pathOf);
  }

  /**
   * A circle, counter-clockwise (x right, y up; clockwise on a canvas), from the point to the right of the centre. It
   * consists of cubics that join at each quarter turn.
   *
   * By default, 8 cubics approximate it within 4.3e-6 of the radius. The largest distance of a cubic over the angle θ is
   * 2/27 sin⁶(θ/4) / cos²(θ/4) of the radius: a tolerance of 2.73e-4 · radius gives the usual four cubics.
   *
   * @param {PointLike} center the center
   * @param {number} radius 0 gives a closed subpath that is a point
   * @param {ArcOptions} [options]
   * @returns {Path}
   * @throws {RangeError} for a negative radius, coordinates that overflow, and a tolerance not above 0 or below 4 ulps of
   *   the largest coordinate
   */
  static circle(center, radius, options) {
    return pathOf(shapes.circle(center, radius, options));
  }

  /**
   * An ellipse with the same direction and accuracy as `circle`, from the end of its first semi-axis.
   *
   * @param {PointLike} center the center
   * @param {number} radiusX the length of the first semi-axis
   * @param {number} radiusY the length of the second semi-axis
   * @param {number} [rotation] the angle from the x-axis to the first semi-axis, in radians, counter-clockwise (y up)
   * @param {ArcOptions} [options]
   * @returns {Path}
   */
  static ellipse(center, radiusX, radiusY, rotation, options) {
    return pathOf(shapes.ellipse(center, radiusX, radiusY, rotation, options));
  }

  /**
   * An arc of a circle as an open subpath, with the accuracy of `circle`: counter-clockwise (x right, y up; clockwise on
   * a canvas) if `endAngle` is greater than `startAngle`, otherwise clockwise.
   *
   *     Path.arc([0, 0], 1, 0, Math.PI / 2); // from (1, 0) to (0, 1)
   *
   * @param {PointLike} center the center
   * @param {number} radius the radius, in the unit of the points
   * @param {number} startAngle in radians, from the x-axis towards the y-axis
   * @param {number} endAngle in radians; at most a full turn away from `startAngle`
   * @param {ArcOptions} [options]
   * @returns {Path}
   */
  static arc(center, radius, startAngle, endAngle, options) {
    return pathOf(shapes.circularArc(center, radius, startAngle, endAngle, options));
  }

  /**
   * A rectangle with sides parallel to the axes, counter-clockwise (x right, y up; clockwise on a canvas), from the
   * corner with the smallest coordinates (after its rounding).
   *
   * @param {PointLike} corner the corner with the smallest coordinates
   * @param {number} width the width, at least 0
   * @param {number} height the height, at least 0
   * @param {RectOptions} [options]
   * @returns {Path}
   */
  static rect(corner, width, height, options) {
    return pathOf(shapes.rect(corner, width, height, options));
  }

  /**
   * A polygon, or an open polyline, with the given corners in their order.
   *
   * @param {PointsLike} points a flat array is read as x, y, x, y, …; at least 1 point, at least 2 if open
   * @param {{ closed?: boolean }} [options] `closed`: true by default
   * @returns {Path}
   */
  static polygon(points, options) {
    requireList(points);
    return pathOf(shapes.polygon(points, options));
  }

  /**
   * Combines the regions that any number of paths fill, see `union`. Without paths the result is empty.
   *
   * @param {Path[]} paths
   * @param {BooleanOperation} operation
   * @param {RegionOptions} [options]
   * @returns {Path}
   */
  static combine(paths, operation, options) {
    return pathOf(regions.combine(paths, operation, options));
  }

  /**
   * The path of a list that is nearest to a point, the first one of several, for hit testing: its index, the location on
   * it, the nearest point and its distance. Null if all are farther than `maxDistance`, and for empty paths.
   *
   *     const hit = Path.nearestOf(paths, [event.offsetX, event.offsetY], { maxDistance: 5 });
   *     if (hit) paths[hit.index]; // is under the pointer
   *
   * @param {ArrayLike<Path>} paths
   * @param {PointLike} point
   * @param {{ maxDistance?: number }} [options] `maxDistance`: by default there is no limit
   * @returns {NearestPath | null}
   */
  static nearestOf(paths, point, options) {
    if (!Array.isArray(paths)) throw new TypeError(`paths: expected an array of paths, got ${check.describe(paths)}`);
    const { maxDistance = Infinity } = check.options(options, ["maxDistance"]);
    if (maxDistance !== Infinity) check.finite(maxDistance, "maxDistance");
    if (maxDistance < 0) throw new RangeError(`maxDistance: expected a number from 0, got ${maxDistance}`);
    const p = coordinatesOf(point);
    const all = Array.from(paths, (path, k) => (path instanceof Path ? path : pathOf(pathData(path, `paths[${k}]`))));
    const distances = all.map((path) => path._boxDistance(p));
    let limit = maxDistance;
    /** @type {NearestPath | null} */
    let best = null;
    const search = (/** @type {number} */ index) => {
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
   * The bounded faces into which the outlines of paths divide the plane, and which paths contain each: what a shape
   * builder shows under the pointer. Faces that no path contains (the hole of a ring) are in the list as well. Open
   * subpaths are closed by lines; see `union` for the contours.
   *
   *     const parts = Path.faces([Path.circle([0, 0], 1), Path.circle([1, 0], 1)]);
   *     parts.map(({ inside }) => inside); // [true, false], [true, true] and [false, true] in some order
   *
   * @param {Path[]} paths
   * @param {RegionOptions} [options]
   * @returns {Face[]}
   */
  static faces(paths, options) {
    return regions.faces(paths, options).map(({ packed, inside }) => ({ path: pathOf(packed), inside }));
  }

  /**
   * A path of fewer lines and cubics: each subpath is simplified as by `Spline.simplify`, so the Hausdorff distance of a
   * subpath from its original is at most the tolerance.
   *
   *     Path.fromSVG(traced).simplify(0.5).toSVG({ precision: 2 });
   *
   * @param {number} tolerance the largest distance, in the unit of the path
   * @param {SimplifyOptions} [options]
   * @returns {this}
   */
  simplify(tolerance, options) {
    check.positive(tolerance, "tolerance");
    const splines = this.subpaths.map((spline) => spline.simplify(tolerance, options));
    return this._pathOf(Path.from(splines)._packed);
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
   * @template {Shape} S
   * @param {S} other a curve, a spline or a path
   * @param {never[]} surplus
   * @returns {Intersection<PathTime, S extends PathValue ? PathTime : number>[]}
   */
  intersections(other, ...surplus) {
    check.noSurplus(surplus, "intersections", 1);
    return /** @type {any} */ (intersectPathWith(this._packed, other));
  }

  /**
   * The points that the path passes twice, on one subpath or on two: at the location `t` and at the later location `u`.
   * Each pair is reported once.
   *
   * @param {never[]} surplus
   * @returns {PathIntersection[]}
   */
  selfIntersections(...surplus) {
    check.noSurplus(surplus, "selfIntersections", 0);
    return selfIntersectPath(this._packed);
  }

  /**
   * @internal
   * @override
   * @param {Float64Array} packed
   * @returns {this}
   */
  _pathOf(packed) {
    return /** @type {this} */ (pathOf(packed));
  }
}

/**
 * @internal
 * @param {Float64Array} packed
 * @returns {Path}
 */
export function pathOf(packed) {
  return new Path(/** @type {any} */ (new CheckedPath(packed))); // outside of the class, see curve.js
}
