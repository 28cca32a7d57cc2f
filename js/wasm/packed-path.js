// Paths as one array, in the arena's form: the number of subpaths, then each one as a spline: the number of segments, 1
// if closed (else 0), the degree of each segment, the control points. One copy takes a path of any size to the core.

/**
 * Where a subpath lies in a packed path.
 *
 * @internal
 * @typedef {{ segments: number, closed: boolean, degrees: number, points: number, end: number }} Extent
 */

/**
 * The subpath that starts at a place.
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
 * All subpaths.
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
 * A path of one spline.
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
 * A path of splines.
 *
 * @internal
 * @param {{ flat: Float64Array, degrees: readonly number[], closed: boolean }[]} parts
 * @returns {Float64Array}
 */
export function packedSplines(parts) {
  const packed = new Float64Array(parts.reduce((sum, { flat, degrees }) => sum + 2 + degrees.length + flat.length, 1));
  packed[0] = parts.length;
  let at = 1;
  for (const { flat, degrees, closed } of parts) {
    packed[at] = degrees.length;
    packed[at + 1] = closed ? 1 : 0;
    packed.set(degrees, at + 2);
    at += 2 + degrees.length;
    packed.set(flat, at);
    at += flat.length;
  }
  return packed;
}

/** @template {Float64Array | Uint8Array} T */
class Growing {
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
 * A packed path that is being made.
 *
 * @internal
 */
export class Packer {
  /** Coordinates, joints once each; a closed subpath ends with its first point again. */
  points = new Growing(new Float64Array(256));
  degrees = new Growing(new Uint8Array(64));
  /** For each subpath where it ends in these, and whether it is closed. */
  ends = new Growing(new Float64Array(12));

  /** @param {boolean} closed */
  endSubpath(closed) {
    this.ends.push(this.points.length);
    this.ends.push(this.degrees.length);
    this.ends.push(closed ? 1 : 0);
  }

  /** @returns {Float64Array} */
  packed() {
    const [points, degrees, ends] = [this.points.list, this.degrees.list, this.ends.list];
    const count = this.ends.length / 3;
    let closed = 0;
    for (let k = 0; k < count; k++) closed += ends[3 * k + 2];
    const packed = new Float64Array(1 + 2 * count + this.degrees.length + this.points.length - 2 * closed);
    packed[0] = count;
    for (let k = 0, at = 1, p = 0, d = 0; k < count; k++) {
      const [pointsEnd, degreesEnd, ring] = [ends[3 * k], ends[3 * k + 1], ends[3 * k + 2]];
      packed[at++] = degreesEnd - d;
      packed[at++] = ring;
      while (d < degreesEnd) packed[at++] = degrees[d++];
      const last = pointsEnd - 2 * ring;
      while (p < last) packed[at++] = points[p++];
      p = pointsEnd;
    }
    return packed;
  }
}
