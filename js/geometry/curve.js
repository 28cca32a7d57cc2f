import * as check from "./check.js";
import { core, cubicEval } from "../wasm/init.js";
import {
  SPLINE_DATA,
  splineDataOf,
  intersectSplines,
  readIntersections,
  readSelfIntersections,
} from "./intersections.js";
import * as queries from "./curve-queries.js";
import { boxAt, flatten, nested, pointAt, samePoints } from "./points.js";
import { packedSpline } from "../wasm/packed-path.js";
import { unwrapCount } from "../wasm/errors.js";
import { svgOf, traceOn } from "../io/svg-write.js";
import { CheckedPoints, writeArguments, readResult, readResultInto, releaseMemory } from "../wasm/transfer.js";
import { curveLength, curveTimeAtLength } from "./arc-length.js";
import { basisNumbers, BASES } from "./basis.js";
import { frameTimes, frameArguments, readFrames } from "./frames.js";
import { readTree } from "./subdivision.js";
import { readSpline } from "./spline.js";

/**
 * @import { SplineData, Intersection, SelfIntersection } from "./intersections.js"
 * @import { MatrixLike, PointLike, PointsLike } from "./check.js"
 * @import { CurveKind, Distance, Extrema, Nearest } from "./curve-queries.js"
 * @import { Point } from "./points.js"
 * @import { BasisLike, BasisName } from "./basis.js"
 * @import { Spline } from "./spline.js"
 * @import { FrameOptions, Frames } from "./frames.js"
 * @import { Subdivision } from "./subdivision.js"
 * @import { SvgOptions } from "../io/svg-write.js"
 */

/**
 * A curve of a lower degree, and its largest distance from the original at equal t.
 *
 * @typedef {{ curve: Curve, error: number }} Reduced
 */

/**
 * One Bézier curve of degree 1 to 64, in the plane or in space.
 *
 * B(t) = Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ for t from 0 to 1; other values extrapolate. The end points are returned exactly.
 * Curves are immutable: every change returns a new one. They need not be freed.
 *
 *     const curve = new Curve([[0, 0], [1, 2], [2, 0]]);
 *     curve.eval(0.5); // { x: 1, y: 1 }
 */
export class Curve {
  /** @type {Float64Array} */
  #flat;
  /** @type {2 | 3} */
  #dimension;

  /**
   * @param {PointsLike} points the control points P₀ … Pₙ, 2 to 65 of them; a flat array is 2D unless `dimension` is 3
   * @param {{ dimension?: 2 | 3 }} [options]
   * @throws {RangeError} for a wrong count, a NaN or an infinity
   * @throws {TypeError} for a value that is not a point
   */
  constructor(points, options) {
    const checked = /** @type {unknown} */ (points);
    if (checked instanceof CheckedPoints) {
      this.#flat = checked.flat;
      this.#dimension = checked.dimension;
      return;
    }
    const { flat, dimension } = flatten(points, check.options(options).dimension, 2);
    const count = flat.length / dimension;
    if (count < 2 || count > 65) {
      throw new RangeError(`points: expected 2 to 65 control points (degree 1 to 64), got ${count}`);
    }
    this.#flat = flat;
    this.#dimension = dimension;
  }

  /**
   * The cubic of four geometry points in another basis, [t³ t² t 1]·M·G.
   *
   * @param {BasisLike} basis "hermite" (P0, P1, M0, M1), "b-spline", "catmull-rom", "bezier", or a matrix, row-major
   * @param {PointsLike} points four points
   * @param {{ dimension?: 2 | 3 }} [options]
   * @returns {Curve}
   */
  static fromBasis(basis, points, options) {
    const matrix = basisNumbers(basis);
    const { flat, dimension } = flatten(points, check.options(options).dimension, 2);
    if (flat.length !== 4 * dimension) {
      throw new RangeError(`points: expected 4 points, got ${flat.length / dimension}`);
    }
    writeArguments(flat, 16).set(matrix, flat.length);
    return readCurve(core().curve_from_basis(dimension), dimension);
  }

