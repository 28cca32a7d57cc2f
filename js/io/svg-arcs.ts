// Runs of cubics that are elliptical arcs, for the command A of SVG path data. src/io/svg_arcs.rs performs the same
// operations and explains them.
import { angleOf, arc, MAX_PIECE_ANGLE } from "./svg-arc.js";
import { MAX_DIGITS, roundTrip, shortNumber } from "./svg-write.js";
import type { ArcFinder } from "./svg-write.js";

const SIMILAR = 1e-9;
/** tan²(θ/4) of a cubic over the angle θ is between these values. */
const [MIN_SQUARE, MAX_SQUARE] = [1e-9, 0.18];
const SAME_SQUARE = 1e-12;
/**
 * Of arcs, as a part of the largest coordinate.
 *
 * @internal
 */
export const ROUNDING = 64 * Number.EPSILON;
const MAX_CUBICS = 414;
/**
 * The rotation of an ellipse has this many more digits, because an error of the angle moves points by its product with the radius.
 *
 * @internal
 */
export const MORE_DIGITS = 3;
/**
 * The number of significant digits (0 for all), and the part by which the radii are smaller.
 *
 * @internal
 */
export const CANDIDATES = [
  [12, 0],
  [12, 1e-11],
  [15, 0],
  [15, 1e-14],
  [0, 0],
  [0, 16 * Number.EPSILON],
];

/**
 * An arc as the arguments of the command A.
 *
 * @internal
 */
export type SvgArc = { radii: number[]; degrees: number; large: boolean; sweep: boolean };

/**
 * What a writer of path data has for arcs: `at` is the current point in short form.
 *
 * @internal
 */
export type SvgWriter = { precision?: number; arc(words: string[]): void; at?(): number[] };

/** The ellipse on which a cubic may be an arc: its center, the vectors u and v at the start, and tan²(θ/4). */
export type Ellipse = { cx: number; cy: number; ux: number; uy: number; vx: number; vy: number; square: number };

/**
 * @param at the index of the first control point after the start
 */
function ellipseOf(p: Float64Array, at: number): Ellipse | null {
  const [x0, y0] = [p[at - 2], p[at - 1]];
  const [ax, ay] = [p[at] - x0, p[at + 1] - y0];
  const [bx, by] = [p[at + 4] - p[at + 2], p[at + 5] - p[at + 3]];
  const [chordX, chordY] = [p[at + 4] - x0, p[at + 5] - y0];
  const [sumX, sumY] = [ax + bx, ay + by];
  const dot = chordX * sumX + chordY * sumY;
  const cross = chordX * sumY - chordY * sumX;
  const q = 1 - (1.5 * (sumX * sumX + sumY * sumY)) / dot;
  if (!(Math.abs(cross) <= SIMILAR * dot && q >= MIN_SQUARE && q < MAX_SQUARE)) return null;
  const w = (1 + q) * (1 + q);
  const cos = (1 - 6 * q + q * q) / w;
  const handleSin = ((16 / 3) * q * (1 - q)) / w;
  const [toX, toY] = [(bx - ax * cos) / handleSin, (by - ay * cos) / handleSin];
  const handle = (4 / 3) * Math.sqrt(q);
  return { cx: x0 + toX, cy: y0 + toY, ux: -toX, uy: -toY, vx: ax / handle, vy: ay / handle, square: q };
}

/**
 * The radii of the ellipse with the conjugate radii u and v, the angle of its first axis in degrees, u × v, and whether the
 * arc from u to v is the sweep of SVG.
 *
 * @internal
 */
export function axesOf(ux: number, uy: number, vx: number, vy: number) {
  const area = ux * vy - uy * vx;
  const sweep = area > 0;
  const [a, b, c] = [ux * ux + vx * vx, ux * uy + vx * vy, uy * uy + vy * vy];
  const [sum, half] = [a + c, (a - c) * 0.5];
  const h = Math.sqrt(half * half + b * b);
  const first = Math.sqrt(0.5 * sum + h);
  const second = Math.abs(area) / first;
  let radii = [first, second];
  let degrees = 0;
  if (h <= SIMILAR * sum) radii = [Math.sqrt(0.5 * sum), Math.sqrt(0.5 * sum)];
  else if (Math.abs(b) <= SIMILAR * sum) radii = half > 0 ? radii : [second, first];
  else {
    const acute = angleOf(Math.abs(half) / h, Math.abs(b) / h);
    const turn = half < 0 ? Math.PI - acute : acute;
    degrees = (b < 0 ? -turn : turn) * (90 / Math.PI);
  }
  return { area, sweep, radii, degrees };
}

