// An outline as the editor knows it: contours of lines and Bézier curves, a mode for each joint. Every change gives a new one.
import { Curve, Path, Spline } from "casteljau";

/** @typedef {"free" | "g1" | "c1" | "c2" | "g2" | "auto"} Mode */
/** @typedef {{ spline: Spline, modes: readonly Mode[] }} Contour `modes[k]`: of the joint at t = k */
/** @typedef {readonly Contour[]} Outline */
/** @typedef {[number, number]} Place */
/** @typedef {{ at: Place, on: boolean, joint: number, index: number }} Node `joint`: its own, or of the segment that it pulls */

export const MODES = /** @type {const} */ (["free", "g1", "c1", "g2", "c2", "auto"]);
/** More points than this nobody edits by hand. */
export const MAX_POINTS = 2000;

/** @param {Outline} outline */
export const pathOf = (outline) => new Path(outline.map(({ spline }) => spline));

/**
 * Smooth joints are held smooth, corners stay free.
 *
 * @param {Spline} spline
 * @returns {Contour}
 */
export function contourOf(spline) {
  const joints = spline.segmentCount + (spline.closed ? 0 : 1);
  const inner = (/** @type {number} */ k) => spline.closed || (k > 0 && k < spline.segmentCount);
  // Letters are drawn on whole numbers: a thousandth of the size is as smooth as anybody means.
  const { min, max } = spline.controlBounds();
  const close = Math.hypot(max.x - min.x, max.y - min.y) * 1e-3;
  const smooth = (/** @type {number} */ k) =>
    inner(k) && segmentsAt(spline, k).some((curve) => curve.degree > 1) && spline.continuity(k, close).g1;
  return { spline, modes: Array.from({ length: joints }, (_, k) => (smooth(k) ? "g1" : "free")) };
}

/** The segments before and behind a joint. @param {Spline} spline @param {number} k */
function segmentsAt(spline, k) {
  const all = spline.segments();
  return [all[(k + all.length - 1) % all.length], all[k % all.length]];
}

/**
 * An outline out of SVG path data.
 *
 * @param {string} d
 * @returns {Outline}
 * @throws {RangeError} for what is no path data, for a path without curves, for one with too many points
 */
export function fromSvg(d) {
  const path = Path.fromSVG(d);
  const points = path.subpaths.reduce((sum, spline) => sum + spline.controlPoints().length / 2, 0);
  if (points === 0) throw new RangeError("expected at least one line or curve");
  if (points > MAX_POINTS) throw new RangeError(`expected at most ${MAX_POINTS} points, got ${points}`);
  return path.subpaths.map(contourOf);
}

/**
 * All points of a contour in order.
 *
 * @param {Spline} spline
 * @returns {Node[]}
 */
export function nodesOf(spline) {
  const flat = spline.controlPoints();
  const starts = [0];
  for (const degree of spline.degrees) starts.push(starts[starts.length - 1] + degree);
  return Array.from({ length: flat.length / 2 }, (_, index) => {
    const after = starts.findIndex((start) => start > index);
    const joint = (after === -1 ? starts.length : after) - 1;
    return {
      at: /** @type {Place} */ ([flat[2 * index], flat[2 * index + 1]]),
      on: starts.includes(index),
      joint,
      index,
    };
  });
}

/** @param {Outline} outline */
export function countPoints(outline) {
  const nodes = outline.flatMap(({ spline }) => nodesOf(spline));
  const on = nodes.filter((node) => node.on).length;
  return { on, off: nodes.length - on, all: nodes.length };
}

/** @param {Outline} outline @param {number} c @param {Contour} contour @returns {Outline} */
const replaced = (outline, c, contour) => outline.map((old, k) => (k === c ? contour : old));

/** @param {Outline} outline @param {number} c @param {number} index @param {Place} to */
export function movePoint(outline, c, index, to) {
  const { spline, modes } = outline[c];
  return replaced(outline, c, { spline: spline.movePoint(index, to, { joints: [...modes] }), modes });
}

/** @param {Outline} outline @param {number} c @param {number} joint @param {Mode} mode */
export function setMode(outline, c, joint, mode) {
  const { spline, modes } = outline[c];
  return replaced(outline, c, {
    spline: spline.setJoint(joint, mode),
    modes: modes.map((old, k) => (k === joint ? mode : old)),
  });
}

/** One more joint, exactly on the outline. @param {Outline} outline @param {number} c @param {number} t */
export function insert(outline, c, t) {
  const { spline, modes } = outline[c];
  const k = Math.min(Math.floor(t), spline.segmentCount - 1);
  const straight = spline.degrees[k] === 1;
  return replaced(outline, c, { spline: spline.insert(t), modes: modes.toSpliced(k + 1, 0, straight ? "free" : "g1") });
}

/**
 * A joint less; its two segments become one. A contour that has only two of them goes as a whole.
 *
 * @param {Outline} outline
 * @param {number} c
 * @param {number} joint
 * @returns {Outline}
 */
