import { firstCurve, verdict } from "./utils/curves.js";

/** @param {{ pieces: { curve: any }[] }} figure */
export function check(figure) {
  const ts = firstCurve(figure).inflections();
  if (ts.length === 0) return verdict(false, "There is no inflection now: make an S first.");
  const [t] = [...ts].sort((a, b) => Math.abs(a - 0.5) - Math.abs(b - 0.5));
  return verdict(Math.abs(t - 0.5) < 0.01, `There is an inflection at t = ${t.toFixed(3)}.`);
}

/** Half a turn about the middle maps such a curve onto itself. @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const [p0, p1, , p3] = element.points;
  element.points = [p0, p1, [p0[0] + p3[0] - p1[0], p0[1] + p3[1] - p1[1]], p3];
}
