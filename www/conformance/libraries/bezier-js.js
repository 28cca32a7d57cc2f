// The answers of bezier-js: quadratic and cubic curves.
import { Bezier } from "bezier-js";
import { tuple } from "../answers.js";

/** @typedef {import("../facts.js").Input} Input */
/** @typedef {import("../facts.js").Fact} Fact */

/** The curve, or undefined for a degree that it does not claim. @param {number[][]} points */
const bezier = (points) =>
  points.length === 3 || points.length === 4
    ? new Bezier(points[0].length === 3 ? points.map(([x, y, z]) => ({ x, y, z })) : points.map(([x, y]) => ({ x, y })))
    : undefined;

/**
 * An answer for curves of these degrees.
 *
 * @param {(curve: any, input: Input, fact: Fact) => unknown} answer
 */
const of = (answer) => (/** @type {Input} */ input, /** @type {Fact} */ fact) => {
  const curve = bezier(input.points);
  return curve && answer(curve, input, fact);
};

/** The threshold of its intersections is a length; by default it is half a pixel. @param {number[][]} points */
const thresholdOf = (points) => 1e-6 * Math.max(...points.flat().map(Math.abs));

/** @param {string[]} pairs "t/u" */
const parameters = (pairs) => pairs.map((pair) => pair.split("/").map(Number));

const inside = (/** @type {number[]} */ ts) => ts.filter((t) => t > 0 && t < 1).sort((a, b) => a - b);
/** Points of each of the curves of an offset. */
const OFFSET_STEPS = 32;

/** @type {import("../answers.js").Answers} */
export const answers = {
  eval: of((curve, { t }) => tuple(curve.get(t))),
  eval_rational: of((curve, { t, weights }) => {
    curve.setRatios(weights);
    const { x, y } = curve.get(t);
    return [x, y];
  }),
  derivative: of((curve, { t, order }) => tuple(order === 1 ? curve.derivative(t) : curve.dderivative(t))),
  tangent: of((curve, { t }) => {
    const { x, y } = curve.derivative(t);
    return [x, y].map((each) => each / Math.hypot(x, y));
  }),
  curvature: of((curve, { t }) => curve.curvature(t).k),
  bbox: of((curve) => {
    const box = Object.values(curve.bbox());
    return { min: box.map(({ min }) => min), max: box.map(({ max }) => max) };
  }),
  extrema: of((curve) => {
    const { x, y } = curve.extrema();
    return { x: inside(x), y: inside(y) };
  }),
  inflection: of((curve) => inside(curve.inflections())),
  split: of((curve, { t }) => {
    const { left, right } = curve.split(t);
    return { left: left.points.map(tuple), right: right.points.map(tuple) };
  }),
  subsegment: of((curve, { t0, t1 }) => curve.split(t0, t1).points.map(tuple)),
  elevate: of((curve) => curve.raise().points.map(tuple)),
  length: of((curve) => curve.length()),
  nearest: of((curve, { query: [x, y] }) => {
    const { t, d, ...point } = curve.project({ x, y });
    return { t, point: tuple(point), distance: d };
  }),
  line_intersect: ({ a, b }) => {
    const [p1, p2] = b.map((/** @type {number[]} */ [x, y]) => ({ x, y }));
    const curve = bezier(a);
    return curve && b.length === 2 ? { t: curve.intersects({ p1, p2 }) } : undefined;
  },
  intersect: ({ a, b }, { expect }) => {
    const [first, second] = [bezier(a), bezier(b)];
    if (!first || !second || expect.overlap) return undefined;
    const found = parameters(first.intersects(second, thresholdOf([...a, ...b])));
    return { t: found.map(([t]) => t), s: found.map(([, u]) => u) };
  },
  selfintersect: of((curve, { points }) => parameters(curve.selfintersects(thresholdOf(points)))),
  circle: ({ k }) => {
    const quarter = bezier([
      [1, 0],
      [1, k],
      [k, 1],
      [0, 1],
    ]);
    return quarter?.getLUT(1000).map(tuple);
  },
  offset: of((curve, { distance }) =>
    curve.offset(distance).flatMap((/** @type {any} */ part) => part.getLUT(OFFSET_STEPS).map(tuple)),
  ),
};
