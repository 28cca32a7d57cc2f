// The way from the surface to the pixels, as one matrix: 16 numbers, column after column.
import { aboutX, aboutZ, multiply, translation } from "#js/elements/surface/matrix.js";

/** The eye's distance, in radii of the sphere around the surface: a little perspective. */
const EYE_RADII = 5;
/** The sphere is wider than the teapot; so much larger than the sphere the picture may be. */
const ENLARGEMENT = 1.25;

/** @typedef {{ centre: number[], radius: number }} Sphere */

/**
 * A sphere around all vertices: about the middle of their box.
 *
 * @param {Float64Array} vertices
 * @returns {Sphere}
 */
export function sphereAround(vertices) {
  const box = [0, 1, 2].map((axis) => {
    const values = vertices.filter((_, i) => i % 3 === axis);
    return { min: Math.min(...values), max: Math.max(...values) };
  });
  return {
    centre: box.map(({ min, max }) => (min + max) / 2),
    radius: Math.hypot(...box.map(({ min, max }) => max - min)) / 2,
  };
}

/**
 * Seen from a distance, z up, with the middle of the surface in the middle of the picture.
 *
 * @param {Sphere} sphere
 * @param {{ turn: number, tilt: number }} view in degrees
 * @param {number} width of the picture in pixels
 * @param {number} height
 * @returns {number[]}
 */
export function pixelsFromSurface({ centre, radius }, { turn, tilt }, width, height) {
  const [x, y, z] = centre;
  const looked = multiply(aboutX(tilt - 90), multiply(aboutZ(turn), translation(-x, -y, -z)));
  return multiply(projection(radius, width, height), looked);
}

/**
 * y down, as on a canvas; w grows with the distance from the eye, and is the eye's distance in the middle.
 *
 * @param {number} radius
 * @param {number} width
 * @param {number} height
 */
function projection(radius, width, height) {
  const eye = EYE_RADII * radius;
  const scale = ((ENLARGEMENT * Math.min(width, height)) / 2 / radius) * eye;
  const [cx, cy] = [width / 2, height / 2];
  return [scale, 0, 0, 0, 0, -scale, 0, 0, -cx, -cy, 1, -1, cx * eye, cy * eye, 0, eye];
}
