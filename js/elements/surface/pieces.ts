// The text's recursion: pieces that count as flat, and the cracks where neighbours were cut differently.
import { Mesh } from "../../surfaces.js";
import { patchesOf } from "./patches.js";
import type { Patch, Surface } from "../../surfaces.js";

export type Piece = ReturnType<Surface["subdivide"]>[number];
export type Vector = [number, number, number];

/** Two triangles for each piece. */
export function piecesMesh(surface: Surface, pieces: Piece[]): Mesh {
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

const uvsOf = ({ u0, u1, v0, v1 }: { u0: number; u1: number; v0: number; v1: number }) =>
  [
    [u0, v0],
    [u1, v0],
    [u1, v1],
    [u0, v1],
  ] as [number, number][];

/** How deep the recursion went: halves of halves of a patch. */
export function depthOf(pieces: Piece[]) {
  return pieces.reduce((max, { u0, u1 }) => Math.max(max, Math.round(-Math.log2(u1 - u0))), 0);
}

/**
 * The gaps between the pieces. Where a piece's side has a corner of a neighbour amid it, the neighbour's two shorter sides
 * and this longer one enclose a triangle with nothing in it.
 */
export interface Cracks {
  /** Nine numbers each */
  triangles: Float32Array;
  /** The shorter sides as straight pieces */
  lines: Float32Array;
  /** The greatest distance of such a corner from the longer side */
  widest: number;
}

export function cracksOf(surface: Surface, pieces: Piece[]): Cracks {
  const corners = cornersOf(surface, pieces);
  const patches = patchesOf(surface);
  const found = { triangles: [] as number[], lines: [] as number[], widest: 0 };
  for (const piece of pieces) {
    const uvs = uvsOf(piece);
    uvs.forEach((from, i) => search(patches[piece.patch], corners[piece.patch], from, uvs[(i + 1) % 4], found));
  }
  return { triangles: Float32Array.from(found.triangles), lines: Float32Array.from(found.lines), widest: found.widest };
}

/** Looks for corners between the ends of a side, and then on its halves. */
function search(
  patch: Patch,
  corners: Set<number>,
  a: [number, number],
  b: [number, number],
  found: { triangles: number[]; lines: number[]; widest: number },
) {
  const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] as [number, number];
  if (!corners.has(key(...middle))) return;
  const [from, mid, to] = [a, middle, b].map(([u, v]) => {
    const { x, y, z = 0 } = patch.eval(u, v);
    return [x, y, z] as Vector;
  });
  found.triangles.push(...from, ...mid, ...to);
  found.lines.push(...from, ...mid, ...mid, ...to);
  found.widest = Math.max(found.widest, fromLine(mid, from, to));
  search(patch, corners, a, middle, found);
  search(patch, corners, middle, b, found);
}

/** A point's distance from a line. */
function fromLine(p: Vector, a: Vector, b: Vector) {
  const [d, e] = [b.map((x, k) => x - a[k]), p.map((x, k) => x - a[k])];
  const cross = [d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]];
  const length = Math.hypot(...d);
  return length > 0 ? Math.hypot(...cross) / length : Math.hypot(...e);
}

/** Halves of halves are exact: one number for a pair of them. */
const key = (u: number, v: number) => u * 2 ** 30 + v;

/** For each patch the corners of its pieces, and on its sides those of the neighbours. */
function cornersOf(surface: Surface, pieces: Piece[]): Set<number>[] {
  const corners = patchesOf(surface).map(() => new Set() as Set<number>);
  /** Where the corners lie along each side */
  const along: Map<string, number[]> = new Map();
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
    const parameterOn = (side: { reversed: boolean }, t: number) => (side.reversed ? 1 - t : t);
    const all = new Set(
      group.flatMap((side) => (along.get(`${side.patch} ${side.edge}`) ?? []).map((t) => parameterOn(side, t))),
    );
    for (const side of group)
      for (const t of all) corners[side.patch].add(key(...placeOn(side.edge, parameterOn(side, t))));
  }
  return corners;
}

/** The sides that a place lies on, and where along them. */
function sidesAt(u: number, v: number) {
  const sides = [
    ["u0", v, u === 0],
    ["u1", v, u === 1],
    ["v0", u, v === 0],
    ["v1", u, v === 1],
  ] as [string, number, boolean][];
  return sides.filter(([, , on]) => on);
}

function placeOn(side: string, t: number): [number, number] {
  const end = Number(side[1]);
  return side[0] === "u" ? [end, t] : [t, end];
}
