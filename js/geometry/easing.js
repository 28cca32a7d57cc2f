// CSS cubic-bezier() in plain JavaScript: a call costs less than crossing into the core. src/easing.rs does the same,
// operation by operation, and gives the same bits.
import { finite } from "./check.js";

/** Pieces into which t is cut. A power of two, so that Bernstein weights at the nodes are exact. */
const PIECES = 32;
/** Numbers of a node: x as a sum of two, its three Taylor coefficients, the same of y, three coefficients of the way back. */
const WIDTH = 13;
/** An error of t that is as good as none: a sixteenth of the rounding error of 1. */
const NEGLIGIBLE = 2 ** -57;
/** Within this part of the first piece, Newton's method starts from the size of the terms. */
const NEAR_START = 2 ** -10;
/** Half of a number's bits. */
const HALF = 2 ** 27;
/** Handles above this are computed at 2⁻¹⁰⁰ of their size, so that no sum overflows. */
const HUGE = 2 ** 900;
/** A bound, not a plan: four times what Newton's method ever took. */
const MOST_STEPS = 100;

/**
 * The timing function of CSS `cubic-bezier(x1, y1, x2, y2)`: the curve from (0, 0) to (1, 1) with the handles (x1, y1) and
 * (x2, y2), as y over x.
 *
 *     const ease = easing(0.25, 0.1, 0.25, 1);
 *     ease(0.5); // 0.802403387584857
 *
 * Exact at 0 and 1; in between |x(t) − x| ≤ 10⁻¹⁵ and y is that t's; never NaN. Below 0 and above 1 it goes on along the
 * tangent at the end, as CSS has it.
 *
 * Source: CSS Easing Functions Level 1, "Cubic Bézier easing functions".
 *
 * @param {number} x1 0 to 1
 * @param {number} y1
 * @param {number} x2 0 to 1
 * @param {number} y2
 * @returns {(x: number) => number}
 * @throws {RangeError} for an x1 or x2 outside of 0 to 1, a NaN or an infinity, here and in the function's calls
 */
export function easing(x1, y1, x2, y2) {
  abscissa(x1, "x1");
  finite(y1, "y1");
  abscissa(x2, "x2");
  finite(y2, "y2");
  const slopes = [slope(x1, y1, x2, y2), slope(1 - x2, 1 - y2, 1 - x1, 1 - y1)];
  if (x1 === y1 && x2 === y2) return (x) => finite(x, "x") + 0; // no −0
  const huge = Math.max(Math.abs(y1), Math.abs(y2)) > HUGE;
  const unit = huge ? 2 ** -100 : 1;
  const table = nodes(x1, x2, y1 * unit, y2 * unit, unit);
  const starts = firstPieces(table);
  return (x) => {
    if (!(typeof x === "number" && x > 0 && x < 1)) return outside(finite(x, "x"), slopes);
    const y = solved(table, starts, x);
    return huge ? bounded(y / unit) : y;
  };
}

/**
 * @param {unknown} value
 * @param {string} name
 */
function abscissa(value, name) {
  const x = finite(value, name);
  if (!(x >= 0 && x <= 1)) throw new RangeError(`${name}: expected a number from 0 to 1, got ${x}`);
}

/**
 * The slope at (0, 0): of the line to the first control point that is ahead in x, as CSS chooses it.
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
 * The Taylor expansions about t = k/PIECES, and the way back from x to t on the piece that begins there.
 *
 * @param {number} x1
 * @param {number} x2
 * @param {number} y1
 * @param {number} y2
 * @param {number} top the y of the end
 */
function nodes(x1, x2, y1, y2, top) {
  const table = new Float64Array((PIECES + 1) * WIDTH);
  for (let k = 0; k <= PIECES; k++) {
    expand(table, k * WIDTH, k / PIECES, x1, x2, 1);
    expand(table, k * WIDTH + 5, k / PIECES, y1, y2, top);
  }
  for (let k = 0; k < PIECES; k++) invert(table, k * WIDTH);
  return table;
}

/**
 * One coordinate with the control values 0, a, b and end about t.
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
  // The weights have at most 15 bits: their products with half of a number's bits are exact.
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
 * @param {number} less 2 to the number of bits that are left out
 */
