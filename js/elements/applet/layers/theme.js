// The colours of the layers.
import { ROLES as FIRST } from "../../../applet/theme.js";

/** Beyond the roles of the small applet: the hues of the third and the fourth level. */
export const ROLES = /** @type {const} */ ([...FIRST, "level3", "level4"]);

/** @typedef {typeof ROLES[number]} Role */
/** @typedef {Record<Role, string>} Theme */

/** Their custom properties, for a style sheet: on a light page, on a dark one, and where the user has colours of their own. */
export const LEVELS = {
  light: "--bz-level3: #8a5a00; --bz-level4: #6a51a3;",
  dark: "--bz-level3: #f0e442; --bz-level4: #b39ddb;",
  forced: "--bz-level3: CanvasText; --bz-level4: Highlight;",
};

/**
 * The hue of a level of a construction or of a tree.
 *
 * @param {Theme} theme
 * @param {number} level from 1
 * @returns {string}
 */
export function hue(theme, level) {
  return [theme.level4, theme.level1, theme.level2, theme.level3][level % 4];
}