  /**
   * @param {{ points: PointsLike, dimension?: 2 | 3 }} json what `toJSON` returned
   * @returns {Curve}
   */
  static fromJSON(json) {
    if (typeof json !== "object" || json === null) {
      throw new TypeError(`json: expected an object with points, got ${check.describe(json)}`);
    }
    return curveFrom(json.points, { dimension: json.dimension });
  }

  /**
   * The values of the n + 1 Bernstein polynomials of a degree at t; for t in [0, 1] their sum is 1 within one ulp.
   *
   * @param {number} degree 0 to 64
   * @param {number} t
   * @returns {Float64Array}
   */
  static bernstein(degree, t) {
    check.whole(degree, "degree", 0, 64);
    return readResult(0, core().bernstein_weights(degree, check.finite(t, "t")));
  }

  /**
   * The 4×4 matrix of a basis, row-major: rows for t³, t², t and 1, columns for the geometry points.
   *
   * @param {BasisName} name
   * @returns {Float64Array} 16 numbers
   */
  static basisMatrix(name) {
    check.oneOf(name, "basis", BASES);
    return basisNumbers(name);
  }

  /** The degree n: one less than the number of control points. */
  get degree() {
    return this.#flat.length / this.#dimension - 1;
  }

  /** 2 in the plane, 3 in space. */
  get dimension() {
    return this.#dimension;
  }

  /**
   * @returns {Float64Array} a copy of the coordinates of P₀ … Pₙ
   */
  controlPoints() {
    return this.#flat.slice();
  }

  /**
   * Whether both have the same degree and each control point lies within a distance of its counterpart.
   *
   * @param {Curve} other
   * @param {number} [tolerance] by default 0: equal coordinates
   * @returns {boolean}
   */
  equals(other, tolerance = 0) {
    const o = asCurve(other);
    return this.#dimension === o.#dimension && samePoints(this.#flat, o.#flat, this.#dimension, tolerance);
  }

