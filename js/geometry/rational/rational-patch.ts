import { checkedData, fromChecked } from "../checked.js";
import { surfacesModule } from "../../wasm/surfaces-module.js";
import * as check from "../check.js";
import { affine } from "../affine.js";
import { patchData, rationalPatchData, requireJSON, typeOf } from "../brand.js";
import { showInNode } from "../inspected.js";
import { netData } from "../net.js";
import { boxAt, nested, pointAt, samePoints } from "../points.js";
import { projective } from "./projective.js";
import { checkedWeights, rationalCurveOf } from "./rational-curve.js";
import type { RationalPatchData } from "../brand.js";
import type { TransformLike } from "../check.js";
import type { NetLike } from "../net.js";
import type { CorePatch, Partials } from "../patch/core-patch.js";
import type { Bounds, Point } from "../points.js";
import type { Curvature } from "../surface-queries.js";
import type { RationalCurve } from "./rational-curve.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** What `RationalPatch.toJSON` returns; `RationalPatch.fromJSON` also reads other forms of nets. */
export interface RationalPatchJSON {
  net: NetLike;
  weights: ArrayLike<number>;
  degreeU?: number;
  degreeV?: number;
}

/**
 * One rational Bézier patch of degrees 1 to 64 in u and in v, in space: a net of control points with weights.
 *
 * S(u, v) = Σ wᵢⱼ Bᵢ(u) Bⱼ(v) Pᵢⱼ / Σ wᵢⱼ Bᵢ(u) Bⱼ(v) with the net of `Patch`. Equal weights give that patch, and a common factor
 * of all weights changes nothing. The corners are returned exactly. Patches are immutable: every change returns a new one.
 *
 *     // A quarter of a cylinder of radius 1 and height 2.
 *     const net = [[[1, 0, 0], [1, 1, 0], [0, 1, 0]], [[1, 0, 2], [1, 1, 2], [0, 1, 2]]];
 *     const quarter = new RationalPatch(net, [1, Math.SQRT1_2, 1, 1, Math.SQRT1_2, 1]);
 *
 * Other values of u and v extrapolate as long as the denominator is above 0.
 */
export class RationalPatch {
  #data: RationalPatchData;

  /**
   * The patch of the given net and weights.
   *
   * @param net (degreeU + 1)·(degreeV + 1) control points, u along the fast index: a flat list, or an array of degreeV
   *   + 1 rows; an array of numbers holds three for each point
   * @param weights a weight for each control point, from 2^-500 to 2^500
   * @param options by default what the lengths of the rows give, and 3 for a flat list
   * @throws {RangeError} for a wrong count, a NaN or an infinity, and for a weight that is not above 0
   */
  constructor(net: NetLike, weights: ArrayLike<number>, options?: { degreeU?: number; degreeV?: number }) {
    if (!isShown) show();
    this.#data = checkedData<RationalPatchData>(net) ?? dataOf(net, weights, options);
  }

  /** The degree in u. */
  get degreeU() {
    return this.#data.degreeU;
  }

