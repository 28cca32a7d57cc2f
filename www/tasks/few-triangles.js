import { formatCount, formatNumber, verdict } from "./utils/surfaces.js";

const [WANTED, MOST] = [0.01, 10000];

/** @param {{ mesh: { error: number | null, unit: string, triangles: number } }} figure */
export function check({ mesh: { error, unit, triangles } }) {
  if (error === null) return verdict(false, "“Flat enough” promises no distance from the surface.");
  if (unit !== "") return verdict(false, "Pixels depend on where you look from. Choose a distance.");
  if (error > WANTED) return verdict(false, `The error may be ${formatNumber(error, 3)}: too much.`);
  const done = triangles < MOST;
  return verdict(
    done,
    `${formatCount(triangles)} triangles${done ? ": where the pot is nearly flat they are large." : ", but they need not be as many."}`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { flatness: null, pixels: null, tolerance: WANTED });
