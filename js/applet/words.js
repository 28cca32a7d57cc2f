// What the applet says: the label at P3, the description of the figure, the announcements.
import { FEWEST_POINTS, POINTS_PER_SEGMENT } from "./state.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./derive.js").Derived} Derived */
/** @typedef {{ verdict: "C1" | "G1" | "C0" | "", text: string }} Label */

const RADIAN_IN_DEGREES = 180 / Math.PI;

export const TITLE = "Bézier curve with control points that can be moved";

export const INSTRUCTIONS =
  "Every control point is a pair of sliders, x and y. Tab goes from point to point in the order of the curve. " +
  "The arrow keys move a point by 1 pixel, with Shift by 10, with Alt by a tenth.";

/**
 * What is true at P3, and nothing else.
 *
 * @param {Derived} derived
 * @returns {Label}
 */
export function jointLabel({ continuity, points }) {
  if (!continuity) return { verdict: "", text: "One cubic Bézier curve: P0 to P3, no joint." };
  if (continuity.c1) return { verdict: "C1", text: "P2, P3, P4 aligned and |P2P3| = |P3P4|: G1 and C1 at P3." };
  const lengths = `${distance(points[2], points[3])} and ${distance(points[3], points[4])}`;
  if (continuity.g1) {
    return {
      verdict: "G1",
      text: `P2, P3, P4 aligned: G1 at P3. C1 when |P2P3| = |P3P4|; now ${lengths}.`,
    };
  }
  const angle = degrees(continuity.angle);
  const turn = Number.isFinite(continuity.angle) ? `the tangent turns by ${angle}` : "no tangent on one side";
  return { verdict: "C0", text: `Broken at P3: ${turn}. P2, P3, P4 are not aligned.` };
}

/**
 * @param {number[]} a
 * @param {number[]} b
 * @returns {string}
 */
function distance(a, b) {
  return String(Math.round(10 * Math.hypot(a[0] - b[0], a[1] - b[1])) / 10);
}

/**
 * Two digits at least, so that a small angle does not read as none.
 *
 * @param {number} radians
 * @returns {string}
 */
function degrees(radians) {
  const value = Math.abs(radians) * RADIAN_IN_DEGREES;
  return `${value >= 10 ? Math.round(value) : Number(value.toPrecision(2))}°`;
}

/**
 * @param {number} index
 * @returns {boolean}
 */
export function isOnCurve(index) {
  return index % POINTS_PER_SEGMENT === 0;
}

/**
 * The picture in words.
 *
 * @param {State} state
 * @param {Derived} derived
 * @returns {string}
 */
export function description(state, derived) {
  const { points } = derived;
  const segments = (points.length - 1) / POINTS_PER_SEGMENT;
  const kind = segments === 1 ? "One cubic Bézier curve" : `${segments} cubic Bézier curves joined end to end`;
  const anchors = points.map(place).filter((_, i) => isOnCurve(i));
  const handles = points.map(place).filter((_, i) => !isOnCurve(i));
  return (
    `${kind} through ${anchors.join(", ")}, with ${handles.join(", ")} off the curve. ` +
    `${jointLabel(derived).text} t is ${state.t.toFixed(2)}.`
  );
}

/**
 * @param {number[]} point
 * @param {number} index
 * @returns {string}
 */
export function place([x, y], index) {
  return `P${index} at ${Math.round(x)}, ${Math.round(y)}`;
}

/**
 * How many points are shown, for the button and the announcement.
 *
 * @param {State} state
 * @returns {string}
 */
export function shownWords(state) {
  return state.shown === FEWEST_POINTS ? "4 points shown: one cubic" : `${state.shown} points shown`;
}