export function remove(outline, c, joint) {
  const { spline, modes } = outline[c];
  if (spline.segmentCount <= 2) return outline.filter((_, k) => k !== c);
  const atEnd = !spline.closed && (joint === 0 || joint === spline.segmentCount);
  if (!atEnd) return replaced(outline, c, { spline: spline.remove(joint), modes: modes.toSpliced(joint, 1) });
  const rest = spline.segments().slice(joint === 0 ? 1 : 0, joint === 0 ? undefined : -1);
  return replaced(outline, c, { spline: Spline.fromCurves(rest), modes: modes.toSpliced(joint, 1) });
}

/** Replaces the segment behind a joint. @param {Outline} outline @param {number} c @param {number} k @param {(segment: Curve) => Curve} change */
function changeSegment(outline, c, k, change) {
  const { spline, modes } = outline[c];
  const segments = spline.segments().map((segment, i) => (i === k ? change(segment) : segment));
  return replaced(outline, c, { spline: Spline.fromCurves(segments, { closed: spline.closed }), modes });
}

/** A line becomes a cubic, anything else a line. @param {Outline} outline @param {number} c @param {number} k */
export function bendOrStraighten(outline, c, k) {
  const straighten = (/** @type {Curve} */ curve) => {
    const [a, b] = [curve.eval(0), curve.eval(1)];
    return new Curve([
      [a.x, a.y],
      [b.x, b.y],
    ]);
  };
  return changeSegment(outline, c, k, (curve) => (curve.degree === 1 ? curve.elevate().elevate() : straighten(curve)));
}

/** Runs a contour the other way: a hole becomes filled, and back. @param {Outline} outline @param {number} c */
export function reverse(outline, c) {
  const { spline, modes } = outline[c];
  // A closed contour keeps its first point.
  return replaced(outline, c, {
    spline: spline.reverse(),
    modes: spline.closed ? [modes[0], ...modes.slice(1).reverse()] : modes.toReversed(),
  });
}

/** A round contour, clockwise as seen. @param {Outline} outline @param {Place} centre @param {number} radius */
export function addRound(outline, [x, y], radius) {
  const arc = (/** @type {number} */ dx, /** @type {number} */ dy) =>
    `A${radius} ${radius} 0 0 1 ${x + dx * radius} ${y + dy * radius}`;
  return [...outline, ...fromSvg(`M${x + radius} ${y}${arc(0, 1)}${arc(-1, 0)}${arc(0, -1)}${arc(1, 0)}Z`)];
}

/** @param {Outline} outline */
export const toCubics = (outline) =>
  outline.map(({ spline }) => {
    const raised = spline.segments().map((segment) => (segment.degree === 2 ? segment.elevate() : segment));
    return contourOf(Spline.fromCurves(raised, { closed: spline.closed }));
  });

/** So many pieces a cubic at most. */
const MAX_PIECES = 64;

/**
 * A cubic as quadratics, as fonts of the TrueType kind want it: pieces of equal t, as few as the tolerance allows, the
 * distance measured and not estimated.
 *
 * @param {Curve} curve
 * @param {number} tolerance
 * @returns {{ curves: Curve[], error: number }}
 */
export function quadratics(curve, tolerance) {
  if (curve.degree < 3) return { curves: [curve], error: 0 };
  for (let n = 1; ; n++) {
    const pieces = Array.from({ length: n }, (_, i) => curve.subsegment(i / n, (i + 1) / n));
    const flat = pieces.map((piece) => piece.controlPoints());
    // Ends kept, the middle where the end tangents of the cubic balance; neighbours share their ends to the bit.
    const curves = flat.map((p, i) => {
      const end = flat[i + 1] ?? p.subarray(6);
      return new Curve([
        [p[0], p[1]],
        [(3 * (p[2] + p[4]) - p[0] - p[6]) / 4, (3 * (p[3] + p[5]) - p[1] - p[7]) / 4],
        [end[0], end[1]],
      ]);
    });
    const error = Math.max(...curves.map((quadratic, i) => quadratic.hausdorff(pieces[i])));
    if (error <= tolerance || n === MAX_PIECES) return { curves, error };
  }
}

/**
 * The whole outline as lines and quadratics.
 *
 * @param {Outline} outline
 * @param {number} tolerance
 * @returns {{ outline: Outline, error: number }} the greatest distance between the two
 */
export function toQuadratics(outline, tolerance) {
  let error = 0;
  const contours = outline.map(({ spline }) => {
    const parts = spline.segments().map((segment) => quadratics(segment, tolerance));
    error = Math.max(error, ...parts.map((part) => part.error));
    return contourOf(
      Spline.fromCurves(
        parts.flatMap((part) => part.curves),
        { closed: spline.closed },
      ),
    );
  });
  return { outline: contours, error };
}
