/**
 * A node of the tree of recursive halving: a part of a curve.
 *
 * @template C the class of the curve
 */
export interface Subdivision<C> {
  /** The part */
  curve: C;
  /** The parameter of its start on the whole curve */
  t0: number;
  /** The parameter of its end */
  t1: number;
  /** D1, the length of its control polygon */
  polygonLength: number;
  /** D2, the length of its chord */
  chordLength: number;
  /** ½√(D1² − D2²), a bound on the distance of the part from its chord */
  deviationBound: number;
  /** Null for a leaf, which counts as straight */
  halves: [Subdivision<C>, Subdivision<C>] | null;
}

/** The numbers before the control points of a node: t0, t1, D1, D2, the bound, and whether halves follow. */
const HEADER_LENGTH = 6;

/**
 * Reads a tree, whose nodes are in preorder.
 *
 * @internal
 */
export function readTree<C>(
  numbers: Float64Array,
  pointsLength: number,
  curveOf: (flat: Float64Array) => C,
): Subdivision<C> {
  let at = 0;
  const node = (): Subdivision<C> => {
    const [t0, t1, polygonLength, chordLength, deviationBound, halved] = numbers.subarray(at, at + HEADER_LENGTH);
    const curve = curveOf(numbers.slice(at + HEADER_LENGTH, at + HEADER_LENGTH + pointsLength));
    at += HEADER_LENGTH + pointsLength;
    const halves = (halved ? [node(), node()] : null) as [Subdivision<C>, Subdivision<C>] | null;
    return { curve, t0, t1, polygonLength, chordLength, deviationBound, halves };
  };
  return node();
}
