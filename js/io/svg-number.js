// The words of path data: blanks, numbers, flags. src/io/svg_number.rs reads the same.
import { shown } from "./text-reader.js";

/** What comes when nothing comes. */
const END = "the end of the text";

/** So many digits make a whole number below 2⁵³. */
const EXACT_DIGITS = 15;
const POWERS = Array.from({ length: EXACT_DIGITS + 1 }, (_, k) => Number(`1e${k}`));

const [TAB, LINE_FEED, FORM_FEED, RETURN, BLANK, PLUS, COMMA, MINUS, POINT] = [9, 10, 12, 13, 32, 43, 44, 45, 46];
const [ZERO, ONE, NINE, UPPER_E] = [48, 49, 57, 69];

/** A lower-case letter less its upper-case one. */
const CASE = 32;

/** @param {number} byte */
const isBlank = (byte) => byte === BLANK || byte === LINE_FEED || byte === TAB || byte === RETURN || byte === FORM_FEED;
/** @param {number} byte */
const isDigit = (byte) => byte >= ZERO && byte <= NINE;

/**
 * What is wrong with path data, and where.
 *
 * @internal
 */
export class Refusal {
  /**
   * @param {number} offset
   * @param {string} expected
   */
  constructor(offset, expected) {
    this.offset = offset;
    this.expected = expected;
  }
}

/**
 * Path data, read from front to back. All that was read is ASCII, so that bytes and characters have the same offsets.
 *
 * @internal
 */
export class Scanner {
  /** @param {string} text */
  constructor(text) {
    this.text = text;
    /** In bytes, which are read several times as fast as characters; with a NUL behind, which ends everything. */
    this.bytes = new TextEncoder().encode(`${text}\0`);
    this.length = this.bytes.length - 1;
    this.at = 0;
  }

  skipBlanks() {
    while (isBlank(this.bytes[this.at])) this.at++;
  }

  /** Skips blanks with at most one comma among them; whether there was one. */
  skipSeparator() {
    this.skipBlanks();
    if (this.bytes[this.at] !== COMMA) return false;
    this.at++;
    this.skipBlanks();
    return true;
  }

  /** Whether a number may start here. */
  atNumber() {
    const byte = this.bytes[this.at];
    return isDigit(byte) || byte === MINUS || byte === POINT || byte === PLUS;
  }

  /**
   * A number: an optional sign, digits with an optional point, an optional exponent. As many characters as can belong
   * to it: "1.5.5" is 1.5 and 0.5.
   *
   * @returns {number}
   */
  number() {
    const { bytes } = this;
    let { at } = this;
    const negative = bytes[at] === MINUS;
    if (negative || bytes[at] === PLUS) at++;
    const first = at;
    let digits = 0;
    for (; isDigit(bytes[at]); at++) digits = 10 * digits + bytes[at] - ZERO;
    let count = at - first;
    let decimals = 0;
    if (bytes[at] === POINT) {
      const point = at++;
      for (; isDigit(bytes[at]); at++) digits = 10 * digits + bytes[at] - ZERO;
      decimals = at - point - 1;
      count += decimals;
    }
    if (count === 0) throw new Refusal(this.at, "a number");
    const power = (bytes[at] & ~CASE) === UPPER_E ? this.#exponent(at) : at;
    if (power !== at || count > EXACT_DIGITS) return this.#anyNumber(power);
    this.at = at;
    // Digits and power of ten are exact, so that their quotient is the nearest number, as `Number` would give it.
    const size = decimals ? digits / POWERS[decimals] : digits;
    return negative ? -size : size;
  }

  /**
   * A flag of an arc: one character.
   *
   * @returns {number} 0 or 1
   */
  flag() {
    const byte = this.bytes[this.at];
    if (byte !== ZERO && byte !== ONE) throw new Refusal(this.at, "a flag (0 or 1)");
    this.at++;
    return byte - ZERO;
  }

  /**
   * The text from an offset to the next blank or comma (or that one), as a message shows it.
   *
   * @param {number} offset
   * @returns {string}
   */
  shown(offset) {
    const { text } = this;
    if (offset >= text.length) return END;
    const separates = (/** @type {number} */ at) => text.charCodeAt(at) === COMMA || isBlank(text.charCodeAt(at));
    let end = offset;
    while (end < text.length && !separates(end)) end++;
    return shown(text.slice(offset, Math.max(end, offset + 1)));
  }

  /**
   * Where an exponent ends that starts here, or here if none does.
   *
   * @param {number} from
   */
  #exponent(from) {
    const { bytes } = this;
    let at = from + 1;
    if (bytes[at] === PLUS || bytes[at] === MINUS) at++;
    const first = at;
    while (isDigit(bytes[at])) at++;
    return at > first ? at : from;
  }

  /**
   * The number up to an offset.
   *
   * @param {number} end
   */
  #anyNumber(end) {
    const number = Number(this.text.slice(this.at, end));
    if (!Number.isFinite(number)) throw new Refusal(this.at, "a finite number");
    this.at = end;
    return number;
  }
}
