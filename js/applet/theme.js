// The colours of the picture, as the style sheet has them now: light, dark or forced.

/**
 * The roles of colour. Each has a custom property `--bz-<role>` in style.js.
 */
export const ROLES = /** @type {const} */ ([
  "ink",
  "quiet",
  "paper",
  "curve",
  "handle",
  "first",
  "second",
  "level1",
  "level2",
]);

/** @typedef {typeof ROLES[number]} Role */
/** @typedef {Record<Role, string>} Theme */

/**
 * Reads colours off a probe element, which resolves variables and system colours alike.
 *
 * @template {string} [R=Role]
 * @param {HTMLElement} probe
 * @param {readonly R[]} [roles] each has a custom property `--bz-<role>`
 * @returns {Record<R, string>}
 */
export function readTheme(probe, roles = /** @type {readonly any[]} */ (ROLES)) {
  const style = getComputedStyle(probe);
  const read = (/** @type {R} */ role) => {
    probe.style.color = `var(--bz-${role})`;
    return [role, style.color];
  };
  return Object.fromEntries(roles.map(read));
}

/** When these change, so do the colours; paper is white. */
const COLOUR_QUERIES = ["(prefers-color-scheme: dark)", "(forced-colors: active)", "print"];

/**
 * @param {() => void} changed
 * @returns {() => void} ends it
 */
export function followColours(changed) {
  const queries = COLOUR_QUERIES.map((query) => matchMedia(query));
  for (const query of queries) query.addEventListener("change", changed);
  return () => queries.forEach((query) => query.removeEventListener("change", changed));
}

/**
 * @template {string} [R=Role]
 * @param {HTMLElement} probe
 * @param {(theme: Record<R, string>) => void} changed
 * @param {readonly R[]} [roles]
 * @returns {() => void} ends it
 */
export function followTheme(probe, changed, roles) {
  return followColours(() => changed(readTheme(probe, roles)));
}
