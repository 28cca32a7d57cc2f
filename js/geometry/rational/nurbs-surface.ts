import { checkedData, fromChecked } from "../checked.js";
import { surfacesModule } from "../../wasm/surfaces-module.js";
import * as check from "../check.js";
import { nurbsSurfaceData, requireJSON } from "../brand.js";
import { showInNode } from "../inspected.js";
import { flatRows, isNested } from "../net.js";
import { boxAt, flatten, nested, samePoints } from "../points.js";
import { nurbsOf } from "./nurbs-curve.js";
import { alike, nurbsOfNumbers } from "./nurbs-data.js";
import { projective } from "./projective.js";
import { checkedWeights } from "./rational-curve.js";
import { noPointAt, rationalPatchOf, transformed } from "./rational-patch.js";
import { surfaceOfPatches } from "./rational-surface.js";
import { pointsOf, section, writeCurves, writeTurning } from "./sections.js";
import type { NurbsSurfaceData } from "../brand.js";
import type { PointLike, PointsLike, TransformLike } from "../check.js";
import type { NetLike } from "../net.js";
import type { Partials } from "../patch/core-patch.js";
import type { Bounds, Point } from "../points.js";
import type { Curvature } from "../surface-queries.js";
import type { NurbsCurve } from "./nurbs-curve.js";
import type { RationalPatch } from "./rational-patch.js";
import type { RationalSurface } from "./rational-surface.js";
import type { SectionLike, TurningOptions } from "./sections.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** What a NURBS surface is made of. */
export interface NurbsSurfaceOptions {
  /** The degree in u, 1 to 64 */
  degreeU: number;
  /** The degree in v, 1 to 64 */
  degreeV: number;
  /** The net of control points, u along the fast index: a flat list, or an array of rows, each along u */
  points: NetLike;
  /** A weight for each control point, from 2^-500 to 2^500; all 1 by default */
  weights?: ArrayLike<number>;
  /** The knots in u in ascending order: degreeU + 1 more than control points in a row */
  knotsU: ArrayLike<number>;
  /** The knots in v in ascending order: degreeV + 1 more than rows */
  knotsV: ArrayLike<number>;
}

/** What `NurbsSurface.toJSON` returns; `NurbsSurface.fromJSON` also reads other forms of points. */
export type NurbsSurfaceJSON = NurbsSurfaceOptions;

const OPTIONS = ["degreeU", "degreeV", "points", "weights", "knotsU", "knotsV"] as const;

/** The kinds of `nurbssurface_shape`. */
const CYLINDER = 0;
const CONE = 1;
const SPHERE = 2;
const TORUS = 3;

/** The patches of a surface, u along the fast index, and the values of u and v at their edges. */
type Parts = { patches: RationalPatch[]; jointsU: Float64Array; jointsV: Float64Array };

/**
 * One NURBS surface of degrees 1 to 64 in u and in v, in space: a tensor product of B-splines with weights.
 *
 * S(u, v) = Σ wᵢⱼ Nᵢ(u) Nⱼ(v) Pᵢⱼ / Σ wᵢⱼ Nᵢ(u) Nⱼ(v), where the N are the B-splines over the knots of each direction. u runs along
 * the fast index of the net. Each row of the net is an open `NurbsCurve` in u, and each column one in v: the rules for knots and
 * the domain are those of such a curve. Other values of u and v extrapolate the patches at the boundary. Surfaces are immutable:
 * every change returns a new one.
 *
 *     const sphere = NurbsSurface.sphere([0, 0, 0], 2);
 *     sphere.normal(0.3, 1); // { x: 0, y: 0, z: 1 }, at the pole
 *
 * The patches, rational ones over the nonempty rectangles of knots, are computed once and kept.
 */
export class NurbsSurface {
  #data: NurbsSurfaceData;
  #parts: Parts | undefined;

