import { formatNumber, verdict } from "./utils/surfaces.js";

const WANTED = 0.1;

/** The error goes with the square of the steps. @param {number} error @param {number} n */
const oneFewer = (error, n) => (error * n * n) / (n - 1) ** 2;

/** @param {{ segments: number | null, mesh: { error: number | null } }} figure */
export function check({ segments, mesh: { error } }) {
  if (segments === null || error === null) return verdict(false, "Cut evenly, by segments.");
  if (error >= WANTED)
    return verdict(false, `With ${segments} segments the error is ${formatNumber(error, 3)} at most: too much.`);
  const spared = segments > 1 && oneFewer(error, segments) < WANTED;
  if (spared) return verdict(false, `${formatNumber(error, 3)} is fine enough, but fewer segments would do.`);
  return verdict(
    true,
    `${segments} segments: ${formatNumber(error, 3)}; with one fewer it would be ${formatNumber(oneFewer(error, segments), 3)}.`,
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
