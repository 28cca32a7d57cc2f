import { checkedData, fromChecked } from "../checked.js";
import { surfacesModule } from "../../wasm/surfaces-module.js";
import * as check from "../check.js";
import * as queries from "../surface-queries.js";
import { basisNumbers } from "../basis.js";
import { coreCurveOf } from "../curve/core-curve.js";
import { patchData, requireJSON } from "../brand.js";
import { affine } from "../affine.js";
import { showInNode } from "../inspected.js";
import { netData, netNumbers } from "../net.js";
import { nested, samePoints, writePoint, pointAt } from "../points.js";
import { readGrid } from "../grid-mesh.js";
import { gridOptions, readMesh } from "../mesh.js";
import { tessellation } from "../tessellation.js";
import type { BasisLike } from "../basis.js";
import type { PatchData } from "../brand.js";
import type { TransformLike, Complete, PointLike } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { NetLike } from "../net.js";
import type { GridOptions, Mesh } from "../mesh.js";
import type { Bounds, Point } from "../points.js";
import type { Curvature, PatchPoint, PatchDeCasteljau } from "../surface-queries.js";
import type { TessellationOptions } from "../tessellation.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** What `Patch.toJSON` returns; `Patch.fromJSON` also reads other forms of nets. */
export interface PatchJSON {
  net: NetLike;
  /** 3 by default */
  degreeU?: number;
  /** 3 by default */
  degreeV?: number;
}

/** The partial derivatives of a patch. */
export type Partials = { u: Point<3>; v: Point<3>; uu: Point<3>; uv: Point<3>; vv: Point<3> };

/**
 * One tensor-product Bézier patch of degrees 1 to 64 in u and in v, in 3D.
 *
 * S(u, v) = Σ Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with the net index j·(degreeU + 1) + i: u runs along the fast index. The corners are
 * returned exactly. Patches are immutable: every change returns a new one.
 *
 * This is `Patch` of casteljau/surfaces. That of `casteljau` extends it; where a function takes a patch, it takes the patches
 * of every entry point.
 *
 * @template C the class of its curves
 */
export class CorePatch<C extends CoreCurve = CoreCurve> {
  #flat: Float64Array;
  #degreeU: number;
  #degreeV: number;

  /**
   * The patch of the given net of control points.
   *
   * @param net (degreeU + 1)·(degreeV + 1) control points, u along the fast index: a flat list, or an array of degreeV
   *   + 1 rows; an array of numbers holds three for each point
   * @param options by default what the lengths of the rows give, and 3 for a flat list
   * @throws {RangeError} for a wrong count, a NaN or an infinity
   */
  constructor(net: NetLike, options?: { degreeU?: number; degreeV?: number }) {
    if (!isShown) show();
    const { flat, degreeU, degreeV } = checkedData<PatchData>(net) ?? netData(net, options);
    this.#flat = flat;
    this.#degreeU = degreeU;
    this.#degreeV = degreeV;
  }

  /** The degree in u. */
  get degreeU() {
    return this.#degreeU;
  }

  /** The degree in v. */
  get degreeV() {
    return this.#degreeV;
  }

  /**
   * @returns a copy of the coordinates of the net
   */
  controlPoints(): Float64Array {
    return this.#flat.slice();
  }

  /**
   * Whether both have the same degrees and each control point lies within a distance of its counterpart.
   *
   * @param other the value to compare with
   * @param tolerance the largest distance of two control points, by default 0
   */
  equals(other: CorePatch, tolerance = 0): boolean {
    const { flat, degreeU } = patchData(other, "other");
    return this.#degreeU === degreeU && samePoints(this.#flat, flat, 3, tolerance);
  }

  /**
   * Splits the patch at u into two.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   */
  splitU(u: number): [this, this] {
    return this.#split(true, check.finite(u, "u"));
  }

