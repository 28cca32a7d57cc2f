import { basisNumbers } from "../basis.js";
import { patchData } from "../brand.js";
import { affine } from "../affine.js";
import * as check from "../check.js";
import { degreeOfRows, netNumbers } from "../net.js";
import { nested, samePoints, writePoint } from "../points.js";
import { core, writeArguments, readResult } from "../../wasm/surfaces-transfer.js";
import { CheckedPoints } from "../../wasm/transfer.js";

/**
 * @import { BasisLike } from "../basis.js"
 * @import { PatchData } from "../brand.js"
 * @import { TransformLike, PointLike } from "../check.js"
 * @import { NetLike } from "../net.js"
 */

/**
 * What `Patch.toJSON` returns; `Patch.fromJSON` also reads other forms of nets.
 *
 * @typedef {object} PatchJSON
 * @property {NetLike} net
 * @property {number} [degreeU] 3 by default
 * @property {number} [degreeV] 3 by default
 */

/**
 * The net of a patch: splitting and other changes of it. The members with an underscore are for the classes that extend
 * this one, see `CurveValue`.
 */
export class PatchValue {
  /** @type {Float64Array} */
  #flat;
  /** @type {number} */
  #degreeU;
  /** @type {number} */
  #degreeV;

  /**
   * The patch of the given net of control points.
   *
   * @param {NetLike} net (degreeU + 1)·(degreeV + 1) control points, u along the fast index: a flat list, or an array of
   *   degreeV + 1 rows; an array of numbers holds three for each point
   * @param {{ degreeU?: number, degreeV?: number }} [options] by default what the lengths of the rows give, and 3 for a
   *   flat list
   * @throws {RangeError} for a wrong count, a NaN or an infinity
   */
  constructor(net, options) {
    const { degreeU = degreeOfRows(net, "u"), degreeV = degreeOfRows(net, "v") } = check.options(options, [
      "degreeU",
      "degreeV",
    ]);
    this.#degreeU = check.whole(degreeU, "degreeU", 1, 64);
    this.#degreeV = check.whole(degreeV, "degreeV", 1, 64);
    const checked = /** @type {unknown} */ (net);
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
   * @returns {Float64Array} a copy of the coordinates of the net
   */
  controlPoints() {
    return this.#flat.slice();
  }

  /**
   * Whether both have the same degrees and each control point lies within a distance of its counterpart.
   *
   * @param {PatchValue} other the value to compare with
   * @param {number} [tolerance] the largest distance of two control points, by default 0
   * @returns {boolean}
   */
  equals(other, tolerance = 0) {
    const { flat, degreeU } = patchData(other, "other");
    return this.#degreeU === degreeU && samePoints(this.#flat, flat, 3, tolerance);
  }

  /**
   * Splits the patch at u into two.
   *
   * @param {number} u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param {never[]} surplus
   * @returns {[this, this]}
   */
  splitU(u, ...surplus) {
    check.noSurplus(surplus, "splitU", 1, "split(u, v)");
    return this.#split(true, check.finite(u, "u"));
  }

  /**
   * Splits the patch at v into two.
   *
   * @param {number} v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   * @param {never[]} surplus
   * @returns {[this, this]}
   */
  splitV(v, ...surplus) {
    check.noSurplus(surplus, "splitV", 1, "split(u, v)");
    return this.#split(false, check.finite(v, "v"));
  }

  /**
   * Splits the patch at (u, v) into four: before both, after u, after v, after both.
   *
   * @param {number} u the parameter along the fast index of the net, from 0 to 1; others extrapolate
   * @param {number} v the parameter along the slow index of the net, from 0 to 1; others extrapolate
   * @returns {[this, this, this, this]}
   */
  split(u, v) {
    check.finite(u, "u");
    const [below, above] = this.splitV(v);
    return [...below.splitU(u), ...above.splitU(u)];
  }

  /**
   * The same patch with both degrees raised by one.
   *
   * @param {never[]} surplus
   * @returns {this}
   * @throws {RangeError} at degree 64
   */
  elevate(...surplus) {
    check.noSurplus(surplus, "elevate", 0);
    writeArguments(this.#flat);
    const length = core().patch_elevate(this.#degreeU, this.#degreeV);
    return this._patchOf(readResult(0, length), this.#degreeU + 1, this.#degreeV + 1);
  }

  /**
   * The patch transformed by an affine map.
   *
   * @param {TransformLike} matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @returns {this}
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform(matrix) {
    writeArguments(this.#flat, 12).set(affine(matrix), this.#flat.length);
    return this.#withNet(readResult(0, core().points_transform(3, this.#flat.length / 3)));
  }

  /**
   * The patch with one control point moved.
   *
   * @param {number} index the number of the control point, from 0
   * @param {PointLike} to the new position
   * @returns {this}
   */
  movePoint(index, to) {
    check.whole(index, "index", 0, this.#flat.length / 3 - 1);
    const flat = this.#flat.slice();
    writePoint(flat, 3 * index, to, 3, "to");
    return this.#withNet(flat);
  }

  /**
   * The patch as an object for JSON, from which `Patch.fromJSON` makes an equal patch.
   *
   * @returns {{ net: number[][], degreeU: number, degreeV: number }}
   */
  toJSON() {
    return { net: nested(this.#flat, 3), degreeU: this.#degreeU, degreeV: this.#degreeV };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   * @returns {"patch"}
   */
  get casteljauType() {
    return "patch";
  }

  /**
   * @internal
   * @returns {PatchData}
   */
  casteljauData() {
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
   * @param {Float64Array} flat
   * @param {number} degreeU
   * @param {number} degreeV
   * @returns {this}
   */
  _patchOf(flat, degreeU, degreeV) {
    throw new TypeError(`expected a class that makes ${degreeU} × ${degreeV} patches of ${flat.length} numbers`);
  }

  /**
   * @internal
   * Writes the net to the arena.
   *
   * @param {number} u
   * @param {number} v
   * @returns {[number, number, number, number]} the arguments of the core's functions of (u, v)
   */
  _writeAt(u, v) {
    check.finite(u, "u");
    check.finite(v, "v");
    writeArguments(this.#flat);
    return [this.#degreeU, this.#degreeV, u, v];
  }

  /**
   * @param {Float64Array} flat
   */
  #withNet(flat) {
    return this._patchOf(flat, this.#degreeU, this.#degreeV);
  }

  /**
   * @param {boolean} alongU
   * @param {number} at
   * @returns {[this, this]}
   */
  #split(alongU, at) {
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
 * @param {BasisLike} basis
 * @param {NetLike} net
 * @returns {Float64Array}
 */
export function netInBasis(basis, net) {
  const matrix = basisNumbers(basis);
  writeArguments(netNumbers(net, 3, 3), 16).set(matrix, 48);
  return readResult(0, core().patch_from_basis());
}

/**
 * The arguments of the constructor for a patch in JSON.
 *
 * @internal
 * @param {PatchJSON} json
 * @returns {[NetLike, { degreeU?: number, degreeV?: number }]}
 */
export function patchArguments(json) {
  if (typeof json !== "object" || json === null) {
    throw new TypeError(`json: expected an object with net, got ${check.describe(json)}`);
  }
  return [json.net, { degreeU: json.degreeU, degreeV: json.degreeV }];
}
