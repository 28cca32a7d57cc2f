// The rational basis functions of a NURBS curve.
import { NurbsCurve } from "casteljau/nurbs";

/**
 * The factor of each control point at the given parameters. A basis function is the x of the curve if its own point is (1, 0)
 * and all others are (0, 0).
 *
 * @param {NurbsCurve} curve
 * @param {ArrayLike<number>} ts
 * @returns {number[][]} for each point its factor at each parameter
 */
export function rationalBasis(curve, ts) {
  const { degree, closed } = curve;
  const [weights, knots] = [curve.weights(), curve.knots()];
  return Array.from(weights, (_, i) => {
    const points = Array.from(weights, (_, k) => [k === i ? 1 : 0, 0]);
    const values = new NurbsCurve({ degree, closed, points, weights, knots }).evalAt(ts);
    return [...values].filter((_, k) => k % 2 === 0);
  });
}