  /**
   * Splits the patch at v into two.
   *
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  splitV(v: number): [this, this] {
    return this.#split(false, check.finite(v, "v"));
  }

  /**
   * Splits the patch at (u, v) into four: before both, after u, after v, after both.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  split(u: number, v: number): [this, this, this, this] {
    check.finite(u, "u");
    const [below, above] = this.splitV(v);
    return [...below.splitU(u), ...above.splitU(u)];
  }

  /**
   * The same patch with both degrees raised by one.
   *
   * @throws {RangeError} at degree 64
   */
  elevate(): this {
    surfacesModule.write(this.#flat);
    const length = surfacesModule.functions.patch_elevate(this.#degreeU, this.#degreeV);
    return this._patchOf(surfacesModule.read(0, length), this.#degreeU + 1, this.#degreeV + 1);
  }

  /**
   * The patch transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform<const M extends TransformLike>(matrix: M & Complete<M>): this {
    surfacesModule.write(this.#flat, 12).set(affine(matrix), this.#flat.length);
    return this.#withNet(surfacesModule.read(0, surfacesModule.functions.points_transform(3, this.#flat.length / 3)));
  }

  /**
   * The patch with one control point moved.
   *
   * @param index the number of the control point, from 0
   * @param to the new position
   */
  movePoint(index: number, to: PointLike): this {
    check.whole(index, "index", 0, this.#flat.length / 3 - 1);
    const flat = this.#flat.slice();
    writePoint(flat, 3 * index, to, 3, "to");
    return this.#withNet(flat);
  }

  /** The patch as an object for JSON, from which `Patch.fromJSON` makes an equal patch. */
  toJSON(): { net: number[][]; degreeU: number; degreeV: number } {
    return { net: nested(this.#flat, 3), degreeU: this.#degreeU, degreeV: this.#degreeV };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "patch" {
    return "patch";
  }

  /**
   * The data, see `Branded`.
   *
   * @internal
   */
  casteljauData(): PatchData {
    return { flat: this.#flat, degreeU: this.#degreeU, degreeV: this.#degreeV };
  }

  /**
   * The coordinates of the net, not copied.
   *
   * @internal
   */
  get _flat() {
    return this.#flat;
  }

  /**
   * A patch of the same class.
   *
   * @internal
   */
  _patchOf(flat: Float64Array, degreeU: number, degreeV: number): this {
    return corePatchOf(flat, degreeU, degreeV) as this;
  }

  /**
   * @internal
   * Writes the net to the arena.
   * @returns the arguments of the core's functions of (u, v)
   */
  _writeAt(u: number, v: number): [number, number, number, number] {
    check.finite(u, "u");
    check.finite(v, "v");
    surfacesModule.write(this.#flat);
    return [this.#degreeU, this.#degreeV, u, v];
  }

  #withNet(flat: Float64Array) {
    return this._patchOf(flat, this.#degreeU, this.#degreeV);
  }

  #split(alongU: boolean, at: number): [this, this] {
    surfacesModule.write(this.#flat);
    surfacesModule.functions.patch_split(this.#degreeU, this.#degreeV, alongU, at);
    const n = this.#flat.length;
    return [this.#withNet(surfacesModule.read(0, n)), this.#withNet(surfacesModule.read(n, 2 * n))];
  }

  /**
   * The point at (u, v), by de Casteljau's algorithm along u and then along v.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  eval(u: number, v: number): Point<3> {
    surfacesModule.functions.patch_eval(...this._writeAt(u, v));
    return pointAt(surfacesModule.read(0, 3), 0, 3);
  }

  /**
   * The first and second partial derivatives at (u, v).
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  partials(u: number, v: number): Partials {
    surfacesModule.functions.patch_partials(...this._writeAt(u, v));
    const numbers = surfacesModule.read(0, 15);
    const at = (k: number) => pointAt(numbers, 3 * k, 3);
    return { u: at(0), v: at(1), uu: at(2), uv: at(3), vv: at(4) };
  }

  /**
   * The unit normal at (u, v) in the direction of ∂u × ∂v. At collapsed edges it is the limit; it is zero for a patch
   * that is a curve or a point.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  normal(u: number, v: number): Point<3> {
    surfacesModule.functions.patch_normal(...this._writeAt(u, v));
    return pointAt(surfacesModule.read(0, 3), 0, 3);
  }

  /**
   * The curvatures at (u, v). Where ∂u × ∂v vanishes, as at a collapsed edge, they are the limits on the line from the
   * patch's middle, and zero if there is no limit (the tip of a cone, a patch that is a curve or a point).
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  curvature(u: number, v: number): Curvature {
    surfacesModule.functions.patch_curvature(...this._writeAt(u, v));
    const [gaussian, mean, k1, k2] = surfacesModule.read(0, 4);
    return { gaussian, mean, k1, k2 };
  }

  /**
   * All intermediate points of de Casteljau's algorithm for S(u, v): rows, then a curve, then the point.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  deCasteljau(u: number, v: number): PatchDeCasteljau {
    check.finite(u, "u");
    check.finite(v, "v");
    const levels = (row: Float64Array, t: number) => this._curveOf(row).deCasteljau(t);
    return queries.deCasteljau(this._flat, this.degreeU + 1, u, v, levels);
  }

  /**
   * The curve u = constant, which runs along v.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   */
  isocurveAtU(u: number): C {
    return this.#isocurve(true, check.finite(u, "u"));
  }

  /**
   * The curve v = constant, which runs along u.
   *
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  isocurveAtV(v: number): C {
    return this.#isocurve(false, check.finite(v, "v"));
  }

  /**
   * The smallest box that contains the patch, exact up to rounding. Each face of the box takes at most 2²³ steps (2²⁶
   * above degree 24), about one for each multiplication. If that is not enough, the face is at the best local extremum
   * found so far.
   */
  bounds(): Bounds<3> {
    return queries.bounds(this.#surfaceWriter()) as Bounds<3>;
  }

  /**
   * The surface area with a relative error below 1e-8. Regions that the patch covers twice count twice; the area of a
   * patch that is a curve or a point is 0.
   *
   * It takes at most 2²² steps, about one for each two multiplications (some milliseconds). Where the patch folds back,
   * or has very different sizes along its axes, the result is the best estimate and its fifth digit may be wrong; where
   * coordinates differ by many powers of ten, the fourth.
   */
  area(): number {
    return queries.area(this.#surfaceWriter());
  }

  /** An upper bound on the distance of the patch from the two triangles that join its corners, for either diagonal. */
  flatness(): number {
    surfacesModule.write(this._flat);
    return surfacesModule.functions.patch_flatness(this.degreeU, this.degreeV);
  }

  /**
   * The point of the patch that is nearest to p (the global minimum of the distance), edges and corners included.
   *
   * Two searches take at most 2²³ steps each (2²⁶ above degree 24), about one for each multiplication. The first uses
   * the square of the distance. The second uses the distance itself and runs where the distance is below 2⁻¹⁶ of the
   * size (2⁻⁴ if the first search reaches its limit). If a search reaches its limit, as where a whole curve of the
   * patch is nearest, the result is the nearest point found so far, a local minimum of the distance.
   *
   * @param p the point, in the unit of the points
   */
  nearest(p: PointLike): PatchPoint {
    const found = queries.nearest(this.#surfaceWriter(), p) as any;
    return queries.withoutPatch(found);
  }

  /**
   * All intersections with a ray, sorted by distance. `distance` is that of the point from the origin, independent of
   * the length of `direction`. Where the ray is tangent to the patch, and at a collapsed edge, there is one
   * intersection. For a ray that lies in the patch, they are its crossings of the edges, and the origin if it is on the
   * patch.
   *
   * @param origin the start of the ray
   * @param direction the direction of the ray, of any length above 0
   * @throws {RangeError} for a direction of length 0, and if the search takes more than 2²⁷ steps, about one for each
   *   multiplication
   */
  intersectRay(origin: PointLike, direction: PointLike): PatchPoint[] {
    return queries.intersectRay(this.#surfaceWriter(), origin, direction).map(queries.withoutPatch);
  }

  /** A mesh of one grid of samples of the patch. */
  grid(options: GridOptions): Mesh {
    const checked = gridOptions(options);
    const { u, v, quads, differences } = checked;
    surfacesModule.write(this._flat);
    surfacesModule.count(surfacesModule.functions.patch_grid(this.degreeU, this.degreeV, u, v, quads, differences));
    return readGrid(1, checked);
  }

  /** A mesh of the patch; see `Surface.tessellate`. Here `weld` is "none" by default, so that the mesh has uvs. */
  tessellate(options: TessellationOptions): Mesh {
    const { args, extra, into, ...kind } = tessellation(options, "none");
    surfacesModule.write(this._flat, extra.length).set(extra, this._flat.length);
    surfacesModule.count(surfacesModule.functions.patch_tessellate(this.degreeU, this.degreeV, ...args));
    return readMesh(into, kind);
  }

  /**
   * A curve in space.
   *
   * @internal
   */
  _curveOf(flat: Float64Array): C {
    return coreCurveOf({ flat, dimension: 3 }) as unknown as C;
  }

  #surfaceWriter() {
    return queries.patchWriter(this._flat, this.degreeU, this.degreeV);
  }

  #isocurve(constantU: boolean, at: number) {
    surfacesModule.write(this._flat);
    const length = surfacesModule.functions.patch_isocurve(this.degreeU, this.degreeV, constantU, at);
    return this._curveOf(surfacesModule.read(0, length));
  }

  /**
   * The bicubic patch of sixteen geometry points in another basis: each row and then each column is converted to the
   * Bézier basis.
   *
   *     const patch = Patch.fromBasis("b-spline", net);
   *
   * @param basis a name, or a 4×4 matrix, row-major
   * @param net row by row; in the Hermite basis, a row holds two points and two derivatives in u, and the last two
   *   rows are derivatives in v
   */
  static fromBasis(basis: BasisLike, net: NetLike): CorePatch {
    return corePatchOf(netInBasis(basis, net), 3, 3);
  }

  /**
   * The patch that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: PatchJSON): CorePatch {
    return corePatchWith(...patchArguments(json));
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(CorePatch.prototype, "Patch", (value) => value.toJSON());
}

// Outside of the class, see ../curve/core-curve.js.

function corePatchWith(net: NetLike, options: { degreeU?: number; degreeV?: number }): CorePatch {
  return new CorePatch(net, options);
}

/**
 * A patch whose net is checked already.
 *
 * @internal
 */
export function corePatchOf(flat: Float64Array, degreeU: number, degreeV: number): CorePatch {
  return fromChecked(CorePatch, { flat, degreeU, degreeV });
}

/**
 * The net of a patch in another basis.
 *
 * @internal
 */
export function netInBasis(basis: BasisLike, net: NetLike): Float64Array {
  const matrix = basisNumbers(basis);
  surfacesModule.write(netNumbers(net, 3, 3), 16).set(matrix, 48);
  return surfacesModule.read(0, surfacesModule.functions.patch_from_basis());
}

/**
 * The arguments of the constructor for a patch in JSON.
 *
 * @internal
 */
export function patchArguments(json: PatchJSON): [NetLike, { degreeU?: number; degreeV?: number }] {
  requireJSON(json, "net", ({ net }) => net !== undefined);
  return [json.net, { degreeU: json.degreeU, degreeV: json.degreeV }];
}
