import { formatCount, formatNumber, verdict } from "./utils/surfaces.js";

/** The limits that the task states. */
const [MAX_ERROR, MAX_TRIANGLES] = [0.01, 10000];

export const predict = {
  options: ["uniformly", "by tolerance", "by pixels", "until flat"],
  answer: 1,
  because:
    "A uniform mesh uses small triangles everywhere, a limit in pixels depends on the view, and “until flat” bounds no distance.",
};

/** @param {{ mesh: { error: number | null, unit: string, triangles: number } }} figure */
export function check({ mesh: { error, unit, triangles } }) {
  if (error === null)
    return verdict(false, "“Until flat” does not bound the distance from the surface. Choose another way.");
  if (unit !== "") return verdict(false, "An error in pixels depends on the view. Choose “by tolerance”.");
  if (error > MAX_ERROR) return verdict(false, `The error can be ${formatNumber(error, 3)}, which is more than 0.01.`);
  const done = triangles < MAX_TRIANGLES;
  return verdict(
    done,
    `${formatCount(triangles)} triangles${done ? ". They are large where the pot is almost flat." : ", but fewer than 10 000 are enough."}`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { flatness: null, pixels: null, tolerance: MAX_ERROR });
