/**
 * A side of a patch, named by the parameter that is constant along it; `reversed` where it runs against the first side of
 * those that it is shared with.
 *
 * @typedef {{ patch: number, edge: "u0" | "u1" | "v0" | "v1", reversed: boolean }} EdgeUse
 */

/**
 * How the patches of a surface are joined. Every side is in exactly one list: `shared` (pairs of sides that are the same
 * line), `nonManifold` (three and more of them), `open` (the boundary) or `collapsed` (the side is a point). `components`
 * holds the patches of each connected part.
 *
 * @typedef {{ shared: EdgeUse[][], nonManifold: EdgeUse[][], open: EdgeUse[], collapsed: EdgeUse[], components: number[][] }} Topology
 */

const NAMES = /** @type {const} */ (["u0", "u1", "v0", "v1"]);

/**
 * What the core left: five lists of groups, see `surface_topology`.
 *
 * @internal
 * @param {Float64Array} numbers
 * @returns {Topology}
 */
export function readTopology(numbers) {
  let at = 0;
  const next = () => numbers[at++];
  const side = (/** @type {number} */ code) => ({
    patch: Math.floor(code / 8),
    edge: NAMES[(code >> 1) & 3],
    reversed: (code & 1) === 1,
  });
  const group = () => Array.from({ length: next() }, next);
  const list = () => Array.from({ length: next() }, group);
  const sides = () => list().map((codes) => codes.map(side));
  return { shared: sides(), nonManifold: sides(), open: sides()[0], collapsed: sides()[0], components: list() };
}
