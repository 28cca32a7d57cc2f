// The surfaces of the chapter that have no name in the element.
import { Surface } from "casteljau/surfaces";
import { revolved, TEAPOT_HANDLE, TEAPOT_PROFILE } from "./revolution.js";

/** A square net over −3 … 3, row by row along u, with a height for each point. @param {number[]} heights @param {number} degree */
function raised(heights, degree) {
  const side = degree + 1;
  const step = 6 / degree;
  const vertices = heights.map((z, k) => [step * (k % side) - 3, step * Math.floor(k / side) - 3, z]);
  return new Surface({ vertices, patches: [heights.map((_, k) => k)] }, { degreeU: degree, degreeV: degree });
}

/** Nine points, of which one stands out of the plane of the others. */
export const NINE_HEIGHTS = [0, 0, 0, 0, 4, 0, 0, 0, 0];

/** A hill whose top lies inside, not in the middle. */
const HILL_HEIGHTS = [-0.6, 0, 0.4, -0.4, 0.3, 5, 2, 0, 0, 2.5, -1.5, 0.6, 0.4, -0.6, 0.5, -0.8];

/** A quarter circle's handle, which is nearly right. */
const HANDLE = 0.5522847498;

/** A patch in the plane z = 0 whose four sides make a circle of radius 3, nearly; its corners make a square. */
function disc() {
  const corner = (/** @type {number} */ angle) => [3 * Math.cos(angle), 3 * Math.sin(angle), 0];
  const side = (/** @type {number} */ k) => {
    const [a, b] = [k, k + 1].map((n) => corner(((2 * n - 3) * Math.PI) / 4));
    return [a, [a[0] - HANDLE * a[1], a[1] + HANDLE * a[0], 0], [b[0] + HANDLE * b[1], b[1] - HANDLE * b[0], 0], b];
  };
  const [bottom, right, top, left] = [0, 1, 2, 3].map(side);
  const inner = [
    [-0.9, -0.9, 0],
    [0.9, -0.9, 0],
    [-0.9, 0.9, 0],
    [0.9, 0.9, 0],
  ];
  const vertices = [
    ...bottom,
    left[2],
    inner[0],
    inner[1],
    right[1],
    left[1],
    inner[2],
    inner[3],
    right[2],
    top[3],
    top[2],
    top[1],
    top[0],
  ];
  return new Surface({ vertices, patches: [vertices.map((_, k) => k)] });
}

/** The same points with u and v exchanged: the same shape, seen from its other side. @param {Surface} surface */
export function exchanged(surface) {
  const patches = surface.patches.map((net) => Array.from(net, (_, k) => net[4 * (k % 4) + Math.floor(k / 4)]));
  return new Surface({ vertices: surface.vertices, patches });
}

/** One flat patch and a hilly neighbour that share a side: the recursion cuts one, not the other. */
function neighbours() {
  const vertices = [];
  for (let j = 0; j < 4; j++) for (let i = 0; i < 7; i++) vertices.push([i - 3, 1.4 * j - 2.1, heightOf(i, j)]);
  const net = (/** @type {number} */ from) =>
    Array.from({ length: 16 }, (_, k) => 7 * Math.floor(k / 4) + (k % 4) + from);
  return new Surface({ vertices, patches: [net(0), net(3)] });
}

/** Rising gently along the common side, which is curved; steep behind it. @param {number} i @param {number} j */
const heightOf = (i, j) => (i > 3 ? [0, 2.6, -1.8, 1.2][j] * (i === 5 ? 1.6 : 0.9) : [0, 0.45, 0.45, 0][j]);

/** Heights of two biquadratic patches with a common side at x = 0, row by row. The point beyond the side in the middle row is too low. */
const JOINT_HEIGHTS = [
  [0, 0.8, 1.3, 1.8, 1],
  [0, 1, 1.5, 0.3, 0.5],
  [0.2, 0.6, 1.1, 1.6, 1.2],
];

/** Two biquadratic patches that meet in an edge, and would be smooth if {@link JOINT_POINT} were higher. */
function joint() {
  const vertices = JOINT_HEIGHTS.flatMap((row, j) => row.map((z, i) => [1.5 * i - 3, 2.5 * j - 2.5, z]));
  const net = (/** @type {number} */ from) =>
    Array.from({ length: 9 }, (_, k) => 5 * Math.floor(k / 3) + (k % 3) + from);
  return new Surface({ vertices, patches: [net(0), net(2)] }, { degreeU: 2, degreeV: 2 });
}

/** The vertex of {@link joint} that is moved, and the height that makes the joint smooth. */
export const JOINT_POINT = { vertex: 8, at: /** @type {[number, number, number]} */ ([1.5, 0, 2]) };

/** Places on the common side where normals are compared. */
const COMPARED = 32;

/** The largest angle between the normals of the first two patches along u = 1 and u = 0, in degrees. @param {Surface} surface */
export function jointAngle(surface) {
  const [left, right] = [surface.patch(0), surface.patch(1)];
  const angles = Array.from({ length: COMPARED + 1 }, (_, k) => {
    const [n, m] = [left.normal(1, k / COMPARED), right.normal(0, k / COMPARED)];
    const cosine = n.x * m.x + n.y * m.y + (n.z ?? 0) * (m.z ?? 0);
    return (Math.acos(Math.min(Math.max(cosine, -1), 1)) * 180) / Math.PI;
  });
  return Math.max(...angles);
}

/** The hill in two parts, before and after u. @param {number} u */
export const halves = (u) => Surface.fromPatches(SURFACES.hill().patch(0).splitU(u));

/** By the word in `data-surface`. @type {Record<string, () => Surface>} */
export const SURFACES = {
  hill: () => raised(HILL_HEIGHTS, 3),
  nine: () => raised(NINE_HEIGHTS, 2),
  disc,
  neighbours,
  joint,
  halves: () => halves(0.5),
  lathe: () => revolved(TEAPOT_PROFILE, TEAPOT_HANDLE),
};

/** Gives every <bezier-surface> with `data-surface` its surface, and with `data-view` its first view. */
export function showSurfaces() {
  for (const element of /** @type {NodeListOf<any>} */ (document.querySelectorAll("bezier-surface[data-view]"))) {
    element.view = JSON.parse(element.dataset.view);
  }
  for (const element of /** @type {NodeListOf<any>} */ (document.querySelectorAll("bezier-surface[data-surface]"))) {
    const { patch } = element; // a new surface has no chosen patch
    element.surface = SURFACES[element.dataset.surface]();
    element.patch = patch;
  }
}
