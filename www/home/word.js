// The word as splines, and what is drawn of it: without a document, because the build draws the first picture with it.
import { Spline } from "./core.js";
import { STROKES } from "./letters.js";

/** @typedef {[number, number]} Point */
/** @typedef {import("casteljau/core").Spline} CoreSpline */
/** A line of a picture: x1, y1, x2, y2. @typedef {[number, number, number, number]} Line */

/** Samples of each curve, for the nearest point and the length. */
const SAMPLES = 24;
/** Joints that turn by less, in radians, stay smooth (G1); the others are corners of letters. */
const MAX_SMOOTH_ANGLE = 0.35;
/** A movement bends what is so near, in units of the picture; a longer one also what is farther. */
const REACH = 130;
/** Half the length of the tangents that the pen leaves behind. */
const TANGENT = 95;
/** The pen leaves lines behind at steps of the parameter. */
const TRAIL_STEP = 1 / 16;
/** The pen takes the time lengthᵏ for a curve: like a hand, it is slower on short, strongly bent ones. */
const TIME_EXPONENT = 0.65;
/** The parameter of a spline's end belongs to its last curve. */
const EPSILON = 1e-6;

/** @param {ArrayLike<number>} flat @returns {Point[]} */
const pairs = (flat) => Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);

/** @param {readonly number[]} numbers */
const sum = (numbers) => numbers.reduce((a, b) => a + b, 0);

const strokes = STROKES.map(({ points }) => new Spline(points));

/** For each stroke the joints that are not corners, as `movePoint` takes them. @type {Record<number, "g1">[]} */
const SMOOTH = strokes.map((spline) => {
  const smooth = Array.from({ length: spline.segmentCount - 1 }, (_, k) => k + 1).filter(
    (k) => spline.continuity(k).angle < MAX_SMOOTH_ANGLE,
  );
  return Object.fromEntries(smooth.map((k) => [k, "g1"]));
});

/** Makes the smooth joints of a stroke smooth. @param {CoreSpline} spline @param {number} stroke */
const smoothed = (spline, stroke) =>
  Object.keys(SMOOTH[stroke]).reduce((result, joint) => result.setJoint(Number(joint), "g1"), spline);

/** For each stroke the number of curves before it. */
const OFFSETS = strokes.map((_, i) => sum(strokes.slice(0, i).map(({ segmentCount }) => segmentCount)));

/** The number of curves: the word has the parameter 0 to this, as a spline has. */
export const CURVES = sum(strokes.map(({ segmentCount }) => segmentCount));
const LAST = CURVES - EPSILON;

/** The stroke of a curve. @param {number} curve */
const strokeOf = (curve) => OFFSETS.findLastIndex((offset) => offset <= curve);

/** The letter of a parameter. @param {number} t */
export function letterAt(t) {
  const stroke = strokeOf(Math.floor(t));
  return STROKES[stroke].letters[Math.floor(t) - OFFSETS[stroke]];
}

/** @typedef {{ points: Point[], lengths: number[] }} Samples points of a stroke, and the length up to each */

/** The word: what follows from the control points of its strokes. */
export class Word {
  /** @param {readonly CoreSpline[]} splines */
  constructor(splines) {
    this.splines = splines;
    this.segments = splines.flatMap((spline) => spline.segments());
    /** @type {Samples[]} */
    this.samples = splines.map((spline) => {
      const points = pairs(spline.sample(SAMPLES));
      const lengths = [0];
      for (let i = 1; i < points.length; i++) lengths.push(lengths[i - 1] + distance(points[i - 1], points[i]));
      return { points, lengths };
    });
  }

  /** The control points of each stroke. @returns {Point[][]} */
  get points() {
    return this.splines.map((spline) => pairs(spline.controlPoints()));
  }

  /** @param {readonly Point[][]} points of each stroke */
  static of(points) {
    return new Word(points.map((stroke) => new Spline(stroke)));
  }

  /** The polygons of de Casteljau's algorithm at a parameter of the word: four, three and two points, and the point. @param {number} t */
  construction(t) {
    const at = Math.min(t, LAST);
    return this.segments[Math.floor(at)].deCasteljau(at % 1);
  }

  /** The part of a stroke's length that is before a parameter of the word. @param {number} stroke @param {number} t */
  partBefore(stroke, t) {
    const { lengths } = this.samples[stroke];
    const at = Math.min(Math.max((t - OFFSETS[stroke]) * SAMPLES, 0), lengths.length - 1);
    const k = Math.min(Math.floor(at), lengths.length - 2);
    return (lengths[k] + (at - k) * (lengths[k + 1] - lengths[k])) / (lengths.at(-1) ?? 1);
  }

