import { formatCount, verdict } from "./utils/surfaces.js";

/** The size that the task asks for, in pixels. */
const SIZE_PX = 8;

export const predict = {
  options: ["It is about twice as large", "It is about four times as large", "It is about eight times as large"],
  answer: 1,
  because: "Edges half as long give twice as many micropolygons in each of the two directions.",
};

/** @param {{ size: number, micropolygons: number }} figure */
export function check({ size, micropolygons }) {
  const count = `With ${size} px there are ${formatCount(micropolygons)} micropolygons.`;
  return verdict(size === SIZE_PX, size === SIZE_PX ? count : `${count} Set the size to ${SIZE_PX} px.`);
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { size: SIZE_PX });
