import { formatCount, verdict } from "./utils/surfaces.js";

/** The zoom and the size in px that the task asks for, and how exactly the slider can be set. */
const [ZOOM, SIZE, TOLERANCE] = [0.5, 16, 1e-9];

export const predict = {
  options: ["to about a half", "to between a quarter and a half", "to less than a quarter"],
  answer: 1,
  because:
    "Their size is measured in pixels. At half the zoom each part is half as long and half as wide, which would give a quarter. It is more, because the number of segments of each part is rounded up.",
};

/** @param {{ zoom: number, size: number, micropolygons: number }} figure */
export function check({ zoom, size, micropolygons }) {
  if (size !== SIZE) return verdict(false, `The size is ${size} px. Set it to ${SIZE} px again.`);
  const done = Math.abs(zoom - ZOOM) < TOLERANCE;
  const count = `At this zoom there are ${formatCount(micropolygons)} micropolygons.`;
  return verdict(done, done ? count : `${count} Set the zoom to ${ZOOM.toFixed(2)}.`);
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { zoom: ZOOM, size: SIZE });
