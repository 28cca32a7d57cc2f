// The builder of all paths that are drawn: SVG path data, shapes, and what a function draws on a `PathBuilder`.
import { isCoordinate } from "../geometry/check.js";
import { arc } from "./svg-arc.js";

const [CUBIC, HORIZONTAL, LINE, MOVE] = [67, 72, 76, 77];
const [QUADRATIC, SMOOTH_CUBIC, SMOOTH_QUADRATIC, VERTICAL] = [81, 83, 84, 86];

/**
 * The difference between the codes of a lower-case letter and its upper-case letter.
 *
 * @internal
 */
export const CASE = 32;

class GrowableArray<T extends Float64Array | Uint8Array> {
  list: T;
  length: number;

  constructor(list: T) {
    this.list = list;
    this.length = 0;
  }

  push(value: number) {
    if (this.length === this.list.length) {
      const longer = new (this.list.constructor as any)(2 * this.length);
      longer.set(this.list);
      this.list = longer;
    }
    this.list[this.length++] = value;
  }
}

/**
 * Builds a packed path from the commands of SVG path data.
 *
 * @internal
 */
export class CommandBuilder {
  tolerance: number;

  /** Coordinates; joints are stored once. The last point of a closed subpath equals its first point. */
  #points = new GrowableArray(new Float64Array(256));
  #degrees = new GrowableArray(new Uint8Array(64));
  /** For each subpath: its end in `#points`, its end in `#degrees`, 1 if closed */
  #ends = new GrowableArray(new Float64Array(12));
  /** The arguments of the command. */
  args = new Float64Array(7);
  /** The current point and the start of the subpath. */
  x = 0;
  y = 0;
  startX = 0;
  startY = 0;
  /** Whether the subpath has a segment. */
  drawing = false;
  /** Whether the last command was Z. */
  closed = false;
  /** The degree of the previous curve (0 after other commands) and its last control point, for S and T. */
  smooth = 0;
  controlX = 0;
  controlY = 0;

  /** @param tolerance for arcs */
  constructor(tolerance: number) {
    this.tolerance = tolerance;
  }

  /** Draws one command with the arguments in `args`. Returns false if a coordinate exceeds the limit. */
  draw(command: number): boolean {
    const { args: n, x, y } = this;
    const relative = (command & CASE) !== 0;
    // Adding −0 changes no number, not even −0.
    const [baseX, baseY] = [relative ? x : -0, relative ? y : -0];
    switch (command & ~CASE) {
      case MOVE:
        return this.#moveTo(baseX + n[0], baseY + n[1]);
      case LINE:
        return this.#line(baseX + n[0], baseY + n[1]);
      case HORIZONTAL:
        return this.#line(baseX + n[0], y);
      case VERTICAL:
        return this.#line(x, baseY + n[0]);
      case CUBIC:
        return this.#cubic(baseX + n[0], baseY + n[1], baseX + n[2], baseY + n[3], baseX + n[4], baseY + n[5]);
      case SMOOTH_CUBIC: {
        const smooth = this.smooth === 3;
        const [cx, cy] = [smooth ? x + (x - this.controlX) : x, smooth ? y + (y - this.controlY) : y];
        return this.#cubic(cx, cy, baseX + n[0], baseY + n[1], baseX + n[2], baseY + n[3]);
      }
      case QUADRATIC:
        return this.#quadratic(baseX + n[0], baseY + n[1], baseX + n[2], baseY + n[3]);
      case SMOOTH_QUADRATIC: {
        const smooth = this.smooth === 2;
        const [cx, cy] = [smooth ? x + (x - this.controlX) : x, smooth ? y + (y - this.controlY) : y];
        return this.#quadratic(cx, cy, baseX + n[0], baseY + n[1]);
      }
      default:
        return this.#arc(baseX + n[5], baseY + n[6]);
    }
  }

  close() {
    if (this.closed) return;
    if (!this.drawing || this.x !== this.startX || this.y !== this.startY) this.#line(this.startX, this.startY);
    // −0 and 0 are the same position: the first point is used for both (the last point is omitted when packed).
    this.x = this.startX;
    this.y = this.startY;
    this.#points.list[this.#points.length - 2] = this.x;
    this.#points.list[this.#points.length - 1] = this.y;
    this.end(true);
    this.closed = true;
    this.smooth = 0;
  }

