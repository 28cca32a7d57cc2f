// The error of an outline: its greatest distance from the union of the discs that its pen makes along its own centre line.
import { getStrokeOutlinePoints, getStrokePoints } from "perfect-freehand";

/**
 * @import { InkStroke, Path, Spline } from "casteljau"
 * @typedef {[x: number, y: number, radius: number]} Disc
 * @typedef {[number, number]} Point
 */

/** Samples of each curve of an outline, and discs for each curve of a centre line. */
const STEPS = 8;
const DISCS = 40;
/** Discs that are looked at together. */
const BLOCK = 12;

/** Points of a polygon's outline, drawn as perfect-freehand recommends, or of a path. @param {number[][] | Path} outline @returns {Point[]} */
export function outlinePoints(outline) {
  if (!Array.isArray(outline))
    return outline.subpaths.flatMap((spline) => {
      const flat = spline.sample(STEPS);
      return Array.from({ length: flat.length / 2 }, (_, k) => /** @type {Point} */ ([flat[2 * k], flat[2 * k + 1]]));
    });
  return outline.flatMap((point, k) => {
    const [before, after] = [outline.at(k - 1) ?? point, outline[(k + 1) % outline.length]];
    return [0, 0.25, 0.5, 0.75].map((u) => {
      const at = (/** @type {number} */ axis) => {
        const [a, b] = [before, after].map((other) => (other[axis] + point[axis]) / 2);
        return (1 - u) ** 2 * a + 2 * u * (1 - u) * point[axis] + u * u * b;
      };
      return /** @type {Point} */ ([at(0), at(1)]);
    });
  });
}

/** `outline` as path data, as perfect-freehand recommends: quadratic curves through the middles of the edges. @param {number[][]} outline */
export function pathData(outline) {
  if (!outline.length) return "";
  const text = (/** @type {number[]} */ numbers) => numbers.map((x) => Number(x.toFixed(2))).join(",");
  const middle = (/** @type {number} */ k) => {
    const next = outline[(k + 1) % outline.length];
    return text([(outline[k][0] + next[0]) / 2, (outline[k][1] + next[1]) / 2]);
  };
  const rest = outline.slice(2).map((_, k) => ` ${middle(k + 1)}`);
  return `M${text(outline[0])} Q${text(outline[1])} ${middle(1)} T${rest.slice(1).join("")}Z`;
}

/**
 * The discs of perfect-freehand's pen. It asks `easing` for the radius at each point of its centre line.
 *
 * @param {number[][]} samples
 * @param {import("perfect-freehand").StrokeOptions & { size: number }} options
 * @returns {Disc[]}
 */
export function freehandDiscs(samples, options) {
  const points = getStrokePoints(samples, options);
  /** @type {number[]} */
  const radii = [];
  const easing = (/** @type {number} */ x) => {
    radii.push(x * options.size);
    return x;
  };
  getStrokeOutlinePoints(points, { ...options, easing });
  const { size, start, end } = options;
  const length = points.at(-1)?.runningLength ?? 0;
  const taper = (/** @type {number} */ along, /** @type {number | boolean | undefined} */ over) =>
    typeof over === "number" && along < over ? tapering(along / over) : 1;
  // It asks once in advance, and leaves out points less than 3 units from the end.
  const used = points.filter(({ runningLength }, k) => k === points.length - 1 || length - runningLength >= 3);
  return used.map(({ point: [x, y], runningLength }, k) => {
    const part = Math.min(taper(runningLength, start?.taper), taper(length - runningLength, end?.taper));
    return [x, y, (radii[k + 1] ?? size / 2) * part];
  });
}

/** The radius along a taper. @param {number} x from 0 to 1 */
export const tapering = (x) => x * (2 - x);

/** The discs of a stroke of ours. @param {InkStroke} ink @returns {Disc[]} */
export function discsOf(ink) {
  const spline = /** @type {Spline<2>} */ (ink.spline());
  const { stops } = ink.widths();
  const count = DISCS * Math.max(10, stops.length, spline.segmentCount);
  const flat = spline.length() > 0 ? spline.evalAt(spline.equidistantTimes(count)) : spline.evalAt([0, 0]);
  const last = flat.length / 2 - 1;
  return Array.from({ length: last + 1 }, (_, k) => [flat[2 * k], flat[2 * k + 1], widthAt(stops, k / last) / 2]);
}

/** A smooth profile of widths: monotone cubics (Fritsch and Butland). @param {readonly (readonly number[])[]} stops @param {number} at */
function widthAt(stops, at) {
  const next = stops.findIndex(([position]) => position > at);
  if (next === 0) return stops[0][1];
  if (next < 0) return /** @type {readonly number[]} */ (stops.at(-1))[1];
  const rise = (/** @type {number} */ k) => (stops[k + 1][1] - stops[k][1]) / (stops[k + 1][0] - stops[k][0]);
  const slope = (/** @type {number} */ k) => {
    if (k === 0) return rise(0);
    if (k === stops.length - 1) return rise(k - 1);
    const [g, h] = [stops[k][0] - stops[k - 1][0], stops[k + 1][0] - stops[k][0]];
    const [p, q] = [rise(k - 1), rise(k)];
    return p * q > 0 ? (3 * (g + h)) / ((2 * g + h) / q + (g + 2 * h) / p) : 0;
  };
  const [[from, a], [to, d]] = [stops[next - 1], stops[next]];
  const [third, t] = [(to - from) / 3, (at - from) / (to - from)];
  const [b, c] = [a + third * slope(next - 1), d - third * slope(next)];
  const s = 1 - t;
  return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}

/**
 * The distance of a point from two discs and those between them, whose radii change linearly.
 *
 * @param {number} x
 * @param {number} y
 * @param {Disc} first
 * @param {Disc} second
 */
function distanceFromPair(x, y, [ax, ay, r], [bx, by, s]) {
  const [dx, dy, px, py] = [bx - ax, by - ay, x - ax, y - ay];
  const length = Math.hypot(dx, dy);
  const at = (/** @type {number} */ t) => Math.hypot(px - t * dx, py - t * dy) - r - t * (s - r);
  const slope = length > 0 ? (s - r) / length : Infinity;
  if (Math.abs(slope) >= 1) return Math.min(at(0), at(1)); // one disc contains the others
  // Where the tangent of the nearest disc is perpendicular to the way to the point.
  const across = Math.abs(px * dy - py * dx) / length;
  const along = (px * dx + py * dy) / length + (slope / Math.sqrt(1 - slope * slope)) * across;
  return at(Math.min(Math.max(along / length, 0), 1));
}

/**
 * The greatest distance of some points from the boundary of the union of discs, with those between neighbours.
 *
 * @param {Point[]} points
 * @param {Disc[]} discs
 */
export function distanceFromDiscs(points, discs) {
  const blocks = Array.from({ length: Math.ceil(discs.length / BLOCK) }, (_, k) => {
    const block = discs.slice(BLOCK * k, BLOCK * (k + 1) + 1);
    const [x, y] = block[block.length >> 1];
    return { x, y, reach: Math.max(...block.map((disc) => Math.hypot(disc[0] - x, disc[1] - y) + disc[2])), block };
  });
  let worst = 0;
  for (const [x, y] of points) {
    let nearest = Infinity;
    for (const { x: cx, y: cy, reach, block } of blocks)
      if (Math.hypot(x - cx, y - cy) - reach < nearest)
        for (let k = 0; k < block.length; k++)
          nearest = Math.min(nearest, distanceFromPair(x, y, block[k], block[k + 1] ?? block[k]));
    worst = Math.max(worst, Math.abs(nearest));
  }
  return worst;
}
