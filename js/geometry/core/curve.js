import { pointsInBasis } from "../basis.js";
import { CoreCurve } from "../curve/core-curve.js";
import { curvePointsOf } from "../curve/curve-value.js";
import { CheckedPoints } from "../../wasm/transfer.js";

/**
 * @import { BasisLike } from "../basis.js"
 * @import { PointsLike } from "../check.js"
 * @import { CurveJSON } from "../curve/curve-value.js"
 * @import { PointArrays } from "../points.js"
 */

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
 *
 * @template {2 | 3} [D=2 | 3]
 * @extends {CoreCurve<D>}
 */
export class Curve extends CoreCurve {
  /**
   * The cubic of four geometry points in another basis, [t³ t² t 1]·M·G.
   *
   * @template {2 | 3} [D=2 | 3]
   * @param {BasisLike} basis "hermite" (P0, P1, M0, M1), "b-spline", "catmull-rom", "bezier", or a matrix, row-major
   * @param {PointArrays<D> | PointsLike} points four points
   * @param {{ dimension?: D }} [options] `dimension`: 2 or 3, how a flat array is read; 2 by default
   * @returns {Curve<D>}
   */
  static fromBasis(basis, points, options) {
    return /** @type {Curve<D>} */ (curveOf(pointsInBasis(basis, points, options)));
  }

  /**
   * @param {CurveJSON} json what `toJSON` returned
   * @returns {Curve}
   */
  static fromJSON(json) {
    return curveOf(curvePointsOf(json));
  }

  /**
   * @internal
   * @override
   * @param {Float64Array} flat
   * @returns {this}
   */
  _curveOf(flat) {
    return /** @type {this} */ (curveOf(new CheckedPoints(flat, this.dimension)));
  }
}

// Outside of the class, see ../curve/curve.js.

/**
 * @internal
 * @param {CheckedPoints} points
 * @returns {Curve}
 */
export function curveOf(points) {
  return new Curve(/** @type {any} */ (points));
}
