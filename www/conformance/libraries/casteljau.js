// The answers of this library.
import { Curve, easing, Path, Spline } from "casteljau";
import { NurbsCurve, RationalCurve } from "casteljau/nurbs";
import { pairsOf, tuple } from "../answers.js";

/** @typedef {import("../facts.js").Input} Input */

const curveOf = (/** @type {Input} */ { points }) => new Curve(points);
const rationalOf = (/** @type {Input} */ { points, weights }) => new RationalCurve(points, weights);
const bounds = (/** @type {{ bounds(): { min: any, max: any } | null }} */ curve) => {
  const box = curve.bounds();
  return box && { min: tuple(box.min), max: tuple(box.max) };
};
const extrema = (
  /** @type {{ extrema(): { x: ArrayLike<number>, y: ArrayLike<number>, z?: ArrayLike<number> } }} */ curve,
) => {
  const { x, y, z } = curve.extrema();
  return { x: Array.from(x), y: Array.from(y), ...(z && { z: Array.from(z) }) };
};
const nearest = (/** @type {{ t: number, point: any, distance: number }} */ { t, point, distance }) => ({
  t,
  point: tuple(point),
  distance,
});
/** @param {any[]} found intersections @param {Curve} curve the first of both */
const meetings = (found, curve) => {
  const isOverlap = found.some(({ kind }) => kind === "overlap");
  if (isOverlap) return { overlap: true };
  return { t: found.map(({ t }) => t), s: found.map(({ u }) => u), points: found.map(({ t }) => tuple(curve.eval(t))) };
};
const intersect = (/** @type {Input} */ { a, b }) => meetings(new Curve(a).intersections(new Curve(b)), new Curve(a));
const piece = (/** @type {RationalCurve} */ curve) => ({
  points: curve.points().map(tuple),
  weights: Array.from(curve.weights()),
});
/** The facts about arcs are exact to nine digits. */
const ARC_TOLERANCE = 1e-10;

/** @type {import("../answers.js").Answers} */
export const answers = {
  eval: (input) => tuple(curveOf(input).eval(input.t)),
  eval_rational: (input) => tuple(rationalOf(input).eval(input.t)),
  derivative: (input) => tuple(curveOf(input).derivativeAt(input.t, input.order)),
  tangent: (input) => tuple(curveOf(input).tangent(input.t)),
  curvature: (input) => curveOf(input).curvature(input.t),
  bbox: (input) => bounds(curveOf(input)),
  extrema: (input) => extrema(curveOf(input)),
  inflection: (input) => Array.from(curveOf(input).inflections()),
  classify: (input) => curveOf(input).classify(),
  selfintersect: (input) =>
    curveOf(input)
      .selfIntersections()
      .map(({ t, u }) => [t, u]),
  split: (input) => {
    const [left, right] = curveOf(input)
      .split(input.t)
      .map((half) => pairsOf(half.controlPoints()));
    return { left, right };
  },
  subsegment: (input) => pairsOf(curveOf(input).subsegment(input.t0, input.t1).controlPoints()),
  elevate: (input) => pairsOf(curveOf(input).elevate().controlPoints()),
  reduce: (input) => {
    const { curve, error } = curveOf(input).reduce();
    return { points: pairsOf(curve.controlPoints()), error };
  },
  length: (input) => curveOf(input).length(),
  inverse_length: (input) => {
    const curve = curveOf(input);
    return curve.timeAtLength(input.s === "length" ? curve.length() : input.s);
  },
  nearest: (input) => nearest(curveOf(input).nearest(input.query)),
  line_intersect: intersect,
  intersect,
  min_distance: ({ a, b }) => {
    const { distance, t, u } = new Curve(a).distanceTo(new Curve(b));
    return { distance, t, s: u };
  },
  area: (input) => {
    if (!input.svg) return curveOf(input).area();
    const path = Path.fromSVG(input.svg);
    return { abs_area: Math.abs(path.area()), perimeter: path.length() };
  },
  easing: ({ bezier, x }) => easing(.../** @type {[number, number, number, number]} */ (bezier))(x),
  circle: ({ k }) => pairsOf(new Curve([1, 0, 1, k, k, 1, 0, 1]).sample(10_000)),
  convert: (input) => {
    if (input.catmull_rom) return pairsOf(Curve.fromBasis("catmull-rom", input.catmull_rom).controlPoints());
    const monomials = pairsOf(curveOf(input).toBasis([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])).reverse();
    return { x: monomials.map(([x]) => x), y: monomials.map(([, y]) => y) };
  },
  bspline: ({ points, degree, knots, u }) => tuple(new NurbsCurve({ degree, points, knots }).eval(u)),
  continuity: ({ a, b }) => {
    const { c0, g1, c1, c2 } = Spline.fromCurves([new Curve(a), new Curve(b)]).continuity(1);
    return { C0: c0, G1: g1, C1: c1, C2: c2 };
  },
  offset: (input, { tol }) => {
    const spline = curveOf(input).offset(input.distance, { tolerance: tol / 10 });
    return pairsOf(spline.sample(64));
  },
  flatten: (input) => pairsOf(curveOf(input).flatten(input.tolerance).points),
  svgpath: ({ d }) => {
    const path = Path.fromSVG(d, { tolerance: ARC_TOLERANCE });
    return path.subpaths.flatMap((spline) => pairsOf(spline.sample(32)));
  },
  solve_t: ({ points, x }) => Array.from(new Curve(points).timesAtCoordinate({ x })),

  "rational length": (input) => rationalOf(input).length(),
  "rational time_at_length": (input) => rationalOf(input).timeAtLength(input.length),
  "rational extrema": (input) => extrema(rationalOf(input)),
  "rational bounds": (input) => bounds(rationalOf(input)),
  "rational nearest": (input) => nearest(rationalOf(input).nearest(input.point)),
  "rational area": (input) => rationalOf(input).area(),
  "rational curvature": (input) => rationalOf(input).curvature(input.t),
  "rational split": (input) => {
    const [left, right] = rationalOf(input).split(input.t).map(piece);
    return { left, right };
  },
  "rational standard_form": (input) => Array.from(rationalOf(input).reparametrize().weights()),
  "rational inflections": (input) => Array.from(rationalOf(input).inflections()),
  "rational perimeter": ({ rx, ry }) => NurbsCurve.ellipse([0, 0], rx, ry).length(),
  "rational intersections": ({ a, b }) =>
    rationalOf(a)
      .intersections(rationalOf(b))
      .map(({ t, u }) => ({ t, s: u, point: tuple(rationalOf(a).eval(t)) })),
};
