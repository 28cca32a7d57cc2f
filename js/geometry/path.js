import { splineData } from "./brand.js";
import * as check from "./check.js";
import { core } from "../wasm/init.js";
import { extents, packedSplines } from "../wasm/packed-path.js";
import { intersectPaths, nearestOnPath, readTimes } from "./path-queries.js";
import { boxAt, samePoints, writePoint } from "./points.js";
import { splineDataOf } from "./spline/spline-value.js";
import { splineOf } from "./spline/spline.js";
import { readSvg } from "../io/svg-read.js";
import { svgOf, traceOn } from "../io/svg-write.js";
import { writeArguments, readResult, releaseMemory } from "../wasm/transfer.js";

/**
 * @import { SplineData } from "./brand.js"
 * @import { MatrixLike, PointLike } from "./check.js"
 * @import { CoreCurve } from "./curve/core-curve.js"
 * @import { PathIntersection, PathPoint, PathTime } from "./path-queries.js"
 * @import { Point } from "./points.js"
 * @import { CoreSpline } from "./spline/core-spline.js"
 * @import { SplineJSON } from "./spline/spline-value.js"
 * @import { Spline } from "./spline/spline.js"
 * @import { SvgOptions } from "../io/svg-write.js"
 */

/**
 * The rule that decides which winding numbers are inside: all except 0, or the odd ones.
 *
 * @typedef {"nonzero" | "evenodd"} FillRule
 */

/**
 * The integrals of 1, x, y, x², xy and y² over the inside; each region is weighted with its winding number.
 *
 * @typedef {{ area: number, x: number, y: number, xx: number, xy: number, yy: number }} Moments
 */

/**
 * The error that `Path.fromSVG` throws: a RangeError with the offset of the error in the text, in characters, and the
 * path up to the error (which viewers are to render, according to the SVG specification).
 *
 * @typedef {RangeError & { offset: number, path: Path }} SvgError
 */

/** @type {readonly FillRule[]} */
const FILL_RULES = ["nonzero", "evenodd"];

/**
 * A list of 2D splines, open or closed: outlines with holes, icons, anything that SVG path data can describe. It may be
 * empty.
 *
 *     const ring = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
 *     ring.contains([0.5, 2]); // true
 *     ring.contains([2, 2]); // false
 */
export class Path {
  /** @type {Float64Array} see `packed-path.js` */
  #packed;
  /** @type {readonly Spline[] | null} */
  #subpaths = null;

