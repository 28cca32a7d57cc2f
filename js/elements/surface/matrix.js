// 4×4 matrices: 16 numbers, column after column.

/** @typedef {number[]} Matrix */
/** @typedef {[number, number, number]} Vector */

const RADIANS_PER_DEGREE = Math.PI / 180;

/**
 * First b, then a.
 *
 * @param {Matrix} a
 * @param {Matrix} b
 * @returns {Matrix}
 */
export function multiply(a, b) {
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, 4 * Math.floor(i / 4)];
    return a[row] * b[column] + a[row + 4] * b[column + 1] + a[row + 8] * b[column + 2] + a[row + 12] * b[column + 3];
  });
}

/**
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @returns {Matrix}
 */
export function translation(x, y, z) {
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
}

/**
 * @param {number} degrees
 * @returns {Matrix}
 */
export function aboutX(degrees) {
  const [c, s] = [Math.cos(degrees * RADIANS_PER_DEGREE), Math.sin(degrees * RADIANS_PER_DEGREE)];
  return [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1];
}

/**
 * @param {number} degrees
 * @returns {Matrix}
 */
export function aboutZ(degrees) {
  const [c, s] = [Math.cos(degrees * RADIANS_PER_DEGREE), Math.sin(degrees * RADIANS_PER_DEGREE)];
  return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

/**
 * To clip coordinates, seen from the origin along −z.
 *
 * @param {number} slopeX half the picture's width at distance 1
 * @param {number} slopeY half its height
 * @param {number} near
 * @param {number} far
 * @returns {Matrix}
 */
export function perspective(slopeX, slopeY, near, far) {
  const depth = near - far;
  return [1 / slopeX, 0, 0, 0, 0, 1 / slopeY, 0, 0, 0, 0, (near + far) / depth, -1, 0, 0, (2 * near * far) / depth, 0];
}

/**
 * The image of a point as (x, y, z, w), before the division.
 *
 * @param {Matrix} m
 * @param {ArrayLike<number>} p
 * @param {number} [at] where its three numbers begin
 * @returns {[number, number, number, number]}
 */
export function image(m, p, at = 0) {
  const [x, y, z] = [p[at], p[at + 1], p[at + 2]];
  const row = (/** @type {number} */ r) => m[r] * x + m[r + 4] * y + m[r + 8] * z + m[r + 12];
  return [row(0), row(1), row(2), row(3)];
}
