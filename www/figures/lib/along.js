// What is plotted along a chain of pieces when t runs evenly: the speed of the point, or how sharply it turns.

/** Samples of each piece. */
const STEPS = 60;

/** @typedef {{ degree: number, derivativeAt(t: number): { x: number, y: number }, curvature(t: number): number }} Piece */

/** What is plotted, at t of a piece that takes `duration`: px in the unit of time, or a turn per px, to either side. */
const MEASURES = {
  speed: (/** @type {Piece} */ piece, /** @type {number} */ t, /** @type {number} */ duration) => {
    const { x, y } = piece.derivativeAt(t);
    return Math.hypot(x, y) / duration;
  },
  curvature: (/** @type {Piece} */ piece, /** @type {number} */ t) => piece.curvature(t),
};

/**
 * The values along all pieces, and on both sides of every joint. `starts` are the times at which the pieces start, and the end.
 *
 * @param {Piece[]} pieces
 * @param {keyof typeof MEASURES} what
 * @param {number[]} durations of the pieces; a missing one is 1
 */
export function along(pieces, what, durations = []) {
  const lasting = pieces.map((_, k) => durations[k] ?? 1);
  const starts = [0, ...lasting].map((_, k) => lasting.slice(0, k).reduce((sum, duration) => sum + duration, 0));
  const measure = (/** @type {number} */ k, /** @type {number} */ t) => MEASURES[what](pieces[k], t, lasting[k]);
  const lines = pieces.map((_, k) =>
    Array.from(
      { length: STEPS + 1 },
      (_, i) => /** @type {[number, number]} */ ([starts[k] + (i / STEPS) * lasting[k], measure(k, i / STEPS)]),
    ),
  );
  const joints = pieces
    .slice(1)
    .map((_, k) => ({ at: starts[k + 1], before: measure(k, 1), after: measure(k + 1, 0) }));
  return { lines, joints, starts };
}

/** Whether a value jumps so that it can be seen. @param {{ before: number, after: number }} joint @param {number} range of all values */
export const jumps = ({ before, after }, range) => Math.abs(after - before) > range / 200;
