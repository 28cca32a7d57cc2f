/**
 * An edge of a patch.
 *
 * @typedef {object} EdgeUse
 * @property {number} patch the number of the patch
 * @property {"u0" | "u1" | "v0" | "v1"} edge the parameter that is constant along the edge, and its value
 * @property {boolean} reversed whether the edge runs against the direction of the first edge in its group of shared edges
 */

/**
 * How the patches of a surface are joined. Every edge is in exactly one of `shared`, `nonManifold`, `open` and `collapsed`.
 *
 * @typedef {object} Topology
 * @property {EdgeUse[][]} shared pairs of edges that are the same line
 * @property {EdgeUse[][]} nonManifold groups of three or more edges that are the same line
 * @property {EdgeUse[]} open edges on the boundary
 * @property {EdgeUse[]} collapsed edges that are a point
 * @property {number[][]} components the patches of each connected component
 */

const EDGE_NAMES = /** @type {const} */ (["u0", "u1", "v0", "v1"]);

/**
 * Decodes the result of `surface_topology`: five lists of groups.
 *
 * @internal
 * @param {Float64Array} numbers
 * @returns {Topology}
 */
export function readTopology(numbers) {
  let at = 0;
  const next = () => numbers[at++];
  const edgeUse = (/** @type {number} */ code) => ({
    patch: Math.floor(code / 8),
    edge: EDGE_NAMES[(code >> 1) & 3],
    reversed: (code & 1) === 1,
  });
  const group = () => Array.from({ length: next() }, next);
  const list = () => Array.from({ length: next() }, group);
  const edges = () => list().map((codes) => codes.map(edgeUse));
  return { shared: edges(), nonManifold: edges(), open: edges()[0], collapsed: edges()[0], components: list() };
}
