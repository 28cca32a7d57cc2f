// A sphere and a torus as meshes within a tolerance, compared with verb-nurbs.
import { NurbsSurface } from "casteljau/nurbs";
import { verb } from "./verb.js";

/** A hundredth of the radius of the sphere and of the tube. */
const TOLERANCE = 0.01;
/** The number of samples along each side of a triangle for measuring distances. */
const SAMPLES = 6;
/** Corners of triangles with a smaller distance are one vertex. */
const SAME_VERTEX = 1e-9;

/** @typedef {{ points: number[][], faces: number[][] }} VerbMesh */

/**
 * A surface, its distance from a point, and the options of verb that give the fewest triangles within the tolerance: the same
 * divisions in both directions, 12, 16, 20, … 56, and `normTol` 0.8, 0.4, 0.2, 0.1, 0.05, 0.025. `openEdges`: the edges of
 * its mesh that belong to one triangle only, three at each gap; a closed surface has none.
 */
const SHAPES = [
  {
    name: "sphere",
    ours: NurbsSurface.sphere([0, 0, 0], 1).toSurface(),
    theirs: new verb.geom.SphericalSurface([0, 0, 0], 1),
    distance: (/** @type {number[]} */ [x, y, z]) => Math.abs(Math.hypot(x, y, z) - 1),
    options: { divisions: 16, normTol: 0.05 },
    openEdges: 3,
  },
  {
    name: "torus",
    ours: NurbsSurface.torus([0, 0, 0], 3, 1).toSurface(),
    theirs: new verb.geom.RevolvedSurface(
      new verb.geom.Circle([3, 0, 0], [1, 0, 0], [0, 0, 1], 1),
      [0, 0, 0],
      [0, 0, 1],
      2 * Math.PI,
    ),
    distance: (/** @type {number[]} */ [x, y, z]) => Math.abs(Math.hypot(Math.hypot(x, y) - 3, z) - 1),
    options: { divisions: 52, normTol: 0.4 },
    openEdges: 0,
  },
];

/** @param {typeof SHAPES[number]} shape @returns {VerbMesh} */
const theirMesh = ({ theirs, options: { divisions, normTol } }) =>
  theirs.tessellate(
    Object.assign(new verb.eval.AdaptiveRefinementOptions(), { minDivsU: divisions, minDivsV: divisions, normTol }),
  );

/** @param {typeof SHAPES[number]} shape @returns {VerbMesh} */
function ourMesh({ ours }) {
  const { positions, indices } = ours.tessellate({ tolerance: TOLERANCE, weld: "position" });
  const triples = (/** @type {ArrayLike<number>} */ list) =>
    Array.from({ length: list.length / 3 }, (_, i) => [list[3 * i], list[3 * i + 1], list[3 * i + 2]]);
  return { points: triples(positions), faces: triples(indices) };
}

/**
 * The largest distance of samples of the triangles from the surface.
 *
 * @param {VerbMesh} mesh
 * @param {(p: number[]) => number} distance
 */
function largestDistance({ points, faces }, distance) {
  let largest = 0;
  for (const face of faces) {
    const [a, b, c] = face.map((i) => points[i]);
    for (let i = 0; i <= SAMPLES; i++) {
      for (let j = 0; j <= SAMPLES - i; j++) {
        const p = a.map((x, k) => (i * x + j * b[k] + (SAMPLES - i - j) * c[k]) / SAMPLES);
        largest = Math.max(largest, distance(p));
      }
    }
  }
  return largest;
}

/** The number of edges that do not belong to two triangles, which have three different corners. @param {VerbMesh} mesh */
function openEdges({ points, faces }) {
  const keys = points.map((p) => p.map((x) => Math.round(x / SAME_VERTEX)).join());
  const counts = new Map();
  for (const face of faces.map((corners) => corners.map((i) => keys[i]))) {
    if (new Set(face).size < 3) continue;
    for (const [k, corner] of face.entries()) {
      const edge = [corner, face[(k + 1) % 3]].sort().join(" ");
      counts.set(edge, (counts.get(edge) ?? 0) + 1);
    }
  }
  return [...counts.values()].filter((count) => count !== 2).length;
}

/** @param {typeof SHAPES[number]} shape */
function check(shape) {
  for (const [side, mesh, open] of /** @type {const} */ ([
    ["verb", theirMesh(shape), shape.openEdges],
    ["ours", ourMesh(shape), 0],
  ])) {
    const [distance, edges] = [largestDistance(mesh, shape.distance), openEdges(mesh)];
    if (!(distance <= TOLERANCE + 1e-6)) throw new Error(`${shape.name}, ${side}: the distance ${distance}`);
    if (edges !== open) throw new Error(`${shape.name}, ${side}: ${edges} open edges instead of ${open}`);
  }
}

/** @type {import("./harness.js").Row[]} */
export const rows = SHAPES.map((shape) => {
  const into = shape.ours.tessellate({ tolerance: TOLERANCE });
  const gaps = shape.openEdges > 0 ? `, verb's with ${shape.openEdges} open edges` : "";
  return {
    id: `nurbs-${shape.name}-verb`,
    work: `NURBS ${shape.name}, tolerance radius / 100, ours closed${gaps}`,
    peer: "verb-nurbs, best options",
    items: 1,
    check: () => check(shape),
    theirs: () => theirMesh(shape).points.length,
    ours: () => shape.ours.tessellate({ tolerance: TOLERANCE, into }).normals[100],
  };
});
