// What draws is a file of its own for each kind of element: pages with none of a kind in sight never fetch it.
import { translated } from "../editor/translations.js";

/** What is said where it could not be fetched. */
export const missing = () =>
  translated("The part that draws could not be loaded. It is asked for again when the picture comes back into view.");

/**
 * Fetches a module once for all elements of the page. Where that failed, the next call tries again.
 *
 * @param part what is in it
 */
export function once<T extends object>(fetch: () => Promise<T>, part: keyof T & string): () => Promise<T> {
  let loading: Promise<T> | null = null;
  let tries = 0;
  let place = "";
  const forget = (error: unknown) => {
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
 */
async function anew(place: string, tries: number, part: string) {
  const module = await import(/* webpackIgnore: true */ /* @vite-ignore */ `${place}?again=${tries}`);
  if (part in module) return module;
  throw new TypeError(`no ${part} in ${place}`); // a bundler gave it another name
}

/** The address that browsers name in their message. */
function placeIn(error: unknown) {
  return /https?:[^\s?#]+/.exec(error instanceof Error ? error.message : "")?.[0] ?? "";
}
