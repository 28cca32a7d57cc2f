import { formatNumber, verdict } from "./utils/surfaces.js";

const WANTED = 0.1;

export const predict = {
  options: ["about 8", "about 16", "about 60"],
  answer: 1,
  because: "1.5 must become 15 times smaller. The bound falls with the square, and √15 is about 3.9: 4 · 3.9 ≈ 15.5.",
};

/** The error is proportional to the square of the step. @param {number} error @param {number} n */
const oneFewer = (error, n) => (error * n * n) / (n - 1) ** 2;

/** @param {{ segments: number | null, mesh: { error: number | null } }} figure */
export function check({ segments, mesh: { error } }) {
  if (segments === null || error === null) return verdict(false, "Use a uniform mesh, by segments.");
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
