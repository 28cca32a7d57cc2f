import * as check from "./check.js";
import { Curve } from "./curve.js";
import { core } from "../wasm/init.js";
import { CHAIN } from "./intersections.js";
import { extents, packedSplines } from "../wasm/packed-path.js";
import { meetPaths, nearestOnPath, takeTimes } from "./path-queries.js";
import { boxAt, samePoints, writePoint } from "./points.js";
import { Spline, splineOf } from "./spline.js";
import { readSvg } from "../io/svg-read.js";
import { svgOf, traceOn } from "../io/svg-write.js";
import { load, take, trim } from "../wasm/transfer.js";

/**
 * @import { MatrixLike, PointLike } from "./check.js"
 * @import { Chain } from "./intersections.js"
 * @import { PathIntersection, PathPoint, PathTime } from "./path-queries.js"
 * @import { Point } from "./points.js"
 * @import { SvgOptions } from "../io/svg-write.js"
 */

/**
 * Which winding numbers count as inside: all but 0, or the odd ones.
 *
 * @typedef {"nonzero" | "evenodd"} FillRule
 */

/**
 * Integrals over what is inside, counted as often as the path winds around it.
 *
 * @typedef {{ area: number, x: number, y: number, xx: number, xy: number, yy: number }} Moments
 */

/**
 * What `Path.fromSVG` throws: a RangeError that knows where the error is, in characters from the start of the text, and
 * the path that was read before it (what SVG asks viewers to draw).
 *
 * @typedef {RangeError & { offset: number, path: Path }} SvgError
 */

/** @type {readonly FillRule[]} */
const RULES = ["nonzero", "evenodd"];

/**
 * Several splines of the plane, open and closed: outlines with holes, icons, what SVG path data can say. It may be empty.
 *
 *     const ring = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
 *     ring.contains([0.5, 2]); // true
 *     ring.contains([2, 2]); // false
 */
export class Path {
  /** @type {Float64Array} see `path-packed.js` */
  #packed;
  /** @type {readonly Spline[] | null} */
  #subpaths = null;

  /**
   * @param {ArrayLike<Spline | Curve>} splines of the plane
   * @throws {TypeError} for what is no spline or curve, or one of space
   */
  constructor(splines) {
    const inside = /** @type {unknown} */ (splines);
    if (inside instanceof CheckedPath) {
      this.#packed = inside.packed;
      return;
    }
    if (!Array.isArray(splines))
      throw new TypeError(`splines: expected an array of splines, got ${check.shown(splines)}`);
    this.#packed = packedSplines(Array.from(splines, (spline, k) => checkedSpline(spline, `splines[${k}]`)));
  }

  /**
   * A path from the `d` of an SVG `<path>`: all commands, in time proportional to the length of the text.
   *
   * Arcs become cubics within 1e-9 of the larger radius. A moveto without a segment is left out; "M1 1Z" is a closed
   * subpath of one line without a length. `Z` adds a line to the start unless the pen is there.
   *
   * @param {string} d
   * @returns {Path}
   * @throws {SvgError} a RangeError with `offset` and `path`, what was read before the error
   */
  static fromSVG(d) {
    if (typeof d !== "string") throw new TypeError(`d: expected a string, got ${check.shown(d)}`);
    const { packed, error } = readSvg(d);
    const path = pathOf(packed);
    if (error) throw Object.assign(new RangeError(error.message), { offset: error.offset, path });
    return path;
  }

  /**
   * @param {{ subpaths: Parameters<typeof Spline.fromJSON>[0][] }} json what `toJSON` gave
   * @returns {Path}
   */
  static fromJSON(json) {
    if (typeof json !== "object" || json === null || !Array.isArray(json.subpaths)) {
      throw new TypeError(`json: expected an object with subpaths, got ${check.shown(json)}`);
    }
    return pathOf(
      packedSplines(
        Array.from(json.subpaths, (subpath, k) => checkedSpline(Spline.fromJSON(subpath), `subpaths[${k}]`)),
      ),
    );
  }

  /** The number of subpaths. */
  get subpathCount() {
    return this.#packed[0];
  }

  /** The subpaths, in a list of their own that cannot be changed. */
  get subpaths() {
    this.#subpaths ??= Object.freeze(unpack(this.#packed));
    return this.#subpaths;
  }

