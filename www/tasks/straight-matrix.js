import { verdict } from "./utils/curves.js";

/** [t³ t² t 1]·M·P = P0 + t (P3 − P0) */
const STRAIGHT = [0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1, 1, 0, 0, 0];
/** How wrong a weight may be: half a pixel for points 500 px apart. */
const ALLOWED = 0.001;
const STEPS = 20;

/** The four weights at t. @param {ArrayLike<number>} matrix row by row @param {number} t */
const weightsAt = (matrix, t) =>
  [0, 1, 2, 3].map((column) =>
    [t ** 3, t ** 2, t, 1].reduce((sum, power, row) => sum + power * matrix[4 * row + column], 0),
  );

/** How wrong the weights at t are. @param {ArrayLike<number>} matrix @param {number} t */
const errorAt = (matrix, t) => {
  const expected = [1 - t, 0, 0, t];
  return Math.max(...weightsAt(matrix, t).map((weight, i) => Math.abs(weight - expected[i])));
};

/** @param {{ basis: string, matrix: ArrayLike<number> }} figure */
export function check({ basis, matrix }) {
  if (basis !== "matrix") return verdict(false, "Change a number of the matrix.");
  // A polynomial of degree 3 that is 0 at four places is 0 everywhere.
  const worst = Array.from({ length: STEPS + 1 }, (_, i) => i / STEPS).reduce((a, b) =>
    errorAt(matrix, b) > errorAt(matrix, a) ? b : a,
  );
  if (errorAt(matrix, worst) <= ALLOWED)
    return verdict(true, "This is the line from P0 to P3 at constant speed, whatever P1 and P2 are.");
  const weights = weightsAt(matrix, worst).map((weight) => String(Number(weight.toFixed(2))).replace("-", "−"));
  return verdict(
    false,
    `At t = ${worst.toFixed(2)} the weights are ${weights.join(", ")}. On the line only P0 and P3 have a weight: ${(1 - worst).toFixed(2)} and ${worst.toFixed(2)}.`,
  );
}

/** @param {{ matrix: number[], basis: string }} element */
export function reveal(element) {
  element.basis = "matrix";
  element.matrix = STRAIGHT;
}
