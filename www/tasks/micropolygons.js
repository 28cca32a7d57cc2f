import { formatCount, verdict } from "./utils/surfaces.js";

/** The zoom that the task asks for, and what the slider allows. */
const [ZOOM, TOLERANCE] = [0.5, 1e-9];

export const predict = {
  options: ["to about a half", "to between a quarter and a half", "to less than a quarter"],
  answer: 1,
  because:
    "Their size is measured in pixels. At half the zoom each part is half as long and half as wide, which would give a quarter. It is more, because the number of segments of each part is rounded up.",
};

/** @param {{ zoom: number, micropolygons: number }} figure */
export function check({ zoom, micropolygons }) {
  const done = Math.abs(zoom - ZOOM) < TOLERANCE;
  const count = `At this zoom there are ${formatCount(micropolygons)} micropolygons.`;
  return verdict(done, done ? count : `${count} Set the zoom to ${ZOOM.toFixed(2)}.`);
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { zoom: ZOOM });
