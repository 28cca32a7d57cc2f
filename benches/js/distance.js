// Distances, for the checks of results.

/** @typedef {number[]} Point */

const minus = (/** @type {Point} */ a, /** @type {Point} */ b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (/** @type {Point} */ a, /** @type {Point} */ b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (/** @type {Point} */ a, /** @type {Point} */ b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/**
 * The distance of a point from a triangle, which may be degenerate.
 *
 * @param {Point} p
 * @param {Point[]} triangle
 */
export function distanceToTriangle(p, [a, b, c]) {
  const normal = cross(minus(b, a), minus(c, a));
  const inside = (/** @type {Point} */ from, /** @type {Point} */ to) =>
    dot(cross(minus(to, from), minus(p, from)), normal) >= 0;
  if (dot(normal, normal) > 0 && inside(a, b) && inside(b, c) && inside(c, a)) {
    return Math.abs(dot(minus(p, a), normal)) / Math.sqrt(dot(normal, normal));
  }
  return Math.min(distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a));
}

/**
 * @param {Point} p
 * @param {Point} from
 * @param {Point} to
 */
export function distanceToSegment(p, from, to) {
  const along = minus(to, from);
  const t = Math.min(1, Math.max(0, dot(minus(p, from), along) / (dot(along, along) || 1)));
  return Math.hypot(
    ...minus(
      p,
      [0, 1, 2].map((k) => from[k] + t * along[k]),
    ),
  );
}