  /**
   * The surface of the given degrees, control points, weights and knots.
   *
   * @param options `degreeU`, `degreeV`, `points`, `knotsU` and `knotsV`; `weights`: all 1 by default
   * @throws {RangeError} for a wrong count, a NaN or an infinity, a weight that is not above 0, and knots that `NurbsCurve` refuses
   * @throws {TypeError} for a value that is not a point
   */
  constructor(options: NurbsSurfaceOptions) {
    if (!isShown) show();
    const checked = checkedData<NurbsSurfaceData>(options);
    this.#data = checked ?? dataOf(options);
    if (!checked) this.#readParts();
  }

  /** The degree in u. */
  get degreeU() {
    return this.#data.degreeU;
  }

  /** The degree in v. */
  get degreeV() {
    return this.#data.degreeV;
  }

  /** The ends of the ranges of u and v. */
  get domain(): { u: [number, number]; v: [number, number] } {
    const { degreeU, degreeV, knotsU, knotsV } = this.#data;
    const ends = (knots: Float64Array, degree: number): [number, number] => [
      knots[degree],
      knots[knots.length - degree - 1],
    ];
    return { u: ends(knotsU, degreeU), v: ends(knotsV, degreeV) };
  }

  /**
   * @returns a copy of the coordinates of the net
   */
  controlPoints(): Float64Array {
    return this.#data.flat.slice();
  }

  /**
   * @returns a copy of the weights of the control points
   */
  weights(): Float64Array {
    return this.#data.weights.slice();
  }

  /**
   * @returns a copy of the knots in u, in ascending order
   */
  knotsU(): Float64Array {
    return this.#data.knotsU.slice();
  }

  /**
   * @returns a copy of the knots in v, in ascending order
   */
  knotsV(): Float64Array {
    return this.#data.knotsV.slice();
  }

  /**
   * The values of u at the edges of the patches, one more than patches in this direction.
   *
   * @returns a copy
   */
  jointsU(): Float64Array {
    return this.#readParts().jointsU.slice();
  }

  /**
   * The values of v at the edges of the patches, one more than patches in this direction.
   *
   * @returns a copy
   */
  jointsV(): Float64Array {
    return this.#readParts().jointsV.slice();
  }

  /**
   * The patches: the rational patches over the nonempty rectangles of knots, u along the fast index. Neighbours have the same
   * control points and weights along their common edge.
   */
  patches(): RationalPatch[] {
    return [...this.#readParts().patches];
  }

  #readParts(): Parts {
    if (this.#parts) return this.#parts;
    const { degreeU, degreeV } = this.#data;
    this.#write();
    const numbers = surfacesModule.read(0, surfacesModule.functions.nurbssurface_patches());
    const [u, v] = numbers;
    const first = 2 + u + v;
    const size = 4 * (degreeU + 1) * (degreeV + 1);
    const patch = (_: unknown, k: number) =>
      rationalPatchOf(numbers.subarray(first + k * size, first + (k + 1) * size), degreeU, degreeV);
    this.#parts = {
      patches: Array.from({ length: (u - 1) * (v - 1) }, patch),
      jointsU: numbers.slice(2, 2 + u),
      jointsV: numbers.slice(2 + u, first),
    };
    return this.#parts;
  }

