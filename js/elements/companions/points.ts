// The points that a companion has of its own while it is linked to nothing.
import { readPoints } from "../../ui/numbers.js";

export type Point2 = [number, number];
/** Points as text or as pairs. */
export type PointsLike = string | ArrayLike<number>[] | null;
export type Check = <T>(name: string, value: T, usable: boolean, expected: string, fallback: T) => T;

/** The first curve of the applet. */
export const FIRST_POINTS: Point2[] = [
  [70, 330],
  [110, 90],
  [235, 120],
  [325, 230],
];

/** The points of an attribute or a property, two at least; else the first curve's. */
export function ownPoints(given: PointsLike, check: Check): Point2[] {
  if (given === null || given === "") return FIRST_POINTS;
  const text = pointsText(given);
  try {
    const points = readPoints(text);
    if (points.length > 1) return points;
  } catch {
    // what is wrong is said below
  }
  check("points", text, false, "at least two points x,y x,y …", FIRST_POINTS.join(" "));
  return FIRST_POINTS;
}

/** As the attribute has them. */
export function pointsText(given: PointsLike) {
  return typeof given === "string" ? given : Array.from(given ?? [], (point) => Array.from(point).join(",")).join(" ");
}
