// The colours of the picture, as the style sheet has them now and WebGL takes them.
import { readTheme as readColours } from "../../ui/theme.js";

/** The roles of colour. Each has a custom property `--bz-<role>` in style.js. */
const ROLES = [
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
] as const;

/** Each from 0 to 1: red, green, blue */
export type Theme = Record<(typeof ROLES)[number], number[]>;

export function readTheme(probe: HTMLElement): Theme {
  const colours = Object.entries(readColours(probe, ROLES));
  return Object.fromEntries(colours.map(([role, colour]) => [role, numbersOf(colour)])) as Theme;
}

/** @param colour as browsers compute it: rgb(…) from 0 to 255, or color(srgb …) from 0 to 1 */
function numbersOf(colour: string) {
  const numbers = (colour.match(/[\d.]+(?:e-?\d+)?/g) ?? []).map(Number).slice(0, 3);
  return colour.startsWith("color(") ? numbers : numbers.map((x) => x / 255);
}
