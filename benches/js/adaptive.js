// Tessellation of the teapot within a tolerance, compared with verb-nurbs.
import { Surface } from "casteljau";
import { distanceToTriangle } from "./distance.js";
import { compare } from "./harness.js";
import { verb } from "./verb.js";

/** @typedef {{ x: number, y: number, z: number }} Vertex */

const teapot = Surface.teapot();
const { min, max } = /** @type {{ min: Vertex, max: Vertex }} */ (teapot.bounds());
/** A thousandth of the diagonal. */
const TOLERANCE = Math.hypot(max.x - min.x, max.y - min.y, max.z - min.z) / 1000;
/** The number of samples along each side of a triangle for measuring distances. */
const SAMPLES = 6;

/** @typedef {{ points: number[][], uvs: number[][], faces: number[][] }} VerbMesh */

/**
 * Options of verb: a minimum number of divisions, and the square of the distance between unit normals above which a
 * cell is divided (0.025 by default). It has no tolerance, and does not divide cells at a pole.
 *
 * @typedef {{ divisions: number, normTol: number }} Options
 */

/**
 * Simple options: the default `normTol`, and the same divisions for all patches, the fewest of 6, 8, 10, 12, 16, 20, 24
 * that suffice.
 */
const PLAIN = Array.from({ length: 32 }, () => ({ divisions: 20, normTol: 0.025 }));

/**
 * The best options of verb: for each patch, those of the same divisions and of `normTol` 0.4, 0.2, 0.1, 0.05, 0.025,
 * 0.0125 that give the fewest triangles within the tolerance.
 */
const SEARCHED = [
  { patches: 4, divisions: 8, normTol: 0.4 }, // rim
  { patches: 4, divisions: 8, normTol: 0.025 }, // body
  { patches: 4, divisions: 12, normTol: 0.4 },
  { patches: 2, divisions: 10, normTol: 0.4 }, // handle
  { patches: 2, divisions: 8, normTol: 0.4 },
  { patches: 2, divisions: 16, normTol: 0.4 }, // spout
  { patches: 2, divisions: 10, normTol: 0.4 },
  { patches: 8, divisions: 12, normTol: 0.4 }, // lid
  { patches: 4, divisions: 16, normTol: 0.4 }, // bottom
].flatMap(({ patches, ...options }) => Array.from({ length: patches }, () => options));

const KNOTS = [0, 0, 0, 0, 1, 1, 1, 1];
const patches = PLAIN.map((_, k) => teapot.patch(k));
const surfaces = patches.map((patch) => {
  const net = patch.controlPoints();
  const point = (/** @type {number} */ i, /** @type {number} */ j) => [
    ...net.subarray(3 * (4 * j + i), 3 * (4 * j + i) + 3),
  ];
  const columns = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => point(i, j)));
  return verb.geom.NurbsSurface.byKnotsControlPointsWeights(3, 3, KNOTS, KNOTS, columns);
});

/**
 * @param {Options[]} options for each patch
 * @returns {VerbMesh[]}
 */
function verbMeshes(options) {
  return surfaces.map((surface, k) => {
    const { divisions, normTol } = options[k];
    // verb reads the divisions along v for u, too.
    const verbOptions = Object.assign(new verb.eval.AdaptiveRefinementOptions(), {
      minDivsU: divisions,
      minDivsV: divisions,
      normTol,
    });
    return surface.tessellate(verbOptions);
  });
}

/**
 * Our mesh in the format of verb, patch by patch: with weld "none" every vertex has (u, v); the triangles are the same.
 */
