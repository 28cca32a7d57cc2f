import { firstCurve, verdict } from "./utils/curves.js";

/** @param {{ pieces: { curve: any }[] }} figure */
export function check(figure) {
  const ts = firstCurve(figure).inflections();
  if (ts.length === 0) return verdict(false, "There is no inflection. Make an S first.");
  if (ts.length > 1) return verdict(false, "There are two inflections, and an S has one.");
  const [t] = ts;
  return verdict(Math.abs(t - 0.5) <= 0.01, `The inflection is at t = ${t.toFixed(3)}.`);
}

/** A curve that a rotation by 180° maps onto itself. @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const [p0, p1, , p3] = element.points;
  element.points = [p0, p1, [p0[0] + p3[0] - p1[0], p0[1] + p3[1] - p1[1]], p3];
}
