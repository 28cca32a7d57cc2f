// Paths as SVG path data, and drawn; src/io/svg_write.rs writes the same.
import * as check from "../geometry/check.js";
import { core } from "../wasm/init.js";
import { extents } from "../wasm/packed-path.js";
import { done } from "../wasm/errors.js";
import { load, take } from "../wasm/transfer.js";

/** From here on a number has no digits after the point, and `String` writes it with an exponent. */
const EXPONENT_FROM = 1e21;

/** The most digits that `toFixed` knows. */
const MOST_DIGITS = 100;

const COMMANDS = ["", "L", "Q", "C"];

/**
 * What draws a packed path: `move`, then `curve` with the degree (1 to 3), the coordinates and the place of the first
 * one after the start; `close`.
 *
 * @typedef {object} PathSink
 * @property {(x: number, y: number) => void} move
 * @property {(degree: number, list: Float64Array, at: number) => void} curve
 * @property {(line: boolean) => void} close the argument says whether the last line is left to it
 */

/**
 * Draws a packed path; higher degrees become cubics.
 *
 * @param {Float64Array} packed
 * @param {PathSink} pen
 * @param {number} tolerance 0 for the default
 * @param {boolean} closing whether the last line of a closed subpath is drawn, or left to `close`
 */
function draw(packed, pen, tolerance, closing) {
  for (const { segments, closed, degrees, points, end } of extents(packed)) {
    pen.move(packed[points], packed[points + 1]);
    let at = points + 2;
    let left = false;
    for (let k = 0; k < segments; k++) {
      const degree = packed[degrees + k];
      const after = at + 2 * degree;
      const ring = after > end;
      left = ring && degree === 1 && !closing && leftToClose(packed, points, at);
      if (!ring && degree <= 3) pen.curve(degree, packed, at);
      else if (!left) {
        const curve = new Float64Array(2 * degree + 2);
        curve.set(packed.subarray(at - 2, Math.min(after, end)));
        if (ring) curve.set(packed.subarray(points, points + 2), 2 * degree);
        if (degree <= 3) pen.curve(degree, curve, 2);
        else cubics(pen, curve, tolerance);
      }
      at = after;
    }
    if (closed) pen.close(left && segments > 1);
  }
}

/**
 * Whether a closed subpath's last line, which starts before a place, is the one that closing draws: it has a length, or
 * there is nothing else.
 *
 * @param {Float64Array} packed
 * @param {number} points
 * @param {number} at
 */
function leftToClose(packed, points, at) {
  return at === points + 2 || packed[at - 2] !== packed[points] || packed[at - 1] !== packed[points + 1];
}

/**
 * @param {PathSink} pen
 * @param {Float64Array} curve
 * @param {number} tolerance
 */
function cubics(pen, curve, tolerance) {
  load(curve);
  const list = take(0, core().curve_cubics(curve.length / 2, tolerance));
  for (let at = 0; at < list.length; at += 6) pen.curve(3, list, at);
}

/**
 * Refuses a tolerance that the coordinates cannot resolve.
 *
 * @param {Float64Array} packed
 * @param {number} tolerance
 */
function checkTolerance(packed, tolerance) {
  if (tolerance === 0) return;
  let size = 0;
  for (const { points, end } of extents(packed))
    for (let k = points; k < end; k++) size = Math.max(size, Math.abs(packed[k]));
  done(core().path_check_tolerance(tolerance, size));
}

/**
 * Draws a packed path on a canvas context or a Path2D.
 *
 * @internal
 * @param {Float64Array} packed
 * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} given
 * @param {{ tolerance?: number } | undefined} options for degrees above 3
 */
export function traceOn(packed, given, options) {
  const target = check.drawingTarget(given);
  const tolerance = check.optionalTolerance(check.options(options).tolerance);
  checkTolerance(packed, tolerance);
  const pen = {
    move: (/** @type {number} */ x, /** @type {number} */ y) => target.moveTo(x, y),
    curve: (/** @type {number} */ degree, /** @type {Float64Array} */ p, /** @type {number} */ at) => {
      if (degree === 1) target.lineTo(p[at], p[at + 1]);
      else if (degree === 2) target.quadraticCurveTo(p[at], p[at + 1], p[at + 2], p[at + 3]);
      else target.bezierCurveTo(p[at], p[at + 1], p[at + 2], p[at + 3], p[at + 4], p[at + 5]);
    },
    close: () => target.closePath(),
  };
  draw(packed, pen, tolerance, true);
}

