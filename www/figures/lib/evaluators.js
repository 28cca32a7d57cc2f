// Four ways to a point of a Bézier curve, written over an arithmetic, so that the same lines compute with 32 bits, with 64,
// or count what they do. Curves here have one coordinate: lists of numbers.

/**
 * @typedef {object} Arithmetic
 * @property {(a: number, b: number) => number} add
 * @property {(a: number, b: number) => number} sub
 * @property {(a: number, b: number) => number} mul
 */

/** Every result rounded to 32 bits, as a shader or a C float has it. @type {Arithmetic} */
export const SINGLE = {
  add: (a, b) => Math.fround(a + b),
  sub: (a, b) => Math.fround(a - b),
  mul: (a, b) => Math.fround(a * b),
};

/**
 * Arithmetic that counts.
 *
 * @returns {Arithmetic & { counts: { sub: number, add: number, mul: number } }}
 */
export function counting() {
  const counts = { sub: 0, add: 0, mul: 0 };
  return {
    counts,
    add: (a, b) => {
      counts.add++;
      return a + b;
    },
    sub: (a, b) => {
      counts.sub++;
      return a - b;
    },
    mul: (a, b) => {
      counts.mul++;
      return a * b;
    },
  };
}

/**
 * C(n, 0) … C(n, n); whole numbers below 2²⁴ up to n = 24.
 *
 * @param {number} n
 */
export function binomials(n) {
  const row = [1];
  for (let k = 1; k <= n; k++) row.push(Math.round((row[k - 1] * (n - k + 1)) / k));
  return row;
}

/** @param {Arithmetic} o @param {number} base @param {number} exponent */
function power(o, base, exponent) {
  let value = 1;
  for (let k = 0; k < exponent; k++) value = k === 0 ? base : o.mul(value, base);
  return value;
}

/**
 * Each weight C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ by itself, then the sum of weighted points.
 *
 * @param {Arithmetic} o
 * @param {readonly number[]} points
 * @param {number} t
 */
export function bernstein(o, points, t) {
  const n = points.length - 1;
  const s = o.sub(1, t);
  const terms = binomials(n).map((c, i) => o.mul(o.mul(c, o.mul(power(o, s, n - i), power(o, t, i))), points[i]));
  return terms.reduce(o.add);
}

/**
 * The coefficients of 1, t, t², …: the basis matrix times the points.
 *
 * @param {Arithmetic} o
 * @param {readonly number[]} points
 */
export function coefficients(o, points) {
  const n = points.length - 1;
  return binomials(n).map((outer, j) => {
    const terms = binomials(j).map((inner, i) => o.mul((j - i) % 2 === 0 ? outer * inner : -outer * inner, points[i]));
    return terms.reduce(o.add);
  });
}

/**
 * [tⁿ … t 1]·M·P: powers first, then the sum.
 *
 * @param {Arithmetic} o
 * @param {readonly number[]} points
 * @param {number} t
 */
export function powers(o, points, t) {
  const terms = coefficients(o, points).map((a, j) => (j === 0 ? a : o.mul(a, power(o, t, j))));
  return terms.reduce(o.add);
}

/**
 * The same coefficients, nested: a₀ + t (a₁ + t (a₂ + …)).
 *
 * @param {Arithmetic} o
 * @param {readonly number[]} points
 * @param {number} t
 */
export const horner = (o, points, t) => coefficients(o, points).reduceRight((sum, a) => o.add(o.mul(sum, t), a));

/**
 * (1 − t)·a + t·b, again and again.
 *
 * @param {Arithmetic} o
 * @param {readonly number[]} points
 * @param {number} t
 */
export function casteljau(o, points, t) {
  const s = o.sub(1, t);
  let row = [...points];
  while (row.length > 1) row = row.slice(1).map((b, i) => o.add(o.mul(s, row[i]), o.mul(t, b)));
  return row[0];
}
