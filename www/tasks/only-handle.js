import { verdict } from "./utils/surfaces.js";

export const predict = {
  options: ["two", "four", "eight"],
  answer: 1,
  because: "Two halves, left and right, each in an upper and a lower patch.",
};

/** @param {{ model: string, parts: string[], surface: any }} figure */
export function check({ model, parts, surface }) {
  if (model !== "teapot") return verdict(false, "Back to the teapot first.");
  const done = parts.length === 1 && parts[0] === "handle";
  return verdict(
    done,
    done
      ? `The handle alone: ${surface.patchCount} patches.`
      : `There are ${surface.patchCount} patches now: ${parts.join(", ") || "nothing"}.`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { model: "teapot", parts: "handle" });
