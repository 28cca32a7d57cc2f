// What draws is a file of its own for each kind of element: pages with none of a kind in sight never fetch it.

/** What is said where it could not be fetched. */
export const MISSING =
  "The part that draws could not be loaded. It is asked for again when the picture comes back into view.";

/**
 * Fetches a module once for all elements of the page. Where that failed, the next call tries again.
 *
 * @template {object} T
 * @param {() => Promise<T>} fetch
 * @param {keyof T & string} part what is in it
 * @returns {() => Promise<T>}
 */
export function once(fetch, part) {
  /** @type {Promise<T> | null} */
  let loading = null;
  let tries = 0;
  let place = "";
  const forget = (/** @type {unknown} */ error) => {
    loading = null;
    place = placeIn(error) || place;
    throw error;
  };
  const ask = () =>
    fetch().catch((error) =>
      place ? anew(place, ++tries, part).catch(() => Promise.reject(error)) : Promise.reject(error),
    );
  return () => (loading ??= ask().catch(forget));
}

/**
 * Firefox keeps in mind, as the standard has it, that a module could not be fetched: it has to be asked by another name.
 *
 * @param {string} place
 * @param {number} tries
 * @param {string} part
 */
async function anew(place, tries, part) {
  const module = await import(/* webpackIgnore: true */ /* @vite-ignore */ `${place}?again=${tries}`);
  if (part in module) return module;
  throw new TypeError(`no ${part} in ${place}`); // a bundler gave it another name
}

/** The address that browsers name in their message. @param {unknown} error */
function placeIn(error) {
  return /https?:[^\s?#]+/.exec(error instanceof Error ? error.message : "")?.[0] ?? "";
}
