// The tree of halves as a small diagram where the picture is emptiest: t from left to right, each level a row.
import { stroke } from "../ui/pen.js";
import { hue } from "./theme.js";
import type { Node } from "./halving.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";

export type Point2 = [number, number];

/** No wider than this share of the picture. */
const WIDEST = 0.4;
/** The others in CSS pixels. */
const WIDTH = 190;
const ROW = 13;
const PADDING = 10;
const MARGIN = 8;
const DOT_RADIUS = 2.5;
/** Deeper levels are not shown: a row has no more room. */
const MAX_ROWS = 8;
const OPACITY = 0.88;
/** More trees than these side by side are no more than dots. */
const MAX_TREES = 12;

/**
 * @param roots one for each piece
 */
export function drawDiagram(context: DrawContext, roots: Node[], figure: Figure) {
  if (!roots.length || roots.length > MAX_TREES) return;
  const { ctx, theme, px, box } = context;
  const rows = Math.min(MAX_ROWS, Math.max(...roots.map(depthOf)));
  const width = Math.min(WIDTH * px, WIDEST * box.width);
  const height = (rows * ROW + 2 * PADDING) * px;
  const [x, y] = emptiestPlace(context, figure, width, height);
  ctx.beginPath();
  ctx.rect(x, y, width, height);
  ctx.globalAlpha = OPACITY;
  ctx.fillStyle = theme.paper;
  ctx.fill();
  ctx.globalAlpha = 1;
  stroke(context, theme.quiet, 1);
  context.reserved.push(x + width / 2, y + height / 2, width / 2, height / 2);
  const inner = width - 2 * PADDING * px;
  const place = (root: number, { t0, t1 }: Node, depth: number) =>
    [x + PADDING * px + (inner * (root + (t0 + t1) / 2)) / roots.length, y + (PADDING + ROW * depth) * px] as Point2;
  for (let depth = rows; depth >= 0; depth--) drawRow(context, roots, depth, place);
}

/** The nodes of a level, and the branches to the halves. */
function drawRow(
  context: DrawContext,
  roots: Node[],
  depth: number,
  place: (root: number, node: Node, depth: number) => Point2,
) {
  const { ctx, theme, px } = context;
  const nodes: [number, Node][] = roots.flatMap((root, k) =>
    level(root, depth).map((node) => [k, node] as [number, Node]),
  );
  ctx.beginPath();
  for (const [k, node] of nodes) {
    for (const half of (depth < MAX_ROWS && node.halves) || []) {
      ctx.moveTo(...place(k, node, depth));
      ctx.lineTo(...place(k, half, depth + 1));
    }
  }
  stroke(context, theme.quiet, 1);
  ctx.beginPath();
  for (const [k, node] of nodes) {
    const [x, y] = place(k, node, depth);
    ctx.moveTo(x + DOT_RADIUS * px, y);
    ctx.arc(x, y, DOT_RADIUS * px, 0, 2 * Math.PI);
  }
  ctx.fillStyle = hue(theme, depth + 1);
  ctx.fill();
}

function level(node: Node, depth: number): Node[] {
  if (depth === 0) return [node];
  return node.halves ? node.halves.flatMap((half: Node) => level(half, depth - 1)) : [];
}

/**
 * @returns 0 without halves
 */
function depthOf(node: Node): number {
  return node.halves ? 1 + Math.max(...node.halves.map(depthOf)) : 0;
}

/** So many places along the lower and the upper edge are tried. */
const PLACES = 9;
/** So many points of each piece count as its picture. */
const SAMPLES = 8;

/** Where the fewest points of the figure are: at the lower edge if that is as good as any, in a corner if that is. */
function emptiestPlace(
  { lens, box, px }: DrawContext,
  { points, pieces }: Figure,
  width: number,
  height: number,
): Point2 {
  const margin = MARGIN * px;
  const seen = [...points.flat(), ...pieces.flatMap(({ curve }) => [...curve.sample(SAMPLES)])];
  const places: Point2[] = [];
  for (let i = 0; i < seen.length; i += 2) places.push(lens.place(seen[i], seen[i + 1]));
  const isNear = ([x, y]: Point2, [left, top]: Point2) =>
    x > left - margin && x < left + width + margin && y > top - margin && y < top + height + margin;
  const crowd = (corner: Point2) => places.reduce((sum, place) => sum + Number(isNear(place, corner)), 0);
  const steps = [0, ...Array.from({ length: PLACES - 1 }, (_, k) => PLACES - 1 - k)].map((k) => k / (PLACES - 1)); // corners first
  const candidates = [box.height - height - margin, margin].flatMap((top) =>
    steps.map((share) => [margin + share * (box.width - width - 2 * margin), top] as Point2),
  );
  return candidates.reduce((best, each) => (crowd(each) < crowd(best) ? each : best));
}
