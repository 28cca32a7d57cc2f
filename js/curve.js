import * as check from "./check.js";
import { core, cubicEval } from "./init.js";
import { CHAIN, chainOf, meetChains, takeIntersections, takeSelfIntersections } from "./meetings.js";
import * as places from "./places.js";
import { boxAt, flatten, nested, pointAt, samePoints } from "./points.js";
import { packedSpline } from "./path-packed.js";
import { done } from "./refusal.js";
import { svgOf, traceOn } from "./svg-write.js";
import { Checked, load, take, takeInto, trim } from "./transfer.js";
import { curveLength, curveTimeAtLength } from "./measure.js";
import { basisNumbers, BASES } from "./basis.js";
import { frameTimes, frameWishes, takeFrames } from "./frames.js";
import { readTree } from "./subdivision.js";
import { takeSpline } from "./spline.js";

/**
 * @import { Chain, Intersection, SelfIntersection } from "./meetings.js"
 * @import { MatrixLike, PointLike, PointsLike } from "./check.js"
 * @import { CurveKind, Distance, Extrema, Nearest } from "./places.js"
 * @import { Point } from "./points.js"
 * @import { BasisLike, BasisName } from "./basis.js"
 * @import { Spline } from "./spline.js"
 * @import { FrameOptions, Frames } from "./frames.js"
 * @import { Subdivision } from "./subdivision.js"
 * @import { SvgOptions } from "./svg-write.js"
 */

/**
 * A curve of a lower degree, and its greatest distance at equal t.
 *
 * @typedef {{ curve: Curve, error: number }} Reduced
 */

