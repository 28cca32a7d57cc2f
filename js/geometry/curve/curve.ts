import { fromChecked } from "../checked.js";
import { curvesModule } from "../../wasm/curves-module.js";
import * as check from "../check.js";
import * as queries from "../curve-queries.js";
import { CoreCurve, curvePointsOf } from "./core-curve.js";
import { frameTimes, frameArguments, readFrames } from "../frames.js";
import { basisNumbers, BASES, pointsInBasis } from "../basis.js";
import { curveData, typeOf } from "../brand.js";
import { intersectSplines, readIntersections, readSelfIntersections } from "../intersections.js";
import { flatten } from "../points.js";
import { readSpline } from "../spline/spline.js";
import { curveToThree } from "../../io/three.js";
import type { ControlPoints } from "../brand.js";
import type { PointLike, PointsLike } from "../check.js";
import type { CurveKind, Distance, Extrema } from "../curve-queries.js";
import type { FrameOptions, Frames } from "../frames.js";
import type { BasisLike, BasisName } from "../basis.js";
import type { CurveJSON } from "./core-curve.js";
import type { Intersection, SelfIntersection } from "../intersections.js";
import type { PointArrays } from "../points.js";
import type { PathTime } from "../path/path-queries.js";
import type { ThreeCurves } from "../../io/three.js";
import type { CorePath } from "../path/core-path.js";
import type { NurbsCurve } from "../rational/nurbs-curve.js";
import type { RationalCurve } from "../rational/rational-curve.js";
import type { CoreSpline } from "../spline/core-spline.js";
import type { Spline } from "../spline/spline.js";

/** A curve of a lower degree, and its largest distance from the original at equal t. */
export type Reduced<D extends 2 | 3 = 2 | 3> = { curve: Curve<D>; error: number };

/**
 * One Bézier curve of degree 1 to 64, in the plane or in space.
 *
 * B(t) = Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ for t from 0 to 1; other values extrapolate. The end points are returned exactly.
 * Curves are immutable: every change returns a new one. They need not be freed.
 *
 *     const curve = new Curve([[0, 0], [1, 2], [2, 0]]);
 *     curve.eval(0.5); // { x: 1, y: 1 }
 *
 * In TypeScript, `Curve<2>` and `Curve<3>` have points `{x, y}` and `{x, y, z}`. The dimension is inferred from points
 * that are arrays, and from the option `dimension`.
 */
export class Curve<D extends 2 | 3 = 2 | 3> extends CoreCurve<D> {
  /**
   * The torsion (B′ × B″)·B‴ / |B′ × B″|² at t: the angle per length by which the osculating plane turns about the
   * tangent, positive for a right-handed helix. It is 0 in 2D and for planar curves. Where B′ × B″ vanishes, it is the
   * limit, which may be infinite.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  torsion(t: number): number {
    check.finite(t, "t");
    return this.dimension === 2 ? 0 : curvesModule.functions.curve_torsion(this._write(), t);
  }

  /**
   * Rotation-minimising frames: the normals do not rotate about the tangents (error below 10⁻⁹), also at inflections,
   * straight pieces and cusps. 3D only.
   *
   *     const { points, tangents, normals } = path.frames(path.equidistantTimes(100), { normal: [0, 0, 1] }); // a camera path
   *
   * Frames are continued from t = 0; the frame at a t does not depend on the other ones. Steps are halved at most 4096
   * times, and 63 times more for each frame (512 times outside 0 to 1).
   *
   * @param where the number of segments n for frames at t = i/n, or values of t
   */
  frames(where: number | ArrayLike<number>, options?: FrameOptions): Frames {
    if (this.dimension === 2) throw new TypeError("frames: expected a 3D curve, got a 2D one");
    const ts = frameTimes(where, 1);
    const args = frameArguments(ts, options);
    const count = this._write(args);
    return readFrames(
      curvesModule.count(curvesModule.functions.curve_frames(count, ts.length, args.length > ts.length)),
    );
  }

  /** The parameters inside (0, 1) where a coordinate has a local extremum (its derivative changes sign), sorted. */
  extrema(): Extrema {
    return queries.extrema(this._flat, this.dimension);
  }

  /**
   * All parameters in [0, 1] at which a coordinate has the given value, end points and tangencies included, sorted. If
   * the coordinate has that value everywhere: 0 and 1, the ends of the range.
   *
   * @param where one coordinate and its value
   */
  timesAtCoordinate(where: { x: number } | { y: number } | { z: number }): Float64Array {
    return queries.timesAtCoordinate(this._flat, this.dimension, where);
  }

  /** The parameters inside (0, 1) where the curvature changes sign, sorted; 2D only. */
  inflections(): Float64Array {
    this._require2D("inflections");
    return curvesModule.read(0, curvesModule.functions.curve_inflections(this._write()));
  }

