// Curves of high degrees for the picture: halved where they are visible, until they differ from lines by less than a pixel.

export type Box = { width: number; height: number };

/** A piece whose points are so near to even steps on its chord, in the picture's units, is a line. */
const STRAIGHT = 0.08;
/** More pieces than these are not looked at: what is left is drawn by its chords. */
const MAX_PIECES = 3000;

/**
 * @param points on the picture
 * @param box what of it is seen
 * @param go a line to a place; left out where it is not seen
 */
export function traceSeen(points: Float64Array, box: Box, go: (x: number, y: number, seen: boolean) => void) {
  let left = MAX_PIECES;
  const visit = (p: Float64Array) => {
    const [x, y] = [p[p.length - 2], p[p.length - 1]];
    if (isAside(p, 0, box.width) || isAside(p, 1, box.height)) return go(x, y, false);
    if (left-- <= 0 || isStraight(p)) return go(x, y, true);
    const second = halve(p);
    visit(p);
    visit(second);
  };
  visit(points);
}

/** Whether all points lie more than the picture's size beyond one side of it, or are no numbers. */
function isAside(p: Float64Array, axis: 0 | 1, size: number) {
  let [min, max] = [Infinity, -Infinity];
  for (let i = axis; i < p.length; i += 2) {
    if (!(p[i] - p[i] === 0)) return true;
    min = Math.min(min, p[i]);
    max = Math.max(max, p[i]);
  }
  return max < -size || min > 2 * size;
}

function isStraight(p: Float64Array) {
  const last = p.length - 2;
  const [x, y, dx, dy] = [p[0], p[1], (p[last] - p[0]) / last, (p[last + 1] - p[1]) / last];
  for (let i = 2; i < last; i += 2) {
    if (!(Math.abs(p[i] - x - i * dx) + Math.abs(p[i + 1] - y - i * dy) <= STRAIGHT)) return false;
  }
  return true;
}

/**
 * De Casteljau's algorithm in place.
 *
 * @param p becomes the first half
 * @returns the second one
 */
function halve(p: Float64Array): Float64Array {
  const second = new Float64Array(p.length);
  for (let end = p.length - 2; end >= 0; end -= 2) {
    second[end] = p[p.length - 2];
    second[end + 1] = p[p.length - 1];
    for (let i = p.length - 1; i > p.length - 1 - end; i--) p[i] = 0.5 * (p[i] + p[i - 2]);
  }
  return second;
}
