// Numbers in texts: the fewest digits that give the number back.

/** So many digits tell all numbers of 32 bits apart; whatever has fewer than so many comes out of so many (C's
 * FLT_DECIMAL_DIG and FLT_DIG). */
const MOST_DIGITS = 9;
const LEAST_DIGITS = 6;
/** Below this numbers have fewer bits, and fewer digits. */
const LEAST_NORMAL = 2 ** -126;

/** Whole numbers below this are numbers of 32 bits. */
const WHOLE_FLOATS = 2 ** 24;

/**
 * A number of a typed array.
 *
 * @internal
 * @param {Float32Array | Float64Array} list
 * @param {number} k
 * @returns {string}
 */
export function written(list, k) {
  const x = list[k];
  if (Object.is(x, -0)) return "-0"; // String would lose the sign
  if (list instanceof Float64Array || (Number.isInteger(x) && Math.abs(x) < WHOLE_FLOATS)) return String(x);
  // From above: most numbers need all digits, or all but one.
  const least = Math.abs(x) < LEAST_NORMAL ? 1 : LEAST_DIGITS;
  let shortest = Number(x.toPrecision(MOST_DIGITS));
  for (let digits = MOST_DIGITS - 1; digits >= least; digits--) {
    const shorter = Number(x.toPrecision(digits));
    if (Math.fround(shorter) !== x) break;
    shortest = shorter;
  }
  return String(shortest);
}