  /** The parameters inside (0, 1) of cusps, where the tangent reverses its direction, sorted. */
  cusps(): Float64Array {
    return curvesModule.read(0, curvesModule.functions.curve_cusps(this.dimension, this._write()));
  }

  /**
   * The kind of curve for t from 0 to 1, independent of its size. A planar 3D curve is classified in its plane; a 3D
   * curve that is not planar is "twisted".
   */
  classify(): CurveKind {
    return queries.CURVE_KINDS[curvesModule.functions.curve_classify(this.dimension, this._write())];
  }

  /**
   * All parameters in [0, 1] at which the tangent line passes through p, sorted; 2D only. If all tangents do, because
   * the curve is straight: 0 and 1, the ends of the range. Where the derivative almost vanishes (below 1e-7 of the
   * largest control vector of the derivative), the limit of the tangent must pass through p within 1e-7 of the curve's
   * size.
   *
   * @param p the point, in the unit of the points
   */
  tangentsFrom(p: PointLike): Float64Array {
    this._require2D("tangentsFrom");
    return queries.tangentsFrom(this._flat, p);
  }

  /**
   * The four geometry points that give this curve (of degree at most 3) in another basis.
   *
   * @param basis a name, or a 4×4 matrix, row-major
   */
  toBasis(basis: BasisLike): Float64Array {
    const matrix = basisNumbers(basis);
    return curvesModule.read(0, curvesModule.functions.curve_to_basis(this.dimension, this._write(matrix)));
  }

  /**
   * The 4×4 matrix of a basis, row-major: rows for t³, t², t and 1, columns for the geometry points.
   *
   * @param name the basis
   * @returns 16 numbers
   */
  static basisMatrix(name: BasisName): Float64Array {
    check.oneOf(name, "basis", BASES);
    return basisNumbers(name);
  }

  /**
   * The cubic of four geometry points in another basis, [t³ t² t 1]·M·G.
   *
   * @param basis "hermite" (P0, P1, M0, M1), "b-spline", "catmull-rom", "bezier", or a matrix, row-major
   * @param points four points
   * @param options `dimension`: 2 or 3, how a flat array is read; 2 by default
   */
  static fromBasis<D extends 2 | 3 = 2 | 3>(
    basis: BasisLike,
    points: PointArrays<D> | PointsLike,
    options?: { dimension?: D },
  ): Curve<D> {
    return curveOf(pointsInBasis(basis, points, options)) as Curve<D>;
  }

  /**
   * The curve that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: CurveJSON): Curve {
    return curveOf(curvePointsOf(json));
  }

  /**
   * The curve of degree n − 1 through n points, 2 to 65. With more than about ten points and equally spaced parameters
   * it oscillates between the points; `Spline.interpolate` does not.
   *
   * @param points the points that are interpolated
   * @param ts the parameter of each point; by default proportional to the lengths of the chords, from 0 to 1 (equally
   *   spaced if two neighbouring points are equal)
   * @param options `dimension`: 2 or 3, how a flat array is read; 2 by default
   * @throws {RangeError} for equal parameters
   */
  static interpolate<D extends 2 | 3 = 2 | 3>(
    points: PointArrays<D> | PointsLike,
    ts?: ArrayLike<number>,
    options?: { dimension?: D },
  ): Curve<D> {
    const { flat, dimension } = flatten(points, check.options(options, ["dimension"]).dimension, 2);
    const count = flat.length / dimension;
    if (count < 2 || count > 65) throw new RangeError(`points: expected 2 to 65 points, got ${count}`);
    const parameters = ts === undefined ? new Float64Array() : check.numbers(ts, "ts");
    if (ts !== undefined && parameters.length !== count) {
      throw new RangeError(`ts: expected ${count} numbers, one for each point, got ${parameters.length}`);
    }
    curvesModule.write(flat, parameters.length).set(parameters, flat.length);
    const length = curvesModule.functions.curve_interpolate(dimension, count, parameters.length);
    return curveOf({ flat: curvesModule.read(0, length), dimension }) as Curve<D>;
  }

  /**
   * The curve of degree n − 1 with the same end points whose largest distance from this one at equal t is smallest, and
   * that distance. A line is returned unchanged with error 0.
   */
  reduce(): Reduced<D> {
    const used = curvesModule.functions.curve_reduce(this.dimension, this._write());
    return { curve: this._curveOf(curvesModule.read(1, used)), error: curvesModule.read(0, 1)[0] };
  }