  /**
   * The path as the `d` of an SVG `<path>`; higher degrees as cubics.
   *
   * Without `precision` "M0,0 L1,0.5 Z", numbers with the fewest digits that give them back, so that `fromSVG` reads an
   * equal path; with it "M0 0 1 .5Z", so many digits after the point at most and no character too many.
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
   * @param {number} [tolerance] the greatest error; without one 1e-12 of the length
   * @returns {number}
   */
  length(tolerance) {
    const most = check.optionalTolerance(tolerance);
    load(this.#packed);
    return take(0, core().path_length(most))[0];
  }

  /**
   * The place that has the length s behind it, from the start of the first subpath; null for an empty path.
   *
   * @param {number} s beyond the ends the nearer end comes back
   * @param {number} [tolerance] the greatest error, as a length
   * @returns {PathTime | null}
   */
  timeAtLength(s, tolerance) {
    check.finite(s, "s");
    const most = check.optionalTolerance(tolerance);
    load(this.#packed);
    return takeTimes(core().path_time_at_length(s, most))[0] ?? null;
  }

  /**
   * `segments` + 1 places that divide the whole path into parts of one length; none for an empty path.
   *
   * @param {number} segments
   * @returns {PathTime[]}
   */
  equidistantTimes(segments) {
    check.segmentCount(segments);
    load(this.#packed);
    const places = takeTimes(core().path_equidistant_times(segments));
    trim();
    return places;
  }

  /**
   * All places that the path shares with another one, or with a spline or a curve: sorted by subpath, then the other's,
   * then t, then u.
   *
   * At worst each segment is compared with each, with the limit of Curve.intersections.
   *
   * @param {Path | Spline | Curve} other
   * @returns {PathIntersection[]}
   */
  intersections(other) {
    const path = typeof other === "object" && other !== null && #packed in other;
    return meetPaths(
      this.#packed,
      path ? other.#packed : packedSplines([checkedSpline(other, "other", "a Path, a Spline or a Curve")]),
    );
  }

  /**
   * The places that the path passes twice, on one subpath or on two; each pair once.
   *
   * @returns {PathIntersection[]}
   */
  selfIntersections() {
    return meetPaths(this.#packed);
  }

  /**
   * The signed area inside, counter-clockwise subpaths positive (x right, y up); open ones are closed by a line.
   *
   * @returns {number}
   */
  area() {
    load(this.#packed);
    return core().path_area();
  }

  /**
   * The integrals of 1, x, y, x², xy and y² over the inside; the centre of mass is (x, y) / area.
   *
   * @returns {Moments}
   */
  moments() {
    load(this.#packed);
    const [area, x, y, xx, xy, yy] = take(0, core().path_moments());
    return { area, x, y, xx, xy, yy };
  }

  /**
   * The point of the path that is nearest to another point, the first of several; null for an empty path.
   *
   * @param {PointLike} point
   * @returns {PathPoint | null}
   */
  nearest(point) {
    return nearestOnPath(this.#packed, place(point));
  }

  /**
   * How often the path runs around a point, counter-clockwise positive (x right, y up); open subpaths are closed by a
   * line. On the boundary the point counts as if it lay a little to the right and above.
   *
   * @param {PointLike} point
   * @returns {number}
   */
  windingNumber(point) {
    const [x, y] = place(point);
    load(this.#packed);
    return core().path_winding_number(x, y);
  }

  /**
   * Whether the path, filled by that rule, covers a point.
   *
   * @param {PointLike} point
   * @param {FillRule} [rule]
   * @returns {boolean}
   */
  contains(point, rule = "nonzero") {
    check.oneOf(rule, "rule", RULES);
    const winding = this.windingNumber(point);
    return rule === "nonzero" ? winding !== 0 : winding % 2 !== 0;
  }

  /**
   * A polyline for each subpath, from which it is nowhere farther than `tolerance`; joints are vertices.
   *
   * @param {number} tolerance
   * @returns {{ points: Float64Array, ts: Float64Array }[]}
   */
  flatten(tolerance) {
    check.positive(tolerance, "tolerance");
    load(this.#packed);
    const numbers = take(0, core().path_flatten(tolerance));
    trim();
    const lines = [];
    for (let at = 0; at < numbers.length; ) {
      const points = at + 1;
      const ts = points + 2 * numbers[at];
      at = ts + numbers[at];
      lines.push({ points: numbers.slice(points, ts), ts: numbers.slice(ts, at) });
    }
    return lines;
  }

  /**
   * The image under an affine map.
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
   * The same path with each subpath run through backwards; the subpaths keep their order, closed ones their first point.
   *
   * @returns {Path}
   */
  reverse() {
    const packed = this.#packed.slice();
    for (const { closed, degrees, points, end } of extents(packed)) {
      packed.subarray(degrees, points).reverse();
      const first = closed ? points + 2 : points;
      // Coordinates backwards are y before x.
      packed.subarray(first, end).reverse();
      for (let k = first; k < end; k += 2) [packed[k], packed[k + 1]] = [packed[k + 1], packed[k]];
    }
    return pathOf(packed);
  }

  /**
   * Draws the path on a canvas context or a Path2D.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
   * @param {{ tolerance?: number }} [options] for degrees above 3, which are drawn as cubics
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
    load(this.#packed);
    const numbers = take(0, core().path_bounds(exact));
    return numbers.length ? boxAt(numbers, 2) : null;
  }
}

/** A packed path that was checked: what the constructor takes from inside. */
class CheckedPath {
  /** @param {Float64Array} packed */
  constructor(packed) {
    this.packed = packed;
  }
}

/** @param {unknown} other */
function asPath(other) {
  return check.instanceOf(other, "other", Path); // outside of the class, see curve.js
}

/** @param {Float64Array} packed */
function pathOf(packed) {
  return new Path(/** @type {any} */ (new CheckedPath(packed)));
}

/**
 * @param {PointLike} point
 * @returns {Float64Array}
 */
function place(point) {
  const p = new Float64Array(2);
  writePoint(p, 0, point, 2, "point");
  return p;
}

/**
 * The parts of a subpath.
 *
 * @param {unknown} spline
 * @param {string} name
 * @param {string} [expected]
 * @returns {Chain}
 */
function checkedSpline(spline, name, expected = "a Spline or a Curve") {
  if (!(spline instanceof Spline || spline instanceof Curve))
    throw new TypeError(`${name}: expected ${expected}, got ${check.shown(spline)}`);
  if (spline.dimension === 3) throw new TypeError(`${name}: expected a 2D one, got a 3D one`);
  return spline[CHAIN]();
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
