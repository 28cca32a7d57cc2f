import { firstCurve, verdict } from "./utils/curves.js";

/** The sine of about 1°: what a slider in steps of a hundredth can reach. */
const LEVEL = 0.02;

export const predict = {
  options: ["It bends most sharply there", "It is highest or lowest there", "It is the middle of the curve"],
  answer: 1,
  because: "The last leg is the tangent. Where the tangent is horizontal, the curve goes neither up nor down.",
};

/** @param {{ t: number, pieces: { curve: any }[] }} figure */
export function check(figure) {
  const { x, y } = firstCurve(figure).tangent(figure.t);
  const degrees = Math.abs((Math.atan2(y, x) * 180) / Math.PI);
  const slope = Math.min(degrees, 180 - degrees);
  const inside = figure.t > 0 && figure.t < 1;
  return verdict(
    inside && Math.abs(y) < LEVEL,
    `At t = ${figure.t.toFixed(2)} the slope of the last leg is ${slope.toFixed(1)}°.`,
  );
}

/** @param {{ t: number, figure: any }} element */
export function reveal(element) {
  const [t] = firstCurve(element.figure).extrema().y;
  if (t !== undefined) element.t = t;
}