  /**
   * The point at t.
   *
   * @param {number} t
   * @returns {Point}
   */
  eval(t) {
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    const flat = this.#flat;
    if (flat.length === 4 * this.#dimension) return cubicAt(flat, t);
    core().curve_eval(this.#dimension, this.#write(), t);
    return this.#readPoint();
  }

  /**
   * `segments` + 1 points at t = i / segments.
   *
   * @param {number} segments
   * @param {{ into?: Float64Array }} [options] `into`: at least (segments + 1) · dimension numbers long
   * @returns {Float64Array}
   */
  sample(segments, options) {
    check.segmentCount(segments);
    const { into } = check.options(options);
    const length = (segments + 1) * this.#dimension;
    if (into !== undefined) check.resultArray(into, length);
    const count = core().curve_sample(this.#dimension, this.#write(), segments);
    if (into !== undefined) return readResultInto(into, count);
    return readLargeResult(count);
  }

  /**
   * The points at the given parameters.
   *
   * @param {ArrayLike<number>} ts
   * @param {{ into?: Float64Array }} [options] `into`: at least ts.length · dimension numbers long
   * @returns {Float64Array}
   */
  evalAt(ts, options) {
    const parameters = check.numbers(ts, "ts");
    const length = parameters.length * this.#dimension;
    const into = check.resultArray(check.options(options).into, length);
    const count = this.#write(parameters);
    core().curve_eval_at(this.#dimension, count, parameters.length);
    return readResultInto(into, length);
  }

  /**
   * The derivative as a curve of degree n − 1; the derivative of a line is a line whose two points are equal.
   *
   * @returns {Curve}
   */
  derivative() {
    return this.#read(core().curve_derivative(this.#dimension, this.#write()));
  }

  /**
   * The k-th derivative at t; zero if k is greater than the degree.
   *
   * @param {number} t
   * @param {number} [k]
   * @returns {Point}
   */
  derivativeAt(t, k = 1) {
    check.finite(t, "t");
    check.whole(k, "k", 0, 0xffffffff);
    core().curve_derivative_at(this.#dimension, this.#write(), t, k);
    return this.#readPoint();
  }

  /**
   * The unit tangent at t. Where the derivative vanishes (handles of length 0, cusps) it is the limit; if all control
   * points are equal, it is zero.
   *
   * @param {number} t
   * @returns {Point}
   */
  tangent(t) {
    check.finite(t, "t");
    core().curve_tangent(this.#dimension, this.#write(), t);
    return this.#readPoint();
  }

  /**
   * The unit normal at t: in 2D the tangent turned by +90°, (x, y) → (−y, x); in 3D the principal normal, which is zero
   * where the curve is straight.
   *
   * @param {number} t
   * @returns {Point}
   */
  normal(t) {
    check.finite(t, "t");
    core().curve_normal(this.#dimension, this.#write(), t);
    return this.#readPoint();
  }

  /**
   * The curvature at t: in 2D positive when turning counter-clockwise (x right, y up), in 3D never negative. Infinite
   * at a cusp.
   *
   * @param {number} t
   * @returns {number}
   */
  curvature(t) {
    check.finite(t, "t");
    return core().curve_curvature(this.#dimension, this.#write(), t);
  }

  /**
   * The torsion (B′ × B″)·B‴ / |B′ × B″|² at t: the angle per length by which the osculating plane turns about the
   * tangent, positive for a right-handed helix. It is 0 in 2D and for planar curves. Where B′ × B″ vanishes, it is the
   * limit, which may be infinite.
   *
   * @param {number} t
   * @returns {number}
   */
  torsion(t) {
    check.finite(t, "t");
    return this.#dimension === 2 ? 0 : core().curve_torsion(this.#write(), t);
  }

  /**
   * Rotation-minimising frames: the normals do not rotate about the tangents (error below 10⁻⁹), also at inflections,
   * straight pieces and cusps. 3D only.
   *
   *     const { points, tangents, normals } = path.frames(path.equidistantTimes(100), { normal: [0, 0, 1] }); // a camera path
   *
   * The steps between frames are halved at most 4096 + 64 n times in total for n frames.
   *
   * @param {number | ArrayLike<number>} where the number of segments n for frames at t = i/n, or values of t
   * @param {FrameOptions} [options]
   * @returns {Frames}
   */
  frames(where, options) {
    if (this.#dimension === 2) throw new TypeError("frames: expected a 3D curve, got a 2D one");
    const ts = frameTimes(where, 1);
    const args = frameArguments(ts, options);
    const count = this.#write(args);
    return readFrames(unwrapCount(core().curve_frames(count, ts.length, args.length > ts.length)));
  }

  /**
   * The arc length ∫ |B′(t)| dt with a relative error below 10⁻¹², also for cusps and curves that turn back.
   *
   * At most 4096 intervals are integrated, more than ten times as many as coordinates of moderate size need.
   *
   * @param {number} [tolerance] the largest error, in the unit of the points, if it is to be smaller
   * @returns {number} 0 if all control points are equal
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  length(tolerance) {
    return curveLength(this.#flat, this.#dimension, tolerance);
  }

  /**
   * The t at which the arc length from the start is s. An s outside of [0, length] gives the nearer end.
   *
   * @param {number} s
   * @param {number} [tolerance] the largest error, as a length; by default 10⁻¹² of the curve's length
   * @returns {number} 0 to 1
   */
  timeAtLength(s, tolerance) {
    return curveTimeAtLength(this.#flat, this.#dimension, s, tolerance);
  }

  /**
   * The values of t that divide the curve into arcs of equal length.
   *
   *     curve.evalAt(curve.equidistantTimes(100)); // 101 points, evenly spaced along the curve
   *
   * @param {number} segments
   * @returns {Float64Array} `segments` + 1 values, the first 0, the last 1
   */
  equidistantTimes(segments) {
    check.segmentCount(segments);
    return readLargeResult(core().curve_equidistant_times(this.#dimension, this.#write(), segments));
  }

  /**
   * The signed area ½ ∫ (x dy − y dx) swept by the line from the origin to the point of the curve, positive while that
   * line turns counter-clockwise (x right, y up). The areas of the segments of an outline add up to its area. 2D only.
   *
   * @returns {number}
   */
  area() {
    this.#require2D("area");
    return core().curve_area(this.#write());
  }

  /**
   * Splits the curve at t into two.
   *
   * @param {number} t
   * @returns {[Curve, Curve]}
   */
  split(t) {
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    core().curve_split(this.#dimension, this.#write(), t);
    return this.#readPair();
  }

  /**
   * Splits the curve at t = ½ into two.
   *
   * @returns {[Curve, Curve]}
   */
  halve() {
    return this.split(0.5);
  }

  /**
   * The part from t0 to t1, reversed if t0 > t1.
   *
   * @param {number} t0
   * @param {number} t1
   * @returns {Curve}
   */
  subsegment(t0, t1) {
    check.finite(t0, "t0");
    check.finite(t1, "t1");
    core().curve_subsegment(this.#dimension, this.#write(), t0, t1);
    return this.#read(this.#flat.length);
  }

  /**
   * The same curve with the opposite direction.
   *
   * @returns {Curve}
   */
  reverse() {
    const d = this.#dimension;
    const flat = new Float64Array(this.#flat.length);
    for (let i = 0; i < flat.length; i += d) flat.set(this.#flat.subarray(i, i + d), flat.length - d - i);
    return curveOf(flat, d);
  }

  /**
   * The same curve with the degree raised by one.
   *
   * @returns {Curve}
   * @throws {RangeError} at degree 64
   */
  elevate() {
    return this.#read(core().curve_elevate(this.#dimension, this.#write()));
  }

  /**
   * The curve transformed by an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Curve}
   */
  transform(matrix) {
    core().points_transform(this.#dimension, this.#write(check.affine(matrix)));
    return this.#read(this.#flat.length);
  }

  /**
   * All levels of de Casteljau's algorithm at t: the first level is the control points, the last is the point of the
   * curve.
   *
   * @param {number} t
   * @returns {Float64Array[]}
   */
  deCasteljau(t) {
    check.finite(t, "t");
    core().curve_de_casteljau(this.#dimension, this.#write(), t);
    const levels = [];
    for (let length = this.#flat.length, from = 0; length > 0; length -= this.#dimension) {
      levels.push(readResult(from, from + length));
      from += length;
    }
    return levels;
  }

  /**
   * The four geometry points that give this curve (of degree at most 3) in another basis.
   *
   * @param {BasisLike} basis
   * @returns {Float64Array}
   */
  toBasis(basis) {
    const matrix = basisNumbers(basis);
    return readResult(0, core().curve_to_basis(this.#dimension, this.#write(matrix)));
  }

  /**
   * A polyline whose distance from the curve is nowhere greater than `tolerance`.
   *
   * @param {number} tolerance in the unit of the points
   * @returns {{ points: Float64Array, ts: Float64Array }} the vertices and their parameters
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  flatten(tolerance) {
    check.positive(tolerance, "tolerance");
    const vertices = core().curve_flatten(this.#dimension, this.#write(), tolerance);
    return readPolyline(vertices, this.#dimension);
  }

  /**
   * The tree of recursive halving until D1 − D2 < tolerance, where D1 is the length of the control polygon and D2 the
   * length of the chord. For teaching: D1 − D2 is not a bound on the distance, but `deviationBound` is.
   *
   * @param {number} tolerance
   * @returns {Subdivision}
   */
  subdivide(tolerance) {
    check.positive(tolerance, "tolerance");
    const used = core().curve_subdivide(this.#dimension, this.#write(), tolerance);
    return readTree(readResult(0, used), this.#flat.length, (flat) => curveOf(flat, this.#dimension));
  }

  /**
   * The smallest box that contains the curve.
   *
   * @returns {{ min: Point, max: Point }}
   */
  bounds() {
    return this.#box(true);
  }

  /**
   * The box of the control points, which contains the curve.
   *
   * @returns {{ min: Point, max: Point }}
   */
  controlBounds() {
    return this.#box(false);
  }

  /**
   * The corners of the convex hull of the control points, counter-clockwise (x right, y up); 2D only.
   *
   * @returns {Float64Array}
   */
  hull() {
    this.#require2D("hull");
    return readResult(0, core().curve_hull(this.#write()));
  }

  /**
   * All intersections with another curve or with a spline (then u is the spline's t), sorted by t, then by u.
   *
   * End points count. At a "tangent" intersection both have the same or opposite directions; an "overlap" is a shared
   * part. 2D only.
   *
   * At most 4096 pairs of pieces are compared, and 256 more for each degree above 3. Only curves that are equal but for
   * rounding along a long part need more; then each pair that is still undecided gives at most one intersection.
   *
   * Curves intersect where their distance is below rounding: about 2ε (L + (n + 1) S), with ε = 2.2e-16, the largest
   * coordinate L, the size S of the box around both curves and the higher degree n; up to four times this where they run
   * along each other. The distance of each curve at its parameter from `point` is at most 64 (n + 2) ulps of L.
   *
   * @param {Curve | Spline} other
   * @returns {Intersection[]}
   * @throws {TypeError} for a 3D curve
   */
  intersections(other) {
    this.#require2D("intersections");
    if (typeof other !== "object" || other === null || !(#flat in other)) {
      return intersectSplines(this[SPLINE_DATA](), splineDataOf(other));
    }
    other.#require2D("intersections");
    const [a, b] = [this.#flat, other.#flat];
    const view = writeArguments(a, b.length);
    for (let i = 0; i < b.length; i++) view[a.length + i] = b[i];
    return readIntersections(core().curve_intersect(a.length / 2, b.length / 2));
  }

  /**
   * The points that the curve passes twice, sorted by t; t < u. If the end equals the start, that point is one of them.
   * Parts that the curve retraces (a straight curve that turns back) are not reported. 2D only.
   *
   * @returns {SelfIntersection[]}
   */
  selfIntersections() {
    this.#require2D("selfIntersections");
    return readSelfIntersections(core().curve_self_intersections(this.#write()));
  }

  /**
   * @internal
   * @returns {SplineData}
   */
  [SPLINE_DATA]() {
    this.#require2D("intersections");
    return { flat: this.#flat, dimension: this.#dimension, degrees: [this.degree], closed: false };
  }

  /**
   * The point of the curve that is nearest to p: the global minimum of the distance for t in [0, 1], found by isolating
   * the roots of (B(t) − p)·B′(t). Of several nearest points, it is the one with the smallest t.
   *
   * At most 256 pieces are examined up to degree 3, and 64 + 16 n at a higher degree n. Only distances that are
   * constant but for rounding need more.
   *
   * @param {PointLike} p
   * @returns {Nearest}
   */
  nearest(p) {
    return queries.nearest(this.#flat, this.#dimension, p);
  }

  /**
   * The parameters inside (0, 1) where a coordinate has a local extremum (its derivative changes sign), sorted.
   *
   * @returns {Extrema}
   */
  extrema() {
    return queries.extrema(this.#flat, this.#dimension);
  }

  /**
   * All parameters in [0, 1] at which a coordinate has the given value, end points and tangencies included, sorted. If
   * the coordinate has that value everywhere: 0 and 1, the ends of the range.
   *
   * @param {{ x: number } | { y: number } | { z: number }} where
   * @returns {Float64Array}
   */
  timesAtCoordinate(where) {
    return queries.timesAtCoordinate(this.#flat, this.#dimension, where);
  }

  /**
   * The curve of degree n − 1 with the same end points whose largest distance from this one at equal t is smallest, and
   * that distance. A line is returned unchanged with error 0.
   *
   * @returns {Reduced}
   */
  reduce() {
    const used = core().curve_reduce(this.#dimension, this.#write());
    return { curve: curveOf(readResult(1, used), this.#dimension), error: readResult(0, 1)[0] };
  }

  /**
   * The curve of degree n − 1 through n points, 2 to 65. With more than about ten points and equally spaced parameters
   * it oscillates between the points; `Spline.interpolate` does not.
   *
   * @param {PointsLike} points
   * @param {ArrayLike<number>} [ts] the parameter of each point; by default proportional to the lengths of the chords,
   *   from 0 to 1 (equally spaced if two neighbouring points are equal)
   * @param {{ dimension?: 2 | 3 }} [options]
   * @returns {Curve}
   * @throws {RangeError} for equal parameters
   */
  static interpolate(points, ts, options) {
    const { flat, dimension } = flatten(points, check.options(options).dimension, 2);
    const count = flat.length / dimension;
    if (count < 2 || count > 65) throw new RangeError(`points: expected 2 to 65 points, got ${count}`);
    const parameters = ts === undefined ? new Float64Array() : check.numbers(ts, "ts");
    if (ts !== undefined && parameters.length !== count) {
      throw new RangeError(`ts: expected ${count} numbers, one for each point, got ${parameters.length}`);
    }
    writeArguments(flat, parameters.length).set(parameters, flat.length);
    return readCurve(core().curve_interpolate(dimension, count, parameters.length), dimension);
  }

  /**
   * The offset curve at a distance along the normal (the tangent turned by +90°; negative: on the other side), as a
   * spline of lines and cubics. 2D only.
   *
   * Nothing is trimmed: where the radius of curvature is smaller than the distance, the offset curve has cusps. Where
   * the curve turns back, a half circle joins the two sides. If all control points are equal, the curve is returned
   * unchanged.
   *
   * @param {number} distance
   * @param {{ tolerance?: number }} [options] `tolerance`: the largest distance between the spline and the exact offset
   *   curve, by default 1e-4 of the diagonal of the control points' box, at least 1e-12 of the largest coordinate plus
   *   the distance
   * @returns {Spline}
   * @throws {RangeError} for a tolerance below 4 ulps of the largest coordinate and the distance, and if more than
   *   2¹⁷ steps (pieces tried and bounds evaluated) would be needed
   */
  offset(distance, options) {
    this.#require2D("offset");
    check.finite(distance, "distance");
    const tolerance = check.optionalTolerance(check.options(options).tolerance);
    return readSpline(core().curve_offset(this.#write(), distance, tolerance), 2);
  }

  /**
   * The parameters inside (0, 1) where the curvature changes sign, sorted; 2D only.
   *
   * @returns {Float64Array}
   */
  inflections() {
    this.#require2D("inflections");
    return readResult(0, core().curve_inflections(this.#write()));
  }

  /**
   * The parameters inside (0, 1) of cusps, where the tangent reverses its direction, sorted.
   *
   * @returns {Float64Array}
   */
  cusps() {
    return readResult(0, core().curve_cusps(this.#dimension, this.#write()));
  }

  /**
   * The kind of curve for t from 0 to 1, independent of its size. A planar 3D curve is classified in its plane; a 3D
   * curve that is not planar is "twisted".
   *
   * @returns {CurveKind}
   */
  classify() {
    return queries.CURVE_KINDS[core().curve_classify(this.#dimension, this.#write())];
  }

  /**
   * All parameters in [0, 1] at which the tangent line passes through p, sorted; 2D only. If all tangents do, because
   * the curve is straight: 0 and 1, the ends of the range. Where the derivative almost vanishes (below 1e-7 of the
   * largest control vector of the derivative), the limit of the tangent must pass through p within 1e-7 of the curve's
   * size.
   *
   * @param {PointLike} p
   * @returns {Float64Array}
   */
  tangentsFrom(p) {
    this.#require2D("tangentsFrom");
    return queries.tangentsFrom(this.#flat, p);
  }

  /**
   * The smallest distance between this curve and another one (0 if they intersect), and the parameters at which it
   * occurs: the global minimum for t and u in [0, 1]. If it occurs several times, any one of them is returned.
   *
   * After 1536 pairs of pieces, or 16384 steps of all kinds, the smallest distance found so far is returned.
   *
   * @param {Curve} curve of the same dimension
   * @returns {Distance}
   */
  distanceTo(curve) {
    return queries.distance(this.#flat, this.#flatOfSameDimension(curve), this.#dimension);
  }

  /**
   * The Hausdorff distance of two curves: the largest distance of a point of either curve from the other curve. It is 0
   * if both are the same set of points. The relative error is below 1e-9.
   *
   * After 600 nearest points or 6000 pieces in one direction, the largest distance found so far is returned.
   *
   * @param {Curve} curve of the same dimension
   * @returns {number}
   */
  hausdorff(curve) {
    return queries.hausdorff(this.#flat, this.#flatOfSameDimension(curve), this.#dimension);
  }

  /**
   * Draws the curve on a canvas context or a Path2D: `moveTo` its start, then the curve. 2D only.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
   * @param {{ tolerance?: number }} [options] `tolerance`: for degrees above 3, which are drawn as cubics
   */
  trace(target, options) {
    this.#require2D("trace");
    traceOn(packedSpline(this.#flat, [this.degree], false), target, options);
  }

  /**
   * The curve as SVG path data, see `Path.toSVG`; 2D only.
   *
   * @param {SvgOptions} [options]
   * @returns {string}
   */
  toSVG(options) {
    this.#require2D("toSVG");
    return svgOf(packedSpline(this.#flat, [this.degree], false), options);
  }

  /**
   * @returns {{ points: number[][] }}
   */
  toJSON() {
    return { points: nested(this.#flat, this.#dimension) };
  }

  /**
   * Writes the control points, and then further numbers, to the arena.
   *
   * @param {ArrayLike<number>} [further]
   * @returns {number} the number of points
   */
  #write(further) {
    const view = writeArguments(this.#flat, further?.length);
    if (further) view.set(further, this.#flat.length);
    return this.#flat.length / this.#dimension;
  }

  /** @param {number} length */
  #read(length) {
    return readCurve(length, this.#dimension);
  }

  /** @returns {[Curve, Curve]} */
  #readPair() {
    const n = this.#flat.length;
    return [curveOf(readResult(0, n), this.#dimension), curveOf(readResult(n, 2 * n), this.#dimension)];
  }

  #readPoint() {
    return pointAt(readResult(0, 3), 0, this.#dimension);
  }

  /** @param {boolean} exact */
  #box(exact) {
    core().curve_bounds(this.#dimension, this.#write(), exact);
    return boxAt(readResult(0, 6), this.#dimension);
  }

  /**
   * The coordinates of a curve that must have the same dimension.
   *
   * @param {unknown} curve
   */
  #flatOfSameDimension(curve) {
    const other = asCurve(curve, "curve");
    if (other.#dimension === this.#dimension) return other.#flat;
    throw new TypeError(`curve: expected a ${this.#dimension}D curve, got a ${other.#dimension}D one`);
  }

  /** @param {string} method */
  #require2D(method) {
    if (this.#dimension === 3) throw new TypeError(`${method}: expected a 2D curve, got a 3D one`);
  }
}

/**
 * The point of a cubic, the most common kind of curve. Passing its coordinates as arguments takes a quarter of the time
 * of passing them through the arena.
 *
 * @param {Float64Array} p
 * @param {number} t
 * @returns {Point}
 */
function cubicAt(p, t) {
  const at = cubicEval();
  if (p.length === 8) return { x: at(p[0], p[2], p[4], p[6], t), y: at(p[1], p[3], p[5], p[7], t) };
  return { x: at(p[0], p[3], p[6], p[9], t), y: at(p[1], p[4], p[7], p[10], t), z: at(p[2], p[5], p[8], p[11], t) };
}

// Code that uses the class by its name is outside of the class: bundlers rename a class that refers to itself (to
// _Curve).

/**
 * @param {PointsLike} points
 * @param {{ dimension?: 2 | 3 }} options
 */
function curveFrom(points, options) {
  return new Curve(points, options);
}

/**
 * @param {unknown} other
 * @param {string} [name]
 */
function asCurve(other, name = "other") {
  return check.instanceOf(other, name, Curve);
}

/**
 * @param {Float64Array} flat
 * @param {2 | 3} dimension
 */
function curveOf(flat, dimension) {
  return new Curve(/** @type {any} */ (new CheckedPoints(flat, dimension)));
}

/**
 * Reads the control points of a curve from the arena.
 *
 * @param {number} length
 * @param {2 | 3} dimension
 */
function readCurve(length, dimension) {
  return curveOf(readResult(0, length), dimension);
}

/** @param {number} length */
function readLargeResult(length) {
  const result = readResult(0, length);
  releaseMemory();
  return result;
}

/**
 * Reads a polyline from the arena.
 *
 * @internal
 * @param {number} vertices
 * @param {2 | 3} dimension
 * @returns {{ points: Float64Array, ts: Float64Array }}
 */
export function readPolyline(vertices, dimension) {
  const end = vertices * dimension;
  const polyline = { points: readResult(0, end), ts: readResult(end, end + vertices) };
  releaseMemory();
  return polyline;
}
