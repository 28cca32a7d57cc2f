// The rational basis functions of a NURBS curve, and the weight of an arc of a circle.
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

/** Legs whose cosine with the chord is above this count as parts of the chord. */
const MAX_COSINE = 0.999;

/**
 * The weight of the middle point for which a conic with the weights 1, w, 1 is an arc of a circle: the cosine of the angle between
 * the chord and a leg. Null unless both legs are equally long and off the chord.
 *
 * @param {readonly (readonly [number, number])[]} points three of them
 */
export function circleWeight([[x0, y0], [x1, y1], [x2, y2]]) {
  const [first, second] = [Math.hypot(x1 - x0, y1 - y0), Math.hypot(x2 - x1, y2 - y1)];
  const cosine = Math.hypot(x2 - x0, y2 - y0) / (first + second);
  const isCircle = Math.abs(first - second) <= 0.01 * (first + second) && cosine > 0 && cosine <= MAX_COSINE;
  return isCircle ? cosine : null;
}
