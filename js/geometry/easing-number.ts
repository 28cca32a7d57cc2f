// Numbers of timing functions.

/**
 * The nearest finite number, for results that overflow.
 *
 * @internal
 */
export function clampToFinite(value: number) {
  return Math.min(Math.max(value, -Number.MAX_VALUE), Number.MAX_VALUE);
}
