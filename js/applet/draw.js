// The picture: a function of its arguments only. Lengths are in CSS pixels, turned into the view box's units by `px`.
import { clamped, isInside, POINTS_PER_SEGMENT } from "./state.js";
import { isOnCurve } from "./words.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./derive.js").Derived} Derived */
/** @typedef {import("./theme.js").Theme} Theme */
/** @typedef {[number, number]} Place */

/**
 * @typedef {object} Paper
 * @property {CanvasRenderingContext2D} ctx scaled to the view box
 * @property {Theme} theme
 * @property {number} px the length of a CSS pixel in the view box
 */

const CURVE_WIDTH = 3;
const HALF_WIDTH = 4;
const POLYGON_WIDTH = 1;
const TANGENT_WIDTH = 1.5;
const SCAFFOLD_WIDTH = 1.5;
const RIM_WIDTH = 1.5;
const DASH = [5, 4];
const HULL_OPACITY = 0.08;
const POLYGON_OPACITY = 0.6;
const DISC_RADIUS = 6;
const SQUARE_HALF = 5;
const HOLLOW_RADIUS = 3.5;
const DIAMOND_HALF = 7;
const FONT = 13;
const LABEL_DISTANCE = 19;
/** Labels keep this far from the edge of the picture. */
const LABEL_MARGIN = 11;

/**
 * Draws everything, from the back to the front.
 *
 * @param {Paper} paper
 * @param {State} state
 * @param {Derived} derived
 */
export function draw(paper, state, derived) {
  const { ctx } = paper;
  const { width, height } = state.box;
  ctx.clearRect(0, 0, width, height);
  ctx.lineJoin = ctx.lineCap = "round";
  for (const hull of derived.hulls) drawHull(paper, hull);
  if (state.layers.polygon) drawPolygon(paper, derived.points);
  drawCurve(paper, derived);
  drawTangents(paper, derived.points);
  for (const levels of derived.scaffolds) drawScaffold(paper, levels);
  derived.points.forEach((point, i) => drawLabel(paper, state, point, i, derived.points));
  derived.points.forEach((point, i) => drawPoint(paper, state, point, isOnCurve(i)));
  for (const at of derived.atT) drawDiamond(paper, at);
}

/**
 * @param {Paper} paper
 * @param {Float64Array} hull
 */
function drawHull(paper, hull) {
  const { ctx, theme, px } = paper;
  path(ctx, hull);
  ctx.closePath();
  ctx.globalAlpha = HULL_OPACITY;
  ctx.fillStyle = theme.curve;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.setLineDash(DASH.map((length) => length * px));
  stroke(paper, theme.curve, POLYGON_WIDTH);
  ctx.setLineDash([]);
}

/**
 * @param {Paper} paper
 * @param {Place[]} points
 */
function drawPolygon(paper, points) {
  path(paper.ctx, points.flat());
  paper.ctx.globalAlpha = POLYGON_OPACITY;
  stroke(paper, paper.theme.ink, POLYGON_WIDTH);
  paper.ctx.globalAlpha = 1;
}

/**
 * From each end of a segment to its neighbour off the curve.
 *
 * @param {Paper} paper
 * @param {Place[]} points
 */
function drawTangents(paper, points) {
  paper.ctx.beginPath();
  points.forEach((point, i) => {
    if (i % POINTS_PER_SEGMENT === 1) line(paper.ctx, points[i - 1], point);
    if (i % POINTS_PER_SEGMENT === 2) line(paper.ctx, point, points[i + 1]);
  });
  stroke(paper, paper.theme.handle, TANGENT_WIDTH);
}

/**
 * @param {Paper} paper
 * @param {Derived} derived
 */
function drawCurve(paper, { curve, halves }) {
  const { ctx, theme } = paper;
  ctx.beginPath();
  curve.trace(ctx);
  stroke(paper, theme.curve, CURVE_WIDTH);
  for (const side of /** @type {const} */ ([0, 1])) {
    ctx.beginPath();
    for (const pair of halves) pair[side].trace(ctx);
    stroke(paper, side === 0 ? theme.first : theme.second, HALF_WIDTH);
  }
}

/**
 * De Casteljau's levels between the control points and the point at t, each with its colour.
 *
 * @param {Paper} paper
 * @param {Float64Array[]} levels
 */
function drawScaffold(paper, levels) {
  const { ctx, theme } = paper;
  const hues = [theme.level1, theme.level2];
  levels.slice(1, -1).forEach((level, i) => {
    path(ctx, level);
    stroke(paper, hues[i % hues.length], SCAFFOLD_WIDTH);
    for (let k = 0; k < level.length; k += 2) drawHollow(paper, [level[k], level[k + 1]], hues[i % hues.length]);
  });
}

