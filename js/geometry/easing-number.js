// Numbers of timing functions.

/**
 * The nearest finite number, for results that overflow.
 *
 * @internal
 * @param {number} value
 */
export function clampToFinite(value) {
  return Math.min(Math.max(value, -Number.MAX_VALUE), Number.MAX_VALUE);
}
