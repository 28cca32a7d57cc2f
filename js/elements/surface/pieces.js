// The text's recursion: pieces that count as flat, and the cracks where neighbours were cut differently.
import { Mesh } from "../../surfaces.js";
import { patchesOf } from "./patches.js";

/**
 * @import { Patch, Surface } from "../../surfaces.js"
 */

/** @typedef {ReturnType<Surface["subdivide"]>[number]} Piece */
/** @typedef {[number, number, number]} Vector */

/**
 * Two triangles for each piece.
 *
 * @param {Surface} surface
 * @param {Piece[]} pieces
 * @returns {Mesh}
 */
export function piecesMesh(surface, pieces) {
  const count = 4 * pieces.length;
  const data = {
    positions: new Float32Array(3 * count),
    normals: new Float32Array(3 * count),
    uvs: new Float32Array(2 * count),
    patchIds: new Uint32Array(count),
  };
  const indices = new Uint32Array(6 * pieces.length);
  const patches = patchesOf(surface);
  pieces.forEach(({ patch, corners, ...at }, k) => {
    data.positions.set(corners, 12 * k);
    uvsOf(at).forEach(([u, v], i) => {
      const { x, y, z = 0 } = patches[patch].normal(u, v);
      data.normals.set([x, y, z], 12 * k + 3 * i);
      data.uvs.set([u, v], 8 * k + 2 * i);
    });
    data.patchIds.fill(patch, 4 * k, 4 * k + 4);
    indices.set(
      [0, 1, 2, 0, 2, 3].map((i) => 4 * k + i),
      6 * k,
    );
  });
  return new Mesh({ ...data, indices, patchRanges: [] });
}

/** @param {{ u0: number, u1: number, v0: number, v1: number }} piece */
const uvsOf = ({ u0, u1, v0, v1 }) =>
  /** @type {[number, number][]} */ ([
    [u0, v0],
    [u1, v0],
    [u1, v1],
    [u0, v1],
  ]);

/** How deep the recursion went: halves of halves of a patch. @param {Piece[]} pieces */
export function depthOf(pieces) {
  return pieces.reduce((most, { u0, u1 }) => Math.max(most, Math.round(-Math.log2(u1 - u0))), 0);
}

/**
 * The gaps between the pieces. Where a piece's side has a corner of a neighbour amid it, the neighbour's two shorter sides
 * and this longer one enclose a triangle with nothing in it.
 *
 * @typedef {object} Cracks
 * @property {Float32Array} triangles nine numbers each
 * @property {Float32Array} lines the shorter sides as straight pieces
 * @property {number} widest the greatest distance of such a corner from the longer side
 */

/**
 * @param {Surface} surface
 * @param {Piece[]} pieces
 * @returns {Cracks}
 */
export function cracksOf(surface, pieces) {
  const corners = cornersOf(surface, pieces);
  const patches = patchesOf(surface);
  const found = { triangles: /** @type {number[]} */ ([]), lines: /** @type {number[]} */ ([]), widest: 0 };
  for (const piece of pieces) {
    const uvs = uvsOf(piece);
    uvs.forEach((from, i) => search(patches[piece.patch], corners[piece.patch], from, uvs[(i + 1) % 4], found));
  }
  return { triangles: Float32Array.from(found.triangles), lines: Float32Array.from(found.lines), widest: found.widest };
}

/**
 * Looks for corners amid a side, and amid its halves.
 *
 * @param {Patch} patch
 * @param {Set<number>} corners
 * @param {[number, number]} a
 * @param {[number, number]} b
 * @param {{ triangles: number[], lines: number[], widest: number }} found
 */
function search(patch, corners, a, b, found) {
  const middle = /** @type {[number, number]} */ ([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
  if (!corners.has(key(...middle))) return;
  const [from, mid, to] = [a, middle, b].map(([u, v]) => {
    const { x, y, z = 0 } = patch.eval(u, v);
    return /** @type {Vector} */ ([x, y, z]);
  });
  found.triangles.push(...from, ...mid, ...to);
  found.lines.push(...from, ...mid, ...mid, ...to);
  found.widest = Math.max(found.widest, fromLine(mid, from, to));
  search(patch, corners, a, middle, found);
  search(patch, corners, middle, b, found);
}

/**
 * A point's distance from a line.
 *
 * @param {Vector} p
 * @param {Vector} a
 * @param {Vector} b
 */
function fromLine(p, a, b) {
  const [d, e] = [b.map((x, k) => x - a[k]), p.map((x, k) => x - a[k])];
  const cross = [d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]];
  const length = Math.hypot(...d);
  return length > 0 ? Math.hypot(...cross) / length : Math.hypot(...e);
}

/** Halves of halves are exact: one number for a pair of them. */
const key = (/** @type {number} */ u, /** @type {number} */ v) => u * 2 ** 30 + v;

/**
 * For each patch the corners of its pieces, and on its sides those of the neighbours.
 *
 * @param {Surface} surface
 * @param {Piece[]} pieces
 * @returns {Set<number>[]}
 */
function cornersOf(surface, pieces) {
  const corners = patchesOf(surface).map(() => /** @type {Set<number>} */ (new Set()));
  /** @type {Map<string, number[]>} where the corners lie along each side */
  const along = new Map();
  for (const piece of pieces) {
    for (const [u, v] of uvsOf(piece)) {
      corners[piece.patch].add(key(u, v));
      for (const [side, t] of sidesAt(u, v)) {
        const name = `${piece.patch} ${side}`;
        const known = along.get(name);
        if (known) known.push(t);
        else along.set(name, [t]);
      }
    }
  }
  const { shared, nonManifold } = surface.topology();
  for (const group of [...shared, ...nonManifold]) {
    const turned = (/** @type {{ reversed: boolean }} */ side, /** @type {number} */ t) => (side.reversed ? 1 - t : t);
    const all = new Set(
      group.flatMap((side) => (along.get(`${side.patch} ${side.edge}`) ?? []).map((t) => turned(side, t))),
    );
    for (const side of group) for (const t of all) corners[side.patch].add(key(...placeOn(side.edge, turned(side, t))));
  }
  return corners;
}

/**
 * The sides that a place lies on, and where along them.
 *
 * @param {number} u
 * @param {number} v
 */
function sidesAt(u, v) {
  const sides = /** @type {[string, number, boolean][]} */ ([
    ["u0", v, u === 0],
    ["u1", v, u === 1],
    ["v0", u, v === 0],
    ["v1", u, v === 1],
  ]);
  return sides.filter(([, , on]) => on);
}

/**
 * @param {string} side
 * @param {number} t
 * @returns {[number, number]}
 */
function placeOn(side, t) {
  const end = Number(side[1]);
  return side[0] === "u" ? [end, t] : [t, end];
}
