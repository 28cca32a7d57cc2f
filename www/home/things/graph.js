// The graph of a timing function in its picture. The build draws the first one with it.

const [LEFT, RIGHT, BOTTOM, TOP] = [36, 236, 164, 60];
/** Values beyond 0 and 1 that the picture has room for. */
const [MIN_Y, MAX_Y] = [-0.25, 1.3];

/** x1, y1, x2, y2 of `cubic-bezier()`. @type {readonly number[]} */
export const FIRST_CURVE = [0.34, 1.3, 0.64, 1];

/** @param {number} x */
const xOf = (x) => LEFT + x * (RIGHT - LEFT);
/** @param {number} y */
export const yOf = (y) => BOTTOM - y * (BOTTOM - TOP);

const clamp = (/** @type {number} */ x, /** @type {number} */ min, /** @type {number} */ max) =>
  Math.round(100 * Math.min(max, Math.max(min, x))) / 100;

/** The numbers of the control point at a place of the picture, to a hundredth. @param {number} x @param {number} y */
export const valueAt = (x, y) => [
  clamp((x - LEFT) / (RIGHT - LEFT), 0, 1),
  clamp((BOTTOM - y) / (BOTTOM - TOP), MIN_Y, MAX_Y),
];

/** What is drawn of a curve: its control points, levers and path. @param {readonly number[]} curve */
export function graphOf([x1, y1, x2, y2]) {
  const [p1, p2] = [
    [xOf(x1), yOf(y1)],
    [xOf(x2), yOf(y2)],
  ].map((point) => point.map((x) => Number(x.toFixed(1))));
  return {
    points: [p1, p2],
    levers: `M${LEFT} ${BOTTOM}L${p1.join(" ")}M${RIGHT} ${TOP}L${p2.join(" ")}`,
    path: `M${LEFT} ${BOTTOM}C${p1.join(" ")} ${p2.join(" ")} ${RIGHT} ${TOP}`,
    css: `cubic-bezier(${[x1, y1, x2, y2].join(", ")})`,
  };
}
