// Tokens of SVG path data: separators, numbers, flags. src/io/svg_number.rs reads the same grammar.
import { quote } from "./text-reader.js";

/** The name of the end of the text in messages. */
const END = "the end of the text";

/** An integer with at most this number of digits is below 2⁵³. */
const EXACT_DIGITS = 15;
const POWERS = Array.from({ length: EXACT_DIGITS + 1 }, (_, k) => Number(`1e${k}`));

const [TAB, LINE_FEED, FORM_FEED, RETURN, BLANK, PLUS, COMMA, MINUS, POINT] = [9, 10, 12, 13, 32, 43, 44, 45, 46];
const [ZERO, ONE, NINE, UPPER_E] = [48, 49, 57, 69];

/** The difference between the codes of a lower-case letter and its upper-case letter. */
const CASE = 32;

const isBlank = (byte: number) =>
  byte === BLANK || byte === LINE_FEED || byte === TAB || byte === RETURN || byte === FORM_FEED;
const isDigit = (byte: number) => byte >= ZERO && byte <= NINE;

/**
 * A syntax error of path data: its offset and what was expected.
 *
 * @internal
 */
export class PathDataError {
  offset: number;
  expected: string;

  constructor(offset: number, expected: string) {
    this.offset = offset;
    this.expected = expected;
  }
}

/**
 * A scanner of path data. Everything before the current position is ASCII, so offsets of bytes and characters are
 * equal.
 *
 * @internal
 */
export class Scanner {
  text: string;
  /** The text in UTF-8, which is read several times as fast as characters, with a NUL added as end mark. */
  bytes: Uint8Array<ArrayBuffer>;
  length: number;
  at: number;

  constructor(text: string) {
    this.text = text;
    this.bytes = new TextEncoder().encode(`${text}\0`);
    this.length = this.bytes.length - 1;
    this.at = 0;
  }

  skipBlanks() {
    while (isBlank(this.bytes[this.at])) this.at++;
  }

  /** Skips blanks and at most one comma; returns whether there was a comma. */
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
   * Reads a number: an optional sign, digits with an optional decimal point, an optional exponent. It is the longest
   * possible one: "1.5.5" gives 1.5 and 0.5.
   */
  number(): number {
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
    if (count === 0) throw new PathDataError(this.at, "a number");
    const end = (bytes[at] & ~CASE) === UPPER_E ? this.#exponent(at) : at;
    if (end !== at || count > EXACT_DIGITS) return this.#anyNumber(end);
    this.at = at;
    // The integer of all digits and the power of ten are exact, so their quotient is correctly rounded, as by `Number`.
    const size = decimals ? digits / POWERS[decimals] : digits;
    return negative ? -size : size;
  }

  /**
   * Reads a flag of an arc, one character.
   *
   * @returns 0 or 1
   */
  flag(): number {
    const byte = this.bytes[this.at];
    if (byte !== ZERO && byte !== ONE) throw new PathDataError(this.at, "a flag (0 or 1)");
    this.at++;
    return byte - ZERO;
  }

  /** The text from an offset up to the next blank or comma (or that character itself), formatted for a message. */
  describe(offset: number): string {
    const { text } = this;
    if (offset >= text.length) return END;
    const isSeparator = (at: number) => text.charCodeAt(at) === COMMA || isBlank(text.charCodeAt(at));
    let end = offset;
    while (end < text.length && !isSeparator(end)) end++;
    return quote(text.slice(offset, Math.max(end, offset + 1)));
  }

  /** The end of the exponent that starts at an offset, or that offset if there is no exponent. */
  #exponent(from: number) {
    const { bytes } = this;
    let at = from + 1;
    if (bytes[at] === PLUS || bytes[at] === MINUS) at++;
    const first = at;
    while (isDigit(bytes[at])) at++;
    return at > first ? at : from;
  }

  /** Reads the number that ends at an offset. */
  #anyNumber(end: number) {
    const number = Number(this.text.slice(this.at, end));
    if (!Number.isFinite(number)) throw new PathDataError(this.at, "a finite number");
    this.at = end;
    return number;
  }
}
