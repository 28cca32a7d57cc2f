import { verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The centre line as the page has it: its length is 60. @type {[number, number][]} */
export const POINTS = [
  [30, 42],
  [50, 42],
  [70, 42],
  [90, 42],
];
const LENGTH = 60;
const [ANGLE, ALLOWED] = [30, 1];

export const predict = {
  options: ["30", "34.6", "52"],
  answer: 0,
  because:
    "The radii at the points of contact are perpendicular to the side, so the side has the angle α with sin α = r′. For 30° the radius must grow by half the length, 60 / 2. With tan instead of sin it would be 34.6.",
};

/** @param {unknown} _figure @param {{ points: any[], first: number, last: number }} element */
export function check(_figure, { points, first, last }) {
  const moved = movedPoints(points, POINTS);
  if (moved) return moved;
  const slope = Math.abs(last - first) / LENGTH;
  if (slope >= 1) return verdict(false, "One disc covers all the others: there are no sides.");
  const angle = (180 / Math.PI) * Math.asin(slope);
  return verdict(Math.abs(angle - ANGLE) <= ALLOWED, `The angle of each side is ${angle.toFixed(1)}°.`);
}

/** @param {{ points: any[], first: number, last: number }} element */
export const reveal = (element) => void Object.assign(element, { points: POINTS, first: 4, last: 34 });
