import { verdict } from "./utils/surfaces.js";

/** The limit that the task states. */
const MAX_SEGMENTS = 4;

export const predict = {
  options: ["Inside, as facets", "At the outline", "Only in the shadows"],
  answer: 1,
  because:
    "Smooth shading uses the normals of the surface at the vertices, so the inside looks smooth. The outline of the mesh still consists of straight edges.",
};

/** @param {{ state: string, segments: number }} figure */
export function check({ state, segments }) {
  if (segments > MAX_SEGMENTS)
    return verdict(false, `The mesh has ${segments} segments; choose ${MAX_SEGMENTS} or fewer.`);
  const done = state === "done";
  return verdict(
    done,
    done ? "Compare the outlines of the lid and the spout." : "The ray-traced picture is not finished yet.",
  );
}

/** @param {any} element */
export function reveal(element) {
  if (element.target) element.target.segments = MAX_SEGMENTS;
  element.start();
}
