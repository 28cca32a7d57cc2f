// CSS cubic-bezier() in JavaScript: a call into the core would cost more than the function itself. src/easing/cubic.rs
// performs the same operations in the same order and gives bit-identical results.
import { clampToFinite } from "./easing-number.js";

/** The number of pieces of the parameter range. A power of two, so that the Bernstein weights at the nodes are exact. */
const PIECES = 32;
/** The numbers of a node: x as a sum of two, its three Taylor coefficients, the same of y, three coefficients of the inverse. */
const WIDTH = 13;
/** An error of t that can be neglected: a sixteenth of the rounding error of 1. */
const NEGLIGIBLE = 2 ** -57;
/** Below this ratio of the first piece, Newton's method starts from an estimate of the magnitude of t. */
const NEAR_START = 2 ** -10;
/** The factor for `upper` that drops half of the bits of a number. */
const HALF = 2 ** 27;
/** Handles above this value are scaled by 2⁻¹⁰⁰ for the computation, so that no sum overflows. */
const HUGE = 2 ** 900;
/** A safety limit: four times the maximum number of steps that was ever observed. */
const MAX_STEPS = 100;

/**
 * The timing function `cubic-bezier(x1, y1, x2, y2)` for checked handles: y over x for the cubic curve from (0, 0) to
 * (1, 1) with the handles (x1, y1) and (x2, y2).
 *
 * @internal
 * @param handles x1, y1, x2, y2
 * @returns for finite numbers
 */
export function cubicBezier([x1, y1, x2, y2]: readonly number[]): (x: number) => number {
  const slopes = [slope(x1, y1, x2, y2), slope(1 - x2, 1 - y2, 1 - x1, 1 - y1)];
  if (x1 === y1 && x2 === y2) return (x) => x + 0; // turns −0 into 0
  const huge = Math.max(Math.abs(y1), Math.abs(y2)) > HUGE;
  const unit = huge ? 2 ** -100 : 1;
  const table = nodes(x1, x2, y1 * unit, y2 * unit, unit);
  const starts = firstPieces(table);
  return (x) => {
    if (!(x > 0 && x < 1)) return outside(x, slopes);
    const y = solve(table, starts, x);
    return huge ? clampToFinite(y / unit) : y;
  };
}

/**
 * The slope at (0, 0) as CSS defines it: that of the line to the first control point that differs from (0, 0), or 0 if
 * that line is vertical.
 */
function slope(x1: number, y1: number, x2: number, y2: number) {
  if (x1 > 0) return clampToFinite(y1 / x1);
  if (y1 !== 0) return 0;
  if (x2 > 0) return clampToFinite(y2 / x2);
  return y2 === 0 ? 1 : 0;
}

function outside(x: number, [first, last]: number[]) {
  if (x <= 0) return x === 0 ? 0 : clampToFinite(first * x) + 0;
  return x === 1 ? 1 : clampToFinite(1 + last * (x - 1));
}

/**
 * The Taylor expansions about t = k/PIECES, and the inverse function, x to t, on the piece that begins there.
 *
 * @param end the y of the end
 */
function nodes(x1: number, x2: number, y1: number, y2: number, end: number) {
  const table = new Float64Array((PIECES + 1) * WIDTH);
  for (let k = 0; k <= PIECES; k++) {
    expand(table, k * WIDTH, k / PIECES, x1, x2, 1);
    expand(table, k * WIDTH + 5, k / PIECES, y1, y2, end);
  }
  for (let k = 0; k < PIECES; k++) invert(table, k * WIDTH);
  return table;
}

/**
 * The expansion of one coordinate with the control values 0, a, b, end about t.
 *
 * @param t a multiple of 1/PIECES
 */
