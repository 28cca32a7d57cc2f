import { Surface } from "casteljau";
import { verdict } from "./utils/surfaces.js";

const WANTED = 100;
/** Bytes of a number and of an index. */
const [NUMBER, INDEX] = [4, 2];

/** What the mesh with its normals takes, in what the patches take. @param {number} segments */
function ratioAt(segments) {
  const teapot = Surface.teapot();
  const { positions, normals, indices } = teapot.tessellate({ segments, weld: "position" });
  const numbers = teapot.patches.reduce((sum, net) => sum + net.length, 0);
  return (
    (positions.byteLength + normals.byteLength + indices.byteLength) /
    (teapot.vertices.length * NUMBER + numbers * INDEX)
  );
}

/** @param {unknown} _figure @param {{ segments: number }} element */
export function check(_figure, { segments }) {
  const ratio = ratioAt(segments);
  if (ratio <= WANTED) return verdict(false, `At ${segments} segments it is ${ratio.toFixed(1)} times as much.`);
  const before = ratioAt(segments - 1);
  if (before > WANTED) return verdict(false, `${ratio.toFixed(1)} times: enough, but not the first.`);
  return verdict(true, `At ${segments} segments: ${ratio.toFixed(1)} times; one fewer makes ${before.toFixed(1)}.`);
}

/** @param {{ segments: number }} element */
export function reveal(element) {
  let segments = 1;
  while (ratioAt(segments) <= WANTED) segments++;
  element.segments = segments;
}
