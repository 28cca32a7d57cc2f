// Parsing SVG path data; src/io/svg_read.rs gives the same messages and bit-identical paths.
import { isCoordinate } from "../geometry/check.js";
import { PackedPathBuilder } from "../wasm/packed-path.js";
import { arc } from "./svg-arc.js";
import { PathDataError, Scanner } from "./svg-number.js";

/** The number of arguments of a command, by the code of its letter; −1 for other characters. @internal */
export const ARGUMENT_COUNTS = argumentCounts();

function argumentCounts() {
  const counts = new Int8Array(128).fill(-1);
  for (const [letters, count] of [
    ["Z", 0],
    ["HV", 1],
    ["MLT", 2],
    ["SQ", 4],
    ["C", 6],
    ["A", 7],
  ] as [string, number][]) {
    for (const letter of letters + letters.toLowerCase()) counts[letter.charCodeAt(0)] = count;
  }
  return counts;
}

const [CUBIC, HORIZONTAL, LINE, MOVE] = [67, 72, 76, 77];
const [QUADRATIC, SMOOTH_CUBIC, SMOOTH_QUADRATIC, VERTICAL] = [81, 83, 84, 86];

/** The value of the CSS property `d` for no path. */
const NONE = /^[ \t\n\f\r]*none[ \t\n\f\r]*$/;

/** The difference between the codes of a lower-case letter and its upper-case letter. */
const CASE = 32;

/**
 * Parses path data.
 *
 * @internal
 * @param tolerance the largest distance of cubics from the arcs; 0 for 1e-5 of the larger radius
 * @returns with an error, the path before it
 */
export function readSvg(
  d: string,
  tolerance: number,
): { packed: Float64Array; error: { offset: number; message: string } | null } {
  const scanner = new Scanner(d);
  const builder = new PathBuilder(tolerance);
  let error: { offset: number; message: string } | null = null;
  try {
    if (!NONE.test(d)) read(scanner, builder);
  } catch (caught) {
    if (!(caught instanceof PathDataError)) throw caught;
    const { offset, expected } = caught;
    error = { offset, message: `d: expected ${expected} at offset ${offset}, got ${scanner.describe(offset)}` };
  }
  builder.endOpen();
  return { packed: builder.packer.packed(), error };
}

function read(scanner: Scanner, builder: PathBuilder) {
  scanner.skipBlanks();
  for (let first = true; scanner.at < scanner.length; first = false) {
    const command = scanner.bytes[scanner.at];
    const count = command < 128 ? ARGUMENT_COUNTS[command] : -1;
    if (first && (command & ~CASE) !== MOVE) throw new PathDataError(scanner.at, '"M" or "m"');
    if (count < 0) throw new PathDataError(scanner.at, "a command");
    scanner.at++;
    scanner.skipBlanks();
    if (count > 0) readGroups(scanner, builder, command, count);
    else builder.close();
  }
}

/** Reads the arguments of a command, one or more groups of them. */
function readGroups(scanner: Scanner, builder: PathBuilder, command: number, count: number) {
  const n = builder.args;
  do {
    const offset = scanner.at;
    for (let k = 0; k < count; k++) {
      if (k > 0) scanner.skipSeparator();
      n[k] = count === 7 && (k === 3 || k === 4) ? scanner.flag() : scanner.number();
    }
    if (!builder.draw(command)) throw new PathDataError(offset, "coordinates from -2^500 to 2^500");
    // Further groups after a moveto are linetos.
    if ((command & ~CASE) === MOVE) command -= MOVE - LINE;
  } while (scanner.skipSeparator() || scanner.atNumber());
}

/**
 * Builds a path from drawing commands.
 *
 * @internal
 */
export class PathBuilder {
  tolerance: number;

  packer = new PackedPathBuilder();
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
    const { points } = this.packer;
    if (!this.drawing || this.x !== this.startX || this.y !== this.startY) this.#line(this.startX, this.startY);
    // −0 and 0 are the same position: the first point is used for both (the last point is omitted when packed).
    this.x = this.startX;
    this.y = this.startY;
    points.list[points.length - 2] = this.x;
    points.list[points.length - 1] = this.y;
    this.packer.endSubpath(true);
    this.drawing = false;
    this.closed = true;
    this.smooth = 0;
  }

  /** Ends a subpath that is not closed. */
  endOpen() {
    if (this.drawing) this.packer.endSubpath(false);
    this.drawing = false;
  }

  #moveTo(x: number, y: number) {
    if (!(isCoordinate(x) && isCoordinate(y))) return false;
    this.endOpen();
    this.x = this.startX = x;
    this.y = this.startY = y;
    this.closed = false;
    this.smooth = 0;
    return true;
  }

  /** Starts a segment, and with the first segment the subpath. */
  #begin(degree: number) {
    const { points } = this.packer;
    if (!this.drawing) {
      points.push(this.x);
      points.push(this.y);
      this.drawing = true;
    }
    this.packer.degrees.push(degree);
    this.closed = false;
    this.smooth = 0;
  }

  #point(x: number, y: number) {
    this.packer.points.push(x);
    this.packer.points.push(y);
    this.x = x;
    this.y = y;
  }

  #line(x: number, y: number) {
    if (!(isCoordinate(x) && isCoordinate(y))) return false;
    this.#begin(1);
    this.#point(x, y);
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
    this.#begin(3);
    this.#point(x1, y1);
    this.#point(x2, y2);
    this.#point(x, y);
    this.#control(3, x2, y2);
    return true;
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
}
