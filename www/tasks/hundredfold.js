import { Surface } from "casteljau/surfaces";
import { verdict } from "./utils/surfaces.js";

export const predict = {
  options: ["about 10", "about 20", "about 40"],
  answer: 1,
  because:
    "For large s the mesh has nearly 32s² vertices and 64s² triangles: 32 · 24 + 64 · 6 = 1152 bytes for each s². 450,400 / 1152 = 391, and √391 is about 20.",
};

const MIN_RATIO = 100;
const [NUMBER_BYTES, INDEX_BYTES] = [4, 2];

/** Bytes of the mesh with normals divided by those of the control points. @param {number} segments */
function ratioAt(segments) {
  const teapot = Surface.teapot();
  const { positions, normals, indices } = teapot.tessellate({ segments, weld: "position" });
  const numbers = teapot.patches.reduce((sum, net) => sum + net.length, 0);
  return (
    (positions.byteLength + normals.byteLength + indices.byteLength) /
    (teapot.vertices.length * NUMBER_BYTES + numbers * INDEX_BYTES)
  );
}

/** @param {unknown} _figure @param {{ segments: number }} element */
export function check(_figure, { segments }) {
  const ratio = ratioAt(segments);
  if (ratio <= MIN_RATIO)
    return verdict(false, `With ${segments} segments the mesh takes ${ratio.toFixed(1)} times as many bytes.`);
  const before = ratioAt(segments - 1);
  if (before > MIN_RATIO)
    return verdict(false, `${ratio.toFixed(1)} times as many bytes, but a smaller number of segments is enough.`);
  return verdict(
    true,
    `With ${segments} segments it is ${ratio.toFixed(1)} times as many, with one fewer ${before.toFixed(1)} times.`,
  );
}

/** @param {{ segments: number }} element */
export function reveal(element) {
  let segments = 1;
  while (ratioAt(segments) <= MIN_RATIO) segments++;
  element.segments = segments;
}