  /**
   * Whether both have the same degrees and numbers of knots, each control point lies within a distance of its counterpart, and
   * weights and knots are equal within `tolerance` times the largest one.
   *
   * @param other the value to compare with
   * @param tolerance by default 0: equal coordinates, weights and knots
   */
  equals(other: NurbsSurface, tolerance = 0): boolean {
    const [a, b] = [this.#data, nurbsSurfaceData(other, "other")];
    if (!samePoints(a.flat, b.flat, 3, tolerance) || a.degreeU !== b.degreeU || a.degreeV !== b.degreeV) return false;
    const lists = ["weights", "knotsU", "knotsV"] as const;
    return lists.every((name) => alike(a[name], b[name], tolerance));
  }

  /** The surface as an object for JSON, from which `NurbsSurface.fromJSON` makes an equal surface. */
  toJSON(): {
    degreeU: number;
    degreeV: number;
    points: number[][];
    weights: number[];
    knotsU: number[];
    knotsV: number[];
  } {
    const { degreeU, degreeV, flat, weights, knotsU, knotsV } = this.#data;
    return {
      degreeU,
      degreeV,
      points: nested(flat, 3),
      weights: [...weights],
      knotsU: [...knotsU],
      knotsV: [...knotsV],
    };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "nurbssurface" {
    return "nurbssurface";
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  casteljauData(): NurbsSurfaceData {
    return this.#data;
  }

  /** Writes the surface, and then further numbers, to the arena. */
  #write(further: ArrayLike<number> = []) {
    const { degreeU, degreeV, flat, weights, knotsU, knotsV } = this.#data;
    const counts = Float64Array.of(degreeU, degreeV, knotsU.length, knotsV.length);
    const lists = [flat, weights, knotsU, knotsV, further];
    const view = surfacesModule.write(
      counts,
      lists.reduce((sum, list) => sum + list.length, 0),
    );
    let at = counts.length;
    for (const list of lists) {
      view.set(list, at);
      at += list.length;
    }
  }

  /** The patch that contains (u, v), the parameters on it, and its extent; an edge belongs to the patch that starts there. */
  #locate(u: number, v: number) {
    check.finite(u, "u");
    check.finite(v, "v");
    const { patches, jointsU, jointsV } = this.#readParts();
    const [column, s, width] = located(jointsU, u);
    const [row, t, height] = located(jointsV, v);
    const patch = patches[row * (jointsU.length - 1) + column];
    if (!patch._hasPointAt(s, t)) throw noPointAt(u, v);
    return { patch, s, t, width, height };
  }

  /**
   * The point at (u, v).
   *
   * @param u the parameter along the fast index of the net, in the domain; others extrapolate
   * @param v the parameter along the slow index of the net, in the domain; others extrapolate
   * @throws {RangeError} outside of the domain where the denominator is not above 0
   */
  eval(u: number, v: number): Point<3> {
    const { patch, s, t } = this.#locate(u, v);
    return patch.eval(s, t);
  }

  /**
   * The first and second partial derivatives at (u, v), in units of length per unit of u and v. At the edge of a patch they are
   * those of the patch that starts there.
   *
   * @param u the parameter along the fast index of the net, in the domain; others extrapolate
   * @param v the parameter along the slow index of the net, in the domain; others extrapolate
   * @throws {RangeError} as `eval`
   */
  partials(u: number, v: number): Partials {
    const { patch, s, t, width, height } = this.#locate(u, v);
    const local = patch.partials(s, t);
    const divided = ({ x, y, z }: Point<3>, a: number, b = 1) => ({ x: x / a / b, y: y / a / b, z: z / a / b });
    return {
      u: divided(local.u, width),
      v: divided(local.v, height),
      uu: divided(local.uu, width, width),
      uv: divided(local.uv, width, height),
      vv: divided(local.vv, height, height),
    };
  }

  /**
   * The unit normal at (u, v) in the direction of ∂u × ∂v, also at poles: there it is the limit.
   *
   * @param u the parameter along the fast index of the net, in the domain; others extrapolate
   * @param v the parameter along the slow index of the net, in the domain; others extrapolate
   * @throws {RangeError} as `eval`
   */
  normal(u: number, v: number): Point<3> {
    const { patch, s, t } = this.#locate(u, v);
    return patch.normal(s, t);
  }

  /**
   * The curvatures at (u, v), with the signs and limits of `Patch.curvature`.
   *
   * @param u the parameter along the fast index of the net, in the domain; others extrapolate
   * @param v the parameter along the slow index of the net, in the domain; others extrapolate
   * @throws {RangeError} as `eval`
   */
  curvature(u: number, v: number): Curvature {
    const { patch, s, t } = this.#locate(u, v);
    return patch.curvature(s, t);
  }

  /**
   * The same surface with a knot u inserted.
   *
   * @param u the knot, in the domain
   * @param times how often, by default once; in total at most as often as the degree
   * @throws {RangeError} as `NurbsCurve.insertKnot`
   */
  insertKnotU(u: number, times = 1): NurbsSurface {
    return this.#insertKnot(true, check.finite(u, "u"), times);
  }

  /**
   * The same surface with a knot v inserted.
   *
   * @param v the knot, in the domain
   * @param times how often, by default once; in total at most as often as the degree
   * @throws {RangeError} as `NurbsCurve.insertKnot`
   */
  insertKnotV(v: number, times = 1): NurbsSurface {
    return this.#insertKnot(false, check.finite(v, "v"), times);
  }

  #insertKnot(alongU: boolean, at: number, times: number): NurbsSurface {
    check.whole(times, "times", 0, 64);
    this.#write();
    return readSurface(surfacesModule.functions.nurbssurface_insert_knot(alongU, at, times));
  }

