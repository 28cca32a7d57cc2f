// The first steps of the REYES algorithm: bound, split and dice patches by their size on the screen.

/** @import { Patch } from "casteljau/surfaces" */

/** @typedef {[number, number, number]} ScreenPoint x and y in pixels, y down, and the depth */
/** @typedef {(point: ArrayLike<number>) => ScreenPoint} Projection a parallel projection: straight lines keep their ratios */
/** @typedef {{ corners: ScreenPoint[], normal: number[], depth: number }} Micropolygon normal in the coordinates of the surface, of any length */

/** A grid has at most so many micropolygons in each direction, so that it needs little memory. */
export const MAX_GRID = 16;
/** A patch can be split so often at most, whatever its size. */
const MAX_DEPTH = 12;

/**
 * How many micropolygons a patch needs in each direction, so that none of their edges is longer than the limit. The speed of a
 * Bézier curve is at most its degree times the longest leg of its control polygon.
 *
 * @param {Patch} patch
 * @param {Projection} project
 * @param {number} maxEdge in pixels
 * @returns {[number, number]} along u and along v
 */
export function gridSize(patch, project, maxEdge) {
  const [n, m] = [patch.degreeU, patch.degreeV];
  const points = screenPoints(patch, project);
  const at = (/** @type {number} */ i, /** @type {number} */ j) => points[j * (n + 1) + i];
  let [longestU, longestV] = [0, 0];
  for (let j = 0; j <= m; j++)
    for (let i = 0; i <= n; i++) {
      if (i > 0) longestU = Math.max(longestU, distance(at(i, j), at(i - 1, j)));
      if (j > 0) longestV = Math.max(longestV, distance(at(i, j), at(i, j - 1)));
    }
  return [Math.max(1, Math.ceil((n * longestU) / maxEdge)), Math.max(1, Math.ceil((m * longestV) / maxEdge))];
}

/**
 * Splits a patch until the grid of each part is small enough, always in the direction that needs more micropolygons.
 *
 * @param {Patch} patch
 * @param {Projection} project
 * @param {number} maxEdge
 * @param {number} [depth]
 * @returns {Patch[]}
 */
export function splitPatch(patch, project, maxEdge, depth = 0) {
  const [countU, countV] = gridSize(patch, project, maxEdge);
  if (Math.max(countU, countV) <= MAX_GRID || depth === MAX_DEPTH) return [patch];
  const halves = countU >= countV ? patch.splitU(0.5) : patch.splitV(0.5);
  return halves.flatMap((half) => splitPatch(half, project, maxEdge, depth + 1));
}

/**
 * The micropolygons of a part.
 *
 * @param {Patch} patch
 * @param {Projection} project
 * @param {number} maxEdge
 * @returns {Micropolygon[]}
 */
export function dice(patch, project, maxEdge) {
  const [countU, countV] = gridSize(patch, project, maxEdge).map((count) => Math.min(count, MAX_GRID));
  const rows = Array.from({ length: countV + 1 }, (_, j) => rowOfVertices(patch, j / countV, countU, project));
  return Array.from({ length: countU * countV }, (_, k) => {
    const [i, j] = [k % countU, Math.floor(k / countU)];
    return micropolygon([rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]]);
  });
}

/** @typedef {{ point: number[], screen: ScreenPoint }} Vertex */

/** @param {Patch} patch @param {number} v @param {number} count of micropolygons @param {Projection} project @returns {Vertex[]} */
function rowOfVertices(patch, v, count, project) {
  const flat = patch.isocurveAtV(v).sample(count);
  return Array.from({ length: count + 1 }, (_, i) => {
    const point = [flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]];
    return { point, screen: project(point) };
  });
}

/** @param {Vertex[]} vertices @returns {Micropolygon} */
function micropolygon(vertices) {
  const [a, b, c, d] = vertices.map(({ point }) => point);
  return {
    corners: vertices.map(({ screen }) => screen),
    normal: crossProduct(minus(c, a), minus(d, b)),
    depth: vertices.reduce((sum, { screen }) => sum + screen[2], 0) / vertices.length,
  };
}

/** The box of the control points on the screen: the patch lies inside it. @param {Patch} patch @param {Projection} project */
export function screenBounds(patch, project) {
  const points = screenPoints(patch, project);
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
}

/** @param {Patch} patch @param {Projection} project */
function screenPoints(patch, project) {
  const flat = patch.controlPoints();
  return Array.from({ length: flat.length / 3 }, (_, k) => project(flat.subarray(3 * k, 3 * k + 3)));
}

/** @param {ScreenPoint} a @param {ScreenPoint} b */
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** @param {number[]} a @param {number[]} b */
const minus = (a, b) => a.map((x, k) => x - b[k]);

/** @param {number[]} a @param {number[]} b */
const crossProduct = ([a0, a1, a2], [b0, b1, b2]) => [a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0];
