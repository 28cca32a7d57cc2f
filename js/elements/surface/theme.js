// The colours of the picture, as the style sheet has them now and WebGL takes them.
import { readTheme as readColours } from "../../applet/theme.js";

/** The roles of colour. Each has a custom property `--bz-<role>` in style.js. */
const ROLES = /** @type {const} */ ([
  "ink",
  "line",
  "paper",
  "front",
  "back",
  "handle",
  "level1",
  "level2",
  "low",
  "middle",
  "high",
  "gap",
  "wire",
]);

/** @typedef {Record<typeof ROLES[number], number[]>} Theme each from 0 to 1: red, green, blue */

/**
 * @param {HTMLElement} probe
 * @returns {Theme}
 */
export function readTheme(probe) {
  const colours = Object.entries(readColours(probe, ROLES));
  return /** @type {Theme} */ (Object.fromEntries(colours.map(([role, colour]) => [role, numbersOf(colour)])));
}

/** @param {string} colour as browsers compute it: rgb(…) from 0 to 255, or color(srgb …) from 0 to 1 */
function numbersOf(colour) {
  const numbers = (colour.match(/[\d.]+(?:e-?\d+)?/g) ?? []).map(Number).slice(0, 3);
  return colour.startsWith("color(") ? numbers : numbers.map((x) => x / 255);
}
