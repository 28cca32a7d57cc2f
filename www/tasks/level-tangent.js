import { firstCurve, verdict } from "./utils/curves.js";

/** Half a degree: what a slider in steps of a hundredth can reach. */
const LEVEL = 0.02;

export const predict = {
  options: ["It bends the most there", "It is highest or lowest there", "It is half-way there"],
  answer: 1,
  because: "The last leg is the tangent: where it lies level, the curve neither climbs nor falls.",
};

/** @param {{ t: number, pieces: { curve: any }[] }} figure */
export function check(figure) {
  const { x, y } = firstCurve(figure).tangent(figure.t);
  const degrees = Math.abs((Math.atan2(y, x) * 180) / Math.PI);
  const slope = Math.min(degrees, 180 - degrees);
  const inside = figure.t > 0 && figure.t < 1;
  return verdict(
    inside && Math.abs(y) < LEVEL,
    `At t = ${figure.t.toFixed(2)} the last leg slopes by ${slope.toFixed(1)}°.`,
  );
}

/** @param {{ t: number, figure: any }} element */
export function reveal(element) {
  const [t] = firstCurve(element.figure).extrema().y;
  if (t !== undefined) element.t = t;
}
