// Looks at a part of the plane: points go from the plane to the picture in double precision, and what lies far outside
// is cut off, so that no closeness shows facets or trembles (canvases keep no more than seven digits).

import { traceSeen } from "./trace.js";

/** @typedef {[number, number]} Place */

/**
 * What a lens needs to know of a state; the view has the box's proportions.
 *
 * @typedef {{ box: { width: number, height: number }, view: { x: number, y: number, width: number, height: number } }} Looks
 */

/** What is wholly beyond this is cut off. Pieces of curves reach twice as far, where a canvas's numbers are a 500th apart. */
const FAR = 2 ** 13;
/** A curve that keeps running along the cut is left after so many pieces. */
const MOST_PIECES = 512;

/** Takes paths in the plane and draws them on the picture. */
export class Lens {
  #ctx;
  #box;
  /** Where the path is, where its last part began: on the picture. */
  #x = 0;
  #y = 0;
  #startX = 0;
  #startY = 0;
  /** Whether the canvas is elsewhere. */
  #lifted = true;
  /** Whether something was cut off since the last start. */
  #cut = false;
  #left = 0;

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
    this.#x = this.#startX = this.scale * (x - this.x);
    this.#y = this.#startY = this.scale * (y - this.y);
    this.#lifted = true;
    this.#cut = false;
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  lineTo(x, y) {
    this.#lineTo(this.scale * (x - this.x), this.scale * (y - this.y));
  }

  /**
   * @param {number} x1
   * @param {number} y1
   * @param {number} x2
   * @param {number} y2
   */
  quadraticCurveTo(x1, y1, x2, y2) {
    const [x0, y0] = [this.#x / this.scale + this.x, this.#y / this.scale + this.y];
    this.bezierCurveTo(x0 + (2 / 3) * (x1 - x0), y0 + (2 / 3) * (y1 - y0), x2 + (2 / 3) * (x1 - x2), y2 + (2 / 3) * (y1 - y2), x2, y2);
  }

  /**
   * @param {number} x1
   * @param {number} y1
   * @param {number} x2
   * @param {number} y2
   * @param {number} x3
   * @param {number} y3
   */
  bezierCurveTo(x1, y1, x2, y2, x3, y3) {
    const { scale, x, y } = this;
    this.#left = MOST_PIECES;
    this.#cubic(this.#x, this.#y, scale * (x1 - x), scale * (y1 - y), scale * (x2 - x), scale * (y2 - y), scale * (x3 - x), scale * (y3 - y));
  }

  closePath() {
    if (this.#cut || this.#lifted) this.#lineTo(this.#startX, this.#startY);
    else this.#ctx.closePath();
  }

  /**
   * A curve from where it starts.
   *
   * @param {Float64Array} p its control points
   */
  curve(p) {
    this.moveTo(p[0], p[1]);
    if (p.length === 8) this.bezierCurveTo(p[2], p[3], p[4], p[5], p[6], p[7]);
    else if (p.length === 6) this.quadraticCurveTo(p[2], p[3], p[4], p[5]);
    else if (p.length === 4) this.lineTo(p[2], p[3]);
    else {
      const seen = p.map((value, i) => this.scale * (value - (i % 2 ? this.y : this.x)));
      traceSeen(seen, this.#box, (x, y, isSeen) => (isSeen ? this.#lineTo(x, y) : this.#skip(x, y)));
    }
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
    this.#lifted = this.#cut = true;
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

  /**
   * @param {number} x0
   * @param {number} y0
   * @param {number} x1
   * @param {number} y1
   * @param {number} x2
   * @param {number} y2
   * @param {number} x3
   * @param {number} y3
   */
  #cubic(x0, y0, x1, y1, x2, y2, x3, y3) {
    const reach = Math.max(Math.abs(x0), Math.abs(y0), Math.abs(x1), Math.abs(y1), Math.abs(x2), Math.abs(y2), Math.abs(x3), Math.abs(y3));
    if (reach <= 2 * FAR) {
      this.#lower();
      this.#ctx.bezierCurveTo(x1, y1, x2, y2, x3, y3);
      return this.#go(x3, y3);
    }
    if (isBeyond(x0, x1, x2, x3) || isBeyond(y0, y1, y2, y3) || this.#left-- <= 0) return this.#skip(x3, y3);
    const [ax, ay, mx, my, bx, by] = [(x0 + x1) / 2, (y0 + y1) / 2, (x1 + x2) / 2, (y1 + y2) / 2, (x2 + x3) / 2, (y2 + y3) / 2];
    const [px, py, qx, qy] = [(ax + mx) / 2, (ay + my) / 2, (mx + bx) / 2, (my + by) / 2];
    const [x, y] = [(px + qx) / 2, (py + qy) / 2];
    this.#cubic(x0, y0, ax, ay, px, py, x, y);
    this.#cubic(x, y, qx, qy, bx, by, x3, y3);
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
 * Whether all four lie on one side outside; also where one is no number.
 *
 * @param {number} a
 * @param {number} b
 * @param {number} c
 * @param {number} d
 */
function isBeyond(a, b, c, d) {
  return !(Math.min(a, b, c, d) <= FAR && Math.max(a, b, c, d) >= -FAR);
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
  for (const [start, step] of [[x0, dx], [-x0, -dx], [y0, dy], [-y0, -dy]]) {
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
  for (const [axis, sign] of [[0, 1], [0, -1], [1, 1], [1, -1]]) {
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
