import { verdict } from "./utils/surfaces.js";

export const predict = {
  options: ["about 10", "about 20", "about 40"],
  answer: 1,
  because:
    "For large s the mesh has nearly 32s² vertices and 64s² triangles: 32 · 24 + 64 · 6 = 1152 bytes for each s². 450,400 / 1152 = 391, and √391 is about 20.",
};

const MIN_RATIO = 100;
/** The bytes of the control points, as the text states them. */
const POINTS_BYTES = 4504;

/** The teapot's welded mesh with normals: 32 s² + 4 s + 1 vertices of 24 bytes, and 64 s² − 8 s triangles of 6. @param {number} s segments */
export const meshBytes = (s) => 24 * (32 * s * s + 4 * s + 1) + 6 * (64 * s * s - 8 * s);

/** @param {unknown} _figure @param {{ model: string, segments: number }} element */
export function check(_figure, { model, segments }) {
  if (model !== "teapot") return verdict(false, "Show the teapot, not the curve.");
  const [ratio, before] = [segments, segments - 1].map((s) => meshBytes(s) / POINTS_BYTES);
  if (ratio <= MIN_RATIO)
    return verdict(false, `With ${segments} segments the mesh takes ${ratio.toFixed(1)} times as many bytes.`);
  if (before > MIN_RATIO)
    return verdict(false, `${ratio.toFixed(1)} times as many bytes, but a smaller number of segments is enough.`);
  return verdict(
    true,
    `With ${segments} segments it is ${ratio.toFixed(1)} times as many, with one fewer ${before.toFixed(1)} times.`,
  );
}

/** @param {{ model: string, segments: number }} element */
export function reveal(element) {
  let segments = 1;
  while (meshBytes(segments) <= MIN_RATIO * POINTS_BYTES) segments++;
  Object.assign(element, { model: "teapot", segments });
}