const largest = (a: number, b: number) => Math.max(Math.abs(a), Math.abs(b));

/**
 * A number with some significant digits, 0 for all.
 *
 * @internal
 */
export const significant = (x: number, digits: number) => (digits ? Number(x.toPrecision(digits)) : x);

/** The angle θ of an arc with tan²(θ/4) = q. */
const cubicAngle = (q: number) => 2 * angleOf((1 - q) / (1 + q), (2 * Math.sqrt(q)) / (1 + q));

/** An elliptical arc and the cubics that it may consist of: of equal angles, at most a turn. */
class ArcRun {
  #ellipse;
  #points;
  #at;
  /** The number of cubics. */
  count = 1;

  constructor(ellipse: Ellipse, points: Float64Array, at: number, isCubic: (k: number) => boolean) {
    this.#ellipse = ellipse;
    this.#points = points;
    this.#at = at;
    const { cx, cy, ux, uy, vx, vy, square } = ellipse;
    const near = SIMILAR * Math.max(largest(ux, uy), largest(vx, vy), largest(cx, cy));
    const turn = Math.min(Math.ceil((2 * Math.PI) / cubicAngle(square)), MAX_CUBICS);
    for (; this.count < turn && isCubic(this.count); this.count++) {
      const [x, y] = this.end();
      if (x === points[at - 2] && y === points[at - 1]) break;
      const other = ellipseOf(points, at + 6 * this.count);
      if (!other || !(largest(other.cx - cx, other.cy - cy) <= near)) break;
      if (!(Math.abs(other.square - square) <= SAME_SQUARE)) break;
    }
  }

  /**
   * The longest run from a cubic on; null if that is no arc.
   *
   * @param at the index of the first control point after its start
   * @param isCubic whether the segment after so many cubics is one, too
   */
  static from(points: Float64Array, at: number, isCubic: (k: number) => boolean): ArcRun | null {
    const ellipse = ellipseOf(points, at);
    return ellipse && new ArcRun(ellipse, points, at, isCubic);
  }

  /** Keeps the first half of the cubics. */
  halve() {
    this.count = Math.floor(this.count / 2);
  }

  /** The end point. */
  end() {
    return this.#joint(this.count);
  }

