// The colours of the picture, as the style sheet has them now: light, dark or forced.

/**
 * The roles of colour. Each has a custom property `--bz-<role>` in style.js.
 */
const ROLES = /** @type {const} */ (["ink", "quiet", "paper", "curve", "handle", "first", "second", "level1", "level2"]);

/** @typedef {Record<typeof ROLES[number], string>} Theme */

/**
 * Reads the colours off a probe element, which resolves variables and system colours alike.
 *
 * @param {HTMLElement} probe
 * @returns {Theme}
 */
export function readTheme(probe) {
  const style = getComputedStyle(probe);
  const read = (/** @type {string} */ role) => {
    probe.style.color = `var(--bz-${role})`;
    return [role, style.color];
  };
  return Object.fromEntries(ROLES.map(read));
}

/** When these change, so do the colours. */
const COLOUR_QUERIES = ["(prefers-color-scheme: dark)", "(forced-colors: active)"];

/**
 * @param {HTMLElement} probe
 * @param {(theme: Theme) => void} changed
 * @returns {() => void} ends it
 */
export function followTheme(probe, changed) {
  const listener = () => changed(readTheme(probe));
  const queries = COLOUR_QUERIES.map((query) => matchMedia(query));
  for (const query of queries) query.addEventListener("change", listener);
  return () => queries.forEach((query) => query.removeEventListener("change", listener));
}
