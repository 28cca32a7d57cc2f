import { pointsInBasis } from "../basis.js";
import { CoreCurve, curvePointsOf } from "../curve/core-curve.js";
import { CheckedPoints } from "../../wasm/transfer.js";
import type { BasisLike } from "../basis.js";
import type { PointsLike } from "../check.js";
import type { CurveJSON } from "../curve/core-curve.js";
import type { PointArrays } from "../points.js";

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
   * @param json what `toJSON` returned
   */
  static fromJSON(json: CurveJSON): Curve {
    return curveOf(curvePointsOf(json));
  }

  /**
   * @internal
   */
  override _curveOf(flat: Float64Array): this {
    return curveOf(new CheckedPoints(flat, this.dimension)) as this;
  }
}

// Outside of the class, see ../curve/curve.js.

/**
 * @internal
 */
export function curveOf(points: CheckedPoints): Curve {
  return new Curve(points as any);
}
