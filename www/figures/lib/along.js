// What is plotted along a chain of pieces when t runs evenly: the speed of the point, or how sharply it turns.

/** Samples of each piece. */
const STEPS = 60;

/** @typedef {{ degree: number, derivativeAt(t: number): { x: number, y: number }, curvature(t: number): number }} Piece */

/** What is plotted, at t of a piece: px in the unit of time, or a turn per px, to either side. */
const MEASURES = {
  speed: (/** @type {Piece} */ piece, /** @type {number} */ t) => {
    const { x, y } = piece.derivativeAt(t);
    return Math.hypot(x, y);
  },
  curvature: (/** @type {Piece} */ piece, /** @type {number} */ t) => piece.curvature(t),
};

/**
 * The values along all pieces, and on both sides of every joint.
 *
 * @param {Piece[]} pieces
 * @param {keyof typeof MEASURES} what
 */
export function along(pieces, what) {
  const measure = MEASURES[what];
  const lines = pieces.map((piece, k) =>
    Array.from(
      { length: STEPS + 1 },
      (_, i) => /** @type {[number, number]} */ ([k + i / STEPS, measure(piece, i / STEPS)]),
    ),
  );
  const joints = pieces
    .slice(1)
    .map((piece, k) => ({ at: k + 1, before: measure(pieces[k], 1), after: measure(piece, 0) }));
  return { lines, joints };
}

/** Whether a value jumps so that it can be seen. @param {{ before: number, after: number }} joint @param {number} range of all values */
export const jumps = ({ before, after }, range) => Math.abs(after - before) > range / 200;
