// An affine map of a curve, in both orders: map the control points and draw, or draw and map every point.
import { Curve } from "casteljau";

/** About the middle of the figure, y down. @type {[number, number][]} */
const POINTS = [
  [-60, 46],
  [-46, -52],
  [44, -58],
  [62, 30],
];
/** Dots on the curve. */
const DOTS = 16;

/**
 * A turn, then a shear, then a stretch of the width, as an SVG matrix.
 *
 * @param {{ turn: number, shear: number, width: number }} map turn in degrees
 * @returns {[number, number, number, number, number, number]}
 */
export function matrixOf({ turn, shear, width }) {
  const [c, s] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)];
  return [width * (c + shear * s), s, width * (shear * c - s), c, 0, 0];
}

/**
 * The two ways, and how far they are apart.
 *
 * @param {Parameters<typeof matrixOf>[0]} map
 */
export function bothWays(map) {
  const [a, b, c, d, e, f] = matrixOf(map);
  const before = new Curve(POINTS);
  const after = before.transform([a, b, c, d, e, f]);
  const dots = Array.from({ length: DOTS + 1 }, (_, i) => before.eval(i / DOTS)).map(
    ({ x, y }) => /** @type {[number, number]} */ ([a * x + c * y + e, b * x + d * y + f]),
  );
  const gap = Math.max(...dots.map(([x, y], i) => Math.hypot(x - after.eval(i / DOTS).x, y - after.eval(i / DOTS).y)));
  return { before, after, dots, gap };
}
