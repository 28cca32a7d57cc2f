// CSS cubic-bezier() in JavaScript, because a call of the core takes longer than the function. src/easing.rs performs
// the same operations in the same order and gives bit-identical results.
import { finite } from "./check.js";

/** The number of pieces of the range of t. A power of two, so that the Bernstein weights at the nodes are exact. */
const PIECES = 32;
/**
 * The numbers of a node: x as a sum of two numbers, its three Taylor coefficients, the same of y, three coefficients of
 * the inverse function.
 */
const NODE_LENGTH = 13;
/** An error of t that can be neglected: a sixteenth of the rounding error of 1. */
const NEGLIGIBLE = 2 ** -57;
/** Below this ratio of the first piece, Newton's method starts from an estimate of the magnitude of t. */
const NEAR_START = 2 ** -10;
/** The factor for `upper` that drops half of the bits of a number. */
const HALF = 2 ** 27;
/** Handles above this value are scaled by 2⁻¹⁰⁰ for the computation, so that no sum overflows. */
const HUGE = 2 ** 900;
/** A safety limit: four times the largest number of steps ever observed. */
const MAX_STEPS = 100;

/**
 * The timing function of CSS `cubic-bezier(x1, y1, x2, y2)`: the curve from (0, 0) to (1, 1) with the handles (x1, y1)
 * and (x2, y2), as a function from x to y.
 *
 *     const ease = easing(0.25, 0.1, 0.25, 1);
 *     ease(0.5); // 0.802403387584857
 *
 * Exact at 0 and 1; between them the result is y(t) for a t with |x(t) − x| ≤ 10⁻¹⁵; never NaN. Below 0 and above 1 it is
 * extrapolated along the tangent at the end, as CSS specifies.
 *
 * Source: CSS Easing Functions Level 1, "Cubic Bézier easing functions".
 *
 * @param {number} x1 0 to 1
 * @param {number} y1
 * @param {number} x2 0 to 1
 * @param {number} y2
 * @returns {(x: number) => number}
 * @throws {RangeError} for an x1 or x2 outside of 0 to 1, a NaN or an infinity; the returned function throws it, too
 */
export function easing(x1, y1, x2, y2) {
  checkAbscissa(x1, "x1");
  finite(y1, "y1");
  checkAbscissa(x2, "x2");
  finite(y2, "y2");
  const slopes = [slope(x1, y1, x2, y2), slope(1 - x2, 1 - y2, 1 - x1, 1 - y1)];
  if (x1 === y1 && x2 === y2) return (x) => finite(x, "x") + 0; // turns −0 into 0
  const huge = Math.max(Math.abs(y1), Math.abs(y2)) > HUGE;
  const unit = huge ? 2 ** -100 : 1;
  const table = nodes(x1, x2, y1 * unit, y2 * unit, unit);
  const starts = firstPieces(table);
  return (x) => {
    if (!(typeof x === "number" && x > 0 && x < 1)) return outside(finite(x, "x"), slopes);
    const y = solve(table, starts, x);
    return huge ? bounded(y / unit) : y;
  };
}

/**
 * @param {unknown} value
 * @param {string} name
 */
function checkAbscissa(value, name) {
  const x = finite(value, name);
  if (!(x >= 0 && x <= 1)) throw new RangeError(`${name}: expected a number from 0 to 1, got ${x}`);
}

/**
 * The slope of the extrapolation at (0, 0): of the line to the first control point with a larger x, as CSS specifies.
 *
 * @param {number} x1
 * @param {number} y1
 * @param {number} x2
 * @param {number} y2
 */
function slope(x1, y1, x2, y2) {
  if (x1 > 0) return bounded(y1 / x1);
  if (y1 !== 0) return 0;
  if (x2 > 0) return bounded(y2 / x2);
  return y2 === 0 ? 1 : 0;
}

/** @param {number} value */
function bounded(value) {
  return Math.min(Math.max(value, -Number.MAX_VALUE), Number.MAX_VALUE);
}

/**
 * @param {number} x
 * @param {number[]} slopes
 */
function outside(x, [first, last]) {
  if (x <= 0) return x === 0 ? 0 : bounded(first * x) + 0;
  return x === 1 ? 1 : bounded(1 + last * (x - 1));
}

/**
 * The nodes t = k/PIECES: the Taylor expansions of x and y, and the cubic that approximates the inverse function, x to
 * t, on the piece that begins there.
 *
 * @param {number} x1
 * @param {number} x2
 * @param {number} y1
 * @param {number} y2
 * @param {number} end the y of the end
 */
function nodes(x1, x2, y1, y2, end) {
  const table = new Float64Array((PIECES + 1) * NODE_LENGTH);
  for (let k = 0; k <= PIECES; k++) {
    expand(table, k * NODE_LENGTH, k / PIECES, x1, x2, 1);
    expand(table, k * NODE_LENGTH + 5, k / PIECES, y1, y2, end);
  }
  for (let k = 0; k < PIECES; k++) invert(table, k * NODE_LENGTH);
  return table;
}

/**
 * Writes the Taylor expansion of one coordinate with the control values 0, a, b and end about t.
 *
 * @param {Float64Array} table
 * @param {number} at
 * @param {number} t a multiple of 1/PIECES
 * @param {number} a
 * @param {number} b
 * @param {number} end
 */
