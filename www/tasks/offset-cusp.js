import { firstCurve, verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The distance may be too small by this. */
const ALLOWED_PX = 3;
const STEPS = 2000;

/** The control points as the page places them. @type {[number, number][]} */
export const POINTS = [
  [80, 400],
  [250, 20],
  [420, 20],
  [590, 400],
];

export const predict = {
  options: ["about 45 px", "about 115 px", "about 255 px"],
  answer: 1,
  because:
    "The curve bends most sharply at the top. The curvature there is 510 · 2280 / 510³ ≈ 0.00877, so the radius of curvature is 114 px. At this distance a point of the offset curve reaches the centre of the circle of curvature, stops, and turns back.",
};

/** The curvature where it is greatest, with its sign. @param {{ curvature(t: number): number }} curve */
const sharpest = (curve) =>
  Array.from({ length: STEPS + 1 }, (_, i) => curve.curvature(i / STEPS)).reduce((best, k) =>
    Math.abs(k) > Math.abs(best) ? k : best,
  );

/** @param {{ points: [number, number][], pieces: { curve: any }[] }} figure @param {{ offset: number }} element */
export function check(figure, element) {
  const moved = movedPoints(figure.points, POINTS);
  if (moved) return moved;
  const { offset } = element;
  const radius = 1 / sharpest(firstCurve(figure));
  const inner = offset * Math.sign(radius);
  if (inner <= 0) return verdict(false, `${offset} px is on the outer side.`);
  const spare = Math.abs(radius) - inner;
  if (spare < 0) return verdict(false, `At ${offset} px there are cusps.`);
  return verdict(
    spare <= ALLOWED_PX,
    spare <= ALLOWED_PX
      ? `${offset} px: the smallest radius of curvature is ${Math.abs(radius).toFixed(1)} px.`
      : `At ${offset} px there are no cusps yet.`,
  );
}

/** @param {{ points: [number, number][], figure: any, offset: number }} element */
export function reveal(element) {
  element.points = POINTS;
  const radius = 1 / sharpest(firstCurve(element.figure));
  element.offset = Math.trunc(radius);
}
