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
    if (!text.startsWith(PREFIX)) return;
    try {
      if (text.length > LONGEST)
        throw new RangeError(`it is ${text.length} characters long, at most ${LONGEST} are read`);
      const state = JSON.parse(decodeURIComponent(text.slice(PREFIX.length)));
      if (typeof state !== "object" || state === null) throw new RangeError("expected an object behind #state=");
      read(state);
      showMessage(element, "");
    } catch (error) {
      showMessage(
        element,
        `The address of this page could not be used: ${/** @type {Error} */ (error).message}. The page is as it was.`,
      );
    }
  };
  const save = () => {
    try {
      history.replaceState(null, "", PREFIX + encodeURIComponent(JSON.stringify(write())));
    } catch {
      // Browsers allow only so many a minute; the next change will do.
    }
  };
  load();
  element.addEventListener("change", save);
  addEventListener("hashchange", load);
  return () => {
    element.removeEventListener("change", save);
    removeEventListener("hashchange", load);
  };
}

/** Says it above the application; an empty text takes it away. @param {HTMLElement} element @param {string} words */
function showMessage(element, words) {
  const known = element.previousElementSibling;
  if (known?.matches(".state-message")) known.remove();
  if (!words) return;
  const line = Object.assign(document.createElement("p"), { className: "state-message", textContent: words });
  line.setAttribute("role", "status");
  element.before(line);
}
