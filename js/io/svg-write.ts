// Drawing paths and writing them as SVG path data; src/io/svg_write.rs writes the same text.
import { curvesModule } from "../wasm/curves-module.js";
import type { CircularArc } from "../geometry/path/path-arcs.js";
import * as check from "../geometry/check.js";
import { extents } from "../wasm/packed-path.js";

/** From this value on, numbers have no digits after the decimal point, and `String` writes them with an exponent. */
const MIN_EXPONENTIAL = 1e21;

/** The maximum number of digits of `toFixed`. */
export const MAX_DIGITS = 100;

const COMMANDS = ["", "L", "Q", "C"];

/**
 * For a subpath of a packed path (the indices of its degrees and points, the end of the points, whether it is closed),
 * a function that writes the arc at the start of the cubics from segment k on, whose first control point after the start
 * is at an index, and returns the number of cubics; null without cubics.
 *
 * @internal
 */
export type ArcFinder = (
  packed: Float64Array,
  degrees: number,
  points: number,
  end: number,
  closed: boolean,
) => ((writer: any, k: number, at: number) => number) | null;

/**
 * The receiver of drawing commands: `move`, then `curve` with the degree (1 to 3), an array of coordinates and the
 * index of the first control point after the start; `close`. With `arcs`, cubics that are arcs are drawn as such.
 *
 * @internal
 */
export interface PathSink {
  move: (x: number, y: number) => void;
  curve: (degree: number, list: Float64Array, at: number) => void;
  arcs?: ArcFinder | null;
  /** The argument says whether it has to draw the last line */
  close: (line: boolean) => void;
}

/**
 * Draws a packed path; higher degrees become cubics.
 *
 * @internal
 * @param tolerance 0 for the default
 * @param drawClosingLine whether the last line of a closed subpath is drawn, or left to `close`
 */
export function draw(packed: Float64Array, sink: PathSink, tolerance: number, drawClosingLine: boolean) {
  for (const { segments, closed, degrees, points, end } of extents(packed)) {
    sink.move(packed[points], packed[points + 1]);
    let at = points + 2;
    let left = false;
    const arcs = sink.arcs?.(packed, degrees, points, end, closed);
    for (let k = 0; k < segments; k++) {
      const degree = packed[degrees + k];
      const cubics = arcs && degree === 3 ? arcs(sink, k, at) : 0;
      if (cubics > 0) {
        k += cubics - 1;
        at += 6 * cubics;
        continue;
      }
      const after = at + 2 * degree;
      const endsAtStart = after > end;
      left = endsAtStart && degree === 1 && !drawClosingLine && leftToClose(packed, points, at);
      if (!endsAtStart && degree <= 3) sink.curve(degree, packed, at);
      else if (!left) {
        const curve = new Float64Array(2 * degree + 2);
        curve.set(packed.subarray(at - 2, Math.min(after, end)));
        if (endsAtStart) curve.set(packed.subarray(points, points + 2), 2 * degree);
        if (degree <= 3) sink.curve(degree, curve, 2);
        else drawCubics(sink, curve, tolerance);
      }
      at = after;
    }
    if (closed) sink.close(left && segments > 1);
  }
}

/**
 * Whether the last line of a closed subpath, whose end would be at an index, is the line that closing draws: it has a
 * length, or it is the only segment.
 */
function leftToClose(packed: Float64Array, points: number, at: number) {
  return at === points + 2 || packed[at - 2] !== packed[points] || packed[at - 1] !== packed[points + 1];
}

function drawCubics(sink: PathSink, curve: Float64Array, tolerance: number) {
  curvesModule.write(curve);
  const list = curvesModule.read(0, curvesModule.functions.curve_cubics(curve.length / 2, tolerance));
  for (let at = 0; at < list.length; at += 6) sink.curve(3, list, at);
}

/**
 * Throws a RangeError for a tolerance below the precision of the coordinates.
 *
 * @internal
 * @param tolerance 0 for the default, which is accepted
 */
export function checkTolerance(packed: Float64Array, tolerance: number) {
  if (tolerance === 0) return;
  let size = 0;
  for (const { points, end } of extents(packed))
    for (let k = points; k < end; k++) size = Math.max(size, Math.abs(packed[k]));
  curvesModule.count(curvesModule.functions.path_check_tolerance(tolerance, size));
}