/**
 * How path data is written: `precision` (0 to 100) asks for the short form with so many digits after the point at most,
 * `tolerance` is for degrees above 3, which become cubics.
 *
 * @typedef {{ precision?: number, tolerance?: number }} SvgOptions
 */

/**
 * A packed path as SVG path data.
 *
 * @internal
 * @param {Float64Array} packed
 * @param {SvgOptions | undefined} options
 * @returns {string}
 */
export function svgOf(packed, options) {
  const { precision, tolerance } = check.options(options);
  if (precision !== undefined) check.whole(precision, "precision", 0, MOST_DIGITS);
  const most = check.optionalTolerance(tolerance);
  checkTolerance(packed, most);
  const writer = precision === undefined ? new ExactWriter() : new BriefWriter(precision);
  draw(packed, writer, most, false);
  return writer.text;
}

/** Absolute commands, each number with the fewest digits that give it back. */
class ExactWriter {
  text = "";

  /**
   * @param {number} x
   * @param {number} y
   */
  move(x, y) {
    this.text += `${this.text ? " " : ""}M${exactly(x)},${exactly(y)}`;
  }

  /**
   * @param {number} degree
   * @param {Float64Array} list
   * @param {number} at
   */
  curve(degree, list, at) {
    let text = ` ${COMMANDS[degree]}${exactly(list[at])},${exactly(list[at + 1])}`;
    for (let k = at + 2; k < at + 2 * degree; k += 2) text += ` ${exactly(list[k])},${exactly(list[k + 1])}`;
    this.text += text;
  }

  close() {
    this.text += " Z";
  }
}

/** So many digits after the point at most, and no character that can be left out. */
class BriefWriter {
  text = "";
  /** Where the pen is, in words; what numbers without a command would mean; the last number before the next. */
  #x = "";
  #y = "";
  #startX = "";
  #startY = "";
  #implied = "";
  #last = "";

  /** @param {number} precision */
  constructor(precision) {
    this.precision = precision;
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  move(x, y) {
    this.#x = this.#startX = fixed(x, this.precision);
    this.#y = this.#startY = fixed(y, this.precision);
    this.#put("M", [this.#x, this.#y]);
  }

  /**
   * @param {number} degree
   * @param {Float64Array} list
   * @param {number} at
   */
  curve(degree, list, at) {
    const words = Array.from(list.subarray(at, at + 2 * degree), (number) => fixed(number, this.precision));
    const [x, y] = [words[2 * degree - 2], words[2 * degree - 1]];
    if (degree === 1 && y === this.#y) this.#put("H", [x]);
    else if (degree === 1 && x === this.#x) this.#put("V", [y]);
    else this.#put(COMMANDS[degree], words);
    this.#x = x;
    this.#y = y;
  }

  /** @param {boolean} line */
  close(line) {
    // Where rounding has left the last line no length, it is written.
    if (line && this.#x === this.#startX && this.#y === this.#startY) this.#put("H", [this.#x]);
    this.text += "Z";
    this.#implied = "";
  }

  /**
   * @param {string} command
   * @param {string[]} words
   */
  #put(command, words) {
    let text = "";
    let last = this.#last;
    if (command !== this.#implied) {
      text = command;
      last = "";
    }
    this.#implied = command === "M" ? "L" : command;
    for (const word of words) {
      const apart = last === "" || word[0] === "-" || (word[0] === "." && (last.includes(".") || last.includes("e")));
      text += apart ? word : ` ${word}`;
      last = word;
    }
    this.text += text;
    this.#last = last;
  }
}

/** @param {number} x */
function exactly(x) {
  return x === 0 && Object.is(x, -0) ? "-0" : `${x}`;
}

/**
 * A number with at most so many digits after the point, without zeros that say nothing: "-.5".
 *
 * @param {number} x
 * @param {number} digits
 */
function fixed(x, digits) {
  if (Math.abs(x) >= EXPONENT_FROM) return String(x).replace("+", "");
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