  /** The sample that is nearest to a point. @param {Point} point */
  nearest(point) {
    let best = { distance: Infinity, t: 0, point };
    for (const [stroke, { points }] of this.samples.entries())
      for (const [i, sample] of points.entries()) {
        const far = distance(point, sample);
        if (far >= best.distance) continue;
        const end = OFFSETS[stroke] + this.splines[stroke].segmentCount - EPSILON;
        best = { distance: far, t: Math.min(OFFSETS[stroke] + i / SAMPLES, end), point: sample };
      }
    return best;
  }

  /** Moves the control points near a point along with it, so that the letters keep their shape. @param {Point} point @param {Point} by */
  bend([x, y], [dx, dy]) {
    const reach = Math.max(REACH, 0.9 * Math.hypot(dx, dy));
    const moved = this.points.map((stroke) =>
      stroke.map(([px, py]) => {
        const weight = Math.exp(-((px - x) ** 2 + (py - y) ** 2) / (2 * reach * reach));
        return /** @type {Point} */ ([px + weight * dx, py + weight * dy]);
      }),
    );
    return new Word(moved.map((stroke, i) => smoothed(new Spline(stroke), i)));
  }

  /** Moves one control point; smooth joints stay smooth. @param {number} stroke @param {number} index @param {Point} to */
  movePoint(stroke, index, to) {
    return new Word(
      this.splines.map((spline, i) => (i === stroke ? spline.movePoint(index, to, { joints: SMOOTH[i] }) : spline)),
    );
  }
}

/** @param {Point} a @param {Point} b */
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The word as it is at first. */
export const WORD = new Word(strokes.map(smoothed));

/** Its control points. @type {readonly Point[][]} */
export const ORIGINAL = WORD.points;

/** The end points of all curves: the stroke and the index of the control point. @type {readonly [number, number][]} */
export const KNOTS = ORIGINAL.flatMap((points, i) =>
  points.flatMap((_, k) => (k % 3 === 0 ? [/** @type {[number, number]} */ ([i, k])] : [])),
);

/** The parameter of a control point that is an end of a curve. @param {number} stroke @param {number} index */
export const parameterOf = (stroke, index) => Math.min(OFFSETS[stroke] + index / 3, LAST);

const times = WORD.samples.flatMap(({ lengths }) =>
  Array.from(
    { length: (lengths.length - 1) / SAMPLES },
    (_, k) => (lengths[(k + 1) * SAMPLES] - lengths[k * SAMPLES]) ** TIME_EXPONENT,
  ),
);
const total = sum(times);
const starts = times.map((_, i) => sum(times.slice(0, i)) / total);

/** Where the pen is after a part of the time for the whole word, from 0 to 1. */
export function parameterAfter(/** @type {number} */ part) {
  const k = starts.findLastIndex((start) => start <= part);
  return Math.min(k + (part - starts[k]) / (times[k] / total), LAST);
}

/** The part of the time after which the pen is at a parameter. */
export function timeOf(/** @type {number} */ t) {
  const k = Math.min(Math.floor(t), CURVES - 1);
  return starts[k] + (t - k) * (times[k] / total);
}

/** @typedef {{ tangent: boolean, line: Line }} TrailLine a tangent, or a side of the triangle of the first round */

/**
 * The lines that the pen leaves behind between two parameters, at even steps whatever the frame rate: the sides of the first
 * round, and the last round made longer, which is the tangent. Many of them show the curve as an envelope.
 *
 * @param {Word} word
 * @param {number} from
 * @param {number} to
 */
export function trailBetween(word, from, to) {
  const [first, last] = [Math.round(from / TRAIL_STEP), Math.round(to / TRAIL_STEP)];
  const step = Math.sign(last - first);
  /** @type {TrailLine[]} */
  const lines = [];
  for (let i = first; i !== last; i += step) {
    const [, a, b] = word.construction(i * TRAIL_STEP);
    lines.push({ tangent: true, line: tangent(b) });
    for (const k of [0, 2]) lines.push({ tangent: false, line: [a[k], a[k + 1], a[k + 2], a[k + 3]] });
  }
  return lines;
}

/** @param {ArrayLike<number>} side two points @returns {Line} */
function tangent({ 0: x1, 1: y1, 2: x2, 3: y2 }) {
  const [x, y] = [(x1 + x2) / 2, (y1 + y2) / 2];
  const k = TANGENT / (Math.hypot(x2 - x1, y2 - y1) || 1);
  const [dx, dy] = [k * (x2 - x1), k * (y2 - y1)];
  return [x - dx, y - dy, x + dx, y + dy];
}

/** Path data of a polyline. @param {ArrayLike<number>} flat */
export const polyline = (flat) =>
  `M${pairs(flat)
    .map(([x, y]) => `${round(x)} ${round(y)}`)
    .join("L")}`;

/** To a tenth of a unit. @param {number} x */
export const round = (x) => Number(x.toFixed(1));