/**
 * Draws a packed path on a canvas context or a Path2D.
 *
 * @internal
 * @param options for degrees above 3
 */
export function traceOn(
  packed: Float64Array,
  target: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D,
  options: { tolerance?: number } | undefined,
) {
  const canvas = check.drawingTarget(target);
  const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
  checkTolerance(packed, tolerance);
  const sink = {
    move: (x: number, y: number) => canvas.moveTo(x, y),
    curve: (degree: number, p: Float64Array, at: number) => {
      if (degree === 1) canvas.lineTo(p[at], p[at + 1]);
      else if (degree === 2) canvas.quadraticCurveTo(p[at], p[at + 1], p[at + 2], p[at + 3]);
      else canvas.bezierCurveTo(p[at], p[at + 1], p[at + 2], p[at + 3], p[at + 4], p[at + 5]);
    },
    close: () => canvas.closePath(),
  };
  draw(packed, sink, tolerance, true);
}

/** The options of SVG path data. */
export interface SvgOptions {
  /** 0 to 100, the maximum number of digits after the decimal point; selects the shortest form */
  precision?: number;
  /** The largest distance of the cubics that replace segments of degrees above 3 */
  tolerance?: number;
}

/**
 * The options of SVG path data of paths. `arcs`: whether cubics that are equal arcs of one ellipse, up to rounding, and at
 * least as many as `Path.fromSVG` makes of it, are written as one arc, true by default.
 */
export type PathSvgOptions = SvgOptions & { arcs?: boolean };

/**
 * The options of SVG path data in which all curves are replaced by lines and arcs. `arcs`: their largest distance, see
 * `toArcs`; it takes the place of `tolerance`.
 */
export type ArcSvgOptions = { precision?: number; arcs: number; tolerance?: undefined };

/**
 * A packed path as SVG path data.
 *
 * @internal
 * @param options `arcs` is an option only with a finder of arcs
 */
export function svgOf(
  packed: Float64Array,
  options: PathSvgOptions | undefined,
  finder: ArcFinder | null = null,
): string {
  const { precision, tolerance, arcs } = check.options(options, [
    "precision",
    "tolerance",
    ...(finder ? (["arcs"] as const) : []),
  ]);
  const maxError = check.optionalTolerance(tolerance);
  checkTolerance(packed, maxError);
  const writer = svgWriter(precision);
  if (check.optionalBoolean(arcs as boolean | undefined, "arcs", true)) writer.arcs = finder;
  draw(packed, writer, maxError, false);
  return writer.text;
}

/**
 * Lines and arcs of circles as SVG path data.
 *
 * @internal
 * @param closed whether each subpath is closed
 */
export function svgOfArcs(subpaths: CircularArc[][], closed: readonly boolean[], options: ArcSvgOptions): string {
  const { precision, tolerance, arcs } = check.options(options, ["precision", "tolerance", "arcs"]);
  if (tolerance !== undefined) {
    throw new TypeError(`tolerance: expected none with arcs ${arcs}, got ${check.describe(tolerance)}`);
  }
  const writer = svgWriter(precision);
  const word = (x: number) => (precision === undefined ? roundTrip(x) : shortNumber(x, precision));
  for (const [k, pieces] of subpaths.entries()) {
    const { start } = pieces[0];
    writer.move(start.x, start.y);
    // Closing draws the last line.
    const closingLine = closed[k] && pieces.length > 1 && !pieces[pieces.length - 1].center;
    for (const { end, center, radius, startAngle, endAngle } of closingLine ? pieces.slice(0, -1) : pieces) {
      const [r, sweep] = [word(radius), endAngle > startAngle ? "1" : "0"];
      if (center) writer.arc([r, r, "0", "0", sweep, word(end.x), word(end.y)]);
      else writer.curve(1, Float64Array.of(end.x, end.y), 0);
    }
    if (closed[k]) writer.close(Boolean(closingLine));
  }
  return writer.text;
}

/**
 * The writer for the option `precision`.
 *
 * @internal
 */
