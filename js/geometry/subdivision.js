/**
 * @import { Curve } from "./curve.js"
 */

/**
 * A piece of a curve in the tree of recursive halving.
 *
 * @typedef {object} Subdivision
 * @property {Curve} curve the piece
 * @property {number} t0 where it starts on the whole curve
 * @property {number} t1 where it ends
 * @property {number} polygonLength D1, the length of its control polygon
 * @property {number} chordLength D2, the length of its chord
 * @property {number} deviationBound ½√(D1² − D2²): the piece is no farther than that from its chord
 * @property {[Subdivision, Subdivision] | null} halves none for a leaf, which counts as straight
 */

/** t0, t1, D1, D2, the bound, and whether halves follow. */
const HEAD_LENGTH = 6;

/**
 * The tree from its numbers in preorder.
 *
 * @internal
 * @param {Float64Array} numbers
 * @param {number} pointsLength
 * @param {(flat: Float64Array) => Curve} curveOf
 * @returns {Subdivision}
 */
export function readTree(numbers, pointsLength, curveOf) {
  let at = 0;
  /** @returns {Subdivision} */
  const node = () => {
    const [t0, t1, polygonLength, chordLength, deviationBound, halved] = numbers.subarray(at, at + HEAD_LENGTH);
    const curve = curveOf(numbers.slice(at + HEAD_LENGTH, at + HEAD_LENGTH + pointsLength));
    at += HEAD_LENGTH + pointsLength;
    const halves = /** @type {[Subdivision, Subdivision] | null} */ (halved ? [node(), node()] : null);
    return { curve, t0, t1, polygonLength, chordLength, deviationBound, halves };
  };
  return node();
}
