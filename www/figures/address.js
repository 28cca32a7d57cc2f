// What an application shows, in the page's address: `#state=…`, written when the user is done, read with suspicion.

const PREFIX = "#state=";
/** Longer ones are not ours: browsers and chats cut addresses long before. */
const LONGEST = 100_000;

/**
 * Keeps an element and the address in step.
 *
 * @param {HTMLElement} element tells "change" when the user is done
 * @param {{ read: (state: unknown) => void, write: () => unknown }} state `read` throws for what it cannot use, and then
 *   has changed nothing; `write` gives plain JSON
 * @returns {() => void} ends it
 */
export function keepInAddress(element, { read, write }) {
  const load = () => {
    const text = location.hash;
    if (!text.startsWith(PREFIX) || text.length > LONGEST) return;
    try {
      read(JSON.parse(decodeURIComponent(text.slice(PREFIX.length))));
    } catch {
      // Somebody's address, cut or made up: the page stays as it is.
    }
  };
  const save = () => history.replaceState(null, "", PREFIX + encodeURIComponent(JSON.stringify(write())));
  load();
  element.addEventListener("change", save);
  addEventListener("hashchange", load);
  return () => {
    element.removeEventListener("change", save);
    removeEventListener("hashchange", load);
  };
}
