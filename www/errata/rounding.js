// How many digits three ways of evaluation lose: in single precision, against the same in double precision.
import { Curve } from "casteljau";

const f = Math.fround;
const DEGREE = 12;
/** One coordinate; the values go up and down between 1 and 2, so that a unit in the last place is the same for all. */
const VALUES = Array.from({ length: DEGREE + 1 }, (_, i) => f(1.5 + 0.45 * Math.cos(2.4 * i)));
const LAST_PLACE = 2 ** -23;
export const SAMPLES = 200;

/** Pascal's row. */
const CHOOSE = VALUES.map((_, i) =>
  Array.from({ length: i }, (_, k) => (DEGREE - k) / (k + 1)).reduce((a, b) => a * b, 1),
).map(Math.round);

/** @param {number} t */
function bernstein(t) {
  const s = f(1 - t);
  const power = (/** @type {number} */ x, /** @type {number} */ k) => {
    let product = 1;
    for (; k > 0; k--) product = f(product * x);
    return product;
  };
  return VALUES.reduce(
    (total, value, i) => f(total + f(f(f(CHOOSE[i] * power(t, i)) * power(s, DEGREE - i)) * value)),
    0,
  );
}

/** @param {number} t */
function casteljau(t) {
  let values = VALUES;
  while (values.length > 1) values = values.slice(1).map((b, i) => f(f(f(1 - t) * values[i]) + f(t * b)));
  return values[0];
}

/** The coefficients of the powers of t: exact differences, rounded once. */
const COEFFICIENTS = (() => {
  let differences = VALUES;
  return VALUES.map((_, k) => {
    const first = f(CHOOSE[k] * differences[0]);
    differences = differences.slice(1).map((b, i) => b - differences[i]);
    return first;
  });
})();

/** Horner's rule. @param {number} t */
const powers = (t) => COEFFICIENTS.reduceRight((total, c) => f(f(total * t) + c), 0);

/** The greatest error of each, in units in the last place. */
export function rounding() {
  const exact = new Curve(VALUES.map((y) => [0, y]));
  const worst = (/** @type {(t: number) => number} */ way) =>
    Math.max(
      ...Array.from({ length: SAMPLES + 1 }, (_, i) => f(i / SAMPLES)).map((t) => Math.abs(way(t) - exact.eval(t).y)),
    ) / LAST_PLACE;
  return { bernstein: worst(bernstein), casteljau: worst(casteljau), powers: worst(powers) };
}
