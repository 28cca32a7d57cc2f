// What draws is a file of its own for each kind of element: pages with none of a kind in sight never fetch it.

/** What is said where it could not be fetched. */
export const MISSING = "The part that draws could not be loaded. It is asked for again when the picture comes back into view.";

/**
 * Fetches something once for all elements of the page. Where that failed, the next call tries again.
 *
 * @template T
 * @param {() => Promise<T>} fetch
 * @returns {() => Promise<T>}
 */
export function once(fetch) {
  /** @type {Promise<T> | null} */
  let loading = null;
  const forget = (/** @type {unknown} */ error) => {
    loading = null;
    throw error;
  };
  return () => (loading ??= fetch().catch(forget));
}
