// The colours of the picture, as the style sheet has them now: light, dark or forced.

/** The roles of colour. Each has a custom property `--bz-<role>` in style.js. */
const ROLES = /** @type {const} */ (["ink", "line", "paper", "front", "back", "handle", "level1", "level2", "low", "middle", "high", "gap", "wire"]);

/** @typedef {Record<typeof ROLES[number], number[]>} Theme each from 0 to 1: red, green, blue */

/** When these change, so do the colours. */
const COLOUR_QUERIES = ["(prefers-color-scheme: dark)", "(forced-colors: active)"];

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
    return [role, numbersOf(style.color)];
  };
  return Object.fromEntries(ROLES.map(read));
}

/** @param {string} colour as browsers compute it: rgb(…) from 0 to 255, or color(srgb …) from 0 to 1 */
function numbersOf(colour) {
  const numbers = (colour.match(/[\d.]+(?:e-?\d+)?/g) ?? []).map(Number).slice(0, 3);
  return colour.startsWith("color(") ? numbers : numbers.map((x) => x / 255);
}

/**
 * @param {() => void} changed
 * @returns {() => void} ends it
 */
export function followTheme(changed) {
  const queries = COLOUR_QUERIES.map((query) => matchMedia(query));
  for (const query of queries) query.addEventListener("change", changed);
  return () => queries.forEach((query) => query.removeEventListener("change", changed));
}
