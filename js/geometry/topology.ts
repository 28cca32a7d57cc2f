/** An edge of a patch. */
export interface EdgeUse {
  /** The number of the patch */
  patch: number;
  /** The parameter that is constant along the edge, and its value */
  edge: "u0" | "u1" | "v0" | "v1";
  /** Whether the edge runs against the direction of the first edge in its group of shared edges */
  reversed: boolean;
}

/**
 * How the patches of a surface are joined. Every edge is in exactly one of `shared`, `nonManifold`, `open` and `collapsed`.
 */
export interface Topology {
  /** Pairs of edges that are the same line */
  shared: EdgeUse[][];
  /** Groups of three or more edges that are the same line */
  nonManifold: EdgeUse[][];
  /** Edges on the boundary */
  open: EdgeUse[];
  /** Edges that are a point */
  collapsed: EdgeUse[];
  /** The patches of each connected component */
  components: number[][];
}

const EDGE_NAMES = ["u0", "u1", "v0", "v1"] as const;

/**
 * Decodes the result of `surface_topology`: five lists of groups.
 *
 * @internal
 */
export function readTopology(numbers: Float64Array): Topology {
  let at = 0;
  const next = () => numbers[at++];
  const edgeUse = (code: number) => ({
    patch: Math.floor(code / 8),
    edge: EDGE_NAMES[(code >> 1) & 3],
    reversed: (code & 1) === 1,
  });
  const group = () => Array.from({ length: next() }, next);
  const list = () => Array.from({ length: next() }, group);
  const edges = () => list().map((codes) => codes.map(edgeUse));
  return { shared: edges(), nonManifold: edges(), open: edges()[0], collapsed: edges()[0], components: list() };
}