/**
 * One Bézier curve of degree 1 to 64, in the plane or in space.
 *
 * B(t) = Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ; t runs from 0 to 1, values outside extrapolate. The end points come back exactly.
 * A curve is a value: every change returns a new one, and nothing has to be freed.
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
   * @throws {TypeError} for a value that is no point
   */
  constructor(points, options) {
    const checked = /** @type {unknown} */ (points);
    if (checked instanceof Checked) {
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
    load(flat, 16).set(matrix, flat.length);
    return made(core().curve_from_basis(dimension), dimension);
  }

  /**
   * @param {{ points: PointsLike, dimension?: 2 | 3 }} json what `toJSON` gave
   * @returns {Curve}
   */
  static fromJSON(json) {
    if (typeof json !== "object" || json === null) {
      throw new TypeError(`json: expected an object with points, got ${check.shown(json)}`);
    }
    return curveFrom(json.points, { dimension: json.dimension });
  }

  /**
   * The n + 1 Bernstein weights of a degree at t; for t in [0, 1] they sum to 1 within one ulp.
   *
   * @param {number} degree 0 to 64
   * @param {number} t
   * @returns {Float64Array}
   */
  static bernstein(degree, t) {
    check.whole(degree, "degree", 0, 64);
    return take(0, core().bernstein_weights(degree, check.finite(t, "t")));
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
   * @returns {Float64Array} the coordinates of P₀ … Pₙ, a copy
   */
  controlPoints() {
    return this.#flat.slice();
  }

  /**
   * Whether both have the same degree and each control point lies within a distance of its counterpart.
   *
   * @param {Curve} other
   * @param {number} [tolerance] 0 for equal numbers
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
    core().curve_eval(this.#dimension, this.#load(), t);
    return this.#point();
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
    const given = check.options(options).into;
    const length = (segments + 1) * this.#dimension;
    if (given !== undefined) check.resultArray(given, length);
    const used = core().curve_sample(this.#dimension, this.#load(), segments);
    if (given !== undefined) return takeInto(given, used);
    return largeTake(used);
  }

  /**
   * The points at some parameters.
   *
   * @param {ArrayLike<number>} ts
   * @param {{ into?: Float64Array }} [options] `into`: at least ts.length · dimension numbers long
   * @returns {Float64Array}
   */
  evalAt(ts, options) {
    const parameters = check.numbers(ts, "ts");
    const length = parameters.length * this.#dimension;
    const into = check.resultArray(check.options(options).into, length);
    const count = this.#load(parameters);
    core().curve_eval_at(this.#dimension, count, parameters.length);
    return takeInto(into, length);
  }

  /**
   * The derivative as a curve of degree n − 1; of a line a constant line.
   *
   * @returns {Curve}
   */
  derivative() {
    return this.#made(core().curve_derivative(this.#dimension, this.#load()));
  }

  /**
   * The k-th derivative at t; zero beyond the degree.
   *
   * @param {number} t
   * @param {number} [k]
   * @returns {Point}
   */
  derivativeAt(t, k = 1) {
    check.finite(t, "t");
    check.whole(k, "k", 0, 0xffffffff);
    core().curve_derivative_at(this.#dimension, this.#load(), t, k);
    return this.#point();
  }

  /**
   * The unit tangent at t; at zero-length handles and cusps its limit, of a point zero.
   *
   * @param {number} t
   * @returns {Point}
   */
  tangent(t) {
    check.finite(t, "t");
    core().curve_tangent(this.#dimension, this.#load(), t);
    return this.#point();
  }

  /**
   * The unit normal at t: in 2D the tangent turned by +90°, (x, y) → (−y, x); in 3D the principal normal, zero where the
   * curve is straight.
   *
   * @param {number} t
   * @returns {Point}
   */
  normal(t) {
    check.finite(t, "t");
    core().curve_normal(this.#dimension, this.#load(), t);
    return this.#point();
  }

  /**
   * The curvature at t: in 2D positive when turning counter-clockwise (x right, y up), in 3D never negative. Infinite at
   * a cusp.
   *
   * @param {number} t
   * @returns {number}
   */
  curvature(t) {
    check.finite(t, "t");
    return core().curve_curvature(this.#dimension, this.#load(), t);
  }

  /**
   * The torsion (B′ × B″)·B‴ / |B′ × B″|² at t: how fast, by length, the plane of the bend turns about the tangent;
   * positive like a right-handed screw. 0 in 2D, and where a 3D curve stays in a plane; else where B′ × B″ vanishes its
   * limit, which may be infinite.
   *
   * @param {number} t
   * @returns {number}
   */
  torsion(t) {
    check.finite(t, "t");
    return this.#dimension === 2 ? 0 : core().curve_torsion(this.#load(), t);
  }

  /**
   * Rotation-minimising frames: the normals do not turn about the tangents, to 10⁻⁹, also through inflections, straight
   * pieces and cusps. 3D only.
   *
   *     const { points, tangents, normals } = path.frames(path.equidistantTimes(100), { normal: [0, 0, 1] }); // a camera's flight
   *
   * Frames are continued from t = 0; the frame at a t does not depend on the other ones. Steps are halved at most 4096
   * times, and 63 times more for each frame (512 times outside 0 to 1).
   *
   * @param {number | ArrayLike<number>} where a number of segments, for frames at t = i / segments, or values of t
   * @param {FrameOptions} [options]
   * @returns {Frames}
   */
  frames(where, options) {
    if (this.#dimension === 2) throw new TypeError("frames: expected a 3D curve, got a 2D one");
    const ts = frameTimes(where, 1);
    const wishes = frameWishes(ts, options);
    const count = this.#load(wishes);
    return takeFrames(done(core().curve_frames(count, ts.length, wishes.length > ts.length)));
  }

  /**
   * The length ∫ |B′(t)| dt, right to 10⁻¹² of itself, at cusps and turn-backs too.
   *
   * At most 4096 intervals are examined, more than ten times what coordinates of moderate size need.
   *
   * @param {number} [tolerance] the greatest error, in the unit of the points, where it asks for more than that
   * @returns {number} 0 for a point
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  length(tolerance) {
    return curveLength(this.#flat, this.#dimension, tolerance);
  }

  /**
   * The t at which the curve has the length s behind it; for an s outside of 0 to the whole length the nearer end.
   *
   * @param {number} s
   * @param {number} [tolerance] the greatest error, as a length; by default 10⁻¹² of the whole
   * @returns {number} 0 to 1
   */
  timeAtLength(s, tolerance) {
    return curveTimeAtLength(this.#flat, this.#dimension, s, tolerance);
  }

  /**
   * The values of t that divide the curve into arcs of one length.
   *
   *     curve.evalAt(curve.equidistantTimes(100)); // 101 points, evenly spaced along the curve
   *
   * @param {number} segments
   * @returns {Float64Array} `segments` + 1 values, the first 0, the last 1
   */
  equidistantTimes(segments) {
    check.segmentCount(segments);
    return largeTake(core().curve_equidistant_times(this.#dimension, this.#load(), segments));
  }

  /**
   * The signed area ½ ∫ (x dy − y dx) that the segment from the origin to the curve's point sweeps, positive while it
   * turns counter-clockwise (x right, y up). Areas of curves that follow each other add up. 2D only.
   *
   * @returns {number}
   */
  area() {
    this.#plane("area");
    return core().curve_area(this.#load());
  }

  /**
   * The pieces before and after t.
   *
   * @param {number} t
   * @returns {[Curve, Curve]}
   */
  split(t) {
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    core().curve_split(this.#dimension, this.#load(), t);
    return this.#two();
  }

  /**
   * The pieces before and after t = ½.
   *
   * @returns {[Curve, Curve]}
   */
  halve() {
    return this.split(0.5);
  }

  /**
   * The piece from t0 to t1; backwards if t0 > t1.
   *
   * @param {number} t0
   * @param {number} t1
   * @returns {Curve}
   */
  subsegment(t0, t1) {
    check.finite(t0, "t0");
    check.finite(t1, "t1");
    core().curve_subsegment(this.#dimension, this.#load(), t0, t1);
    return this.#made(this.#flat.length);
  }

  /**
   * The same curve run through backwards.
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
   * The same curve with one more control point.
   *
   * @returns {Curve}
   * @throws {RangeError} at degree 64
   */
  elevate() {
    return this.#made(core().curve_elevate(this.#dimension, this.#load()));
  }

  /**
   * The image under an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Curve}
   */
  transform(matrix) {
    core().points_transform(this.#dimension, this.#load(check.affine(matrix)));
    return this.#made(this.#flat.length);
  }

  /**
   * All levels of de Casteljau's triangle at t: first the control points, last the point of the curve.
   *
   * @param {number} t
   * @returns {Float64Array[]}
   */
  deCasteljau(t) {
    check.finite(t, "t");
    core().curve_de_casteljau(this.#dimension, this.#load(), t);
    const levels = [];
    for (let length = this.#flat.length, from = 0; length > 0; length -= this.#dimension) {
      levels.push(take(from, from + length));
      from += length;
    }
    return levels;
  }

  /**
   * The four geometry points of this curve (degree at most 3) in another basis.
   *
   * @param {BasisLike} basis
   * @returns {Float64Array}
   */
  toBasis(basis) {
    const matrix = basisNumbers(basis);
    return take(0, core().curve_to_basis(this.#dimension, this.#load(matrix)));
  }

  /**
   * A polyline from which the curve is nowhere farther than `tolerance`.
   *
   * @param {number} tolerance in the unit of the points
   * @returns {{ points: Float64Array, ts: Float64Array }} vertices and their parameters
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  flatten(tolerance) {
    check.positive(tolerance, "tolerance");
    const vertices = core().curve_flatten(this.#dimension, this.#load(), tolerance);
    return takePolyline(vertices, this.#dimension);
  }

  /**
   * The tree of recursive halving until D1 − D2 < tolerance, D1 the length of the control polygon and D2 that of the
   * chord. For teaching: D1 − D2 is no distance, `deviationBound` is.
   *
   * @param {number} tolerance
   * @returns {Subdivision}
   */
  subdivide(tolerance) {
    check.positive(tolerance, "tolerance");
    const used = core().curve_subdivide(this.#dimension, this.#load(), tolerance);
    return readTree(take(0, used), this.#flat.length, (flat) => curveOf(flat, this.#dimension));
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
    this.#plane("hull");
    return take(0, core().curve_hull(this.#load()));
  }

  /**
   * All places that this curve shares with another curve or a spline (then u is the spline's t), sorted by t, then by u.
   *
   * Ends count. "tangent" says that both have the same or the opposite direction there, "overlap" is a shared piece. 2D only.
   *
   * At most 4096 pairs of pieces are compared, and 256 more for each degree above 3. Only curves that rounding makes hard
   * to tell apart on long stretches need more; each pair of pieces that is undecided then counts as one place at most.
   *
   * Both curves have the point at their parameters but for rounding: 64 (n + 2) ulps of the largest coordinate, n being the
   * higher degree.
   *
   * @param {Curve | Spline} other
   * @returns {Intersection[]}
   * @throws {TypeError} for a curve of space
   */
  intersections(other) {
    this.#plane("intersections");
    if (typeof other !== "object" || other === null || !(#flat in other)) {
      return meetChains(this[CHAIN](), chainOf(other));
    }
    other.#plane("intersections");
    const [mine, its] = [this.#flat, other.#flat];
    const view = load(mine, its.length);
    for (let i = 0; i < its.length; i++) view[mine.length + i] = its[i];
    return takeIntersections(core().curve_intersect(mine.length / 2, its.length / 2));
  }

  /**
   * The points that the curve passes twice, sorted by t; t < u. A closed curve passes its start again. Pieces that are run
   * through again (a straight curve that turns back) are left out. 2D only.
   *
   * @returns {SelfIntersection[]}
   */
  selfIntersections() {
    this.#plane("selfIntersections");
    return takeSelfIntersections(core().curve_self_intersections(this.#load()));
  }

  /**
   * @internal
   * @returns {Chain}
   */
  [CHAIN]() {
    this.#plane("intersections");
    return { flat: this.#flat, dimension: this.#dimension, degrees: [this.degree], closed: false };
  }

  /**
   * The point of the curve that is nearest to p: the least distance of all for t in [0, 1], found by isolating the roots
   * of (B(t) − p)·B′(t). Of equally near points the one with the smallest t.
   *
   * Up to degree 3 at most 256 pieces are examined, above 64 + 16 n; only distances that are constant but for rounding
   * need more.
   *
   * @param {PointLike} p
   * @returns {Nearest}
   */
  nearest(p) {
    return places.nearest(this.#flat, this.#dimension, p);
  }

  /**
   * The parameters inside (0, 1) where a coordinate has a local extremum: where its derivative changes sign. Sorted.
   *
   * @returns {Extrema}
   */
  extrema() {
    return places.extrema(this.#flat, this.#dimension);
  }

  /**
   * All parameters in [0, 1] where a coordinate has a value, ends and touches included, sorted. Of a coordinate that has
   * the value everywhere: 0 and 1, the ends of the range.
   *
   * @param {{ x: number } | { y: number } | { z: number }} where
   * @returns {Float64Array}
   */
  timesAtCoordinate(where) {
    return places.timesAtCoordinate(this.#flat, this.#dimension, where);
  }

  /**
   * The closest curve of degree n − 1 with the same ends, and the greatest distance between both at equal t: no such curve
   * has a smaller one. A line comes back with the error 0.
   *
   * @returns {Reduced}
   */
  reduce() {
    const used = core().curve_reduce(this.#dimension, this.#load());
    return { curve: curveOf(take(1, used), this.#dimension), error: take(0, 1)[0] };
  }

  /**
   * The curve of degree n − 1 that passes n points, 2 to 65. Above ten or so, even parameters make it swing out between
   * the points; `Spline.interpolate` does not.
   *
   * @param {PointsLike} points
   * @param {ArrayLike<number>} [ts] the parameter of each point; by default in proportion to the chords, from 0 to 1 (even
   *   ones where two neighbours coincide)
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
    load(flat, parameters.length).set(parameters, flat.length);
    return made(core().curve_interpolate(dimension, count, parameters.length), dimension);
  }

  /**
   * The parallel curve at a distance along the normal (the tangent turned by +90°; negative: on the other side), as a
   * spline of lines and cubics. 2D only.
   *
   * Nothing is trimmed: where the curve bends too sharply the parallel has cusps. Where the curve turns back a half circle
   * joins its two sides. A curve that is a point comes back as it is.
   *
   * @param {number} distance
   * @param {{ tolerance?: number }} [options] `tolerance`: the greatest distance between the spline and the true parallel, by
   *   default 1e-4 of the diagonal of the control points' box, at least 1e-12 of the largest coordinate plus the distance
   * @returns {Spline}
   * @throws {RangeError} for a tolerance below 4 ulps of the largest coordinate and the distance, and where more than 2¹⁷
   *   steps (pieces tried and bounds evaluated) would be needed
   */
  offset(distance, options) {
    this.#plane("offset");
    check.finite(distance, "distance");
    const tolerance = check.optionalTolerance(check.options(options).tolerance);
    return takeSpline(core().curve_offset(this.#load(), distance, tolerance), 2);
  }

  /**
   * The parameters inside (0, 1) where the curve changes the side to which it bends, sorted; 2D only.
   *
   * @returns {Float64Array}
   */
  inflections() {
    this.#plane("inflections");
    return take(0, core().curve_inflections(this.#load()));
  }

  /**
   * The parameters inside (0, 1) where the curve stops and goes back, sorted.
   *
   * @returns {Float64Array}
   */
  cusps() {
    return take(0, core().curve_cusps(this.#dimension, this.#load()));
  }

  /**
   * The kind of curve, judged by what it does for t from 0 to 1 and without regard to its size. In space a plane curve is
   * judged in its plane, and one that lies in no plane is "twisted".
   *
   * @returns {CurveKind}
   */
  classify() {
    return places.CURVE_KINDS[core().curve_classify(this.#dimension, this.#load())];
  }

  /**
   * All parameters in [0, 1] at which the tangent line passes through p, sorted; 2D only. Where every tangent does, the
   * curve being straight: 0 and 1, the ends of the range. Where the curve stops (its derivative is below 1e-7 of the largest
   * control vector of the derivative), the tangent itself must pass through p within 1e-7 of the size.
   *
   * @param {PointLike} p
   * @returns {Float64Array}
   */
  tangentsFrom(p) {
    this.#plane("tangentsFrom");
    return places.tangentsFrom(this.#flat, p);
  }

  /**
   * The least distance between the points of this curve and another one, 0 where they meet, and where it is: the least of
   * all, for t and u in [0, 1]. Of several such places any one.
   *
   * After 1536 pairs of pieces, or 16384 steps of all kinds, the least distance seen is returned.
   *
   * @param {Curve} curve of the same dimension
   * @returns {Distance}
   */
  distanceTo(curve) {
    return places.distance(this.#flat, this.#alike(curve), this.#dimension);
  }

  /**
   * The Hausdorff distance of two curves: the greatest distance that a point of either has from the other. 0 says that
   * they are the same set of points. Within 1e-9 of itself.
   *
   * After 600 nearest points or 6000 pieces in either direction, the greatest distance seen is returned.
   *
   * @param {Curve} curve of the same dimension
   * @returns {number}
   */
  hausdorff(curve) {
    return places.hausdorff(this.#flat, this.#alike(curve), this.#dimension);
  }

  /**
   * Draws the curve on a canvas context or a Path2D: `moveTo` its start, then the curve. 2D only.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
   * @param {{ tolerance?: number }} [options] for degrees above 3, which are drawn as cubics
   */
  trace(target, options) {
    this.#plane("trace");
    traceOn(packedSpline(this.#flat, [this.degree], false), target, options);
  }

  /**
   * The curve as SVG path data, see `Path.toSVG`; 2D only.
   *
   * @param {SvgOptions} [options]
   * @returns {string}
   */
  toSVG(options) {
    this.#plane("toSVG");
    return svgOf(packedSpline(this.#flat, [this.degree], false), options);
  }

  /**
   * @returns {{ points: number[][] }}
   */
  toJSON() {
    return { points: nested(this.#flat, this.#dimension) };
  }

  /**
   * Writes the control points, and numbers behind them, to the arena.
   *
   * @param {ArrayLike<number>} [behind]
   * @returns {number} the number of points
   */
  #load(behind) {
    const view = load(this.#flat, behind?.length);
    if (behind) view.set(behind, this.#flat.length);
    return this.#flat.length / this.#dimension;
  }

  /** @param {number} length */
  #made(length) {
    return made(length, this.#dimension);
  }

  /** @returns {[Curve, Curve]} */
  #two() {
    const n = this.#flat.length;
    return [curveOf(take(0, n), this.#dimension), curveOf(take(n, 2 * n), this.#dimension)];
  }

  #point() {
    return pointAt(take(0, 3), 0, this.#dimension);
  }

  /** @param {boolean} exact */
  #box(exact) {
    core().curve_bounds(this.#dimension, this.#load(), exact);
    return boxAt(take(0, 6), this.#dimension);
  }

  /**
   * The numbers of a curve of the same dimension.
   *
   * @param {unknown} curve
   */
  #alike(curve) {
    const other = asCurve(curve, "curve");
    if (other.#dimension === this.#dimension) return other.#flat;
    throw new TypeError(`curve: expected a ${this.#dimension}D curve, got a ${other.#dimension}D one`);
  }

  /** @param {string} method */
  #plane(method) {
    if (this.#dimension === 3) throw new TypeError(`${method}: expected a 2D curve, got a 3D one`);
  }
}

/**
 * The point of a cubic, the most common kind of curve: its numbers go over as arguments, in a quarter of the time that
 * the way through the arena takes.
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

// What needs the class by its name stands outside of it: a bundler renames a class that names itself (to _Curve).

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
  return new Curve(/** @type {any} */ (new Checked(flat, dimension)));
}

/**
 * The curve whose control points the core left.
 *
 * @param {number} length
 * @param {2 | 3} dimension
 */
function made(length, dimension) {
  return curveOf(take(0, length), dimension);
}

/** @param {number} length */
function largeTake(length) {
  const result = take(0, length);
  trim();
  return result;
}

/**
 * The polyline that the core left.
 *
 * @internal
 * @param {number} vertices
 * @param {2 | 3} dimension
 * @returns {{ points: Float64Array, ts: Float64Array }}
 */
export function takePolyline(vertices, dimension) {
  const end = vertices * dimension;
  const line = { points: take(0, end), ts: take(end, end + vertices) };
  trim();
  return line;
}
