import { formatNumber, verdict } from "./utils/surfaces.js";

const WANTED = 0.1;

export const predict = {
  options: ["about 8", "about 16", "about 60"],
  answer: 1,
  because: "1.5 must become 15 times smaller. The bound falls with the square, and √15 is about 3.9: 4 · 3.9 ≈ 15.5.",
};

/** The bound with 4 segments, as the text states it: rounded to tenths. */
const [BOUND_AT_4, BOUND_ROUNDED] = [1.5, 0.05];

/** The bound with 4 segments. @param {number} error the bound with n segments @param {number} n */
const boundAt4 = (error, n) => (error * n * n) / 16;

/** The error is proportional to the square of the step. @param {number} error @param {number} n */
const oneFewer = (error, n) => (error * n * n) / (n - 1) ** 2;

/** @param {{ segments: number | null, mesh: { error: number | null } }} figure */
export function check({ segments, mesh: { error } }) {
  if (segments === null || error === null) return verdict(false, "Use a uniform mesh, by segments.");
  if (Math.abs(boundAt4(error, segments) - BOUND_AT_4) > BOUND_ROUNDED)
    return {
      ...verdict(false, "The points of the patch have moved: with 4 segments the bound is no longer 1.5."),
      restore: (/** @type {any} */ element) => (element.surface = null),
    };
  if (error >= WANTED)
    return verdict(
      false,
      `With ${segments} segments the error can be ${formatNumber(error, 3)}, which is not below 0.1.`,
    );
  const spared = segments > 1 && oneFewer(error, segments) < WANTED;
  if (spared)
    return verdict(false, `The error is below 0.1 (${formatNumber(error, 3)}), but fewer segments are enough.`);
  return verdict(
    true,
    `With ${segments} segments the error is ${formatNumber(error, 3)}, with one fewer ${formatNumber(oneFewer(error, segments), 3)}.`,
  );
}

/** @param {any} element */
export function reveal(element) {
  const {
    segments,
    mesh: { error },
  } = element.figure;
  element.segments = Math.floor(segments * Math.sqrt(error / WANTED)) + 1;
}
