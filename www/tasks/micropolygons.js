import { formatCount, verdict } from "./utils/surfaces.js";

/** The size in px that the task asks for, and the part of the number at the zoom 1: a half, and how far from it. */
const [SIZE, PART, ALLOWED] = [16, 0.5, 0.06];
/** The zooms that the slider has. */
const ZOOMS = Array.from({ length: 25 }, (_, k) => (6 + k) / 20);

export const predict = {
  options: ["at the zoom 0.25", "at the zoom 0.5", "between 0.6 and 0.7"],
  answer: 2,
  because:
    "Half the zoom makes each part half as long and half as wide, so only about a quarter of the micropolygons would remain. Half of them would remain at √½ ≈ 0.71. It takes a little less, because the numbers of segments are rounded up: they fall more slowly.",
};

/** @param {unknown} _figure @param {{ zoom: number, size: number, countAt(zoom: number): number }} element */
export function check(_figure, element) {
  const { zoom, size } = element;
  if (size !== SIZE)
    return {
      done: false,
      words: `The size is ${size} px. The answer is asked for ${SIZE} px.`,
      restore: (/** @type {{ size: number }} */ it) => (it.size = SIZE),
    };
  const [count, all] = [element.countAt(zoom), element.countAt(1)];
  const part = count / all;
  const words = `At the zoom ${zoom.toFixed(2)} there are ${formatCount(count)} micropolygons: ${(100 * part).toFixed(0)} % of ${formatCount(all)}.`;
  return verdict(Math.abs(part - PART) <= ALLOWED, words);
}

/** @param {{ zoom: number, size: number, countAt(zoom: number): number }} element */
export function reveal(element) {
  element.size = SIZE;
  const half = PART * element.countAt(1);
  const off = (/** @type {number} */ zoom) => Math.abs(element.countAt(zoom) - half);
  element.zoom = ZOOMS.reduce((best, zoom) => (off(zoom) < off(best) ? zoom : best));
}
