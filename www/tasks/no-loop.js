import { farthest, splineOf } from "../figures/lib/families.js";
import { verdict } from "./utils/curves.js";

/** A spline passes through points from which it is closer than this, in the units of the figure. */
const ON = 1e-6;

export const predict = {
  options: ["the natural spline", "the centripetal spline", "both"],
  answer: 1,
  because:
    "Both the Catmull–Rom spline and the natural spline give each piece the same time. A short piece gets velocities that suit its long neighbours, so its handles are much too long for it. The centripetal spline gives a short piece less time.",
};

/** @param {unknown} _figure @param {{ points: [number, number][], family: any, tension: number }} element */
export function check(_figure, { points, family, tension }) {
  if (!splineOf("catmull-rom", points, 0).selfIntersections().length)
    return verdict(false, "The Catmull–Rom spline of these points does not cross itself yet.");
  if (family === "catmull-rom")
    return verdict(false, "The Catmull–Rom spline crosses itself. Now choose another family.");
  const spline = splineOf(family, points, tension);
  if (farthest(spline, points) > ON) return verdict(false, "This curve does not pass through the points.");
  if (spline.selfIntersections().length) return verdict(false, "This spline crosses itself, too.");
  if (family === "cardinal" && tension === 1) return verdict(false, "With the tension 1 the spline has corners.");
  return verdict(true, "Through the same points, without a corner, and no loop.");
}

/** P2 close to P1: a short piece between two long ones. @param {any} element */
export const reveal = (element) =>
  void Object.assign(element, {
    points: element.points.with(2, [element.points[1][0] + 6, element.points[1][1] - 1]),
    family: "centripetal",
  });
