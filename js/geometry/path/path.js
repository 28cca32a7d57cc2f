import { packedPath } from "../brand.js";
import * as check from "../check.js";
import { PathMeasures } from "./path-measures.js";
import { intersectPaths } from "./path-queries.js";
import { CheckedPath, checkedSplineData, require2D } from "./path-value.js";
import { splineDataOf } from "../spline/spline-value.js";
import { readSvg } from "../../io/svg-read.js";
import { packedSplines } from "../../wasm/packed-path.js";

/**
 * @import { CoreCurve } from "../curve/core-curve.js"
 * @import { PathIntersection } from "./path-queries.js"
 * @import { PathValue } from "./path-value.js"
 * @import { CoreSpline } from "../spline/core-spline.js"
 * @import { SplineJSON } from "../spline/spline-value.js"
 */

/**
 * The error that `Path.fromSVG` throws: a RangeError with the offset of the error in the text, in characters, and the
 * path up to the error (which viewers are to render, according to the SVG specification).
 *
 * @typedef {RangeError & { offset: number, path: Path }} SvgError
 */

/**
 * A list of 2D splines, open or closed: outlines with holes, icons, anything that SVG path data can describe. It may be
 * empty.
 *
 *     const ring = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
 *     ring.contains([0.5, 2]); // true
 *     ring.contains([2, 2]); // false
 */
export class Path extends PathMeasures {
  /**
   * Parses the `d` attribute of an SVG `<path>` with all its commands, in time proportional to the length of the text.
   *
   * Arcs are approximated by cubics within 1e-9 of the larger radius. A moveto without a segment is ignored; "M1 1Z" is
   * a closed subpath with one line of length 0. `Z` adds a line to the start unless the current point is already there.
   *
   * @param {string} d
   * @returns {Path}
   * @throws {SvgError} a RangeError with `offset` and `path`, the path up to the error
   */
  static fromSVG(d) {
    if (typeof d !== "string") throw new TypeError(`d: expected a string, got ${check.describe(d)}`);
    const { packed, error } = readSvg(d);
    const path = pathOf(packed);
    if (error) throw Object.assign(new RangeError(error.message), { offset: error.offset, path });
    return path;
  }

  /**
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
   * All intersections with another path, a spline or a curve: sorted by subpath, then by the other's subpath, then by
   * t, then by u.
   *
   * In the worst case each pair of segments is compared, with the limits of `Curve.intersections`.
   *
   * @param {PathValue | CoreSpline | CoreCurve} other
   * @returns {PathIntersection[]}
   */
  intersections(other) {
    const packed =
      packedPath(other) ?? packedSplines([checkedSplineData(other, "other", "a Path, a Spline or a Curve")]);
    return intersectPaths(this._packed, packed);
  }

  /**
   * The points that the path passes twice, on one subpath or on two; each pair is reported once.
   *
   * @returns {PathIntersection[]}
   */
  selfIntersections() {
    return intersectPaths(this._packed);
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
