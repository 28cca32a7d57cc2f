import { formatNumber, verdict } from "./utils/surfaces.js";
import { SURFACES } from "../figures/lib/surfaces.js";

/** What a hand can do: a few pixels of the picture. */
const PRECISION = 0.12;

/** @param {{ points: [number, number, number][] }} figure */
export function check({ points }) {
  const most = Math.max(...points.map(([, , z]) => Math.abs(z)));
  const done = most <= PRECISION;
  return verdict(
    done,
    done
      ? "Flat: all nine points lie in one plane, and the patch within their hull."
      : `A point is still ${formatNumber(most)} away from the plane of the corners.`,
  );
}

/** @param {any} element */
export function reveal(element) {
  element.surface = SURFACES.nine().movePoint(4, [0, 0, 0]);
}
