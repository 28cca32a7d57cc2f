// The colours of the layers.
import { ROLES as FIRST } from "../ui/theme.js";

/** Beyond the roles of the small applet: the hues of the third and the fourth level. */
export const ROLES = [...FIRST, "level3", "level4"] as const;

export type Role = (typeof ROLES)[number];
export type Theme = Record<Role, string>;

/**
 * The custom properties of these: on a light page, and on a dark one.
 *
 * @cssprop --bz-level3 - the third level
 * @cssprop --bz-level4 - the fourth level
 */
export const LEVELS = {
  light: "--bz-level3: #7b4fb0; --bz-level4: #8a6d00;",
  dark: "--bz-level3: #b79be0; --bz-level4: #d8bd3a;",
};

/**
 * The hue of a level of a construction or of a tree.
 *
 * @param level from 1
 */
export function hue(theme: Theme, level: number): string {
  return [theme.level4, theme.level1, theme.level2, theme.level3][level % 4];
}
