// Measurements that the tasks of the chapter on curves share.

/** How exactly a point can be placed by hand, in the units of the picture. */
export const PRECISION_PX = 4;

/** @typedef {readonly [number, number]} Pair */
/** @typedef {{ eval(t: number): { x: number, y: number } }} Evaluated */

/** @param {Pair} a @param {Pair} b */
export const distance = ([ax, ay], [bx, by]) => Math.hypot(bx - ax, by - ay);

/** A verdict of <lesson-task>. @param {boolean} done @param {string} words */
export const verdict = (done, words) => ({ done, words });

/** A number of pixels, as people say it. @param {number} value */
export const px = (value) => `${value < 10 ? value.toFixed(2) : value.toFixed(0)} px`;

/** The first curve of a figure. @param {{ pieces: { curve: any }[] }} figure */
export const firstCurve = ({ pieces }) => pieces[0]?.curve ?? null;

/** Points as the attribute `points` takes them. @param {Iterable<Pair>} points */
export const asText = (points) => [...points].map(([x, y]) => `${x},${y}`).join(" ");

/**
 * The greatest distance of a curve from the polyline of `segments` equal steps of t, measured at SAMPLES_PER_STEP places of each
 * step.
 *
 * @param {Evaluated} curve
 * @param {number} segments
 */
export function polylineError(curve, segments) {
  let worst = 0;
  for (let k = 0; k < segments; k++) {
    const [a, b] = [curve.eval(k / segments), curve.eval((k + 1) / segments)];
    for (let i = 1; i < SAMPLES_PER_STEP; i++)
      worst = Math.max(worst, fromChord(curve.eval((k + i / SAMPLES_PER_STEP) / segments), a, b));
  }
  return worst;
}
const SAMPLES_PER_STEP = 16;

/** @param {{ x: number, y: number }} p @param {{ x: number, y: number }} a @param {{ x: number, y: number }} b */
function fromChord(p, a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy || 1);
  const s = Math.min(1, Math.max(0, along));
  return Math.hypot(p.x - a.x - s * dx, p.y - a.y - s * dy);
}

/**
 * The greatest distance between two curves at equal parameters: 0 only for the same curve.
 *
 * @param {Evaluated} a
 * @param {Evaluated} b
 */
export function apart(a, b) {
  const gaps = Array.from({ length: 2 * SAMPLES_PER_STEP + 1 }, (_, i) => {
    const [p, q] = [a.eval(i / (2 * SAMPLES_PER_STEP)), b.eval(i / (2 * SAMPLES_PER_STEP))];
    return Math.hypot(p.x - q.x, p.y - q.y);
  });
  return Math.max(...gaps);
}
