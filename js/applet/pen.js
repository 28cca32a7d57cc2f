// What pictures are drawn with: lines and marks whose sizes are CSS pixels, turned into the canvas's units by `px`.

/** @typedef {[number, number]} Place */

/**
 * @template {string} [Role=import("./theme.js").Role]
 * @typedef {object} Paper
 * @property {CanvasRenderingContext2D} ctx scaled to the view box
 * @property {Record<Role, string>} theme
 * @property {number} px the length of a CSS pixel in the view box
 */

/**
 * Paper of any theme.
 *
 * @typedef {Paper<"ink" | "paper">} AnyPaper
 */

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
const FONT = /** @type {const} */ ([600, 13]);
/** The rim of paper around words, on both sides together. */
const HALO = 4;

/**
 * Begins a path through points.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {ArrayLike<number>} flat
 */
export function path(ctx, flat) {
  ctx.beginPath();
  for (let i = 0; i < flat.length; i += 2) ctx.lineTo(flat[i], flat[i + 1]);
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Place} from
 * @param {Place} to
 */
export function line(ctx, from, to) {
  ctx.moveTo(...from);
  ctx.lineTo(...to);
}

/**
 * @param {AnyPaper} paper
 * @param {string} colour
 * @param {number} width
 */
export function stroke({ ctx, px }, colour, width) {
  ctx.strokeStyle = colour;
  ctx.lineWidth = width * px;
  ctx.stroke();
}

/**
 * The path that there is, filled faintly inside a dashed rim.
 *
 * @param {AnyPaper} paper
 * @param {string} colour
 */
export function tint(paper, colour) {
  const { ctx, px } = paper;
  ctx.globalAlpha = HULL_OPACITY;
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.setLineDash(DASH.map((length) => length * px));
  stroke(paper, colour, POLYGON_WIDTH);
  ctx.setLineDash([]);
}

/**
 * A control point: a disc on the curve, a square off it; hollow where the point itself lies elsewhere.
 *
 * @param {AnyPaper} paper
 * @param {Place} centre
 * @param {boolean} onCurve
 * @param {string} colour
 * @param {boolean} full
 */
export function knob(paper, [x, y], onCurve, colour, full) {
  const { ctx, theme, px } = paper;
  ctx.beginPath();
  if (onCurve) ctx.arc(x, y, DISC_RADIUS * px, 0, 2 * Math.PI);
  else ctx.rect(x - SQUARE_HALF * px, y - SQUARE_HALF * px, 2 * SQUARE_HALF * px, 2 * SQUARE_HALF * px);
  ctx.fillStyle = full ? colour : theme.paper;
  ctx.fill();
  stroke(paper, full ? theme.paper : colour, RIM_WIDTH);
}

/**
 * A point that follows from others.
 *
 * @param {AnyPaper} paper
 * @param {Place} centre
 * @param {string} colour
 */
export function hollow(paper, [x, y], colour) {
  const { ctx, theme, px } = paper;
  ctx.beginPath();
  ctx.arc(x, y, HOLLOW_RADIUS * px, 0, 2 * Math.PI);
  ctx.fillStyle = theme.paper;
  ctx.fill();
  stroke(paper, colour, RIM_WIDTH);
}

/**
 * The point at t.
 *
 * @param {AnyPaper} paper
 * @param {Place} centre
 */
export function diamond(paper, [x, y]) {
  const { ctx, theme, px } = paper;
  const half = DIAMOND_HALF * px;
  path(ctx, [x, y - half, x + half, y, x, y + half, x - half, y]);
  ctx.closePath();
  ctx.fillStyle = theme.ink;
  ctx.fill();
  stroke(paper, theme.paper, RIM_WIDTH);
}

/**
 * Words around a place, with a rim of paper to stay readable on lines.
 *
 * @param {AnyPaper} paper
 * @param {string} words
 * @param {Place} centre
 * @param {readonly [weight: number, size: number]} [font]
 */
export function label({ ctx, theme, px }, words, [x, y], [weight, size] = FONT) {
  ctx.font = `${weight} ${size * px}px system-ui, sans-serif`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.strokeStyle = theme.paper;
  ctx.lineWidth = HALO * px;
  ctx.strokeText(words, x, y);
  ctx.fillStyle = theme.ink;
  ctx.fillText(words, x, y);
}

/**
 * The direction opposite to the neighbours; where they lie on both sides, across.
 *
 * @param {Place} at
 * @param {(Place | undefined)[]} neighbours
 * @returns {Place}
 */
export function awayFrom(at, neighbours) {
  const directions = neighbours.flatMap((point) => (point ? [unit([at[0] - point[0], at[1] - point[1]])] : []));
  const sum = directions.reduce(([x, y], [dx, dy]) => [x + dx, y + dy], [0, 0]);
  const [x, y] = directions[0] ?? [1, 0];
  return Math.hypot(...sum) > 0.5 ? unit(sum) : unit([-y, x]);
}

/**
 * @param {Place} direction
 * @returns {Place} of length 1; upwards where there is none
 */
export function unit([x, y]) {
  const length = Math.hypot(x, y);
  return length > 0 ? [x / length, y / length] : [0, -1];
}

/**
 * @param {import("./state.js").Box} box
 * @param {Place} point
 * @param {number} margin
 * @returns {Place} just inside the picture
 */
export function atEdge(box, [x, y], margin) {
  return [Math.min(Math.max(x, margin), box.width - margin), Math.min(Math.max(y, margin), box.height - margin)];
}
