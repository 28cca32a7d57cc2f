// Rational curves of the plane. With the homogeneous points (w x, w y, w) they are curves in space; dividing by w projects them back.
import { Curve, Spline } from "casteljau";

/** @typedef {import("./plane.js").Point} Point */

/**
 * @param {readonly Point[]} points
 * @param {readonly number[]} weights
 */
const homogeneous = (points, weights) => points.map(([x, y], i) => [weights[i] * x, weights[i] * y, weights[i]]);

/** @param {{ x: number, y: number, z: number }} point @returns {Point} */
const projected = ({ x, y, z }) => [x / z, y / z];

/**
 * A rational Bézier curve as a function of t.
 *
 * @param {readonly Point[]} points
 * @param {readonly number[]} weights
 * @returns {(t: number) => Point}
 */
export function rationalCurve(points, weights) {
  const curve = new Curve(homogeneous(points, weights));
  return (t) => projected(/** @type {any} */ (curve.eval(t)));
}

/**
 * A NURBS curve as a function of t, for clamped knots from 0 to 1.
 *
 * @param {readonly Point[]} points
 * @param {readonly number[]} weights
 * @param {readonly number[]} knots points + degree + 1 of them
 * @returns {(t: number) => Point}
 */
export function nurbsCurve(points, weights, knots) {
  const degree = knots.length - points.length - 1;
  const spline = Spline.fromBSpline(homogeneous(points, weights), { degree, knots: [...knots], dimension: 3 });
  const ends = [...new Set(knots)];
  return (t) => {
    const k = Math.max(
      0,
      ends.findLastIndex((knot, i) => knot <= t && i < ends.length - 1),
    );
    return projected(/** @type {any} */ (spline.eval(k + (t - ends[k]) / (ends[k + 1] - ends[k]))));
  };
}

/**
 * The rational basis functions at t: how much each point counts.
 *
 * @param {readonly number[]} weights
 * @param {readonly number[]} knots
 * @param {number} t
 */
export function rationalBasis(weights, knots, t) {
  const degree = knots.length - weights.length - 1;
  const products = weights.map((w, i) => w * basis(knots, degree, i, t));
  const sum = products.reduce((a, b) => a + b, 0);
  return products.map((product) => product / sum);
}

/** N of Cox and de Boor. @param {readonly number[]} knots @param {number} degree @param {number} i @param {number} t @returns {number} */
function basis(knots, degree, i, t) {
  if (degree === 0) {
    const isLast = t >= knots[knots.length - 1] && knots[i] < knots[i + 1] && knots[i + 1] === knots[knots.length - 1];
    return (knots[i] <= t && t < knots[i + 1]) || isLast ? 1 : 0;
  }
  const part = (/** @type {number} */ numerator, /** @type {number} */ width) => (width > 0 ? numerator / width : 0);
  return (
    part(t - knots[i], knots[i + degree] - knots[i]) * basis(knots, degree - 1, i, t) +
    part(knots[i + degree + 1] - t, knots[i + degree + 1] - knots[i + 1]) * basis(knots, degree - 1, i + 1, t)
  );
}

/** @param {Point} a @param {Point} b */
const distance = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

/**
 * The weight of the middle point for which a conic is an arc of a circle: the cosine of the angle between the chord and a leg. Null
 * unless both legs are equally long.
 *
 * @param {readonly Point[]} points
 */
export function circleWeight([p0, p1, p2]) {
  const [first, second] = [distance(p0, p1), distance(p1, p2)];
  return Math.abs(first - second) <= 0.01 * (first + second) ? distance(p0, p2) / (first + second) : null;
}
