// The tree of halves as a small diagram where the picture is emptiest: t from left to right, each level a row.
import { stroke } from "../../../applet/pen.js";
import { hue } from "./theme.js";

/** @typedef {import("./halving.js").Node} Node */
/** @typedef {import("./sheet.js").Sheet} Sheet */
/** @typedef {import("../figure.js").Figure} Figure */
/** @typedef {[number, number]} Place */

/** No wider than this share of the picture. */
const WIDEST = 0.4;
/** The others in CSS pixels. */
const WIDTH = 190;
const ROW = 13;
const PADDING = 10;
const MARGIN = 8;
const DOT_RADIUS = 2.5;
/** Deeper levels are not shown: a row has no more room. */
const MOST_ROWS = 8;
const OPACITY = 0.88;
/** More trees than these side by side are no more than dots. */
const MOST_TREES = 12;

/**
 * @param {Sheet} sheet
 * @param {Node[]} roots one for each piece
 * @param {Figure} figure
 */
export function drawDiagram(sheet, roots, figure) {
  if (!roots.length || roots.length > MOST_TREES) return;
  const { ctx, theme, px, box } = sheet;
  const rows = Math.min(MOST_ROWS, Math.max(...roots.map(depthOf)));
  const width = Math.min(WIDTH * px, WIDEST * box.width);
  const height = (rows * ROW + 2 * PADDING) * px;
  const [x, y] = emptiestPlace(sheet, figure, width, height);
  ctx.beginPath();
  ctx.rect(x, y, width, height);
  ctx.globalAlpha = OPACITY;
  ctx.fillStyle = theme.paper;
  ctx.fill();
  ctx.globalAlpha = 1;
  stroke(sheet, theme.quiet, 1);
  sheet.taken.push(x + width / 2, y + height / 2, width / 2, height / 2);
  const inner = width - 2 * PADDING * px;
  const place = (/** @type {number} */ root, /** @type {Node} */ { t0, t1 }, /** @type {number} */ depth) =>
    /** @type {Place} */ ([
      x + PADDING * px + (inner * (root + (t0 + t1) / 2)) / roots.length,
      y + (PADDING + ROW * depth) * px,
    ]);
  for (let depth = rows; depth >= 0; depth--) drawRow(sheet, roots, depth, place);
}

/**
 * The nodes of a level, and the branches to the halves.
 *
 * @param {Sheet} sheet
 * @param {Node[]} roots
 * @param {number} depth
 * @param {(root: number, node: Node, depth: number) => Place} place
 */
function drawRow(sheet, roots, depth, place) {
  const { ctx, theme, px } = sheet;
  /** @type {[number, Node][]} */
  const nodes = roots.flatMap((root, k) => level(root, depth).map((node) => /** @type {[number, Node]} */ ([k, node])));
  ctx.beginPath();
  for (const [k, node] of nodes) {
    for (const half of (depth < MOST_ROWS && node.halves) || []) {
      ctx.moveTo(...place(k, node, depth));
      ctx.lineTo(...place(k, half, depth + 1));
    }
  }
  stroke(sheet, theme.quiet, 1);
  ctx.beginPath();
  for (const [k, node] of nodes) {
    const [x, y] = place(k, node, depth);
    ctx.moveTo(x + DOT_RADIUS * px, y);
    ctx.arc(x, y, DOT_RADIUS * px, 0, 2 * Math.PI);
  }
  ctx.fillStyle = hue(theme, depth + 1);
  ctx.fill();
}

/**
 * @param {Node} node
 * @param {number} depth
 * @returns {Node[]}
 */
function level(node, depth) {
  if (depth === 0) return [node];
  return node.halves ? node.halves.flatMap((/** @type {Node} */ half) => level(half, depth - 1)) : [];
}

/**
 * @param {Node} node
 * @returns {number} 0 without halves
 */
function depthOf(node) {
  return node.halves ? 1 + Math.max(...node.halves.map(depthOf)) : 0;
}

/** So many places along the lower and the upper edge are tried. */
const PLACES = 9;
/** So many points of each piece count as its picture. */
const SAMPLES = 8;

/**
 * Where the fewest points of the figure are: at the lower edge if that is as good as any, in a corner if that is.
 *
 * @param {Sheet} sheet
 * @param {Figure} figure
 * @param {number} width
 * @param {number} height
 * @returns {Place}
 */
function emptiestPlace({ lens, box, px }, { points, pieces }, width, height) {
  const margin = MARGIN * px;
  const seen = [...points.flat(), ...pieces.flatMap(({ curve }) => [...curve.sample(SAMPLES)])];
  /** @type {Place[]} */
  const places = [];
  for (let i = 0; i < seen.length; i += 2) places.push(lens.place(seen[i], seen[i + 1]));
  const isNear = (/** @type {Place} */ [x, y], /** @type {Place} */ [left, top]) =>
    x > left - margin && x < left + width + margin && y > top - margin && y < top + height + margin;
  const crowd = (/** @type {Place} */ corner) => places.reduce((sum, place) => sum + Number(isNear(place, corner)), 0);
  const steps = [0, ...Array.from({ length: PLACES - 1 }, (_, k) => PLACES - 1 - k)].map((k) => k / (PLACES - 1)); // corners first
  const candidates = [box.height - height - margin, margin].flatMap((top) =>
    steps.map((share) => /** @type {Place} */ ([margin + share * (box.width - width - 2 * margin), top])),
  );
  return candidates.reduce((best, each) => (crowd(each) < crowd(best) ? each : best));
}
