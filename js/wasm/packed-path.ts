// Packed paths: a path as one array, in the layout of the arena. The number of subpaths, then for each subpath: the
// number of segments, 1 if closed (otherwise 0), the degree of each segment, the control points. A path of any size is
// passed to the core with one copy.

/**
 * The indices of a subpath's parts in a packed path: of its degrees, of its points, and the index after it.
 *
 * @internal
 */
export type Extent = { segments: number; closed: boolean; degrees: number; points: number; end: number };

/**
 * The extent of the subpath that starts at an index.
 *
 * @internal
 */
export function extentAt(packed: Float64Array, at: number): Extent {
  const segments = packed[at];
  const closed = packed[at + 1] === 1;
  const degrees = at + 2;
  const points = degrees + segments;
  let count = closed ? 0 : 1;
  for (let k = degrees; k < points; k++) count += packed[k];
  return { segments, closed, degrees, points, end: points + 2 * count };
}

/**
 * The extents of all subpaths.
 *
 * @internal
 */
export function* extents(packed: Float64Array): Generator<Extent> {
  for (let at = 1; at < packed.length; ) {
    const extent = extentAt(packed, at);
    yield extent;
    at = extent.end;
  }
}

/**
 * Packs one spline.
 *
 * @internal
 */
export function packedSpline(flat: Float64Array, degrees: readonly number[], closed: boolean): Float64Array {
  return packedSplines([{ flat, degrees, closed }]);
}

/**
 * Packs splines.
 *
 * @internal
 */
export function packedSplines(
  splines: { flat: Float64Array; degrees: readonly number[]; closed: boolean }[],
): Float64Array {
  const packed = new Float64Array(
    splines.reduce((sum, { flat, degrees }) => sum + 2 + degrees.length + flat.length, 1),
  );
  packed[0] = splines.length;
  let at = 1;
  for (const { flat, degrees, closed } of splines) {
    packed[at] = degrees.length;
    packed[at + 1] = closed ? 1 : 0;
    packed.set(degrees, at + 2);
    at += 2 + degrees.length;
    packed.set(flat, at);
    at += flat.length;
  }
  return packed;
}

/**
 * Joins packed paths to one with all their subpaths.
 *
 * @internal
 */
export function packedPaths(paths: Float64Array[]): Float64Array {
  const joined = new Float64Array(paths.reduce((length, path) => length + path.length - 1, 1));
  let at = 1;
  for (const path of paths) {
    joined[0] += path[0];
    joined.set(path.subarray(1), at);
    at += path.length - 1;
  }
  return joined;
}
