// The picture: a function of its arguments only. Lengths are in CSS pixels, turned into the view box's units by `px`.
import * as pen from "../ui/pen.js";
import { clamped, isInside, POINTS_PER_SEGMENT } from "../editor/plane.js";
import { isOnCurve } from "./words.js";
import type { State } from "./state.js";
import type { Derived } from "./derive.js";
import type { Paper } from "../ui/pen.js";

export type Point2 = [number, number];

const LABEL_DISTANCE = 19;
/** Labels keep this far from the edge of the picture. */
const LABEL_MARGIN = 11;

/** Draws everything, from the back to the front. */
export function draw(paper: Paper, state: State, derived: Derived) {
  const { ctx } = paper;
  const { width, height } = state.box;
  ctx.clearRect(0, 0, width, height);
  ctx.lineJoin = ctx.lineCap = "round";
  for (const hull of derived.hulls) drawHull(paper, hull);
  if (state.layers.polygon) drawPolygon(paper, derived.points);
  drawCurve(paper, derived);
  drawTangents(paper, derived.points);
  for (const levels of derived.constructions) drawConstruction(paper, levels);
  derived.points.forEach((point, i) => drawLabel(paper, state, point, i, derived.points));
  derived.points.forEach((point, i) => drawPoint(paper, state, point, isOnCurve(i)));
  for (const at of derived.atT) pen.diamond(paper, at);
}

function drawHull(paper: Paper, hull: Float64Array) {
  pen.path(paper.ctx, hull);
  paper.ctx.closePath();
  pen.tint(paper, paper.theme.curve);
}

function drawPolygon(paper: Paper, points: Point2[]) {
  pen.path(paper.ctx, points.flat());
  paper.ctx.globalAlpha = pen.POLYGON_OPACITY;
  pen.stroke(paper, paper.theme.ink, pen.POLYGON_WIDTH);
  paper.ctx.globalAlpha = 1;
}

/** From each end of a segment to its neighbour off the curve. */
function drawTangents(paper: Paper, points: Point2[]) {
  paper.ctx.beginPath();
  points.forEach((point, i) => {
    if (i % POINTS_PER_SEGMENT === 1) pen.line(paper.ctx, points[i - 1], point);
    if (i % POINTS_PER_SEGMENT === 2) pen.line(paper.ctx, point, points[i + 1]);
  });
  pen.stroke(paper, paper.theme.handle, pen.TANGENT_WIDTH);
}

function drawCurve(paper: Paper, { curve, halves }: Derived) {
  const { ctx, theme } = paper;
  ctx.beginPath();
  curve.trace(ctx);
  pen.stroke(paper, theme.curve, pen.CURVE_WIDTH);
  for (const side of [0, 1] as const) {
    ctx.beginPath();
    for (const pair of halves) pair[side].trace(ctx);
    pen.stroke(paper, side === 0 ? theme.first : theme.second, pen.HALF_WIDTH);
  }
}

/** De Casteljau's levels between the control points and the point at t, each with its colour. */
function drawConstruction(paper: Paper, levels: Float64Array[]) {
  const { ctx, theme } = paper;
  const hues = [theme.level1, theme.level2];
  levels.slice(1, -1).forEach((level, i) => {
    pen.path(ctx, level);
    pen.stroke(paper, hues[i % hues.length], pen.SCAFFOLD_WIDTH);
    for (let k = 0; k < level.length; k += 2) pen.ring(paper, [level[k], level[k + 1]], hues[i % hues.length]);
  });
}

/** A disc on the curve, a square off it; hollow at the edge where the point itself lies outside. */
function drawPoint(paper: Paper, state: State, point: Point2, onCurve: boolean) {
  const inside = isInside(state.box, point);
  const at = inside ? point : pen.atEdge(state.box, point, pen.DISC_RADIUS * paper.px);
  pen.controlPoint(paper, at, onCurve, onCurve ? paper.theme.curve : paper.theme.handle, inside);
}

/** The name of a point, on the side away from its neighbours. */
function drawLabel(paper: Paper, { box }: State, point: Point2, index: number, points: Point2[]) {
  const at = clamped(box, point);
  const [dx, dy] = pen.awayFrom(at, [points[index - 1], points[index + 1]]);
  const away = LABEL_DISTANCE * paper.px;
  const margin = LABEL_MARGIN * paper.px + (isInside(box, point) ? 0 : away);
  pen.label(paper, `P${index}`, pen.atEdge(box, [at[0] + dx * away, at[1] + dy * away], margin));
}
