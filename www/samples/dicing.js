import { Surface } from "casteljau";

const MAX_GRID = 16;

export function sample(print) {
  const teapot = Surface.teapot();
  for (const pixels of [50, 100, 200]) {
    const maxEdge = 4 / pixels; // edges of at most 4 pixels
    let count = 0;
    for (let k = 0; k < teapot.patchCount; k++) count += micropolygons(teapot.patch(k), maxEdge);
    print(`${pixels} pixels for each unit: ${count} micropolygons`);
  }
}

// Splits a patch until its grid is small enough, and counts the micropolygons.
function micropolygons(patch, maxEdge) {
  const points = patch.controlPoints();
  const distance = (a, b) => Math.hypot(...[0, 1, 2].map((axis) => points[3 * a + axis] - points[3 * b + axis]));
  let [u, v] = [0, 0]; // the longest legs of the net
  for (let k = 0; k < 16; k++) {
    if (k % 4 < 3) u = Math.max(u, distance(k, k + 1));
    if (k < 12) v = Math.max(v, distance(k, k + 4));
  }
  const [countU, countV] = [u, v].map((leg) => Math.max(1, Math.ceil((3 * leg) / maxEdge)));
  if (Math.max(countU, countV) <= MAX_GRID) return countU * countV;
  const [a, b] = countU >= countV ? patch.splitU(0.5) : patch.splitV(0.5);
  return micropolygons(a, maxEdge) + micropolygons(b, maxEdge);
}