  /**
   * The offset curve at a distance along the normal (the tangent turned by +90°; negative: on the other side), as a
   * spline of lines and cubics. 2D only.
   *
   * Nothing is trimmed: where the radius of curvature is smaller than the distance, the offset curve has cusps. Where
   * the curve turns back, a half circle joins the two sides. If all control points are equal, the curve is returned
   * unchanged.
   *
   * @param distance the distance, in the unit of the points; negative on the other side
   * @param options `tolerance`: the largest distance between the spline and the exact offset curve, by default 1e-4 of
   *   the diagonal of the control points' box, at least 1e-12 of the largest coordinate plus the distance
   * @throws {RangeError} for a tolerance below 4 ulps of the largest coordinate and the distance, and if more than 2¹⁷
   *   steps (pieces tried and bounds evaluated) would be needed
   */
  offset(distance: number, options?: { tolerance?: number }): Spline<2> {
    this._require2D("offset");
    check.finite(distance, "distance");
    const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
    return readSpline(curvesModule.functions.curve_offset(this._write(), distance, tolerance), 2) as Spline<2>;
  }

  /**
   * All intersections with another curve, a spline, a rational or NURBS curve (then u is its t) or a path (then u is a
   * location {subpath, t}), sorted by t, then by u; with a path by its subpaths first.
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
   * @param other a curve, a spline, a path, or a rational or NURBS curve of `casteljau/nurbs`
   * @throws {TypeError} for a 3D curve
   */
  intersections<S extends CoreCurve | CoreSpline | CorePath | RationalCurve | NurbsCurve>(
    other: S,
  ): Intersection<number, S extends CorePath ? PathTime : number>[] {
    this._require2D("intersections");
    if (typeOf(other) !== "curve") return intersectSplines(this.casteljauData(), other) as any;
    const a = this._flat;
    const { flat: b, dimension } = curveData(other, "other");
    check.require2D("intersections", "curve", dimension);
    const view = curvesModule.write(a, b.length);
    for (let i = 0; i < b.length; i++) view[a.length + i] = b[i];
    return readIntersections(curvesModule.functions.curve_intersect(a.length / 2, b.length / 2)) as any;
  }

  /**
   * The points that the curve passes twice, sorted by t; t < u. If the end equals the start, that point is one of them.
   * Parts that the curve retraces (a straight curve that turns back) are not reported. 2D only.
   */
  selfIntersections(): SelfIntersection[] {
    this._require2D("selfIntersections");
    return readSelfIntersections(curvesModule.functions.curve_self_intersections(this._write()));
  }

  /**
   * The smallest distance between this curve and another one (0 if they intersect), and the parameters at which it
   * occurs: the global minimum for t and u in [0, 1]. If it occurs several times, any one of them is returned.
   *
   * After 1536 pairs of pieces, or 16384 steps of all kinds, the smallest distance found so far is returned.
   *
   * @param curve of the same dimension
   */
  distanceTo(curve: CoreCurve): Distance {
    return queries.distance(this._flat, this.#flatOfSameDimension(curve), this.dimension);
  }

  /**
   * The Hausdorff distance of two curves: the largest distance of a point of either curve from the other curve. It is 0
   * if both are the same set of points. The relative error is below 1e-9.
   *
   * After 600 nearest points or 6000 pieces in one direction, the largest distance found so far is returned.
   *
   * @param curve of the same dimension
   */
  hausdorff(curve: CoreCurve): number {
    return queries.hausdorff(this._flat, this.#flatOfSameDimension(curve), this.dimension);
  }

  /**
   * The curve as a `Curve` of three.js, for `TubeGeometry` and `ExtrudeGeometry`: its points are `Vector2` in the plane and
   * `Vector3` in space; arc lengths are those of this package, not a table's.
   *
   * @param THREE the namespace of three.js, or an object with `Curve`, `Vector2` and `Vector3`
   */
  toThree<CurveClass extends { prototype: any }>(THREE: ThreeCurves<CurveClass>): CurveClass["prototype"] {
    return curveToThree(this, 1, THREE);
  }

  /**
   * A curve of the full class.
   *
   * @internal
   */
  override _curveOf(flat: Float64Array): this {
    return curveOf({ flat, dimension: this.dimension }) as this;
  }

  /** The coordinates of a curve that must have the same dimension. */
  #flatOfSameDimension(curve: unknown) {
    const { flat, dimension } = curveData(curve, "curve");
    if (dimension === this.dimension) return flat;
    throw new TypeError(`curve: expected a ${this.dimension}D curve, got a ${dimension}D one`);
  }
}

// Code that uses the class by its name is outside of the class: bundlers rename a class that refers to itself (to
// _Curve).

/**
 * A curve whose points are checked already.
 *
 * @internal
 */
export function curveOf(points: ControlPoints): Curve {
  return fromChecked(Curve, points);
}