  /** Ends the subpath as it is, if it has a segment. */
  end(closed: boolean) {
    if (!this.drawing) return;
    this.#ends.push(this.#points.length);
    this.#ends.push(this.#degrees.length);
    this.#ends.push(closed ? 1 : 0);
    this.drawing = false;
  }

  /** Adds a line without a check of its coordinates. */
  addLine(x: number, y: number) {
    this.#begin(1);
    this.#point(x, y);
  }

  /** Adds the cubics of an elliptical arc with the radii, the rotation and the flags in `args` without a check of their coordinates. */
  addArc(x: number, y: number) {
    const c = arc(this.x, this.y, this.args, x, y, this.tolerance);
    if (!c) return this.addLine(x, y);
    for (let k = 0; k < c.length; k += 6) this.#addCubic(c[k], c[k + 1], c[k + 2], c[k + 3], c[k + 4], c[k + 5]);
  }

  #moveTo(x: number, y: number) {
    if (!(isCoordinate(x) && isCoordinate(y))) return false;
    this.end(false);
    this.x = this.startX = x;
    this.y = this.startY = y;
    this.closed = false;
    this.smooth = 0;
    return true;
  }

  /** Starts a segment, and with the first segment the subpath. */
  #begin(degree: number) {
    if (!this.drawing) {
      this.#points.push(this.x);
      this.#points.push(this.y);
      this.drawing = true;
    }
    this.#degrees.push(degree);
    this.closed = false;
    this.smooth = 0;
  }

  #point(x: number, y: number) {
    this.#points.push(x);
    this.#points.push(y);
    this.x = x;
    this.y = y;
  }

  #line(x: number, y: number) {
    if (!(isCoordinate(x) && isCoordinate(y))) return false;
    this.addLine(x, y);
    return true;
  }

  #quadratic(x1: number, y1: number, x: number, y: number) {
    if (!(isCoordinate(x1) && isCoordinate(y1) && isCoordinate(x) && isCoordinate(y))) return false;
    this.#begin(2);
    this.#point(x1, y1);
    this.#point(x, y);
    this.#control(2, x1, y1);
    return true;
  }

  #cubic(x1: number, y1: number, x2: number, y2: number, x: number, y: number) {
    if (!(isCoordinate(x1) && isCoordinate(y1) && isCoordinate(x2) && isCoordinate(y2))) return false;
    if (!(isCoordinate(x) && isCoordinate(y))) return false;
    this.#addCubic(x1, y1, x2, y2, x, y);
    return true;
  }

  #addCubic(x1: number, y1: number, x2: number, y2: number, x: number, y: number) {
    this.#begin(3);
    this.#point(x1, y1);
    this.#point(x2, y2);
    this.#point(x, y);
    this.#control(3, x2, y2);
  }

  #control(degree: number, x: number, y: number) {
    this.smooth = degree;
    this.controlX = x;
    this.controlY = y;
  }

  #arc(x: number, y: number) {
    if (!(isCoordinate(x) && isCoordinate(y))) return false;
    if (x !== this.x || y !== this.y) {
      const c = arc(this.x, this.y, this.args, x, y, this.tolerance);
      if (!c) this.#line(x, y);
      else
        for (let k = 0; k < c.length; k += 6)
          if (!this.#cubic(c[k], c[k + 1], c[k + 2], c[k + 3], c[k + 4], c[k + 5])) return false;
    }
    this.closed = false;
    this.smooth = 0;
    return true;
  }

  /** The packed path, without the repeated last points of closed subpaths. */
  packed(): Float64Array {
    const [points, degrees, ends] = [this.#points.list, this.#degrees.list, this.#ends.list];
    const count = this.#ends.length / 3;
    let closedCount = 0;
    for (let k = 0; k < count; k++) closedCount += ends[3 * k + 2];
    const packed = new Float64Array(1 + 2 * count + this.#degrees.length + this.#points.length - 2 * closedCount);
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
