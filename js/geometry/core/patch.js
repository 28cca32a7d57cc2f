import { curveOf } from "./curve.js";
import { CorePatch } from "../patch/core-patch.js";
import { netInBasis, patchArguments } from "../patch/patch-value.js";
import { CheckedPoints } from "../../wasm/transfer.js";

/**
 * @import { BasisLike } from "../basis.js"
 * @import { Curve } from "./curve.js"
 * @import { NetLike } from "../net.js"
 * @import { PatchJSON } from "../patch/patch-value.js"
 */

/**
 * One tensor-product Bézier patch of degrees 1 to 64 in u and in v, in 3D.
 *
 * S(u, v) = Σ Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with the net index j·(degreeU + 1) + i: u runs along the fast index. The corners are
 * returned exactly. Patches are immutable: every change returns a new one.
 *
 * @extends {CorePatch<Curve<3>>}
 */
export class Patch extends CorePatch {
  /**
   * The bicubic patch of sixteen geometry points in another basis: each row and then each column is converted to the
   * Bézier basis.
   *
   *     const patch = Patch.fromBasis("b-spline", net);
   *
   * @param {BasisLike} basis
   * @param {NetLike} net row by row; in the Hermite basis, a row holds two points and two derivatives in u, and the
   *   last two rows are derivatives in v
   * @returns {Patch}
   */
  static fromBasis(basis, net) {
    return patchOf(netInBasis(basis, net), 3, 3);
  }

  /**
   * @param {PatchJSON} json what `toJSON` returned
   * @returns {Patch}
   */
  static fromJSON(json) {
    return patchWith(...patchArguments(json));
  }

  /**
   * @internal
   * @override
   * @param {Float64Array} flat
   * @returns {Curve<3>}
   */
  _curveOf(flat) {
    return /** @type {Curve<3>} */ (curveOf(new CheckedPoints(flat, 3)));
  }

  /**
   * @internal
   * @override
   * @param {Float64Array} flat
   * @param {number} degreeU
   * @param {number} degreeV
   * @returns {this}
   */
  _patchOf(flat, degreeU, degreeV) {
    return /** @type {this} */ (patchOf(flat, degreeU, degreeV));
  }
}

// Outside of the class, see curve.js.

/**
 * @param {NetLike} net
 * @param {{ degreeU?: number, degreeV?: number }} options
 * @returns {Patch}
 */
function patchWith(net, options) {
  return new Patch(net, options);
}

/**
 * @internal
 * @param {Float64Array} flat
 * @param {number} degreeU
 * @param {number} degreeV
 * @returns {Patch}
 */
export function patchOf(flat, degreeU, degreeV) {
  return patchWith(/** @type {any} */ (new CheckedPoints(flat, 3)), { degreeU, degreeV });
}
