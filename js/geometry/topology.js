/**
 * An edge of a patch, named by the parameter that is constant along it. `reversed` says that it runs against the
 * direction of the first edge in its group of shared edges.
 *
 * @typedef {{ patch: number, edge: "u0" | "u1" | "v0" | "v1", reversed: boolean }} EdgeUse
 */

/**
 * How the patches of a surface are joined. Every edge is in exactly one list: `shared` (pairs of edges that are the
 * same line), `nonManifold` (groups of three or more), `open` (the boundary) or `collapsed` (the edge is a point).
 * `components` lists the patches of each connected component.
 *
 * @typedef {{ shared: EdgeUse[][], nonManifold: EdgeUse[][], open: EdgeUse[], collapsed: EdgeUse[], components: number[][] }} Topology
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
