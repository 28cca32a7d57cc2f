// Numbers as text with the fewest digits that round-trip.

/** With this number of digits, every f32 round-trips (FLT_DECIMAL_DIG of C). */
const MAX_DIGITS = 9;
/** Every decimal number with at most this number of digits is preserved by a normal f32 (FLT_DIG of C). */
const MIN_DIGITS = 6;
/** Smaller numbers are subnormal: they have fewer bits and need fewer digits. */
const MIN_NORMAL = 2 ** -126;
/** f32 represents all integers below this. */
const MAX_EXACT_INTEGER = 2 ** 24;

/**
 * Formats an element of a typed array.
 *
 * @internal
 */
export function formatNumber(list: Float32Array | Float64Array, k: number): string {
  const x = list[k];
  if (Object.is(x, -0)) return "-0"; // String would lose the sign
  if (list instanceof Float64Array || (Number.isInteger(x) && Math.abs(x) < MAX_EXACT_INTEGER)) return String(x);
  // Downwards, because most numbers need all digits or all but one.
  const minDigits = Math.abs(x) < MIN_NORMAL ? 1 : MIN_DIGITS;
  let shortest = Number(x.toPrecision(MAX_DIGITS));
  for (let digits = MAX_DIGITS - 1; digits >= minDigits; digits--) {
    const shorter = Number(x.toPrecision(digits));
    if (Math.fround(shorter) !== x) break;
    shortest = shorter;
  }
  return String(shortest);
}