  /**
   * @param {ArrayLike<CoreSpline | CoreCurve>} splines 2D
   * @throws {TypeError} for values that are not splines or curves, and for 3D ones
   */
  constructor(splines) {
    const checked = /** @type {unknown} */ (splines);
    if (checked instanceof CheckedPath) {
      this.#packed = checked.packed;
      return;
    }
    if (!Array.isArray(splines))
      throw new TypeError(`splines: expected an array of splines, got ${check.describe(splines)}`);
    this.#packed = packedSplines(Array.from(splines, (spline, k) => checkedSplineData(spline, `splines[${k}]`)));
  }

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
   * See `brand.js`.
   *
   * @internal
   * @returns {"path"}
   */
  get casteljauType() {
    return "path";
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
   *
   * @param {SvgOptions} [options]
   * @returns {string}
   */
  toSVG(options) {
    return svgOf(this.#packed, options);
  }

  /**
   * Whether both have the same structure and each control point lies within a distance of its counterpart.
   *
   * @param {Path} other
   * @param {number} [tolerance]
   * @returns {boolean}
   */
  equals(other, tolerance = 0) {
    const [a, b] = [this.#packed, asPath(other).#packed];
    samePoints(new Float64Array(0), new Float64Array(0), 2, tolerance); // checks the tolerance
    if (a.length !== b.length || a[0] !== b[0]) return false;
    for (const { degrees, points, end } of extents(a)) {
      for (let k = degrees - 2; k < points; k++) if (a[k] !== b[k]) return false;
      if (!samePoints(a.subarray(points, end), b.subarray(points, end), 2, tolerance)) return false;
    }
    return true;
  }

  /**
   * The smallest box that contains the path; null for an empty one.
   *
   * @returns {{ min: Point, max: Point } | null}
   */
  bounds() {
    return this.#box(true);
  }

  /**
   * The box of the control points, which contains the path; null for an empty one.
   *
   * @returns {{ min: Point, max: Point } | null}
   */
  controlBounds() {
    return this.#box(false);
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
    writeArguments(this.#packed);
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
    writeArguments(this.#packed);
    return readTimes(core().path_time_at_length(s, maxError))[0] ?? null;
  }

  /**
   * `segments` + 1 positions that divide the whole path into parts of equal length; none for an empty path.
   *
   * @param {number} segments
   * @returns {PathTime[]}
   */
  equidistantTimes(segments) {
    check.segmentCount(segments);
    writeArguments(this.#packed);
    const times = readTimes(core().path_equidistant_times(segments));
    releaseMemory();
    return times;
  }

  /**
   * All intersections with another path, a spline or a curve: sorted by subpath, then by the other's subpath, then by
   * t, then by u.
   *
   * In the worst case each pair of segments is compared, with the limits of `Curve.intersections`.
   *
   * @param {Path | CoreSpline | CoreCurve} other
   * @returns {PathIntersection[]}
   */
  intersections(other) {
    const isPath = typeof other === "object" && other !== null && #packed in other;
    return intersectPaths(
      this.#packed,
      isPath ? other.#packed : packedSplines([checkedSplineData(other, "other", "a Path, a Spline or a Curve")]),
    );
  }

  /**
   * The points that the path passes twice, on one subpath or on two; each pair is reported once.
   *
   * @returns {PathIntersection[]}
   */
  selfIntersections() {
    return intersectPaths(this.#packed);
  }

  /**
   * The signed area inside, positive for counter-clockwise subpaths (x right, y up); open subpaths are closed by a
   * line.
   *
   * @returns {number}
   */
  area() {
    writeArguments(this.#packed);
    return core().path_area();
  }

  /**
   * The integrals of 1, x, y, x², xy and y² over the inside, weighted as in `area`; the centre of mass is (x, y) /
   * area.
   *
   * @returns {Moments}
   */
  moments() {
    writeArguments(this.#packed);
    const [area, x, y, xx, xy, yy] = readResult(0, core().path_moments());
    return { area, x, y, xx, xy, yy };
  }

  /**
   * The point of the path that is nearest to another point, the first one of several; null for an empty path.
   *
   * @param {PointLike} point
   * @returns {PathPoint | null}
   */
  nearest(point) {
    return nearestOnPath(this.#packed, coordinatesOf(point));
  }

  /**
   * The winding number of the path around a point: counter-clockwise is positive (x right, y up). Open subpaths are
   * closed by a line. A point on the boundary counts as slightly displaced to the right and upwards.
   *
   * @param {PointLike} point
   * @returns {number}
   */
  windingNumber(point) {
    const [x, y] = coordinatesOf(point);
    writeArguments(this.#packed);
    return core().path_winding_number(x, y);
  }

  /**
   * Whether the path, filled by the rule, contains a point.
   *
   * @param {PointLike} point
   * @param {FillRule} [rule]
   * @returns {boolean}
   */
  contains(point, rule = "nonzero") {
    check.oneOf(rule, "rule", FILL_RULES);
    const winding = this.windingNumber(point);
    return rule === "nonzero" ? winding !== 0 : winding % 2 !== 0;
  }

  /**
   * For each subpath a polyline whose distance from it is nowhere greater than `tolerance`; joints are vertices.
   *
   * @param {number} tolerance
   * @param {never[]} surplus
   * @returns {{ points: Float64Array, ts: Float64Array }[]}
   */
  flatten(tolerance, ...surplus) {
    check.noSurplus(surplus, "flatten", 1);
    check.positive(tolerance, "tolerance");
    writeArguments(this.#packed);
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
   * The path transformed by an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Path}
   */
  transform(matrix) {
    const [a, b, , c, d, , , , , e, f] = check.affine(matrix);
    const packed = this.#packed.slice();
    for (const { points, end } of extents(packed)) {
      for (let k = points; k < end; k += 2) {
        const [x, y] = [packed[k], packed[k + 1]];
        packed[k] = a * x + c * y + e;
        packed[k + 1] = b * x + d * y + f;
      }
    }
    return pathOf(packed);
  }

  /**
   * The same path with each subpath reversed; the order of the subpaths and the first points of closed ones are kept.
   *
   * @returns {Path}
   */
  reverse() {
    const packed = this.#packed.slice();
    for (const { closed, degrees, points, end } of extents(packed)) {
      packed.subarray(degrees, points).reverse();
      const first = closed ? points + 2 : points;
      // Reversing the array also exchanges x and y of each point.
      packed.subarray(first, end).reverse();
      for (let k = first; k < end; k += 2) [packed[k], packed[k + 1]] = [packed[k + 1], packed[k]];
    }
    return pathOf(packed);
  }

  /**
   * Draws the path on a canvas context or a Path2D.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
   * @param {{ tolerance?: number }} [options] `tolerance`: for degrees above 3, which are drawn as cubics
   */
  trace(target, options) {
    traceOn(this.#packed, target, options);
  }

  /**
   * @returns {{ subpaths: ReturnType<Spline["toJSON"]>[] }}
   */
  toJSON() {
    return { subpaths: this.subpaths.map((spline) => spline.toJSON()) };
  }

  /** @param {boolean} exact */
  #box(exact) {
    writeArguments(this.#packed);
    const numbers = readResult(0, core().path_bounds(exact));
    return numbers.length ? boxAt(numbers, 2) : null;
  }
}

/** A packed path that is already checked: the constructor accepts it from inside the package. */
class CheckedPath {
  /** @param {Float64Array} packed */
  constructor(packed) {
    this.packed = packed;
  }
}

/** @param {unknown} other */
function asPath(other) {
  return check.instanceOf(other, "other", Path, "a Path"); // outside of the class, see curve.js
}

/** @param {Float64Array} packed */
function pathOf(packed) {
  return new Path(/** @type {any} */ (new CheckedPath(packed)));
}

/**
 * @param {PointLike} point
 * @returns {Float64Array}
 */
function coordinatesOf(point) {
  const coordinates = new Float64Array(2);
  writePoint(coordinates, 0, point, 2, "point");
  return coordinates;
}

/**
 * The data of a subpath.
 *
 * @param {unknown} spline
 * @param {string} name
 * @param {string} [expected]
 * @returns {SplineData}
 */
function checkedSplineData(spline, name, expected = "a Spline or a Curve") {
  return require2D(splineData(spline, name, expected), name);
}

/**
 * @param {SplineData} data
 * @param {string} name
 */
function require2D(data, name) {
  if (data.dimension === 3) throw new TypeError(`${name}: expected a 2D one, got a 3D one`);
  return data;
}

/**
 * @param {Float64Array} packed
 * @returns {Spline[]}
 */
function unpack(packed) {
  return Array.from(extents(packed), ({ closed, degrees, points, end }) =>
    splineOf({ flat: packed.slice(points, end), dimension: 2, degrees: [...packed.subarray(degrees, points)], closed }),
  );
}
