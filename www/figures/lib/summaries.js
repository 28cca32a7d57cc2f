// Sentences about what figures show.
import { Curve } from "casteljau";

/** A cubic's ends and the velocities there. @param {[number, number][]} points */
export function hermiteSummary(points) {
  if (points.length !== 4) return "";
  const data = new Curve(points).toBasis("hermite");
  const pair = (/** @type {number} */ i) => `(${Math.round(data[2 * i])}, ${Math.round(data[2 * i + 1])})`;
  return `From ${pair(0)} with the velocity ${pair(2)}, to ${pair(1)} with ${pair(3)}.`.replaceAll("-", "−");
}

/** What a subdivision tree measures. @param {{ segments: number, error: number } | null} tree */
export function treeSummary(tree) {
  if (!tree) return "";
  const error = tree.error < 0.01 ? tree.error.toExponential(1) : tree.error.toFixed(2);
  return `${tree.segments} ${tree.segments === 1 ? "piece" : "pieces"}, measured error ${error} px.`;
}
