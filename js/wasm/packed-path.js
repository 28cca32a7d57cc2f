// Packed paths: a path as one array, in the layout of the arena. The number of subpaths, then for each subpath: the
// number of segments, 1 if closed (otherwise 0), the degree of each segment, the control points. A path of any size is
// passed to the core with one copy.

/**
 * The indices of a subpath's parts in a packed path: of its degrees, of its points, and the index after it.
 *
 * @internal
 * @typedef {{ segments: number, closed: boolean, degrees: number, points: number, end: number }} Extent
 */

/**
 * The extent of the subpath that starts at an index.
 *
 * @internal
 * @param {Float64Array} packed
 * @param {number} at
 * @returns {Extent}
 */
export function extentAt(packed, at) {
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
 * @param {Float64Array} packed
 * @returns {Generator<Extent>}
 */
export function* extents(packed) {
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
 * @param {Float64Array} flat
 * @param {readonly number[]} degrees
 * @param {boolean} closed
 * @returns {Float64Array}
 */
export function packedSpline(flat, degrees, closed) {
  return packedSplines([{ flat, degrees, closed }]);
}

/**
 * Packs splines.
 *
 * @internal
 * @param {{ flat: Float64Array, degrees: readonly number[], closed: boolean }[]} splines
 * @returns {Float64Array}
 */
export function packedSplines(splines) {
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
 * @param {Float64Array[]} paths
 * @returns {Float64Array}
 */
export function packedPaths(paths) {
  const joined = new Float64Array(paths.reduce((length, path) => length + path.length - 1, 1));
  let at = 1;
  for (const path of paths) {
    joined[0] += path[0];
    joined.set(path.subarray(1), at);
    at += path.length - 1;
  }
  return joined;
}

/** @template {Float64Array | Uint8Array} T */
class GrowableArray {
  /** @param {T} list */
  constructor(list) {
    this.list = list;
    this.length = 0;
  }

  /** @param {number} value */
  push(value) {
    if (this.length === this.list.length) {
      const longer = new /** @type {any} */ (this.list.constructor)(2 * this.length);
      longer.set(this.list);
      this.list = longer;
    }
    this.list[this.length++] = value;
  }
}

/**
 * Builds a packed path segment by segment.
 *
 * @internal
 */
export class PackedPathBuilder {
  /** Coordinates; joints are stored once. The last point of a closed subpath equals its first point. */
  points = new GrowableArray(new Float64Array(256));
  degrees = new GrowableArray(new Uint8Array(64));
  /** For each subpath: its end in `points`, its end in `degrees`, 1 if closed. */
  ends = new GrowableArray(new Float64Array(12));

  /** @param {boolean} closed */
  endSubpath(closed) {
    this.ends.push(this.points.length);
    this.ends.push(this.degrees.length);
    this.ends.push(closed ? 1 : 0);
  }

  /**
   * The packed path, without the repeated last points of closed subpaths.
   *
   * @returns {Float64Array}
   */
  packed() {
    const [points, degrees, ends] = [this.points.list, this.degrees.list, this.ends.list];
    const count = this.ends.length / 3;
    let closedCount = 0;
    for (let k = 0; k < count; k++) closedCount += ends[3 * k + 2];
    const packed = new Float64Array(1 + 2 * count + this.degrees.length + this.points.length - 2 * closedCount);
    packed[0] = count;
    for (let k = 0, at = 1, p = 0, d = 0; k < count; k++) {
      const [pointsEnd, degreesEnd, isClosed] = [ends[3 * k], ends[3 * k + 1], ends[3 * k + 2]];
      packed[at++] = degreesEnd - d;
      packed[at++] = isClosed;
      while (d < degreesEnd) packed[at++] = degrees[d++];
      const last = pointsEnd - 2 * isClosed;
      while (p < last) packed[at++] = points[p++];
      p = pointsEnd;
    }
    return packed;
  }
}
