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
  return Object.fromEntries(colours.map(([role, colour]) => [role, numbersOf(inSRGB(probe, colour))])) as Theme;
}

/** A colour as `rgb(…)` or `color(srgb …)`; browsers keep oklch(), lab() and other colour spaces when they compute it. */
function inSRGB(probe: HTMLElement, colour: string) {
  if (/^(rgb|color\(srgb )/.test(colour)) return colour;
  probe.style.color = `color-mix(in srgb, ${colour}, ${colour})`;
  return getComputedStyle(probe).color;
}

/** @param colour rgb(…) from 0 to 255, or color(srgb …) from 0 to 1, or beyond where a screen cannot show it */
function numbersOf(colour: string) {
  const unit = colour.startsWith("color(") ? 1 : 255;
  const numbers = colour.match(/-?[\d.]+(?:e-?\d+)?|none/g) ?? [];
  return numbers.slice(0, 3).map((x) => Math.min(Math.max((Number(x) || 0) / unit, 0), 1));
}