  /** The degree in v. */
  get degreeV() {
    return this.#data.degreeV;
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
   * Whether both have the same degrees, each control point lies within a distance of its counterpart, and the weights are
   * equal up to a common factor, each within `tolerance` times the largest weight.
   *
   * @param other the value to compare with
   * @param tolerance by default 0: equal coordinates and weights
   */
  equals(other: RationalPatch, tolerance = 0): boolean {
    const { flat, weights, degreeU, degreeV } = this.#data;
    const patch = rationalPatchData(other, "other");
    const sameDegrees = degreeU === patch.degreeU && degreeV === patch.degreeV;
    if (!samePoints(flat, patch.flat, 3, tolerance) || !sameDegrees) return false;
    const factor = weights[0] / patch.weights[0];
    const max = tolerance * Math.max(...weights);
    return weights.every((w, i) => Math.abs(w - patch.weights[i] * factor) <= max);
  }

  /** The patch as an object for JSON, from which `RationalPatch.fromJSON` makes an equal patch. */
  toJSON(): { net: number[][]; weights: number[]; degreeU: number; degreeV: number } {
    const { flat, weights, degreeU, degreeV } = this.#data;
    return { net: nested(flat, 3), weights: [...weights], degreeU, degreeV };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "rationalpatch" {
    return "rationalpatch";
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  casteljauData(): RationalPatchData {
    return this.#data;
  }

  /**
   * Writes the patch, and then further numbers, to the arena.
   *
   * @returns the degrees
   */
  #write(further: ArrayLike<number> = []): [number, number] {
    const { flat, weights, degreeU, degreeV } = this.#data;
    const view = surfacesModule.write(flat, weights.length + further.length);
    view.set(weights, flat.length);
    view.set(further, flat.length + weights.length);
    return [degreeU, degreeV];
  }

  /** Reads a patch from the arena. */
  #read(end: number, degreeU: number, degreeV: number, from = 0): RationalPatch {
    const numbers = surfacesModule.read(from, end);
    return rationalPatchOf(numbers, degreeU, degreeV);
  }

  /**
   * Writes the patch for a query at (u, v).
   *
   * @returns the arguments of the core's function
   * @throws {RangeError} outside of [0, 1] where the patch has no point
   */
  #at(u: number, v: number): [number, number, number, number] {
    check.finite(u, "u");
    check.finite(v, "v");
    if (!this._hasPointAt(u, v)) throw noPointAt(u, v);
    return [...this.#write(), u, v];
  }

  /**
   * Whether the denominator is above 0, as it is in [0, 1].
   *
   * @internal
   */
  _hasPointAt(u: number, v: number): boolean {
    if (u >= 0 && u <= 1 && v >= 0 && v <= 1) return true;
    return !Number.isNaN(
      surfacesModule.read(0, surfacesModule.functions.rationalpatch_eval(...this.#write(), u, v))[0],
    );
  }

  /**
   * The point at (u, v).
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   * @throws {RangeError} outside of [0, 1] where the denominator is not above 0
   */
  eval(u: number, v: number): Point<3> {
    return pointAt(surfacesModule.read(0, surfacesModule.functions.rationalpatch_eval(...this.#at(u, v))), 0, 3);
  }

  /**
   * The first and second partial derivatives at (u, v).
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   * @throws {RangeError} as `eval`
   */
  partials(u: number, v: number): Partials {
    const numbers = surfacesModule.read(0, surfacesModule.functions.rationalpatch_partials(...this.#at(u, v)));
    const at = (k: number) => pointAt(numbers, 3 * k, 3);
    return { u: at(0), v: at(1), uu: at(2), uv: at(3), vv: at(4) };
  }

  /**
   * The unit normal at (u, v) in the direction of ∂u × ∂v. At collapsed edges it is the limit; it is zero for a patch
   * that is a curve or a point.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   * @throws {RangeError} as `eval`
   */
  normal(u: number, v: number): Point<3> {
    return pointAt(surfacesModule.read(0, surfacesModule.functions.rationalpatch_normal(...this.#at(u, v))), 0, 3);
  }

  /**
   * The curvatures at (u, v), with the signs and limits of `Patch.curvature`.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   * @throws {RangeError} as `eval`
   */
  curvature(u: number, v: number): Curvature {
    const [gaussian, mean, k1, k2] = surfacesModule.read(
      0,
      surfacesModule.functions.rationalpatch_curvature(...this.#at(u, v)),
    );
    return { gaussian, mean, k1, k2 };
  }

  /**
   * The curve u = constant, which runs along v.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @throws {RangeError} where a weight of the curve would not be above 0
   */
  isocurveAtU(u: number): RationalCurve<3> {
    return this.#isocurve(true, check.finite(u, "u"));
  }

  /**
   * The curve v = constant, which runs along u.
   *
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   * @throws {RangeError} where a weight of the curve would not be above 0
   */
  isocurveAtV(v: number): RationalCurve<3> {
    return this.#isocurve(false, check.finite(v, "v"));
  }

  #isocurve(constantU: boolean, at: number): RationalCurve<3> {
    const numbers = surfacesModule.read(
      0,
      surfacesModule.functions.rationalpatch_isocurve(...this.#write(), constantU, at),
    );
    const weights = (numbers.length / 4) * 3;
    return rationalCurveOf(
      { flat: numbers.slice(0, weights), dimension: 3 },
      numbers.slice(weights),
    ) as RationalCurve<3>;
  }

  /**
   * Splits the patch at u into two.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @throws {RangeError} where a weight of a part would not be above 0
   */
  splitU(u: number): [RationalPatch, RationalPatch] {
    return this.#split(true, check.finite(u, "u"));
  }

  /**
   * Splits the patch at v into two.
   *
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   * @throws {RangeError} where a weight of a part would not be above 0
   */
  splitV(v: number): [RationalPatch, RationalPatch] {
    return this.#split(false, check.finite(v, "v"));
  }

  #split(alongU: boolean, at: number): [RationalPatch, RationalPatch] {
    const degrees = this.#write();
    const end = surfacesModule.functions.rationalpatch_split(...degrees, alongU, at);
    return [this.#read(end < 0 ? end : end / 2, ...degrees), this.#read(end, ...degrees, end / 2)];
  }

  /**
   * The same patch with both degrees raised by one.
   *
   * @throws {RangeError} at degree 64
   */
  elevate(): RationalPatch {
    const [degreeU, degreeV] = this.#write();
    return this.#read(surfacesModule.functions.rationalpatch_elevate(degreeU, degreeV), degreeU + 1, degreeV + 1);
  }

  /**
   * The patch transformed by an affine map, which keeps the weights, or by a projective map, which changes them; see
   * `RationalCurve.transform`.
   *
   * @param matrix 6 or 16 numbers, a DOMMatrix or another object with a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} as there
   */
  transform(matrix: TransformLike): RationalPatch {
    const { flat, weights, degreeU, degreeV } = this.#data;
    const numbers = projective(matrix, 3);
    if (numbers)
      return this.#read(surfacesModule.functions.rationalpatch_project(...this.#write(numbers)), degreeU, degreeV);
    return patchOf({ flat: transformed(flat, matrix), weights, degreeU, degreeV });
  }

  /** The smallest box that contains the patch, exact up to rounding; see `Patch.bounds`. */
  bounds(): Bounds<3> {
    return boxAt(surfacesModule.read(0, surfacesModule.functions.rationalpatch_bounds(...this.#write())), 3);
  }

  /** The patch as JSON: `String(patch)` and `${patch}` give this text. */
  toString(): string {
    return JSON.stringify(this);
  }

  /**
   * A patch with the weights 1, or a rational patch itself.
   *
   * @param patch of any entry point
   */
  static from(patch: CorePatch | RationalPatch): RationalPatch {
    if (typeOf(patch) === "rationalpatch") {
      return patchOf(rationalPatchData(patch, "patch"));
    }
    const data = patchData(patch, "patch");
    return patchOf({ ...data, weights: new Float64Array(data.flat.length / 3).fill(1) });
  }

  /**
   * The patch that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: RationalPatchJSON): RationalPatch {
    requireJSON(json, "net and weights", ({ net, weights }) => net !== undefined && weights !== undefined);
    const { net, weights, degreeU, degreeV } = json;
    return rationalPatchFrom(net, weights, { degreeU, degreeV });
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(RationalPatch.prototype, "RationalPatch", (value) => value.toJSON());
}

// Outside of the class, see ../curve/core-curve.js.
function rationalPatchFrom(net: NetLike, weights: ArrayLike<number>, degrees: { degreeU?: number; degreeV?: number }) {
  return new RationalPatch(net, weights, degrees);
}

const patchOf = (data: RationalPatchData): RationalPatch => fromChecked(RationalPatch, data);

function dataOf(
  net: NetLike,
  weights: ArrayLike<number>,
  options?: { degreeU?: number; degreeV?: number },
): RationalPatchData {
  const data = netData(net, options);
  return { ...data, weights: checkedWeights(weights, data.flat.length / 3) };
}

/**
 * A patch from numbers that are checked.
 *
 * @internal
 * @param numbers the coordinates of the net, then the weights
 */
export function rationalPatchOf(numbers: Float64Array, degreeU: number, degreeV: number): RationalPatch {
  const at = (numbers.length / 4) * 3;
  return patchOf({ flat: numbers.slice(0, at), weights: numbers.slice(at), degreeU, degreeV });
}

/**
 * The error for parameters at which the denominator is 0.
 *
 * @internal
 */
export function noPointAt(u: number, v: number): RangeError {
  return new RangeError(`u, v: expected parameters at which the denominator is above 0, got ${u}, ${v}`);
}

/**
 * The images of points in space under an affine map.
 *
 * @internal
 */
export function transformed(flat: Float64Array, matrix: TransformLike): Float64Array {
  surfacesModule.write(flat, 12).set(affine(matrix), flat.length);
  return surfacesModule.read(0, surfacesModule.functions.points_transform(3, flat.length / 3));
}