export function svgWriter(precision: number | undefined): ExactWriter | ShortWriter {
  if (precision === undefined) return new ExactWriter();
  return new ShortWriter(check.whole(precision, "precision", 0, MAX_DIGITS));
}

/** Writes absolute commands, each number with the fewest digits that round-trip. */
class ExactWriter {
  text = "";
  arcs: ArcFinder | null = null;

  move(x: number, y: number) {
    this.text += `${this.text ? " " : ""}M${roundTrip(x)},${roundTrip(y)}`;
  }

  curve(degree: number, list: Float64Array, at: number) {
    let text = ` ${COMMANDS[degree]}${roundTrip(list[at])},${roundTrip(list[at + 1])}`;
    for (let k = at + 2; k < at + 2 * degree; k += 2) text += ` ${roundTrip(list[k])},${roundTrip(list[k + 1])}`;
    this.text += text;
  }

  /** @param words the arguments of the command */
  arc([rx, ry, degrees, large, sweep, x, y]: string[]) {
    this.text += ` A${rx},${ry} ${degrees} ${large} ${sweep} ${x},${y}`;
  }

  close() {
    this.text += " Z";
  }
}

/** Writes the shortest absolute form, with a maximum number of digits after the decimal point. */
class ShortWriter {
  precision: number;

  text = "";
  arcs: ArcFinder | null = null;
  /** The current point as text. */
  #x = "";
  #y = "";
  #startX = "";
  #startY = "";
  /** The command that numbers without a command have. */
  #implied = "";
  /** The previous number, if the next one follows it directly. */
  #last = "";

  constructor(precision: number) {
    this.precision = precision;
  }

  move(x: number, y: number) {
    this.#x = this.#startX = shortNumber(x, this.precision);
    this.#y = this.#startY = shortNumber(y, this.precision);
    this.#write("M", [this.#x, this.#y]);
  }

  curve(degree: number, list: Float64Array, at: number) {
    const words = Array.from(list.subarray(at, at + 2 * degree), (number) => shortNumber(number, this.precision));
    const [x, y] = [words[2 * degree - 2], words[2 * degree - 1]];
    if (degree === 1 && y === this.#y) this.#write("H", [x]);
    else if (degree === 1 && x === this.#x) this.#write("V", [y]);
    else this.#write(COMMANDS[degree], words);
    this.#x = x;
    this.#y = y;
  }

  /** @param words the arguments of the command */
  arc(words: string[]) {
    this.#write("A", words);
    [this.#x, this.#y] = words.slice(5);
  }

  /** The current point. */
  at() {
    return [Number(this.#x), Number(this.#y)];
  }

  close(line: boolean) {
    // If rounding reduces the last line to length 0, it is written.
    if (line && this.#x === this.#startX && this.#y === this.#startY) this.#write("H", [this.#x]);
    this.text += "Z";
    this.#implied = "";
  }

  #write(command: string, words: string[]) {
    let text = "";
    let last = this.#last;
    if (command !== this.#implied) {
      text = command;
      last = "";
    }
    this.#implied = command === "M" ? "L" : command;
    for (const word of words) {
      const needsNoSpace =
        last === "" || word[0] === "-" || (word[0] === "." && (last.includes(".") || last.includes("e")));
      text += needsNoSpace ? word : ` ${word}`;
      last = word;
    }
    this.text += text;
    this.#last = last;
  }
}

/**
 * A number with the fewest digits that round-trip.
 *
 * @internal
 */
export function roundTrip(x: number) {
  return x === 0 && Object.is(x, -0) ? "-0" : `${x}`;
}

/**
 * A number with at most `digits` digits after the decimal point, without redundant zeros: "-.5".
 *
 * @internal
 */
export function shortNumber(x: number, digits: number) {
  if (Math.abs(x) >= MIN_EXPONENTIAL) return String(x).replace("+", "");
  let word = x.toFixed(digits);
  if (digits > 0) {
    let end = word.length;
    while (word[end - 1] === "0") end--;
    if (word[end - 1] === ".") end--;
    word = word.slice(0, end);
  }
  if (word === "-0") return "0";
  if (word.startsWith("0.")) return word.slice(1);
  return word.startsWith("-0.") ? `-${word.slice(2)}` : word;
}
