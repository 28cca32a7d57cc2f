// Looks at a part of the plane: points go from the plane to the picture in double precision, and what lies far outside
// is cut off, so that no closeness shows facets or trembles (canvases keep no more than seven digits).

import { traceSeen } from "./trace.js";

/** @typedef {[number, number]} Place */

/**
 * What a lens needs to know of a state; the view has the box's proportions.
 *
 * @typedef {{ box: { width: number, height: number }, view: { x: number, y: number, width: number, height: number } }} Looks
 */

/** Cut off beyond this; there a canvas's numbers are still a thousandth apart. */
const FAR = 2 ** 13;

/** Takes paths in the plane and draws them on the picture. */
export class Lens {
  #ctx;
  #box;
  /** Where the path is on the picture. */
  #x = 0;
  #y = 0;
  /** Whether the canvas is elsewhere. */
  #lifted = true;

  /**
   * @param {CanvasRenderingContext2D} ctx
   * @param {Looks} state
   */
  constructor(ctx, { box, view }) {
    this.#ctx = ctx;
    this.#box = box;
    this.scale = box.width / view.width;
    this.x = view.x;
    this.y = view.y;
  }

  /**
   * @param {number} x
   * @param {number} y
   * @returns {Place} on the picture
   */
  place(x, y) {
    return [this.scale * (x - this.x), this.scale * (y - this.y)];
  }

  beginPath() {
    this.#ctx.beginPath();
    this.#lifted = true;
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  moveTo(x, y) {
    this.#skip(...this.place(x, y));
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  lineTo(x, y) {
    this.#lineTo(this.scale * (x - this.x), this.scale * (y - this.y));
  }

  /**
   * A curve from where it starts.
   *
   * @param {Float64Array} points its control points
   */
  curve(points) {
    this.moveTo(points[0], points[1]);
    const p = points.map((value, i) => this.scale * (value - (i % 2 ? this.y : this.x)));
    if (p.length > 8 || !p.every((value) => Math.abs(value) <= FAR)) {
      return traceSeen(p, this.#box, (x, y, isSeen) => (isSeen ? this.#lineTo(x, y) : this.#skip(x, y)));
    }
    this.#lower();
    if (p.length === 8) this.#ctx.bezierCurveTo(p[2], p[3], p[4], p[5], p[6], p[7]);
    else if (p.length === 6) this.#ctx.quadraticCurveTo(p[2], p[3], p[4], p[5]);
    else this.#ctx.lineTo(p[2], p[3]);
    this.#go(p[p.length - 2], p[p.length - 1]);
  }

  /**
   * Begins a path that is a closed polygon; what is cut off leaves it closed.
   *
   * @param {ArrayLike<number>} flat
   */
  polygon(flat) {
    /** @type {Place[]} */
    let corners = [];
    for (let i = 0; i < flat.length; i += 2) corners.push(this.place(flat[i], flat[i + 1]));
    this.beginPath();
    if (!corners.every(isNumber)) return;
    if (!corners.every(([x, y]) => isNear(x, y))) corners = within(corners);
    corners.forEach(([x, y], i) => (i ? this.#ctx.lineTo(x, y) : this.#ctx.moveTo(x, y)));
    if (corners.length) this.#ctx.closePath();
  }

  /** Puts the canvas where the path is. */
  #lower() {
    if (this.#lifted) this.#ctx.moveTo(this.#x, this.#y);
    this.#lifted = false;
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  #go(x, y) {
    this.#x = x;
    this.#y = y;
  }

  /** Leaves out the way to a place. @param {number} x @param {number} y */
  #skip(x, y) {
    this.#go(x, y);
    this.#lifted = true;
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  #lineTo(x, y) {
    if (isNear(this.#x, this.#y) && isNear(x, y)) {
      this.#lower();
      this.#ctx.lineTo(x, y);
      return this.#go(x, y);
    }
    const ends = clipped(this.#x, this.#y, x, y);
    if (ends) {
      this.#ctx.moveTo(ends[0], ends[1]);
      this.#ctx.lineTo(ends[2], ends[3]);
    }
    this.#skip(x, y);
  }
}

/** @param {Place} place */
function isNumber([x, y]) {
  return x - x === 0 && y - y === 0;
}

/**
 * @param {number} x
 * @param {number} y
 */
function isNear(x, y) {
  return Math.abs(x) <= FAR && Math.abs(y) <= FAR;
}

/**
 * The part of a line that is not cut off.
 *
 * @param {number} x0
 * @param {number} y0
 * @param {number} x1
 * @param {number} y1
 * @returns {[number, number, number, number] | null}
 */
function clipped(x0, y0, x1, y1) {
  const [dx, dy] = [x1 - x0, y1 - y0];
  if (!isNumber([dx, dy])) return null;
  let [from, to] = [0, 1];
  for (const [start, step] of [
    [x0, dx],
    [-x0, -dx],
    [y0, dy],
    [-y0, -dy],
  ]) {
    if (step === 0 && start > FAR) return null;
    if (step > 0) to = Math.min(to, (FAR - start) / step);
    if (step < 0) from = Math.max(from, (FAR - start) / step);
  }
  return from < to ? [x0 + from * dx, y0 + from * dy, x0 + to * dx, y0 + to * dy] : null;
}

/**
 * A polygon without what is cut off, side by side of the square (Sutherland and Hodgman, 1974).
 *
 * @param {Place[]} corners
 * @returns {Place[]}
 */
function within(corners) {
  for (const [axis, sign] of [
    [0, 1],
    [0, -1],
    [1, 1],
    [1, -1],
  ]) {
    const depth = (/** @type {Place} */ corner) => FAR - sign * corner[axis];
    corners = corners.flatMap((corner, i) => {
      const before = corners.at(i - 1) ?? corner;
      const [a, b] = [depth(before), depth(corner)];
      const share = a / (a - b);
      /** @type {Place} */
      const crossing = [before[0] + share * (corner[0] - before[0]), before[1] + share * (corner[1] - before[1])];
      const crosses = a >= 0 !== b >= 0;
      return [...(crosses ? [crossing] : []), ...(b >= 0 ? [corner] : [])];
    });
  }
  return corners;
}
