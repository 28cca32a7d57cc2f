// Numbers in texts: the fewest digits that give the number back.

/** Every number of 32 bits is told apart by 9 digits, none by fewer than 6 where it has more (FLT_DIG of C). */
const FLOAT_DIGITS = [6, 7, 8, 9];

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
  if (list instanceof Float64Array) return String(x);
  for (const digits of FLOAT_DIGITS) {
    const short = Number(x.toPrecision(digits));
    if (Math.fround(short) === x) return String(short);
  }
  return String(x);
}
