import { basisNumbers } from "../basis.js";
import { patchData } from "../brand.js";
import { affine } from "../affine.js";
import * as check from "../check.js";
import { degreeOfRows, netNumbers } from "../net.js";
import { nested, samePoints, writePoint } from "../points.js";
import { core, writeArguments, readResult } from "../../wasm/surfaces-transfer.js";
import { CheckedPoints } from "../../wasm/transfer.js";
import type { BasisLike } from "../basis.js";
import type { PatchData } from "../brand.js";
import type { TransformLike, PointLike } from "../check.js";
import type { NetLike } from "../net.js";

/** What `Patch.toJSON` returns; `Patch.fromJSON` also reads other forms of nets. */
export interface PatchJSON {
  net: NetLike;
  /** 3 by default */
  degreeU?: number;
  /** 3 by default */
  degreeV?: number;
}

/**
 * The net of a patch: splitting and other changes of it. The members with an underscore are for the classes that extend
 * this one, see `CurveValue`.
 */
export class PatchValue {
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
    const { degreeU = degreeOfRows(net, "u"), degreeV = degreeOfRows(net, "v") } = check.options(options, [
      "degreeU",
      "degreeV",
    ]);
    this.#degreeU = check.whole(degreeU, "degreeU", 1, 64);
    this.#degreeV = check.whole(degreeV, "degreeV", 1, 64);
    const checked = net as unknown;
    this.#flat = checked instanceof CheckedPoints ? checked.flat : netNumbers(net, degreeU, degreeV);
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
  equals(other: PatchValue, tolerance = 0): boolean {
    const { flat, degreeU } = patchData(other, "other");
    return this.#degreeU === degreeU && samePoints(this.#flat, flat, 3, tolerance);
  }

  /**
   * Splits the patch at u into two.
   *
   * @param u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   */
  splitU(u: number, ...surplus: never[]): [this, this] {
    check.noSurplus(surplus, "splitU", 1, "split(u, v)");
    return this.#split(true, check.finite(u, "u"));
  }

  /**
   * Splits the patch at v into two.
   *
   * @param v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   */
  splitV(v: number, ...surplus: never[]): [this, this] {
    check.noSurplus(surplus, "splitV", 1, "split(u, v)");
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
  elevate(...surplus: never[]): this {
    check.noSurplus(surplus, "elevate", 0);
    writeArguments(this.#flat);
    const length = core().patch_elevate(this.#degreeU, this.#degreeV);
    return this._patchOf(readResult(0, length), this.#degreeU + 1, this.#degreeV + 1);
  }

  /**
   * The patch transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform(matrix: TransformLike): this {
    writeArguments(this.#flat, 12).set(affine(matrix), this.#flat.length);
    return this.#withNet(readResult(0, core().points_transform(3, this.#flat.length / 3)));
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
   * A patch of the same class. The class of each entry point implements it.
   *
   * @internal
   */
  _patchOf(flat: Float64Array, degreeU: number, degreeV: number): this {
    throw new TypeError(`expected a class that makes ${degreeU} × ${degreeV} patches of ${flat.length} numbers`);
  }

  /**
   * @internal
   * Writes the net to the arena.
   * @returns the arguments of the core's functions of (u, v)
   */
  _writeAt(u: number, v: number): [number, number, number, number] {
    check.finite(u, "u");
    check.finite(v, "v");
    writeArguments(this.#flat);
    return [this.#degreeU, this.#degreeV, u, v];
  }

  #withNet(flat: Float64Array) {
    return this._patchOf(flat, this.#degreeU, this.#degreeV);
  }

  #split(alongU: boolean, at: number): [this, this] {
    writeArguments(this.#flat);
    core().patch_split(this.#degreeU, this.#degreeV, alongU, at);
    const n = this.#flat.length;
    return [this.#withNet(readResult(0, n)), this.#withNet(readResult(n, 2 * n))];
  }
}

/**
 * The net of a patch in another basis.
 *
 * @internal
 */
export function netInBasis(basis: BasisLike, net: NetLike): Float64Array {
  const matrix = basisNumbers(basis);
  writeArguments(netNumbers(net, 3, 3), 16).set(matrix, 48);
  return readResult(0, core().patch_from_basis());
}

/**
 * The arguments of the constructor for a patch in JSON.
 *
 * @internal
 */
export function patchArguments(json: PatchJSON): [NetLike, { degreeU?: number; degreeV?: number }] {
  if (typeof json !== "object" || json === null) {
    throw new TypeError(`json: expected an object with net, got ${check.describe(json)}`);
  }
  return [json.net, { degreeU: json.degreeU, degreeV: json.degreeV }];
}
