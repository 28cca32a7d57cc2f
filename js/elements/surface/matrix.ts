// 4×4 matrices: 16 numbers, column after column.

export type Matrix = number[];
export type Vector = [number, number, number];

const RADIANS_PER_DEGREE = Math.PI / 180;

/** First b, then a. */
export function multiply(a: Matrix, b: Matrix): Matrix {
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, 4 * Math.floor(i / 4)];
    return a[row] * b[column] + a[row + 4] * b[column + 1] + a[row + 8] * b[column + 2] + a[row + 12] * b[column + 3];
  });
}

export function translation(x: number, y: number, z: number): Matrix {
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
}

export function aboutX(degrees: number): Matrix {
  const [c, s] = [Math.cos(degrees * RADIANS_PER_DEGREE), Math.sin(degrees * RADIANS_PER_DEGREE)];
  return [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1];
}

export function aboutZ(degrees: number): Matrix {
  const [c, s] = [Math.cos(degrees * RADIANS_PER_DEGREE), Math.sin(degrees * RADIANS_PER_DEGREE)];
  return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

/**
 * To clip coordinates, seen from the origin along −z.
 *
 * @param slopeX half the picture's width at distance 1
 * @param slopeY half its height
 */
export function perspective(slopeX: number, slopeY: number, near: number, far: number): Matrix {
  const depth = near - far;
  return [1 / slopeX, 0, 0, 0, 0, 1 / slopeY, 0, 0, 0, 0, (near + far) / depth, -1, 0, 0, (2 * near * far) / depth, 0];
}

/**
 * The image of a point as (x, y, z, w), before the division.
 *
 * @param at where its three numbers begin
 */
export function image(m: Matrix, p: ArrayLike<number>, at = 0): [number, number, number, number] {
  const [x, y, z] = [p[at], p[at + 1], p[at + 2]];
  const row = (r: number) => m[r] * x + m[r + 4] * y + m[r + 8] * z + m[r + 12];
  return [row(0), row(1), row(2), row(3)];
}