function ourMeshes() {
  const { positions, uvs, indices, patchRanges } = teapot.tessellate({ tolerance: TOLERANCE, weld: "none" });
  const itemAt = (/** @type {ArrayLike<number>} */ list, /** @type {number} */ i, /** @type {number} */ count) =>
    Array.from({ length: count }, (_, k) => list[count * i + k]);
  const count = positions.length / 3;
  const points = Array.from({ length: count }, (_, i) => itemAt(positions, i, 3));
  const pairs = Array.from({ length: count }, (_, i) => itemAt(/** @type {Float32Array} */ (uvs), i, 2));
  return patchRanges.map(({ firstIndex, indices: length }) => {
    const faces = Array.from({ length: length / 3 }, (_, i) => itemAt(indices, firstIndex / 3 + i, 3));
    return { points, uvs: pairs, faces };
  });
}

/**
 * The largest distance of the surface from the triangles with the same (u, v), sampled.
 *
 * @param {VerbMesh[]} meshes one for each patch
 */
function largestDistance(meshes) {
  let largest = 0;
  meshes.forEach(({ points, uvs, faces }, k) => {
    for (const face of faces) {
      const [a, b, c] = face.map((i) => uvs[i]);
      for (let i = 0; i <= SAMPLES; i++) {
        for (let j = 0; j <= SAMPLES - i; j++) {
          const at = (/** @type {number} */ axis) =>
            (i * a[axis] + j * b[axis] + (SAMPLES - i - j) * c[axis]) / SAMPLES;
          const { x, y, z } = /** @type {{ x: number, y: number, z: number }} */ (patches[k].eval(at(0), at(1)));
          largest = Math.max(
            largest,
            distanceToTriangle(
              [x, y, z],
              face.map((vertex) => points[vertex]),
            ),
          );
        }
      }
    }
  });
  return largest;
}

/** @param {VerbMesh[]} meshes */
const triangles = (meshes) => meshes.reduce((sum, { faces }) => sum + faces.length, 0);

/**
 * @param {string} side
 * @param {VerbMesh[]} meshes
 */
function assertClose(side, meshes) {
  const distance = largestDistance(meshes);
  if (!(distance <= TOLERANCE))
    throw new Error(`teapot within a tolerance, ${side}: the distance ${distance} is above ${TOLERANCE}`);
}

/** @param {Options[]} options */
function check(options) {
  const ours = ourMeshes();
  assertClose("verb", verbMeshes(options));
  assertClose("ours", ours);
  if (into.indices.length / 3 !== triangles(ours))
    throw new Error("teapot within a tolerance: welding changes the triangles");
}

const into = teapot.tessellate({ tolerance: TOLERANCE });

/**
 * @param {string} id
 * @param {string} peer
 * @param {Options[]} options
 * @returns {import("./harness.js").Row}
 */
const rowOf = (id, peer, options) => ({
  id,
  work: "teapot, tolerance diagonal / 1000, ours without cracks",
  peer,
  items: 1,
  check: () => check(options),
  theirs: () => verbMeshes(options)[31].points.length,
  ours: () => teapot.tessellate({ tolerance: TOLERANCE, into }).normals[100],
});

/** @param {import("./harness.js").Effort} effort */
export function results(effort) {
  const plain = compare(rowOf("adaptive-verb", "verb-nurbs adaptive", PLAIN), effort);
  const searched = compare(rowOf("adaptive-verb-searched", "verb-nurbs, best options", SEARCHED), effort);
  const ours = into.indices.length / 3;
  const counts = [triangles(verbMeshes(PLAIN)), triangles(verbMeshes(SEARCHED))];
  const more = [plain, searched].map((result, k) => ({ ...result, spread: [0, 0], triangles: counts[k] }));
  const counted = more.map(({ triangles: theirs, ...result }) => ({
    ...result,
    work: "  its triangles",
    unit: "triangles",
    theirs,
    ours,
    ratio: theirs / ours,
  }));
  return [
    plain,
    { ...counted[0], id: "adaptive-triangles" },
    {
      ...more[0],
      id: "adaptive-triangle",
      work: "  per triangle",
      theirs: plain.theirs / counts[0],
      ours: plain.ours / ours,
      ratio: null,
    },
    searched,
    { ...counted[1], id: "adaptive-triangles-searched" },
  ];
}
