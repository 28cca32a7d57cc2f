// The answers of paper.js: cubic curves in the plane. Quadratic curves and lines are raised to cubics, which are the same curves.
import library from "paper/dist/paper-core.js";
import { tuple } from "../answers.js";

/** @typedef {import("../facts.js").Input} Input */
/** @typedef {import("../facts.js").Fact} Fact */

/** Its types are those of scripts that know it as a global name. */
const paper = /** @type {any} */ (library);

paper.setup(new paper.Size(100, 100));

/** @param {number[][]} points @returns {number[][]} */
function cubic(points) {
  if (points.length === 4) return points;
  const n = points.length;
  return cubic([
    points[0],
    ...points.slice(1).map((to, i) => to.map((x, axis) => ((i + 1) * points[i][axis] + (n - i - 1) * x) / n)),
    points[n - 1],
  ]);
}

/** The segments of a path, or undefined for points that it does not claim. @param {number[][]} points */
function segmentsOf(points) {
  if (points.length > 4 || points[0].length !== 2) return undefined;
  const [a, b, c, d] = cubic(points);
  const minus = (/** @type {number[]} */ [x, y], /** @type {number[]} */ [u, v]) => [x - u, y - v];
  return { first: { point: a, handleOut: minus(b, a) }, last: { point: d, handleIn: minus(c, d) } };
}

/** @param {number[][]} points */
function curveOf(points) {
  const segments = segmentsOf(points);
  return segments && new paper.Curve(new paper.Segment(segments.first), new paper.Segment(segments.last));
}

/** @param {number[][]} points */
function pathOf(points) {
  const segments = segmentsOf(points);
  return segments && new paper.Path({ segments: [segments.first, segments.last], insert: false });
}

/**
 * An answer for curves that it claims.
 *
 * @param {(curve: any, input: Input, fact: Fact) => unknown} answer
 */
const of = (answer) => (/** @type {Input} */ input, /** @type {Fact} */ fact) => {
  const curve = curveOf(input.points);
  return curve && answer(curve, input, fact);
};

/** The control points of a curve. @param {any} curve */
const pointsOf = ({ point1, handle1, handle2, point2 }) =>
  [point1, point1.add(handle1), point2.add(handle2), point2].map(tuple);

/** @param {Input} input */
const intersect = ({ a, b }) => {
  const [first, second] = [curveOf(a), curveOf(b)];
  if (!first || !second) return undefined;
  const found = first.getIntersections(second);
  if (found.some((/** @type {any} */ location) => location.hasOverlap())) return { overlap: true };
  return {
    t: found.map((/** @type {any} */ { time }) => time),
    s: found.map((/** @type {any} */ { intersection }) => intersection.time),
  };
};

/** Steps of each curve at which an arc is looked at. */
const ARC_STEPS = 32;
const CIRCLE_STEPS = 1000;

/** @param {any} curve @param {number} steps */
const samples = (curve, steps) => Array.from({ length: steps + 1 }, (_, i) => tuple(curve.getPointAtTime(i / steps)));

/** @type {import("../answers.js").Answers} */
export const answers = {
  eval: of((curve, { t }) => tuple(curve.getPointAtTime(t))),
  derivative: of((curve, { t, order }) => (order === 1 ? tuple(curve.getWeightedTangentAtTime(t)) : undefined)),
  tangent: of((curve, { t }) => tuple(curve.getTangentAtTime(t))),
  curvature: of((curve, { t }) => curve.getCurvatureAtTime(t)),
  bbox: of((curve) => {
    const { left, top, right, bottom } = curve.bounds;
    return { min: [left, top], max: [right, bottom] };
  }),
  inflection: of((curve) => {
    const { type, roots } = curve.classify();
    return type === "serpentine" ? [...roots].filter((t) => t > 0 && t < 1).sort((a, b) => a - b) : [];
  }),
  // It has no type for a single point.
  classify: of((curve, { points }) => (new Set(points.map(String)).size > 1 ? curve.classify().type : undefined)),
  split: of((curve, { t }) => ({ left: pointsOf(curve.getPart(0, t)), right: pointsOf(curve.getPart(t, 1)) })),
  subsegment: of((curve, { t0, t1 }) => pointsOf(curve.getPart(t0, t1))),
  length: of((curve) => curve.length),
  inverse_length: of((curve, { s }) => curve.getTimeAt(s === "length" ? curve.length : s)),
  nearest: of((curve, { query }) => {
    const { time, point, distance } = curve.getNearestLocation(query);
    return { t: time, point: tuple(point), distance };
  }),
  line_intersect: intersect,
  intersect,
  selfintersect: ({ points }) =>
    pathOf(points)
      ?.getIntersections()
      .map((/** @type {any} */ { time, intersection }) => [time, intersection.time].sort((a, b) => a - b)),
  area: ({ svg }) => {
    if (!svg) return undefined;
    const path = new paper.CompoundPath(svg);
    return { abs_area: Math.abs(path.area), perimeter: path.length };
  },
  flatten: ({ points, tolerance }) => {
    const path = pathOf(points);
    path?.flatten(tolerance);
    return path?.segments.map((/** @type {any} */ { point }) => tuple(point));
  },
  circle: ({ k }) => {
    const quarter = curveOf([
      [1, 0],
      [1, k],
      [k, 1],
      [0, 1],
    ]);
    return samples(quarter, CIRCLE_STEPS);
  },
  svgpath: ({ d }) => new paper.Path(d).curves.flatMap((/** @type {any} */ curve) => samples(curve, ARC_STEPS)),
  convert: ({ catmull_rom: points }) => {
    if (!points) return undefined;
    const path = new paper.Path({ segments: points, insert: false });
    path.smooth({ type: "catmull-rom", factor: 0 });
    return pointsOf(path.curves[1]);
  },
  "rational perimeter": ({ rx, ry }) => new paper.Path.Ellipse({ center: [0, 0], radius: [rx, ry] }).length,
};
