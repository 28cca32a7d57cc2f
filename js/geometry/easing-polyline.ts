// The fewest links of a polyline within a tolerance of another one. src/easing/polyline.rs performs the same operations
// in the same order.
//
// Source: H. Imai and M. Iri, "An optimal algorithm for approximating a piecewise linear function", Journal of
// Information Processing 9 (1986). Each link is extended as far as a line stays within the tolerance. The longest line
// touches one boundary and ends at the other one; the next link may begin anywhere between these two points.

import type { Stop } from "./easing-piecewise.js";

/** The line of a link through the point `from`. The next link begins on it, between `from` and x = `to`. */
export type Line = readonly [slope: number, from: Stop, to: number];

/** What a line has to pass, for one boundary of the tolerance. */
export type Boundary = {
  /** The points on the boundary */
  points: Stop[];
  /** The slope of the line that touches it last, and the point that it touches then */
  slope: number;
  touch: Stop;
  /** The convex hull, on the side of the lines, of the first `done` points */
  hull: Stop[];
  done: number;
};

/** Halvings of the tolerance in the search for the smallest error. */
const ROUNDS = 12;
/** The lower boundary limits slopes from below, the upper boundary from above. */
const SIGNS = [1, -1];

/**
 * The polyline of the fewest stops between the ends of a run, at the smallest error that this number permits.
 *
 * @internal
 */
export function approximate(run: readonly Stop[], tolerance: number): Stop[] {
  let best = fewestLines(run, tolerance);
  for (let low = 0, round = 0; round < ROUNDS; round++) {
    const middle = 0.5 * (low + tolerance);
    const lines = fewestLines(run, middle);
    if (lines.length > best.length) low = middle;
    else [tolerance, best] = [middle, lines];
  }
  const inner = best.slice(1).map((next, k) => corner(best[k], next));
  return [run[0], ...inner, run[run.length - 1]];
}

/** The lines of the fewest links, each one as long as possible. */
function fewestLines(run: readonly Stop[], tolerance: number): Line[] {
  const end = run.length - 1;
  const lines: Line[] = [];
  let link = newLink();
  for (let k = 0; k <= end; ) {
    const [x, y] = run[k];
    const points = SIGNS.map((sign) => [x, k % end === 0 ? y : y - sign * tolerance] as Stop);
    const side = points.findIndex((point, i) => SIGNS[i] * (slopeTo(link, i, point) - link[1 - i].slope) > 0);
    if (side < 0) {
      points.forEach((point, i) => addPoint(link, i, point));
      k++;
    } else {
      const { points: others, slope, touch: from } = link[1 - side];
      const to = k === end ? x : crossing(slope, from, link[side].points.at(-1) as Stop, points[side]);
      lines.push([slope, from, to] as const);
      const next = newLink();
      for (const point of others.slice(others.indexOf(from))) addPoint(next, 1 - side, point);
      if (k < end) addPoint(next, side, [to, heightAt(slope, from, to)]);
      link = next;
    }
  }
  // Through the last point, in the middle of the possible slopes.
  const slopes = link.map(({ slope }) => slope).filter(Number.isFinite);
  const slope = 0.5 * (slopes[0] + slopes[slopes.length - 1]);
  return [...lines, [slope, run[end], 0] as const];
}

/** @returns lower, upper */
const newLink = (): Boundary[] =>
  SIGNS.map((sign) => ({ points: [], slope: -sign / 0, touch: [0, 0], hull: [], done: 0 }));

/**
 * The limit that a point of one boundary sets to the slopes of lines which pass the other one, on the left of the point.
 *
 * @param point not left of any other
 */
function slopeTo(link: Boundary[], side: number, point: Stop) {
  const sign = SIGNS[side];
  const other = link[1 - side];
  const { points, hull } = other;
  const slope = ([a, b]: Stop, [x, y]: Stop) => (sign * (y - b)) / (x - a);
  for (; points[other.done]?.[0] < point[0]; other.done++) {
    const next = points[other.done];
    let k = hull.length - 1;
    while (k > 0 && !(slope(hull[k - 1], hull[k]) < slope(hull[k], next))) k--;
    hull.length = k + 1;
    hull.push(next);
  }
  // Along the hull the slopes grow up to the point that the line touches, and then fall.
  let low = 0;
  for (let high = hull.length - 1; low < high; ) {
    const middle = (low + high) >> 1;
    if (slope(hull[middle], point) < slope(hull[middle + 1], point)) low = middle + 1;
    else high = middle;
  }
  return hull.length ? sign * slope(hull[low], point) : -sign / 0;
}

function addPoint(link: Boundary[], side: number, point: Stop) {
  const own = link[side];
  const slope = slopeTo(link, side, point);
  own.points.push(point);
  if (SIGNS[side] * (slope - own.slope) > 0) [own.slope, own.touch] = [slope, point];
}

/** The x at which a line crosses the one between two points, which lie on different sides of it. */
function crossing(slope: number, from: Stop, a: Stop, b: Stop) {
  const [before, after] = [a, b].map(([x, y]) => Math.abs(heightAt(slope, from, x) - y));
  return a[0] + (before / (before + after)) * (b[0] - a[0]);
}

const heightAt = (slope: number, from: Stop, x: number) => from[1] + slope * (x - from[0]);

/** The point at which two consecutive lines meet. */
function corner([slope, from, to]: Line, [nextSlope, nextFrom]: Line): Stop {
  const turn = slope - nextSlope;
  const away = turn ? (heightAt(nextSlope, nextFrom, from[0]) - from[1]) / turn : 0;
  const x = Math.min(from[0] + Math.max(away, 0), to);
  return [x, heightAt(slope, from, x)];
}
