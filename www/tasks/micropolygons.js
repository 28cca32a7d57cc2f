import { formatCount, verdict } from "./utils/surfaces.js";

/** The zoom that the task asks for, and what the slider allows. */
const [ZOOM, TOLERANCE] = [0.5, 1e-9];

export const predict = {
  options: ["It falls", "It stays the same", "It rises"],
  answer: 0,
  because:
    "Their size is measured in pixels. A pot that looks smaller covers fewer pixels and needs fewer micropolygons.",
};

/** @param {{ zoom: number, micropolygons: number }} figure */
export function check({ zoom, micropolygons }) {
  const done = Math.abs(zoom - ZOOM) < TOLERANCE;
  const count = `At this zoom there are ${formatCount(micropolygons)} micropolygons.`;
  return verdict(done, done ? count : `${count} Set the zoom to ${ZOOM.toFixed(2)}.`);
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { zoom: ZOOM });
