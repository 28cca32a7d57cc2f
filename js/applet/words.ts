// What the applet says: the label at P3, the description of the figure, the announcements.
import { placeWords } from "../editor/descriptions.js";
import { translated } from "../editor/translations.js";
import type { Continuity, Figure } from "../editor/figure.js";

export type Label = { verdict: "C1" | "G1" | "C0" | ""; text: string };

const RADIAN_IN_DEGREES = 180 / Math.PI;

export const title = () => translated("Bézier curve with control points that can be moved");

export const instructions = () =>
  translated(
    "Every control point is a pair of sliders, x and y. Tab goes from point to point in the order of the curve. " +
      "The arrow keys move a point by 1 pixel, with Shift by 10, with Alt by a tenth.",
  );

/** What holds at P3; null where P3 is an end. */
export function continuityAtP3({ spline }: Figure): Continuity | null {
  return spline && spline.segmentCount > 1 ? spline.continuity(1) : null;
}

/** What is true at P3, and nothing else. */
export function jointLabel(figure: Figure): Label {
  const { points } = figure;
  const continuity = continuityAtP3(figure);
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

function distance(a: readonly number[], b: readonly number[]): string {
  return String(Math.round(10 * Math.hypot(a[0] - b[0], a[1] - b[1])) / 10);
}

/** Two digits at least, so that a small angle does not read as none. */
function degrees(radians: number): string {
  const value = Math.abs(radians) * RADIAN_IN_DEGREES;
  return `${value >= 10 ? Math.round(value) : Number(value.toPrecision(2))}°`;
}

/** The picture in words. */
export function description(figure: Figure, t: number): string {
  const { points, pieces, kinds } = figure;
  const placesOf = (kind: string) =>
    points
      .map((_, i) => place(figure, i))
      .filter((_, i) => kinds[i] === kind)
      .join(", ");
  const places = [placesOf("on"), placesOf("off")];
  const kind =
    pieces.length === 1
      ? translated("One cubic Bézier curve through {0}, with {1} off the curve.", ...places)
      : translated(
          "{2} cubic Bézier curves joined end to end through {0}, with {1} off the curve.",
          ...places,
          pieces.length,
        );
  return `${kind} ${jointLabel(figure).text} ${translated("t is {0}", t.toFixed(2))}.`;
}

export function place({ names, points }: Figure, index: number): string {
  return translated("{0} at {1}", names[index], placeWords(points[index]));
}
