import { SURFACES } from "../figures/lib/surfaces.js";
import { movedPoints } from "./utils/moved.js";
import { formatNumber, pointsOf, verdict } from "./utils/surfaces.js";

/** The limit that the task states. */
const MAX_DISTANCE = 0.01;

/** The highest point of a patch with one maximum, by steps that are halved. @param {any} patch */
function top(patch) {
  let best = { u: 0.5, v: 0.5 };
  for (let step = 0.25; step > 0.002; step /= 2) {
    for (let again = true; again; ) {
      again = false;
      for (const [du, dv] of [
        [step, 0],
        [-step, 0],
        [0, step],
        [0, -step],
      ]) {
        const next = { u: Math.min(Math.max(best.u + du, 0), 1), v: Math.min(Math.max(best.v + dv, 0), 1) };
        if (patch.eval(next.u, next.v).z <= patch.eval(best.u, best.v).z) continue;
        best = next;
        again = true;
      }
    }
  }
  return best;
}

export const predict = {
  options: ["in u, v < ½", "in u > ½, v < ½", "in u < ½, v > ½", "in u, v > ½"],
  answer: 0,
  because: "P11 has its largest weight at u = v = 1/3, so it pulls the patch up most near there.",
};

/** @param {{ surface: any, points: [number, number, number][], place: { point: number[] } | null }} figure */
export function check({ surface, points, place }) {
  const moved = movedPoints(points, pointsOf(SURFACES.hill()), (element) => (element.surface = SURFACES.hill()));
  if (moved) return moved;
  const highest = surface.bounds().max.z;
  const height = place?.point[2] ?? -Infinity;
  const done = highest - height <= MAX_DISTANCE;
  const words = done
    ? `The maximum is ${formatNumber(highest, 3)}; your point has the height ${formatNumber(height, 3)}.`
    : `Your point has the height ${formatNumber(height, 3)}. The maximum is ${formatNumber(highest - height, 3)} higher.`;
  return verdict(done, words);
}

/** @param {any} element */
export function reveal(element) {
  element.surface = SURFACES.hill();
  const { u, v } = top(element.surface.patch(0));
  Object.assign(element, { u: Math.round(100 * u) / 100, v: Math.round(100 * v) / 100, step: 4 });
}
