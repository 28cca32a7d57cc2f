// Points with noise beside a known curve, and what fits them.
import { Path, Spline } from "../modules/fitting.js";

/** @typedef {[number, number]} Point */

/** The curve from which the points are taken, in the units of the figure. */
export const ORIGINAL = new Spline([
  [8, 70],
  [20, 20],
  [34, 6],
  [50, 26],
  [66, 46],
  [62, 74],
  [80, 74],
  [98, 74],
  [104, 40],
  [120, 14],
]);

const COUNT = 90;

/** Directions and parts of the noise, the same each time: a linear congruential generator. */
const NOISE = (() => {
  let state = 2;
  const random = () => {
    state = (state * 1664525 + 1013904223) % 2 ** 32;
    return state / 2 ** 32;
  };
  return Array.from({ length: COUNT }, () => ({ angle: 2 * Math.PI * random(), part: Math.sqrt(random()) }));
})();

/** Points of the curve, each moved by up to `noise`. @param {number} noise @returns {Point[]} */
export const samplesOf = (noise) =>
  NOISE.map(({ angle, part }, i) => {
    const { x, y } = ORIGINAL.eval((ORIGINAL.segmentCount * i) / (COUNT - 1));
    return [x + noise * part * Math.cos(angle), y + noise * part * Math.sin(angle)];
  });

/**
 * The spline within a tolerance of the points.
 *
 * @param {readonly Point[]} points
 * @param {number} tolerance
 */
export function fitOf(points, tolerance) {
  const spline = Spline.fit(/** @type {Point[]} */ ([...points]), { tolerance });
  const error = Math.max(...points.map((point) => spline.nearest(point).distance));
  return { spline, error, cubics: spline.segmentCount };
}

const CORNERS = 240;

/** An outline of many lines: a flower with five petals. */
export const OUTLINE = Path.polygon(
  Array.from({ length: CORNERS }, (_, i) => {
    const angle = (2 * Math.PI * i) / CORNERS;
    const radius = 32 * (1 + 0.22 * Math.sin(5 * angle));
    return /** @type {Point} */ ([64 + radius * Math.cos(angle), 42 + radius * Math.sin(angle)]);
  }),
);