function upper(value, less) {
  const spread = (less + 1) * value;
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
 * The cubic that leads from x back to t on a piece, with the slopes of the ends, at most three times the chord's: it
 * rises then (Fritsch and Carlson, "Monotone piecewise cubic interpolation", 1980).
 *
 * @param {Float64Array} table
 * @param {number} at
 */
function invert(table, at) {
  const width = table[at + WIDTH] - table[at];
  const chord = 1 / PIECES / width;
  const first = Math.min(Math.abs(1 / table[at + 2]), 3 * chord);
  const last = Math.min(Math.abs(1 / table[at + WIDTH + 2]), 3 * chord);
  table[at + 10] = first;
  table[at + 11] = (3 * chord - 2 * first - last) / width;
  table[at + 12] = (first + last - 2 * chord) / width / width;
}

/**
 * For each PIECESth of the way in x, the piece of t in which it starts.
 *
 * @param {Float64Array} table
 */
function firstPieces(table) {
  const starts = new Uint16Array(PIECES);
  let piece = 0;
  for (let i = 0; i < PIECES; i++) {
    while (piece < PIECES - 1 && table[(piece + 1) * WIDTH] <= i / PIECES) piece++;
    starts[i] = piece * WIDTH;
  }
  return starts;
}

/**
 * y where the curve has this x, between 0 and 1.
 *
 * @param {Float64Array} table
 * @param {Uint16Array} starts
 * @param {number} x
 */
function solved(table, starts, x) {
  let at = starts[(x * PIECES) | 0];
  while (table[at + WIDTH] <= x) at += WIDTH;
  // Here errors are relative, and a step of x must be more than they are for y to rise: 48 bits of x are enough.
  if (at === 0) x = Math.min(upper(x, 2 ** 5), table[WIDTH]);
  const far = x - table[at];
  let d = far * (table[at + 10] + far * (table[at + 11] + far * table[at + 12]));
  if (at === 0 && x < table[WIDTH] * NEAR_START) {
    d = sizeAtStart(table, x);
  } else if (d > 0.5 / PIECES) {
    // From the node that is nearer: what is small is subtracted from what is exact.
    at += WIDTH;
    d -= 1 / PIECES;
  }
  return newton(table, at, x, d);
}

/**
 * About the t of a small x, where no term of the cubic can be larger than x.
 *
 * @param {Float64Array} table
 * @param {number} x
 */
function sizeAtStart(table, x) {
  const fourth = Math.sqrt(Math.sqrt(x));
  const sixteenth = Math.sqrt(Math.sqrt(fourth));
  const cubic = fourth * sixteenth * Math.sqrt(Math.sqrt(sixteenth)); // x to the power 21/64: a cube root, nearly
  return 1 / (table[2] / x + Math.sqrt(Math.abs(table[3])) / Math.sqrt(x) + 1 / cubic);
}

/**
 * y at the zero of x(node + d) − x, by Newton's method; a step that leaves the pieces beside the node is a bisection.
 *
 * Newton's method has ended when the error that its step leaves, step² · |x″| / (2 x′), is negligible: against t at the
 * first node, against 1 at the others.
 *
 * @param {Float64Array} table
 * @param {number} at
 * @param {number} x
 * @param {number} d where to begin
 */
function newton(table, at, x, d) {
  const c1 = table[at + 2];
  const c2 = table[at + 3];
  const c3 = table[at + 4];
  const sought = x - table[at] - table[at + 1];
  const origin = at === 0 ? 0 : 1;
  let least = -origin / PIECES;
  let most = 1 / PIECES;
  for (let count = 0; count < MOST_STEPS; count++) {
    const off = sought - d * (c1 + d * (c2 + d * c3));
    if (off === 0) break;
    const speed = c1 + d * (2 * c2 + 3 * d * c3);
    const step = off / speed;
    if (off > 0) least = d;
    else most = d;
    const negligible = step * step * Math.abs(c2 + 3 * d * c3) <= NEGLIGIBLE * speed * (origin + d);
    d += step;
    if (negligible) break;
    if (!(d >= least && d <= most)) d = 0.5 * (least + most);
  }
  return table[at + 5] + (table[at + 6] + d * (table[at + 7] + d * (table[at + 8] + d * table[at + 9])));
}
