// The part of the plane that is seen: points are transformed to the picture in double precision, and what lies far outside
// is cut off, because canvases keep seven digits: enlarged curves would have corners and tremble.

import { traceSeen } from "./trace.js";

export type Point2 = [number, number];

/** The picture and the part of the plane in it, which has the same proportions. */
export type VisiblePart = {
  box: { width: number; height: number };
  view: { x: number; y: number; width: number; height: number };
};

/** Cut off beyond this; there a canvas's numbers are still a thousandth apart. */
const FAR = 2 ** 13;

/** Takes paths in the plane and draws them on the picture. */
export class Lens {
  scale: number;
  x: number;
  y: number;

  #ctx;
  #box;
  /** Where the path is on the picture. */
  #x = 0;
  #y = 0;
  /** Whether the next segment needs a moveTo. */
  #lifted = true;

  constructor(ctx: CanvasRenderingContext2D, { box, view }: VisiblePart) {
    this.#ctx = ctx;
    this.#box = box;
    this.scale = box.width / view.width;
    this.x = view.x;
    this.y = view.y;
  }

  /**
   * @returns on the picture
   */
  place(x: number, y: number): Point2 {
    return [this.scale * (x - this.x), this.scale * (y - this.y)];
  }

  beginPath() {
    this.#ctx.beginPath();
    this.#lifted = true;
  }

  moveTo(x: number, y: number) {
    this.#skip(...this.place(x, y));
  }

  lineTo(x: number, y: number) {
    this.#lineTo(this.scale * (x - this.x), this.scale * (y - this.y));
  }

  /**
   * A curve from where it starts.
   *
   * @param points its control points
   */
  curve(points: Float64Array) {
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

  /** Begins a path that is a closed polygon; what is cut off leaves it closed. */
  polygon(flat: ArrayLike<number>) {
    let corners: Point2[] = [];
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

  #go(x: number, y: number) {
    this.#x = x;
    this.#y = y;
  }

  /** Leaves out the way to a place. */
  #skip(x: number, y: number) {
    this.#go(x, y);
    this.#lifted = true;
  }

  #lineTo(x: number, y: number) {
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

function isNumber([x, y]: Point2) {
  return x - x === 0 && y - y === 0;
}

function isNear(x: number, y: number) {
  return Math.abs(x) <= FAR && Math.abs(y) <= FAR;
}

/** The part of a line that is not cut off. */
function clipped(x0: number, y0: number, x1: number, y1: number): [number, number, number, number] | null {
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

/** A polygon without what is cut off, side by side of the square (Sutherland and Hodgman, 1974). */
function within(corners: Point2[]): Point2[] {
  for (const [axis, sign] of [
    [0, 1],
    [0, -1],
    [1, 1],
    [1, -1],
  ]) {
    const depth = (corner: Point2) => FAR - sign * corner[axis];
    corners = corners.flatMap((corner, i) => {
      const before = corners.at(i - 1) ?? corner;
      const [a, b] = [depth(before), depth(corner)];
      const share = a / (a - b);
      const crossing: Point2 = [
        before[0] + share * (corner[0] - before[0]),
        before[1] + share * (corner[1] - before[1]),
      ];
      const crosses = a >= 0 !== b >= 0;
      return [...(crosses ? [crossing] : []), ...(b >= 0 ? [corner] : [])];
    });
  }
  return corners;
}
