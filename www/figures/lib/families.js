// Splines of several families on the same points.
import { Curve, Spline } from "casteljau";

/** @typedef {[number, number]} Point */
/** @typedef {"bezier" | "natural" | "catmull-rom" | "centripetal" | "cardinal" | "b-spline"} Family */

/** @type {[Family, string][]} */
export const FAMILIES = [
  ["bezier", "One Bézier curve"],
  ["natural", "Natural"],
  ["catmull-rom", "Catmull–Rom"],
  ["centripetal", "Centripetal"],
  ["cardinal", "Cardinal"],
  ["b-spline", "B-spline"],
];

/**
 * The curve of a family.
 *
 * @param {Family} family
 * @param {readonly Point[]} points at least four
 * @param {number} tension of a cardinal spline, 0 to 1
 * @returns {Spline<2>}
 */
export function splineOf(family, points, tension) {
  const given = /** @type {Point[]} */ ([...points]);
  switch (family) {
    case "bezier":
      return Spline.fromCurves([new Curve(given)]);
    case "natural":
      return Spline.interpolate(given, { kind: "natural" });
    case "catmull-rom":
      return Spline.interpolate(given, { kind: "catmull-rom", alpha: 0 });
    case "centripetal":
      return Spline.interpolate(given, { kind: "catmull-rom", alpha: 0.5 });
    case "cardinal":
      return new Spline(cardinal(given, tension));
    case "b-spline":
      return Spline.fromBSpline(given);
  }
}

/**
 * The control points of a cardinal spline: the velocity at a point is (1 − tension) / 2 times the difference of its neighbours. At an
 * end, the missing neighbour is the reflection of the other one.
 *
 * @param {readonly Point[]} points
 * @param {number} tension
 */
function cardinal(points, tension) {
  const last = points.length - 1;
  const third = (1 - tension) / 6;
  const handle = points.map(([x, y], i) => {
    const [before, after] = [points[Math.max(i - 1, 0)], points[Math.min(i + 1, last)]];
    const factor = i === 0 || i === last ? 2 * third : third;
    return { x, y, dx: factor * (after[0] - before[0]), dy: factor * (after[1] - before[1]) };
  });
  return handle.flatMap(({ x, y, dx, dy }, i) => [
    ...(i > 0 ? [/** @type {Point} */ ([x - dx, y - dy])] : []),
    /** @type {Point} */ ([x, y]),
    ...(i < last ? [/** @type {Point} */ ([x + dx, y + dy])] : []),
  ]);
}

/** The greatest distance of a point from the spline. @param {Spline<2>} spline @param {readonly Point[]} points */
export const farthest = (spline, points) => Math.max(...points.map((point) => spline.nearest(point).distance));

/** The continuity that all joints have. With the velocity 0, a joint can be C1 and a corner. @param {Spline<2>} spline */
export function continuityOf(spline) {
  const joints = Array.from({ length: spline.segmentCount - 1 }, (_, i) => spline.continuity(i + 1));
  const all = (/** @type {"c2" | "c1" | "g1"} */ name) => joints.every((joint) => joint[name]);
  if (!all("g1")) return "with corners";
  return all("c2") ? "C2" : all("c1") ? "C1" : "G1";
}
