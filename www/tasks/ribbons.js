import { formatCount, verdict } from "./utils/surfaces.js";

const [MOST, LEAST_STRIPS] = [5000, 4];

/** @param {{ layers: string[], lines: number, mesh: { triangles: number } }} figure */
export function check({ layers, lines, mesh: { triangles } }) {
  if (layers.join(" ") !== "ribbons") return verdict(false, "Show ribbons, and nothing else.");
  if (lines < LEAST_STRIPS) return verdict(false, `${lines === 1 ? "One strip is" : `${lines} strips are`} too few.`);
  const done = triangles < MOST;
  return verdict(done, `${formatCount(triangles)} triangles${done ? "." : ": too many."}`);
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { show: "ribbons", lines: LEAST_STRIPS });