function expand(table: Float64Array, at: number, t: number, a: number, b: number, end: number) {
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
 * A number rounded to fewer bits (Veltkamp splitting).
 *
 * @param less 2 to the power of the number of bits dropped
 */
function upper(value: number, less: number) {
  const spread = (less + 1) * value;
  return spread - (spread - value);
}

/** The rounding error of a sum (Knuth's two-sum). */
function rest(a: number, b: number, sum: number) {
  const part = sum - a;
  return a - (sum - part) + (b - part);
}

/**
 * The cubic Hermite interpolant of the inverse function, x to t. Its end slopes are limited to three times the slope of
 * the chord, which makes it monotone (Fritsch and Carlson, "Monotone piecewise cubic interpolation", 1980).
 */
function invert(table: Float64Array, at: number) {
  const width = table[at + WIDTH] - table[at];
  const chord = 1 / PIECES / width;
  const first = Math.min(Math.abs(1 / table[at + 2]), 3 * chord);
  const last = Math.min(Math.abs(1 / table[at + WIDTH + 2]), 3 * chord);
  table[at + 10] = first;
  table[at + 11] = (3 * chord - 2 * first - last) / width;
  table[at + 12] = (first + last - 2 * chord) / width / width;
}

/** For each start of an interval of x of width 1/PIECES, the offset of the piece of t that contains it. */
function firstPieces(table: Float64Array) {
  const starts = new Uint16Array(PIECES);
  let piece = 0;
  for (let i = 0; i < PIECES; i++) {
    while (piece < PIECES - 1 && table[(piece + 1) * WIDTH] <= i / PIECES) piece++;
    starts[i] = piece * WIDTH;
  }
  return starts;
}

/** The value of y at x between 0 and 1. */
function solve(table: Float64Array, starts: Uint16Array, x: number) {
  let at = starts[(x * PIECES) | 0];
  while (table[at + WIDTH] <= x) at += WIDTH;
  // Errors are relative here. Rounding x to 48 bits makes each step of x larger than the error, so that y is monotone.
  if (at === 0) x = Math.min(upper(x, 2 ** 5), table[WIDTH]);
  const far = x - table[at];
  let d = far * (table[at + 10] + far * (table[at + 11] + far * table[at + 12]));
  if (at === 0 && x < table[WIDTH] * NEAR_START) {
    d = sizeAtStart(table, x);
  } else if (d > 0.5 / PIECES) {
    // Use the nearer node, so that a small difference is added to an exact value.
    at += WIDTH;
    d -= 1 / PIECES;
  }
  return newton(table, at, x, d);
}

/** An estimate of t for a small x; no single term of the cubic exceeds x there. */
function sizeAtStart(table: Float64Array, x: number) {
  const fourth = Math.sqrt(Math.sqrt(x));
  const sixteenth = Math.sqrt(Math.sqrt(fourth));
  const cubic = fourth * sixteenth * Math.sqrt(Math.sqrt(sixteenth)); // x to the power 21/64, approximately the cube root
  return 1 / (table[2] / x + Math.sqrt(Math.abs(table[3])) / Math.sqrt(x) + 1 / cubic);
}

/**
 * y at the zero of x(node + d) − x, by Newton's method; a step beyond the bracket is replaced by a bisection.
 *
 * The iteration ends when the error that a step leaves, step² · |x″| / (2 x′), is negligible: relative to t at the first
 * node, relative to 1 at the others.
 *
 * @param d the start value
 */
function newton(table: Float64Array, at: number, x: number, d: number) {
  const c1 = table[at + 2];
  const c2 = table[at + 3];
  const c3 = table[at + 4];
  const sought = x - table[at] - table[at + 1];
  const origin = at === 0 ? 0 : 1;
  let min = -origin / PIECES;
  let max = 1 / PIECES;
  for (let count = 0; count < MAX_STEPS; count++) {
    const off = sought - d * (c1 + d * (c2 + d * c3));
    if (off === 0) break;
    const speed = c1 + d * (2 * c2 + 3 * d * c3);
    const step = off / speed;
    if (off > 0) min = d;
    else max = d;
    const negligible = step * step * Math.abs(c2 + 3 * d * c3) <= NEGLIGIBLE * speed * (origin + d);
    d += step;
    if (negligible) break;
    if (!(d >= min && d <= max)) d = 0.5 * (min + max);
  }
  return table[at + 5] + (table[at + 6] + d * (table[at + 7] + d * (table[at + 8] + d * table[at + 9])));
}