/**
 * A disc on the curve, a square off it; hollow at the edge where the point itself lies outside.
 *
 * @param {Paper} paper
 * @param {State} state
 * @param {Place} point
 * @param {boolean} onCurve
 */
function drawPoint(paper, state, point, onCurve) {
  const { ctx, theme, px } = paper;
  const inside = isInside(state.box, point);
  const [x, y] = inside ? point : atEdge(state.box, point, DISC_RADIUS * px);
  ctx.beginPath();
  if (onCurve) ctx.arc(x, y, DISC_RADIUS * px, 0, 2 * Math.PI);
  else ctx.rect(x - SQUARE_HALF * px, y - SQUARE_HALF * px, 2 * SQUARE_HALF * px, 2 * SQUARE_HALF * px);
  const colour = onCurve ? theme.curve : theme.handle;
  ctx.fillStyle = inside ? colour : theme.paper;
  ctx.fill();
  stroke(paper, inside ? theme.paper : colour, RIM_WIDTH);
}

/**
 * @param {import("./state.js").Box} box
 * @param {Place} point
 * @param {number} margin
 * @returns {Place} just inside the picture
 */
function atEdge(box, [x, y], margin) {
  return [Math.min(Math.max(x, margin), box.width - margin), Math.min(Math.max(y, margin), box.height - margin)];
}

/**
 * @param {Paper} paper
 * @param {Place} centre
 * @param {string} colour
 */
function drawHollow(paper, [x, y], colour) {
  const { ctx, theme, px } = paper;
  ctx.beginPath();
  ctx.arc(x, y, HOLLOW_RADIUS * px, 0, 2 * Math.PI);
  ctx.fillStyle = theme.paper;
  ctx.fill();
  stroke(paper, colour, RIM_WIDTH);
}

/**
 * @param {Paper} paper
 * @param {Place} centre
 */
function drawDiamond(paper, [x, y]) {
  const { ctx, theme, px } = paper;
  const half = DIAMOND_HALF * px;
  path(ctx, [x, y - half, x + half, y, x, y + half, x - half, y]);
  ctx.closePath();
  ctx.fillStyle = theme.ink;
  ctx.fill();
  stroke(paper, theme.paper, RIM_WIDTH);
}

/**
 * The name of a point, on the side away from its neighbours, with a rim of paper to stay readable on lines.
 *
 * @param {Paper} paper
 * @param {State} state
 * @param {Place} point
 * @param {number} index
 * @param {Place[]} points
 */
function drawLabel(paper, { box }, point, index, points) {
  const { ctx, theme, px } = paper;
  const at = clamped(box, point);
  const [dx, dy] = awayFrom(at, [points[index - 1], points[index + 1]]);
  const away = LABEL_DISTANCE * px;
  const margin = isInside(box, point) ? LABEL_MARGIN * px : LABEL_MARGIN * px + away;
  const [x, y] = atEdge(box, [at[0] + dx * away, at[1] + dy * away], margin);
  ctx.font = `600 ${FONT * px}px system-ui, sans-serif`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.strokeStyle = theme.paper;
  ctx.lineWidth = 4 * px;
  ctx.strokeText(`P${index}`, x, y);
  ctx.fillStyle = theme.ink;
  ctx.fillText(`P${index}`, x, y);
}

/**
 * The direction opposite to the neighbours; where they lie on both sides, across.
 *
 * @param {Place} at
 * @param {(Place | undefined)[]} neighbours
 * @returns {Place}
 */
function awayFrom(at, neighbours) {
  const directions = neighbours.flatMap((point) => (point ? [unit([at[0] - point[0], at[1] - point[1]])] : []));
  const sum = directions.reduce(([x, y], [dx, dy]) => [x + dx, y + dy], [0, 0]);
  const [x, y] = directions[0];
  return Math.hypot(...sum) > 0.5 ? unit(sum) : unit([-y, x]);
}

/**
 * @param {Place} direction
 * @returns {Place} of length 1; upwards where there is none
 */
function unit([x, y]) {
  const length = Math.hypot(x, y);
  return length > 0 ? [x / length, y / length] : [0, -1];
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {ArrayLike<number>} flat
 */
function path(ctx, flat) {
  ctx.beginPath();
  for (let i = 0; i < flat.length; i += 2) ctx.lineTo(flat[i], flat[i + 1]);
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Place} from
 * @param {Place} to
 */
function line(ctx, from, to) {
  ctx.moveTo(...from);
  ctx.lineTo(...to);
}

/**
 * @param {Paper} paper
 * @param {string} colour
 * @param {number} width
 */
function stroke({ ctx, px }, colour, width) {
  ctx.strokeStyle = colour;
  ctx.lineWidth = width * px;
  ctx.stroke();
}
