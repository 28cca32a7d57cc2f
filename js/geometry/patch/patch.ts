import { fromChecked } from "../checked.js";
import { curveOf } from "../curve/curve.js";
import { CorePatch, netInBasis, patchArguments } from "./core-patch.js";
import type { BasisLike } from "../basis.js";
import type { Curve } from "../curve/curve.js";
import type { NetLike } from "../net.js";
import type { PatchJSON } from "./core-patch.js";

/**
 * One tensor-product Bézier patch of degrees 1 to 64 in u and in v, in 3D.
 *
 * S(u, v) = Σ Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with the net index j·(degreeU + 1) + i: u runs along the fast index. The corners are
 * returned exactly. Patches are immutable: every change returns a new one.
 */
export class Patch extends CorePatch<Curve<3>> {
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
  static fromBasis(basis: BasisLike, net: NetLike): Patch {
    return patchOf(netInBasis(basis, net), 3, 3);
  }

  /**
   * The patch that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: PatchJSON): Patch {
    return patchWith(...patchArguments(json));
  }

  /**
   * A curve of the full class.
   *
   * @internal
   */
  override _curveOf(flat: Float64Array): Curve<3> {
    return curveOf({ flat, dimension: 3 }) as Curve<3>;
  }

  /**
   * A patch of the full class.
   *
   * @internal
   */
  override _patchOf(flat: Float64Array, degreeU: number, degreeV: number): this {
    return patchOf(flat, degreeU, degreeV) as this;
  }
}

// Outside of the class, see curve.js.

function patchWith(net: NetLike, options: { degreeU?: number; degreeV?: number }): Patch {
  return new Patch(net, options);
}

/**
 * A patch whose net is checked already.
 *
 * @internal
 */
export function patchOf(flat: Float64Array, degreeU: number, degreeV: number): Patch {
  return fromChecked(Patch, { flat, degreeU, degreeV });
}
