// Chance, and places for new points.
import type { Spline } from "../index.js";
import { cubics, isInside, pairs, POINTS_PER_SEGMENT } from "./plane.js";
import type { Box } from "./plane.js";

/** Random points keep this share of the box's smaller side as a margin, so that handles are not cut. */
const MARGIN_RATIO = 0.06;
/** About three draws in four put a C1 handle outside: the chance that 64 draws all fail is 1e-8. */
const MAX_DRAWS = 64;
/** Best-candidate sampling: of so many random places the one farthest from the other points is taken. */
const CANDIDATES = 5;
/** Columns and rows of the candidates for a new point. */
const GRID = { columns: 12, rows: 9 };

/**
 * The small generator "mulberry32" (Tommy Ettinger, public domain): equal seeds, equal numbers in [0, 1).
 *
 * @param seed an integer
 */
export function generator(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Random cubics inside the box whose joints are held. */
export function randomChain(
  box: Box,
  segments: number,
  modeOf: (joint: number) => Parameters<Spline["setJoint"]>[1],
  random: () => number,
): Spline {
  let spline = cubics(randomPlaces(box, POINTS_PER_SEGMENT * segments + 1, random));
  for (let joint = 1; joint < segments; joint++) spline = withJointInside(spline, joint, modeOf(joint), box, random);
  return spline;
}

/** Places inside the box, none close to another. */
export function randomPlaces(box: Box, count: number, random: () => number): [number, number][] {
  const points: [number, number][] = [];
  while (points.length < count) points.push(roomyPlace(box, points, random));
  return points;
}

function roomyPlace(box: Box, others: number[][], random: () => number) {
  return roomiest(
    Array.from({ length: CANDIDATES }, () => randomPlace(box, random)),
    others,
  );
}

/** Draws the three points of a joint anew until its lock leaves them inside. */
function withJointInside(
  spline: Spline,
  joint: number,
  mode: Parameters<Spline["setJoint"]>[1],
  box: Box,
  random: () => number,
): Spline {
  const anchor = POINTS_PER_SEGMENT * joint;
  for (let draws = 0; ; draws++) {
    const held = spline.setJoint(joint, mode);
    const placed = pairs(held.controlPoints()).slice(anchor - 1, anchor + 3); // P2 to P5 at P3
    if (draws > MAX_DRAWS || placed.every((point) => isInside(box, point))) return held;
    const points = pairs(spline.controlPoints());
    const others = points.filter((_, index) => Math.abs(index - anchor) > 1);
    for (const index of [anchor - 1, anchor, anchor + 1]) points[index] = roomyPlace(box, others, random);
    // The mirror image in the centre of what is inside is inside.
    if (draws >= MAX_DRAWS) points[anchor] = [box.width / 2, box.height / 2];
    if (draws >= MAX_DRAWS) points[anchor + 1] = points[anchor - 1];
    spline = cubics(points);
  }
}

function randomPlace({ width, height }: Box, random: () => number): [number, number] {
  const margin = MARGIN_RATIO * Math.min(width, height);
  return [margin + random() * (width - 2 * margin), margin + random() * (height - 2 * margin)];
}

/** The place of a coarse grid that is farthest from all points: where there is room for a new one. */
export function roomiestAmong(box: Box, points: readonly number[][]): [number, number] {
  return roomiest(gridPlaces(box), points);
}

/**
 * @returns the place with the greatest distance to the nearest of the others
 */
function roomiest(places: [number, number][], others: readonly number[][]): [number, number] {
  const room = ([x, y]: number[]) => Math.min(...others.map(([px, py]) => Math.hypot(x - px, y - py)));
  const rooms = places.map((place) => ({ place, room: room(place) }));
  return rooms.reduce((best, next) => (next.room > best.room ? next : best)).place;
}

function gridPlaces({ width, height }: Box): [number, number][] {
  const { columns, rows } = GRID;
  return Array.from({ length: columns * rows }, (_, i) => [
    ((1 + (i % columns)) * width) / (columns + 1),
    ((1 + Math.floor(i / columns)) * height) / (rows + 1),
  ]);
}
