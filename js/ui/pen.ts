// What pictures are drawn with: lines and marks whose sizes are CSS pixels, turned into the canvas's units by `px`.
import { FONT_FAMILY } from "./tokens.js";
import type { Role as AppletRole } from "./theme.js";
import type { Box } from "../editor/plane.js";

export type Point2 = [number, number];

export interface PenContext<Role extends string = AppletRole> {
  /** Scaled to the view box */
  ctx: CanvasRenderingContext2D;
  theme: Record<Role, string>;
  /** The length of a CSS pixel in the view box */
  px: number;
}

/** With any theme that has these two roles. */
export type AnyPenContext = PenContext<"ink" | "paper">;

export const CURVE_WIDTH = 3;
export const HALF_WIDTH = 4;
export const POLYGON_WIDTH = 1;
export const TANGENT_WIDTH = 1.5;
export const SCAFFOLD_WIDTH = 1.5;
export const RIM_WIDTH = 1.5;
export const DASH = [5, 4];
export const HULL_OPACITY = 0.08;
export const POLYGON_OPACITY = 0.6;
export const DISC_RADIUS = 6;
const SQUARE_HALF = 5;
const HOLLOW_RADIUS = 3.5;
const DIAMOND_HALF = 7;
/** Of the names of points: weight and size. */
const FONT = [600, 13] as const;
/** The rim of paper around words, on both sides together. */
const HALO = 4;

/** Begins a path through points. */
export function path(ctx: CanvasRenderingContext2D, flat: ArrayLike<number>) {
  ctx.beginPath();
  for (let i = 0; i < flat.length; i += 2) ctx.lineTo(flat[i], flat[i + 1]);
}

export function line(ctx: CanvasRenderingContext2D, from: Point2, to: Point2) {
  ctx.moveTo(...from);
  ctx.lineTo(...to);
}

export function stroke({ ctx, px }: AnyPenContext, colour: string, width: number) {
  ctx.strokeStyle = colour;
  ctx.lineWidth = width * px;
  ctx.stroke();
}

/** The path that there is, filled faintly inside a dashed rim. */
export function tint(context: AnyPenContext, colour: string) {
  const { ctx, px } = context;
  ctx.globalAlpha = HULL_OPACITY;
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.setLineDash(DASH.map((length) => length * px));
  stroke(context, colour, POLYGON_WIDTH);
  ctx.setLineDash([]);
}

/** A control point: a disc on the curve, a square off it; hollow where the point itself lies elsewhere. */
export function controlPoint(context: AnyPenContext, [x, y]: Point2, onCurve: boolean, colour: string, full: boolean) {
  const { ctx, theme, px } = context;
  ctx.beginPath();
  if (onCurve) ctx.arc(x, y, DISC_RADIUS * px, 0, 2 * Math.PI);
  else ctx.rect(x - SQUARE_HALF * px, y - SQUARE_HALF * px, 2 * SQUARE_HALF * px, 2 * SQUARE_HALF * px);
  ctx.fillStyle = full ? colour : theme.paper;
  ctx.fill();
  stroke(context, full ? theme.paper : colour, RIM_WIDTH);
}

/** A point that follows from others. */
export function ring(context: AnyPenContext, [x, y]: Point2, colour: string) {
  const { ctx, theme, px } = context;
  ctx.beginPath();
  ctx.arc(x, y, HOLLOW_RADIUS * px, 0, 2 * Math.PI);
  ctx.fillStyle = theme.paper;
  ctx.fill();
  stroke(context, colour, RIM_WIDTH);
}

/** The point at t. */
export function diamond(context: AnyPenContext, [x, y]: Point2) {
  const { ctx, theme, px } = context;
  const half = DIAMOND_HALF * px;
  path(ctx, [x, y - half, x + half, y, x, y + half, x - half, y]);
  ctx.closePath();
  ctx.fillStyle = theme.ink;
  ctx.fill();
  stroke(context, theme.paper, RIM_WIDTH);
}

/** Words around a place, with a rim to stay readable on lines. */
export function label(
  { ctx, theme, px }: AnyPenContext,
  words: string,
  [x, y]: Point2,
  [weight, size]: readonly [weight: number, size: number] = FONT,
) {
  ctx.font = `${weight} ${size * px}px ${FONT_FAMILY}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.strokeStyle = theme.paper;
  ctx.lineWidth = HALO * px;
  ctx.strokeText(words, x, y);
  ctx.fillStyle = theme.ink;
  ctx.fillText(words, x, y);
}

/** The direction opposite to the neighbours; where they lie on both sides, across. */
export function awayFrom(at: Point2, neighbours: (Point2 | undefined)[]): Point2 {
  const directions = neighbours.flatMap((point) => (point ? [unit([at[0] - point[0], at[1] - point[1]])] : []));
  const sum = directions.reduce(([x, y], [dx, dy]) => [x + dx, y + dy], [0, 0]);
  const [x, y] = directions[0] ?? [1, 0];
  return Math.hypot(...sum) > 0.5 ? unit(sum) : unit([-y, x]);
}

/**
 * @returns of length 1; upwards where there is none
 */
export function unit([x, y]: Point2): Point2 {
  const length = Math.hypot(x, y);
  return length > 0 ? [x / length, y / length] : [0, -1];
}

/**
 * @returns just inside the picture
 */
export function atEdge(box: Box, [x, y]: Point2, margin: number): Point2 {
  return [Math.min(Math.max(x, margin), box.width - margin), Math.min(Math.max(y, margin), box.height - margin)];
}
