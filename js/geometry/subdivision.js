/**
 * @import { Curve } from "./curve/curve.js"
 */

/**
 * A node of the tree of recursive halving: a part of a curve.
 *
 * @template [C=Curve] the class of the curve
 * @typedef {object} Subdivision
 * @property {C} curve the part
 * @property {number} t0 the parameter of its start on the whole curve
 * @property {number} t1 the parameter of its end
 * @property {number} polygonLength D1, the length of its control polygon
 * @property {number} chordLength D2, the length of its chord
 * @property {number} deviationBound ½√(D1² − D2²), a bound on the distance of the part from its chord
 * @property {[Subdivision<C>, Subdivision<C>] | null} halves null for a leaf, which counts as straight
 */

/** The numbers before the control points of a node: t0, t1, D1, D2, the bound, and whether halves follow. */
const HEADER_LENGTH = 6;

/**
 * Reads a tree, whose nodes are in preorder.
 *
 * @internal
 * @template C
 * @param {Float64Array} numbers
 * @param {number} pointsLength
 * @param {(flat: Float64Array) => C} curveOf
 * @returns {Subdivision<C>}
 */
export function readTree(numbers, pointsLength, curveOf) {
  let at = 0;
  /** @returns {Subdivision<C>} */
  const node = () => {
    const [t0, t1, polygonLength, chordLength, deviationBound, halved] = numbers.subarray(at, at + HEADER_LENGTH);
    const curve = curveOf(numbers.slice(at + HEADER_LENGTH, at + HEADER_LENGTH + pointsLength));
    at += HEADER_LENGTH + pointsLength;
    const halves = /** @type {[Subdivision<C>, Subdivision<C>] | null} */ (halved ? [node(), node()] : null);
    return { curve, t0, t1, polygonLength, chordLength, deviationBound, halves };
  };
  return node();
}