  /**
   * The same surface with a higher degree in u; every knot gets as many more copies, so the surface is as smooth as before.
   *
   * @param times by how much the degree is raised, by default 1
   * @throws {RangeError} for a degree above 64
   */
  elevateU(times = 1): NurbsSurface {
    return this.#elevate(true, times);
  }

  /**
   * The same surface with a higher degree in v; see `elevateU`.
   *
   * @param times by how much the degree is raised, by default 1
   * @throws {RangeError} for a degree above 64
   */
  elevateV(times = 1): NurbsSurface {
    return this.#elevate(false, times);
  }

  #elevate(alongU: boolean, times: number): NurbsSurface {
    check.whole(times, "times", 0, 64 - (alongU ? this.degreeU : this.degreeV));
    let surface: NurbsSurface = this;
    for (let k = 0; k < times; k++) {
      surface.#write();
      surface = readSurface(surfacesModule.functions.nurbssurface_elevate(alongU));
    }
    return surface;
  }

  /**
   * Splits the surface at u into two, whose domains together are that of this one.
   *
   * @param u the parameter, inside of the domain
   * @throws {RangeError} for any other u
   */
  splitU(u: number): [NurbsSurface, NurbsSurface] {
    return this.#split("u", u);
  }

  /**
   * Splits the surface at v into two, whose domains together are that of this one.
   *
   * @param v the parameter, inside of the domain
   * @throws {RangeError} for any other v
   */
  splitV(v: number): [NurbsSurface, NurbsSurface] {
    return this.#split("v", v);
  }

  #split(direction: "u" | "v", at: number): [NurbsSurface, NurbsSurface] {
    check.finite(at, direction);
    const [from, to] = this.domain[direction];
    if (!(at > from && at < to)) {
      throw new RangeError(`${direction}: expected a number inside of the domain, ${from} to ${to}, got ${at}`);
    }
    this.#write();
    const numbers = surfacesModule.read(0, surfacesModule.functions.nurbssurface_split(direction === "u", at));
    const [m, n, knotsU, knotsV] = numbers;
    const end = 4 + 4 * (knotsU - m - 1) * (knotsV - n - 1) + knotsU + knotsV;
    return [surfaceOfNumbers(numbers.subarray(0, end)), surfaceOfNumbers(numbers.subarray(end))];
  }

  /**
   * The curve u = constant, with the degree and the knots in v.
   *
   * @param u the parameter, in the domain
   * @throws {RangeError} for any other u
   */
  isocurveAtU(u: number): NurbsCurve<3> {
    return this.#isocurve(true, check.finite(u, "u"));
  }

  /**
   * The curve v = constant, with the degree and the knots in u.
   *
   * @param v the parameter, in the domain
   * @throws {RangeError} for any other v
   */
  isocurveAtV(v: number): NurbsCurve<3> {
    return this.#isocurve(false, check.finite(v, "v"));
  }

  #isocurve(constantU: boolean, at: number): NurbsCurve<3> {
    this.#write();
    const numbers = surfacesModule.read(0, surfacesModule.functions.nurbssurface_isocurve(constantU, at));
    return nurbsOf(nurbsOfNumbers(numbers, 3)) as NurbsCurve<3>;
  }

  /** The same surface with u in the opposite direction over the same domain, so that the normals point to the other side. */
  reverse(): NurbsSurface {
    this.#write();
    return readSurface(surfacesModule.functions.nurbssurface_reverse());
  }

  /**
   * The surface transformed by an affine map, which keeps the weights, or by a projective map, which changes them; see
   * `RationalCurve.transform`.
   *
   * @param matrix 6 or 16 numbers, a DOMMatrix or another object with a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} as there
   */
  transform(matrix: TransformLike): NurbsSurface {
    const numbers = projective(matrix, 3);
    if (!numbers) return surfaceOf({ ...this.#data, flat: transformed(this.#data.flat, matrix) });
    this.#write(numbers);
    return readSurface(surfacesModule.functions.nurbssurface_project());
  }

  /** The smallest box that contains the surface: that of all patches, exact up to rounding. */
  bounds(): Bounds<3> {
    this.#write();
    return boxAt(surfacesModule.read(0, surfacesModule.functions.nurbssurface_bounds()), 3);
  }

  /**
   * The same surface as a network of its patches, exactly: for meshes, measures, rays and nearest points.
   *
   *     NurbsSurface.sphere([0, 0, 0], 1).toSurface().tessellate({ tolerance: 0.01 });
   *
   * Adjacent patches share the vertices along their edge; so do a start and an end that are equal, as those of a full turn, and all
   * edges at a pole share one vertex.
   */
  toSurface(): RationalSurface {
    return surfaceOfPatches(this.#readParts().patches.map((patch) => patch.casteljauData()));
  }

  /** The surface as JSON: `String(surface)` and `${surface}` give this text. */
  toString(): string {
    return JSON.stringify(this);
  }

  /**
   * The parallelogram with a corner and two sides: S(u, v) = origin + u·U + v·V for u and v from 0 to 1.
   *
   * @param origin the corner
   * @param u the side U
   * @param v the side V
   */
  static plane(origin: PointLike, u: PointLike, v: PointLike): NurbsSurface {
    surfacesModule.write(pointsOf([origin, "origin"], [u, "u"], [v, "v"]));
    return readSurface(surfacesModule.functions.nurbssurface_plane());
  }

  /**
   * The side of a cylinder: u runs once around the axis, v from the base to the height. There are no caps.
   *
   * The normals point outwards for a positive height.
   *
   * @param center of the base
   * @param radius at least 0
   * @param height along the axis
   * @param options `axis`: a direction of any length above 0, by default [0, 0, 1]
   * @throws {RangeError} for a negative radius and an axis of length 0
   */
  static cylinder(center: PointLike, radius: number, height: number, options?: { axis?: PointLike }): NurbsSurface {
    return shape(CYLINDER, center, options, [radius, "radius"], [height, "height"]);
  }

  /**
   * The side of a cone: u runs once around the axis, v from the base to the tip at the height.
   *
   * @param center of the base
   * @param radius of the base, at least 0
   * @param height along the axis
   * @param options `axis`: a direction of any length above 0, by default [0, 0, 1]
   * @throws {RangeError} as `cylinder`
   */
  static cone(center: PointLike, radius: number, height: number, options?: { axis?: PointLike }): NurbsSurface {
    return shape(CONE, center, options, [radius, "radius"], [height, "height"]);
  }

  /**
   * A sphere of eight patches of degree 2 × 2: u runs once around the axis, v from the pole against the axis to the pole along it.
   * The normals point outwards.
   *
   * @param center a point
   * @param radius at least 0
   * @param options `axis`: a direction of any length above 0, by default [0, 0, 1]
   * @throws {RangeError} as `cylinder`
   */
  static sphere(center: PointLike, radius: number, options?: { axis?: PointLike }): NurbsSurface {
    return shape(SPHERE, center, options, [radius, "radius"], [0, "height"]);
  }

  /**
   * A torus of 16 patches of degree 2 × 2: u runs once around the axis, v once around the tube, from the outermost circle towards
   * the axis direction. The normals point outwards.
   *
   * @param center a point
   * @param majorRadius the distance of the middle of the tube from the axis, above the minor radius
   * @param minorRadius the radius of the tube, at least 0
   * @param options `axis`: a direction of any length above 0, by default [0, 0, 1]
   * @throws {RangeError} as `cylinder`, and for a major radius that is not above the minor radius
   */
  static torus(
    center: PointLike,
    majorRadius: number,
    minorRadius: number,
    options?: { axis?: PointLike },
  ): NurbsSurface {
    return shape(TORUS, center, options, [majorRadius, "majorRadius"], [minorRadius, "minorRadius"]);
  }

  /**
   * The surface of the lines between points of two curves at equal parameters: a at v = 0 and b at v = 1; u runs along the curves.
   *
   * The curves are brought to one degree, the domain [0, 1] and the same knots, which does not change them.
   *
   * @param a a curve of any kind; one of the plane lies in z = 0
   * @param b a curve of any kind
   */
  static ruled(a: SectionLike, b: SectionLike): NurbsSurface {
    writeCurves([section(a, "a"), section(b, "b")]);
    return readSurface(surfacesModule.functions.nurbssurface_ruled());
  }

  /**
   * The surface that a curve sweeps over when it is moved by a vector: u runs along the curve, v along the vector.
   *
   * @param curve a curve of any kind; one of the plane lies in z = 0
   * @param vector in the unit of the points
   */
  static extrude(curve: SectionLike, vector: PointLike): NurbsSurface {
    writeCurves([section(curve, "curve")], pointsOf([vector, "vector"]));
    return readSurface(surfacesModule.functions.nurbssurface_extrude());
  }

  /**
   * The surface that a profile sweeps over when it turns around an axis.
   *
   * u runs around the axis over [0, 1], from the profile in the direction of a right-handed turn (the other way for a negative
   * angle), with a patch for each quarter turn or less; v runs along the profile, with its knots and domain. Where the profile ends
   * on the axis, the surface has a pole.
   *
   * @param profile a curve of any kind; one of the plane lies in z = 0
   * @param options `origin`: a point of the axis, by default [0, 0, 0]; `axis`: its direction, by default [0, 0, 1]; `angle`: in
   *   radians, by default a full turn
   * @throws {RangeError} for an axis of length 0, an angle above a full turn, and a profile that meets the axis elsewhere than at
   *   its ends
   */
  static revolve(profile: SectionLike, options?: TurningOptions): NurbsSurface {
    const angle = writeTurning(profile, options);
    return readSurface(surfacesModule.functions.nurbssurface_revolve(angle));
  }

  /**
   * The surface through curves, which are its isocurves at increasing v; u runs along them.
   *
   * The curves should run in the same direction; closed ones should start side by side. They are brought to one degree, the
   * domain [0, 1] and the same knots, which does not change them. In v the surface interpolates as `NurbsCurve.interpolate`.
   *
   * @param curves degree + 1 or more curves of any kind, all open or all closed; those of the plane lie in z = 0
   * @param options `degree`: in v, 1 to 64, by default 3, or less for fewer than four curves
   * @throws {RangeError} for too few curves, open and closed ones, a curve that is equal to the one before, and for weights that
   *   differ so much that those of the surface would not be above 0
   */
  static loft(curves: readonly SectionLike[], options?: { degree?: number }): NurbsSurface {
    if (!Array.isArray(curves)) throw new TypeError(`curves: expected an array, got ${check.describe(curves)}`);
    const sections = Array.from(curves, (curve, k) => section(curve, `curves[${k}]`));
    const { degree = Math.min(3, Math.max(1, sections.length - 1)) } = check.options(options, ["degree"]);
    check.whole(degree, "degree", 1, 64);
    if (sections.length <= degree) {
      throw new RangeError(`curves: expected at least ${degree + 1} curves (degree ${degree}), got ${sections.length}`);
    }
    writeCurves(sections);
    return readSurface(surfacesModule.functions.nurbssurface_loft(sections.length, degree));
  }

  /**
   * The surface that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: NurbsSurfaceJSON): NurbsSurface {
    requireJSON(json, "degrees, points, weights and knots", ({ points }) => points !== undefined);
    return surfaceFrom({ ...json });
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(NurbsSurface.prototype, "NurbsSurface", (value) => value.toJSON());
}

// Outside of the class, see ../curve/core-curve.js.
const surfaceFrom = (options: NurbsSurfaceOptions): NurbsSurface => new NurbsSurface(options);
const surfaceOf = (data: NurbsSurfaceData) => fromChecked(NurbsSurface, data);

/** Reads a surface from the arena. */
const readSurface = (end: number) => surfaceOfNumbers(surfacesModule.read(0, end));

/** The surface that numbers of the arena describe. */
function surfaceOfNumbers(numbers: Float64Array): NurbsSurface {
  const [degreeU, degreeV, countU, countV] = numbers;
  const count = (countU - degreeU - 1) * (countV - degreeV - 1);
  const [weights, knotsU] = [4 + 3 * count, 4 + 4 * count];
  return surfaceOf({
    degreeU,
    degreeV,
    flat: numbers.slice(4, weights),
    weights: numbers.slice(weights, knotsU),
    knotsU: numbers.slice(knotsU, knotsU + countU),
    knotsV: numbers.slice(knotsU + countU),
  });
}

/** The index of the span that contains t, the parameter on it, and its length; the last end belongs to the last span. */
function located(joints: Float64Array, t: number): [number, number, number] {
  let [k, after] = [0, joints.length - 1];
  while (after - k > 1) {
    const middle = (k + after) >> 1;
    if (joints[middle] <= t) k = middle;
    else after = middle;
  }
  const [from, to] = [joints[k], joints[k + 1]];
  return [k, t === to ? 1 : (t - from) / (to - from), to - from];
}

function dataOf(options: NurbsSurfaceOptions): NurbsSurfaceData {
  const { degreeU, degreeV, points, weights, knotsU, knotsV } = check.options(options, OPTIONS);
  const u = checkedKnots(knotsU, check.whole(degreeU, "degreeU", 1, 64), "U");
  const v = checkedKnots(knotsV, check.whole(degreeV, "degreeV", 1, 64), "V");
  const flat = netOf(points as NetLike, u.count, v.count);
  return {
    degreeU: u.degree,
    degreeV: v.degree,
    flat,
    weights:
      weights === undefined ? new Float64Array(flat.length / 3).fill(1) : checkedWeights(weights, flat.length / 3),
    knotsU: u.knots,
    knotsV: v.knots,
  };
}

const RHINO = "rhino3dm leaves out the first and the last knot";

/** The knots of a direction, and the number of control points for them. Their order is checked by the core. */
function checkedKnots(list: unknown, degree: number, direction: string) {
  const knots = check.numbers(list, `knots${direction}`);
  const min = 2 * (degree + 1);
  if (knots.length < min) {
    throw new RangeError(
      `knots${direction}: expected at least 2·(degree${direction} + 1) = ${min} knots (${RHINO}), got ${knots.length}`,
    );
  }
  return { knots, degree, count: knots.length - degree - 1 };
}

function netOf(points: NetLike, columns: number, rows: number): Float64Array {
  const nested = isNested(points);
  const flat = nested ? flatRows(points, columns, "points") : flatten(points as PointsLike, 3, 3).flat;
  if (flat.length === 3 * columns * rows) return flat;
  const got = nested ? `${points.length} rows` : flat.length / 3;
  const knots = "knotsU − degreeU − 1 times knotsV − degreeV − 1";
  throw new RangeError(`points: expected ${columns} × ${rows} control points (${knots}; ${RHINO}), got ${got}`);
}

function shape(
  kind: number,
  center: PointLike,
  options: { axis?: PointLike } | undefined,
  [a, nameOfA]: [number, string],
  [b, nameOfB]: [number, string],
): NurbsSurface {
  const { axis = [0, 0, 1] } = check.options(options, ["axis"]);
  const args = pointsOf([center, "center"], [axis, "axis"]);
  check.finite(a, nameOfA);
  check.finite(b, nameOfB);
  surfacesModule.write(args);
  return readSurface(surfacesModule.functions.nurbssurface_shape(kind, a, b));
}
