// Surfaces of revolution of bicubic patches, four for each cubic of the profile, as the teapot is made.
import { Surface } from "casteljau/surfaces";

/** The teapot's: control points of a quarter are at (1, κ) and (κ, 1). */
export const TEAPOT_HANDLE = 0.56;

/** The profile of the teapot's body, as pairs (r, z). @type {[number, number][]} */
export const TEAPOT_PROFILE = [
  [1.5, 2.4],
  [1.75, 1.875],
  [2, 1.35],
  [2, 0.9],
  [2, 0.45],
  [1.5, 0.225],
  [1.5, 0.15],
];

/** Corners of a box around every profile that fits into the picture: with them, the picture of the surface keeps its scale. */
const BOX = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [0, 2.6].map((z) => [2.1 * x, 2.1 * y, z])));

const QUARTERS = 4;
const DEGREE = 3;
const AROUND = QUARTERS * DEGREE;

/** The control points of a unit circle of four cubics, clockwise from (1, 0), as in the teapot. @param {number} handle */
function circleOf(handle) {
  const corners = [
    [1, 0],
    [0, -1],
    [-1, 0],
    [0, 1],
  ];
  return corners.flatMap(([x, y], k) => {
    const [nextX, nextY] = corners[(k + 1) % QUARTERS];
    return [
      [x, y],
      [x + handle * nextX, y + handle * nextY],
      [handle * x + nextX, handle * y + nextY],
    ];
  });
}

/**
 * A profile turned about the z axis. Eight vertices are of no patch: they frame the picture.
 *
 * @param {readonly (readonly [number, number])[]} profile control points (r, z) of cubics that share their ends
 * @param {number} handle
 */
export function revolved(profile, handle) {
  const circle = circleOf(handle);
  const vertices = profile.flatMap(([r, z]) => circle.map(([x, y]) => [r * x, r * y, z]));
  const patches = [];
  for (let first = 0; first + DEGREE < profile.length; first += DEGREE)
    for (let quarter = 0; quarter < QUARTERS; quarter++)
      patches.push(
        Array.from({ length: (DEGREE + 1) ** 2 }, (_, k) => {
          const row = first + Math.floor(k / (DEGREE + 1));
          const column = (quarter * DEGREE + (k % (DEGREE + 1))) % AROUND;
          return row * AROUND + (profile[row][0] === 0 ? 0 : column); // on the axis, all points are one
        }),
      );
  return new Surface({ vertices: [...vertices, ...BOX], patches });
}
