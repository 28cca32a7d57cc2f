import { Curve } from "casteljau";
import { distance, verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The sine of about 2°: what a slider in steps of a hundredth can reach. */
const LEVEL = 0.04;

/** The control points as the page places them. @type {[number, number][]} */
export const POINTS = [
  [70, 300],
  [160, 40],
  [400, 60],
  [610, 430],
];
/** Control points of the parts that are closer than this to those of a split have not been moved. */
const SAME_PX = 0.5;

export const predict = {
  options: ["on a vertical line", "on a horizontal line", "on the line through P0 and P3"],
  answer: 1,
  because:
    "The handles of an inserted point lie on the last leg, and that is the tangent. At the highest point the tangent is horizontal.",
};

/** Whether pieces are the parts of a curve, in order. @param {Curve} whole @param {Curve[]} pieces */
function arePartsOf(whole, pieces) {
  const ends = pieces.slice(0, -1).map((piece) => whole.nearest(piece.eval(1)).t);
  return pieces.every((piece, k) => {
    const part = whole.subsegment(k === 0 ? 0 : ends[k - 1], k < ends.length ? ends[k] : 1);
    const [found, expected] = [piece.controlPoints(), part.controlPoints()];
    return [0, 2, 4, 6].every((i) => distance([found[i], found[i + 1]], [expected[i], expected[i + 1]]) <= SAME_PX);
  });
}

/** @param {{ points: [number, number][], pieces: { curve: any }[] }} figure */
export function check({ points, pieces }) {
  const curves = pieces.map(({ curve }) => curve);
  const whole = new Curve(POINTS);
  if (curves.length < 2)
    return movedPoints(points, POINTS) ?? verdict(false, "The curve is still one piece. Move t and press Split at t.");
  const restore = (/** @type {any} */ element) => (element.points = POINTS);
  if (!arePartsOf(whole, curves))
    return { ...verdict(false, "The shape has changed. To insert a point keeps it."), restore };
  const isLevel = curves.slice(1).some((curve) => Math.abs(curve.tangent(0).y) < LEVEL);
  if (isLevel) return verdict(true, "The new point is the highest: both of its handles are horizontal.");
  const above = Math.min(...curves.slice(1).map((curve) => curve.eval(0).y)) - whole.bounds().min.y;
  return { ...verdict(false, `The curve rises ${above.toFixed(1)} px above the new point. Try another t.`), restore };
}

/** @param {{ points: [number, number][], insertJoint(t?: number): void, t: number }} element */
export function reveal(element) {
  const [t] = new Curve(POINTS).extrema().y;
  element.points = POINTS;
  element.t = t;
  element.insertJoint(t);
}
