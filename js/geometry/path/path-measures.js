import * as check from "../check.js";
import { boxAt } from "../points.js";
import { nearestOnPath, readTimes } from "./path-queries.js";
import { PathEvaluation } from "./path-evaluation.js";
import { coordinatesOf } from "./path-value.js";
import { core } from "../../wasm/init.js";
import { writeArguments, readResult, releaseMemory } from "../../wasm/transfer.js";

/**
 * @import { PointLike } from "../check.js"
 * @import { PathPoint, PathPointAtLength, PathTime } from "./path-queries.js"
 * @import { Point } from "../points.js"
 */

/**
 * The rule that decides which winding numbers are inside: all except 0, or the odd ones.
 *
 * @typedef {"nonzero" | "evenodd"} FillRule
 */

/**
 * The integrals of 1, x, y, x², xy and y² over the inside; each region is weighted with its winding number.
 *
 * @typedef {object} Moments
 * @property {number} area the integral of 1
 * @property {number} x the integral of x; x / area is the x coordinate of the centroid
 * @property {number} y the integral of y; y / area is the y coordinate of the centroid
 * @property {number} xx the integral of x²
 * @property {number} xy the integral of xy
 * @property {number} yy the integral of y²
 */

/**
 * How a path is filled.
 *
 * @typedef {object} RegionOptions
 * @property {FillRule} [fillRule] which points a path contains: those with a winding number other than 0 ("nonzero", the
 *   default), or with an odd one ("evenodd")
 */

/** @type {readonly FillRule[]} */
const FILL_RULES = ["nonzero", "evenodd"];

/**
 * @internal
 * @param {RegionOptions | undefined} options
 * @returns {boolean} whether the rule is "evenodd"
 */
export function isEvenOdd(options) {
  const { fillRule = "nonzero" } = check.options(options, ["fillRule"]);
  check.oneOf(fillRule, "fillRule", FILL_RULES);
  return fillRule === "evenodd";
}

/** Boxes, lengths, areas, winding numbers and nearest points of a path. */
export class PathMeasures extends PathEvaluation {
  /**
   * The smallest box that contains the path; null for an empty one.
   *
   * @param {never[]} surplus
   * @returns {{ min: Point, max: Point } | null}
   */
  bounds(...surplus) {
    check.noSurplus(surplus, "bounds", 0);
    return this._box(true);
  }

  /**
   * The box of the control points, which contains the path; null for an empty one.
   *
   * @returns {{ min: Point, max: Point } | null}
   */
  controlBounds() {
    return this._box(false);
  }

  /**
   * The sum of the lengths of all segments.
   *
   * @param {number} [tolerance] the largest error, by default 1e-12 of the length
   * @param {never[]} surplus
   * @returns {number}
   */
  length(tolerance, ...surplus) {
    check.noSurplus(surplus, "length", 1);
    const maxError = check.optionalTolerance(tolerance);
    writeArguments(this._packed);
    return readResult(0, core().path_length(maxError))[0];
  }

  /**
   * The position at which the arc length from the start of the first subpath is s; null for an empty path.
   *
   * @param {number} s outside of [0, length] it gives the nearer end
   * @param {number} [tolerance] the largest error, as a length
   * @returns {PathTime | null}
   */
  timeAtLength(s, tolerance) {
    check.finite(s, "s");
    const maxError = check.optionalTolerance(tolerance);
    writeArguments(this._packed);
    return readTimes(core().path_time_at_length(s, maxError))[0] ?? null;
  }

  /**
   * The location at which the arc length from the start of the first subpath is s, with its point, unit tangent and unit
   * normal: for text, markers and motion along a path. Null for an empty path.
   *
   * @param {number} s outside of [0, length] it gives the nearer end
   * @param {number} [tolerance] the largest error, as a length
   * @returns {PathPointAtLength | null}
   */
  pointAtLength(s, tolerance) {
    const time = this.timeAtLength(s, tolerance);
    return time && { ...time, point: this.eval(time), tangent: this.tangent(time), normal: this.normal(time) };
  }

  /**
   * `segments` + 1 positions that divide the whole path into parts of equal length; none for an empty path.
   *
   * @param {number} segments how many parts, at least 1
   * @returns {PathTime[]}
   */
  equidistantTimes(segments) {
    check.segmentCount(segments);
    writeArguments(this._packed);
    const times = readTimes(core().path_equidistant_times(segments));
    releaseMemory();
    return times;
  }

  /**
   * The signed area inside, positive for counter-clockwise subpaths (x right, y up); open subpaths are closed by a
   * line.
   *
   * @returns {number}
   */
  area() {
    writeArguments(this._packed);
    return core().path_area();
  }

  /**
   * The integrals of 1, x, y, x², xy and y² over the inside, weighted as in `area`; the centre of mass is (x, y) /
   * area.
   *
   * @returns {Moments}
   */
  moments() {
    writeArguments(this._packed);
    const [area, x, y, xx, xy, yy] = readResult(0, core().path_moments());
    return { area, x, y, xx, xy, yy };
  }

  /**
   * The point of the path that is nearest to another point, the first one of several; null for an empty path.
   *
   * @param {PointLike} point the point, in the unit of the points
   * @returns {PathPoint | null}
   */
  nearest(point) {
    return nearestOnPath(this._packed, coordinatesOf(point));
  }

  /**
   * The winding number of the path around a point: counter-clockwise is positive (x right, y up). Open subpaths are
   * closed by a line. A point on the boundary counts as slightly displaced to the right and upwards.
   *
   * @param {PointLike} point the point, in the unit of the points
   * @returns {number}
   */
  windingNumber(point) {
    const [x, y] = coordinatesOf(point);
    writeArguments(this._packed);
    return core().path_winding_number(x, y);
  }

  /**
   * Whether the path, filled by the rule, contains a point.
   *
   * @param {PointLike} point the point, in the unit of the points
   * @param {RegionOptions} [options]
   * @returns {boolean}
   */
  contains(point, options) {
    const evenOdd = isEvenOdd(options);
    const winding = this.windingNumber(point);
    return evenOdd ? winding % 2 !== 0 : winding !== 0;
  }

  /**
   * For each subpath a polyline whose distance from it is nowhere greater than `tolerance`; joints are vertices.
   *
   * @param {number} tolerance the largest distance, in the unit of the points
   * @param {never[]} surplus
   * @returns {{ points: Float64Array, ts: Float64Array }[]}
   */
  flatten(tolerance, ...surplus) {
    check.noSurplus(surplus, "flatten", 1);
    check.positive(tolerance, "tolerance");
    writeArguments(this._packed);
    const numbers = readResult(0, core().path_flatten(tolerance));
    releaseMemory();
    const polylines = [];
    for (let at = 0; at < numbers.length; ) {
      const points = at + 1;
      const ts = points + 2 * numbers[at];
      at = ts + numbers[at];
      polylines.push({ points: numbers.slice(points, ts), ts: numbers.slice(ts, at) });
    }
    return polylines;
  }

  /**
   * @internal
   * @param {boolean} exact
   */
  _box(exact) {
    writeArguments(this._packed);
    const numbers = readResult(0, core().path_bounds(exact));
    return numbers.length ? boxAt(numbers, 2) : null;
  }
}
