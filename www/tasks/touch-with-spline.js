import { PRECISION_PX, distance, px, verdict } from "./utils/curves.js";

/** How far the spline may be from P2, and how near two control points may come to each other. */
const [ALLOWED_PX, APART_PX] = [2, 20];

/** @param {{ points: [number, number][], basis: string, pieces: { curve: any }[] }} figure */
export function check({ points, basis, pieces }) {
  if (basis !== "b-spline")
    return verdict(false, "Keep the B-spline. The other splines pass through their points anyway.");
  const isOnePlace = points.some((a, i) => points.slice(0, i).some((b) => distance(a, b) < APART_PX));
  if (isOnePlace) return verdict(false, `Two points are in one place: keep all points at least ${APART_PX} px apart.`);
  const off = Math.min(...pieces.map(({ curve }) => curve.nearest(points[2]).distance));
  const words = `The distance from P2 to the spline is ${px(off)}.`;
  if (off > ALLOWED_PX) return verdict(false, words);
  const [, p1, p2, p3] = points;
  const isMiddle = distance([(p1[0] + p3[0]) / 2, (p1[1] + p3[1]) / 2], p2) <= 2 * PRECISION_PX;
  return verdict(true, `${words}${isMiddle ? " P2 is the midpoint of P1 and P3." : ""}`);
}

/** @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const { points } = element;
  element.points = points.with(2, [(points[1][0] + points[3][0]) / 2, (points[1][1] + points[3][1]) / 2]);
}
