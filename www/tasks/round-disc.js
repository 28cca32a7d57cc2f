import { formatNumber, verdict } from "./utils/surfaces.js";

const WANTED = 0.01;

/** @param {{ flatness?: number, mesh: { error: number | null, unit: string, triangles: number } }} figure */
export function check({ flatness, mesh: { error, unit, triangles } }) {
  if (triangles === 0) return verdict(false, "The figure has not been drawn yet: scroll to it.");
  if (flatness !== undefined)
    return verdict(
      false,
      `${triangles} triangles, and “flat enough” is content at any distance. Choose the other recipe.`,
    );
  const done = error !== null && unit === "" && error <= WANTED;
  return verdict(done, done ? `Round, within ${formatNumber(error, 3)}.` : "Round, but not within 0.01 yet.");
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { flatness: null, tolerance: WANTED });
