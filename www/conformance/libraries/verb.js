// The answers of verb: NURBS curves of any degree and dimension.
import verb from "verb-nurbs";

/** @typedef {import("../facts.js").Input} Input */

const { BezierCurve, Ellipse, Intersect, NurbsCurve } = verb.geom;

/** Tolerances: of parameters at a length, and of intersections; with a smaller one it finds the same intersections more than once. */
const TOLERANCE = 1e-12;
const INTERSECTION_TOLERANCE = 1e-6;
const CIRCLE_STEPS = 1000;

const curveOf = (/** @type {Input} */ { points, weights }) => new BezierCurve(points, weights);
const eval_ = (/** @type {Input} */ input) => curveOf(input).point(input.t);
const nearest = (/** @type {Input} */ input, /** @type {number[]} */ query) => {
  const curve = curveOf(input);
  const point = curve.closestPoint(query);
  const distance = Math.hypot(...point.map((/** @type {number} */ x, /** @type {number} */ axis) => x - query[axis]));
  return { t: curve.closestParam(query), point, distance };
};
/** @param {Input} a @param {Input} b */
const meetings = (a, b) => Intersect.curves(curveOf(a), curveOf(b), INTERSECTION_TOLERANCE);
/** @param {Input} input @param {import("../facts.js").Fact} fact */
const intersect = ({ a, b }, { expect }) => {
  if (expect.overlap) return undefined;
  const found = meetings({ points: a }, { points: b });
  return { t: found.map((/** @type {any} */ { u0 }) => u0), s: found.map((/** @type {any} */ { u1 }) => u1) };
};

/** @type {import("../answers.js").Answers} */
export const answers = {
  eval: eval_,
  eval_rational: eval_,
  derivative: (input) => curveOf(input).derivatives(input.t, input.order)[input.order],
  tangent: (input) => {
    const tangent = curveOf(input).tangent(input.t);
    return tangent.map((/** @type {number} */ x) => x / Math.hypot(...tangent));
  },
  split: (input) => {
    const [left, right] = curveOf(input).split(input.t);
    return { left: left.controlPoints(), right: right.controlPoints() };
  },
  elevate: (input) => {
    const curve = curveOf(input);
    const raised = verb.eval.Modify.curveElevateDegree(curve.asNurbs(), curve.degree() + 1);
    return new NurbsCurve(raised).controlPoints();
  },
  length: (input) => curveOf(input).length(),
  inverse_length: (input) => {
    const curve = curveOf(input);
    return curve.paramAtLength(input.s === "length" ? curve.length() : input.s, TOLERANCE);
  },
  nearest: (input) => nearest(input, input.query),
  line_intersect: intersect,
  intersect,
  circle: ({ k }) => {
    const quarter = curveOf({
      points: [
        [1, 0],
        [1, k],
        [k, 1],
        [0, 1],
      ],
    });
    return Array.from({ length: CIRCLE_STEPS + 1 }, (_, i) => quarter.point(i / CIRCLE_STEPS));
  },
  bspline: ({ points, degree, knots, u }) => NurbsCurve.byKnotsControlPointsWeights(degree, knots, points).point(u),
  "rational length": (input) => curveOf(input).length(),
  "rational time_at_length": (input) => curveOf(input).paramAtLength(input.length, TOLERANCE),
  "rational nearest": (input) => nearest(input, input.point),
  "rational split": (input) => {
    const [left, right] = curveOf(input)
      .split(input.t)
      .map((/** @type {any} */ part) => ({ points: part.controlPoints(), weights: part.weights() }));
    return { left, right };
  },
  "rational perimeter": ({ rx, ry }) => new Ellipse([0, 0], [rx, 0], [0, ry]).length(),
  "rational intersections": ({ a, b }) =>
    meetings(a, b).map((/** @type {any} */ { u0, u1, point0 }) => ({ t: u0, s: u1, point: point0 })),
};