function expand(table, at, t, a, b, end) {
  const s = 1 - t;
  // The weights have at most 15 bits, so their products with the upper half of a number's bits are exact.
  const u = 3 * t * s * s;
  const v = 3 * t * t * s;
  const w = t * t * t * end;
  const highA = upper(a, HALF);
  const highB = upper(b, HALF);
  const pair = u * highA + v * highB;
  const sum = pair + w;
  const low = rest(u * highA, v * highB, pair) + rest(pair, w, sum) + u * (a - highA) + v * (b - highB);
  const value = sum + low;
  table[at] = value;
  table[at + 1] = low - (value - sum);
  table[at + 2] = 3 * (a * s * s + 2 * (b - a) * t * s + (end - b) * t * t);
  table[at + 3] = 3 * ((b - 2 * a) * s + (end - 2 * b + a) * t);
  table[at + 4] = end + 3 * (a - b);
}

/**
 * A number rounded to fewer bits (Veltkamp).
 *
 * @param {number} value
 * @param {number} factor 2 to the number of bits that are dropped
 */
function upper(value, factor) {
  const spread = (factor + 1) * value;
  return spread - (spread - value);
}

/**
 * The rounding error of a sum (Knuth).
 *
 * @param {number} a
 * @param {number} b
 * @param {number} sum
 */
function rest(a, b, sum) {
  const part = sum - a;
  return a - (sum - part) + (b - part);
}

/**
 * Writes the cubic that approximates the inverse function, x to t, on a piece. It has the slopes of the ends, limited
 * to three times the slope of the chord, so that it is monotone (Fritsch and Carlson, "Monotone piecewise cubic
 * interpolation", 1980).
 *
 * @param {Float64Array} table
 * @param {number} at
 */
function invert(table, at) {
  const width = table[at + NODE_LENGTH] - table[at];
  const chord = 1 / PIECES / width;
  const first = Math.min(Math.abs(1 / table[at + 2]), 3 * chord);
  const last = Math.min(Math.abs(1 / table[at + NODE_LENGTH + 2]), 3 * chord);
  table[at + 10] = first;
  table[at + 11] = (3 * chord - 2 * first - last) / width;
  table[at + 12] = (first + last - 2 * chord) / width / width;
}

/**
 * For each interval of x of width 1/PIECES, the piece of t that contains its start.
 *
 * @param {Float64Array} table
 */
function firstPieces(table) {
  const starts = new Uint16Array(PIECES);
  let piece = 0;
  for (let i = 0; i < PIECES; i++) {
    while (piece < PIECES - 1 && table[(piece + 1) * NODE_LENGTH] <= i / PIECES) piece++;
    starts[i] = piece * NODE_LENGTH;
  }
  return starts;
}

/**
 * The value of y at an x between 0 and 1.
 *
 * @param {Float64Array} table
 * @param {Uint16Array} starts
 * @param {number} x
 */
function solve(table, starts, x) {
  let at = starts[(x * PIECES) | 0];
  while (table[at + NODE_LENGTH] <= x) at += NODE_LENGTH;
  // Errors are relative here. Rounding x to 48 bits makes each step of x larger than the error, so that y is monotone.
  if (at === 0) x = Math.min(upper(x, 2 ** 5), table[NODE_LENGTH]);
  const distance = x - table[at];
  let d = distance * (table[at + 10] + distance * (table[at + 11] + distance * table[at + 12]));
  if (at === 0 && x < table[NODE_LENGTH] * NEAR_START) {
    d = sizeAtStart(table, x);
  } else if (d > 0.5 / PIECES) {
    // Use the nearer node, so that a small difference is added to an exact value.
    at += NODE_LENGTH;
    d -= 1 / PIECES;
  }
  return newton(table, at, x, d);
}

/**
 * An estimate of the magnitude of t for a small x, where no term of the cubic is larger than x.
 *
 * @param {Float64Array} table
 * @param {number} x
 */
function sizeAtStart(table, x) {
  const fourth = Math.sqrt(Math.sqrt(x));
  const sixteenth = Math.sqrt(Math.sqrt(fourth));
  const cubic = fourth * sixteenth * Math.sqrt(Math.sqrt(sixteenth)); // x to the power 21/64, almost a cube root
  return 1 / (table[2] / x + Math.sqrt(Math.abs(table[3])) / Math.sqrt(x) + 1 / cubic);
}

/**
 * The value of y at the zero of x(node + d) − x, by Newton's method; a step that leaves the pieces beside the node is
 * replaced by a bisection.
 *
 * The iteration ends when the remaining error of a step, step² · |x″| / (2 x′), is negligible: relative to t at the
 * first node, relative to 1 at the others.
 *
 * @param {Float64Array} table
 * @param {number} at
 * @param {number} x
 * @param {number} d the start value
 */
function newton(table, at, x, d) {
  const c1 = table[at + 2];
  const c2 = table[at + 3];
  const c3 = table[at + 4];
  const target = x - table[at] - table[at + 1];
  const origin = at === 0 ? 0 : 1;
  let min = -origin / PIECES;
  let max = 1 / PIECES;
  for (let count = 0; count < MAX_STEPS; count++) {
    const residual = target - d * (c1 + d * (c2 + d * c3));
    if (residual === 0) break;
    const derivative = c1 + d * (2 * c2 + 3 * d * c3);
    const step = residual / derivative;
    if (residual > 0) min = d;
    else max = d;
    const negligible = step * step * Math.abs(c2 + 3 * d * c3) <= NEGLIGIBLE * derivative * (origin + d);
    d += step;
    if (negligible) break;
    if (!(d >= min && d <= max)) d = 0.5 * (min + max);
  }
  return table[at + 5] + (table[at + 6] + d * (table[at + 7] + d * (table[at + 8] + d * table[at + 9])));
}