  /** The arc of these cubics, up to rounding, if there is one. */
  exactArc(): SvgArc | null {
    const shape = this.arc();
    const from = [this.#points[this.#at - 2], this.#points[this.#at - 1]];
    let size = 0;
    for (let k = this.#at - 2; k < this.#at + 6 * this.count; k++) size = Math.max(size, Math.abs(this.#points[k]));
    for (const [digits, less] of CANDIDATES) {
      const round = (x: number) => significant(x, digits);
      const rounded = { ...shape, radii: shape.radii.map((r) => round(r * (1 - less))), degrees: round(shape.degrees) };
      if (this.isArc(rounded, from, this.end(), ROUNDING * size)) return rounded;
    }
    return null;
  }

  /** The number of cubics into which an arc is divided at least to be compared with these. */
  #minPieces() {
    const read = Math.ceil((cubicAngle(this.#ellipse.square) * this.count) / MAX_PIECE_ANGLE);
    return read < this.count ? this.count : 1;
  }

  /**
   * Whether an arc between two points is read as these cubics, or consists of them if they are finer, up to an error in each
   * coordinate.
   */
  isArc({ radii, degrees, large, sweep }: SvgArc, from: number[], to: number[], max: number) {
    const numbers = Float64Array.of(...radii, degrees, Number(large), Number(sweep));
    let same = true;
    const isNear = (x: number, k: number) => Math.abs(x - this.#points[this.#at + k]) <= max;
    const isSame = (cubics: number[]) => {
      const first = cubics.length - 6;
      same = cubics.length <= 6 * this.count && cubics.slice(first).every((x, i) => isNear(x, first + i));
      return same;
    };
    const cubics = arc(from[0], from[1], numbers, to[0], to[1], 0, this.#minPieces(), isSame);
    return same && cubics?.length === 6 * this.count;
  }

  /** The start of cubic k, or the end of the one before. */
  #joint(k: number) {
    const at = this.#at + 6 * k - 2;
    return [this.#points[at], this.#points[at + 1]];
  }

  /** The center and two conjugate radii. */
  #conjugateRadii() {
    const m = Math.floor(this.count / 3);
    if (m === 0) return this.#ellipse;
    const [[ax, ay], [bx, by], [cx, cy], [dx, dy]] = [0, m, 2 * m, 3 * m].map((k) => this.#joint(k));
    const [sumX, sumY] = [ax - bx + (cx - dx), ay - by + (cy - dy)];
    const [middleX, middleY] = [bx - cx, by - cy];
    const cos = (0.5 * (sumX * middleX + sumY * middleY)) / (middleX * middleX + middleY * middleY);
    const half = 0.5 / (1 - cos);
    const [ux, uy] = [(bx - ax + (bx - cx)) * half, (by - ay + (by - cy)) * half];
    const halfSin = 0.5 / Math.sqrt((1 - cos) * (1 + cos));
    return { cx: bx - ux, cy: by - uy, ux, uy, vx: (cx - ax) * halfSin, vy: (cy - ay) * halfSin };
  }

  /** The arc of the ellipse from the start to the end. */
  arc(): SvgArc {
    const { cx, cy, ux, uy, vx, vy } = this.#conjugateRadii();
    const { area, sweep, radii, degrees } = axesOf(ux, uy, vx, vy);
    const [startX, startY] = this.#joint(0);
    const [x, y] = this.end();
    const beyond = (startX - cx) * (y - cy) - (startY - cy) * (x - cx);
    return { radii, degrees, large: (sweep ? beyond : -beyond) < -SIMILAR * Math.abs(area), sweep };
  }
}

/**
 * Finds and writes the arcs of a subpath.
 *
 * @internal
 */
export const findArcs: ArcFinder = (packed, degrees, points, end, closed) => {
  if (!packed.subarray(degrees, points).includes(3)) return null;
  const outline = new Float64Array(end - points + 2 * Number(closed));
  outline.set(packed.subarray(points, end));
  if (closed) outline.set(packed.subarray(points, points + 2), end - points);
  return (writer: SvgWriter, k, at) => {
    const run = ArcRun.from(outline, at - points, (i) => degrees + k + i < points && packed[degrees + k + i] === 3);
    for (; run && run.count > 0; run.halve()) {
      const words = writer.precision === undefined ? exactWords(run) : shortWords(run, writer, writer.precision);
      if (!words) continue;
      writer.arc(words);
      return run.count;
    }
    return 0;
  };
};

function exactWords(run: ArcRun) {
  const arc = run.exactArc();
  if (!arc) return null;
  const [large, sweep] = [`${Number(arc.large)}`, `${Number(arc.sweep)}`];
  return [...[...arc.radii, arc.degrees].map(roundTrip), large, sweep, ...run.end().map(roundTrip)];
}

/**
 * The radii are rounded, or rounded down by one unit of the last digit: of half an ellipse, larger radii would move the
 * center far.
 */
function shortWords(run: ArcRun, writer: SvgWriter, precision: number) {
  const unit = 10 ** -precision;
  const arc = run.arc();
  const to = run.end().map((x) => shortNumber(x, precision));
  const degrees = shortNumber(arc.degrees, Math.min(precision + MORE_DIGITS, MAX_DIGITS));
  for (const less of [0, unit]) {
    const words = arc.radii.map((r) => shortNumber(r - less, precision));
    const rounded = { ...arc, radii: words.map(Number), degrees: Number(degrees) };
    if (!(Math.min(...rounded.radii) > 0)) continue;
    if (!run.isArc(rounded, writer.at?.() ?? [], to.map(Number), unit)) continue;
    return [...words, degrees, `${Number(arc.large)}`, `${Number(arc.sweep)}`, ...to];
  }
  return null;
}
