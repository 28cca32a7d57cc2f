// What the applet says: the label at P3, the description of the figure, the announcements.
import { FEWEST_POINTS } from "./state.js";
import { POINTS_PER_SEGMENT } from "../editor/plane.js";
import { translated } from "../editor/translations.js";
import type { State } from "./state.js";
import type { Derived } from "./derive.js";

export type Label = { verdict: "C1" | "G1" | "C0" | ""; text: string };

const RADIAN_IN_DEGREES = 180 / Math.PI;

export const title = () => translated("Bézier curve with control points that can be moved");

export const instructions = () =>
  translated(
    "Every control point is a pair of sliders, x and y. Tab goes from point to point in the order of the curve. " +
      "The arrow keys move a point by 1 pixel, with Shift by 10, with Alt by a tenth.",
  );

/** What is true at P3, and nothing else. */
export function jointLabel({ continuity, points }: Derived): Label {
  if (!continuity) return { verdict: "", text: translated("One cubic Bézier curve: P0 to P3, no joint.") };
  if (continuity.c1)
    return { verdict: "C1", text: translated("P2, P3, P4 aligned and |P2P3| = |P3P4|: G1 and C1 at P3.") };
  const lengths = [distance(points[2], points[3]), distance(points[3], points[4])];
  if (continuity.g1) {
    return {
      verdict: "G1",
      text: translated("P2, P3, P4 aligned: G1 at P3. C1 when |P2P3| = |P3P4|; now {0} and {1}.", ...lengths),
    };
  }
  const angle = degrees(continuity.angle);
  const text = Number.isFinite(continuity.angle)
    ? translated("Broken at P3: the tangent turns by {0}. P2, P3, P4 are not aligned.", angle)
    : translated("Broken at P3: no tangent on one side. P2, P3, P4 are not aligned.");
  return { verdict: "C0", text };
}

function distance(a: number[], b: number[]): string {
  return String(Math.round(10 * Math.hypot(a[0] - b[0], a[1] - b[1])) / 10);
}

/** Two digits at least, so that a small angle does not read as none. */
function degrees(radians: number): string {
  const value = Math.abs(radians) * RADIAN_IN_DEGREES;
  return `${value >= 10 ? Math.round(value) : Number(value.toPrecision(2))}°`;
}

export function isOnCurve(index: number): boolean {
  return index % POINTS_PER_SEGMENT === 0;
}

/** The picture in words. */
export function description(state: State, derived: Derived): string {
  const { points } = derived;
  const segments = (points.length - 1) / POINTS_PER_SEGMENT;
  const anchors = points.map(place).filter((_, i) => isOnCurve(i));
  const handles = points.map(place).filter((_, i) => !isOnCurve(i));
  const places = [anchors.join(", "), handles.join(", ")];
  const kind =
    segments === 1
      ? translated("One cubic Bézier curve through {0}, with {1} off the curve.", ...places)
      : translated(
          "{2} cubic Bézier curves joined end to end through {0}, with {1} off the curve.",
          ...places,
          segments,
        );
  return `${kind} ${jointLabel(derived).text} ${translated("t is {0}", state.t.toFixed(2))}.`;
}

export function place([x, y]: number[], index: number): string {
  return translated("{0} at {1}", `P${index}`, `${Math.round(x)}, ${Math.round(y)}`);
}

/** How many points are shown, for the button and the announcement. */
export function shownWords(state: State): string {
  return state.shown === FEWEST_POINTS
    ? translated("4 points shown: one cubic")
    : translated("{0} points shown", state.shown);
}
