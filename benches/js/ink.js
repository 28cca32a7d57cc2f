// Freehand strokes, compared with perfect-freehand, which computes the polygon of the whole stroke at each call.
import { InkStroke } from "casteljau";
import { getStroke } from "perfect-freehand";
import { discsOf, distanceFromDiscs, freehandDiscs, outlinePoints } from "../../www/ink/compare.js";
import { hand } from "../../www/ink/samples.js";

const COUNT = 500;
const OPTIONS = { size: 12, thinning: 0.5, smoothing: 0.5, streamline: 0.5 };
const samples = hand(COUNT, 2);

function stroke() {
  const ink = new InkStroke(OPTIONS);
  for (const [x, y] of samples) ink.append(x, y);
  return ink;
}

/** Our outline is nearer to the discs of its pen, with fewer curves. */
function check() {
  const ink = stroke();
  const outline = ink.outline();
  const polygon = getStroke(samples, OPTIONS);
  const ours = distanceFromDiscs(outlinePoints(outline), discsOf(ink));
  const theirs = distanceFromDiscs(outlinePoints(polygon), freehandDiscs(samples, OPTIONS));
  const count = outline.subpaths.reduce((sum, { segmentCount }) => sum + segmentCount, 0);
  if (!(ours < theirs && count < polygon.length)) throw new Error(`ink: ${ours} ${theirs}, ${count} ${polygon.length}`);
}

/** A stroke that goes on around a circle. */
const growing = stroke();
let angle = 0;
function grow() {
  angle += 0.1;
  growing.append(300 + 100 * Math.cos(angle), 150 + 100 * Math.sin(angle));
  return growing.changes().open.subpathCount;
}

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    id: "ink",
    work: "stroke of 500 samples, outline",
    peer: "perfect-freehand getStroke",
    items: 1,
    check,
    theirs: () => getStroke(samples, OPTIONS).length,
    ours: () => stroke().outline().subpathCount,
  },
  {
    id: "ink-frame",
    work: "one more of 500 samples, drawn",
    peer: "perfect-freehand getStroke",
    items: 1,
    check,
    theirs: () => getStroke(samples, OPTIONS).length,
    ours: grow,
  },
];
