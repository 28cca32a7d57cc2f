import { verdict } from "../surfaces/judge.js";

const WANTED = 100;

/** @param {{ segments: number, ratio: number }} figure @param {any} element */
export function check({ segments, ratio }, element) {
  if (ratio <= WANTED) return verdict(false, `At ${segments} segments it is ${ratio.toFixed(1)} times as much.`);
  const before = element.ratioAt(segments - 1);
  if (before > WANTED) return verdict(false, `${ratio.toFixed(1)} times: enough, but not the first.`);
  return verdict(true, `At ${segments} segments: ${ratio.toFixed(1)} times; one fewer makes ${before.toFixed(1)}.`);
}

/** @param {any} element */
export function reveal(element) {
  let segments = 1;
  while (element.ratioAt(segments) <= WANTED) segments++;
  element.segments = segments;
}
