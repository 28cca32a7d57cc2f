// Reading text by rows, and syntax errors; src/io/text_reader.rs reads the same format.
import { MAX_COORDINATE } from "../geometry/check.js";

/** The name of the end of the text in messages. */
export const END = "the end of the text";

const BYTE_ORDER_MARK = 0xfeff;

/** The maximum number of characters of a word that a message shows. */
const MAX_SHOWN_CHARACTERS = 40;

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
/** An integer with at most this number of digits is below 2⁵³. */
const EXACT_DIGITS = 15;
const POWERS = Array.from({ length: EXACT_DIGITS + 1 }, (_, k) => Number(`1e${k}`));
const WHOLE = /^\d+$/;

const [TAB, LINE_FEED, RETURN, BLANK, HASH, COMMA] = [9, 10, 13, 32, 35, 44];
const [MINUS, POINT, ZERO, NINE] = [45, 46, 48, 57];

const isBreak = (byte: number) => byte === LINE_FEED || byte === RETURN;
const isBlank = (byte: number) =>
  byte === BLANK || byte === TAB || byte === COMMA || (byte > LINE_FEED && byte < RETURN);

/**
 * A reader of text as rows of words.
 *
 * Spaces, tabs and commas separate words; `#` starts a comment up to the end of the line; a line ends with a line feed,
 * a carriage return or both. Lines without words are counted but skipped.
 *
 * @internal
 */
export class Reader {
  /** The length of the text in UTF-16 units. */
  length: number;
  /**
   * The text in UTF-8, which is read several times as fast as characters, with a line break added to end the last
   * word.
   */
  bytes: Uint8Array<ArrayBuffer>;
  at: number;
  /** The line number of the current row. */
  line: number;
  /**
   * The start and the end of each word of the current row, up to the requested number. Creating strings would take
   * more time than everything else.
   */
  ends: number[];
  /** The number of words in `ends`. */
  count: number;

  constructor(text: string) {
    this.length = text.length;
    const marked = text.charCodeAt(0) === BYTE_ORDER_MARK;
    this.bytes = new TextEncoder().encode(`${marked ? text.slice(1) : text}\n`);
    this.at = 0;
    this.line = 1;
    this.ends = [];
    this.count = 0;
  }

  /**
   * A word of the current row.
   *
   * @returns undefined past the requested number of words
   */
  word(index: number): string | undefined {
    if (index >= this.count) return undefined;
    return new TextDecoder("utf-8", { ignoreBOM: true }).decode(
      this.bytes.subarray(this.ends[2 * index], this.ends[2 * index + 1]),
    );
  }

  /**
   * Reads the next row. Words beyond the requested number are only counted, because a row may be as long as the text.
   *
   * @returns the number of words in the row, 0 at the end of the text
   */
  next(requested: number): number {
    this.count = 0;
    while (!this.#findWord()) if (!this.#nextLine()) return 0;
    let count = 0;
    for (; this.#findWord(); count++) {
      const from = this.at;
      this.#skipWord();
      if (count >= requested) continue;
      this.ends[2 * count] = from;
      this.ends[2 * count + 1] = this.at;
    }
    this.count = Math.min(count, requested);
    return count;
  }

  /** Reads the next row, which must have exactly this number of words. */
  words(count: number, what: string) {
    const got = this.next(count);
    if (got !== count) throw syntaxError(this.line, `${count} ${what}`, got || END);
  }

  /** A number of the current row. */
  number(index: number): number {
    const simple = this.#simpleNumber(index);
    if (!Number.isNaN(simple)) return simple;
    const number = numberOf(this.word(index) ?? "");
    if (number === undefined) throw this.syntaxError(index, "a number");
    if (!Number.isFinite(number)) throw this.syntaxError(index, "a finite number");
    if (Math.abs(number) > MAX_COORDINATE) throw this.syntaxError(index, "a number from -2^500 to 2^500");
    return number;
  }

  /** An integer of the current row. */
  whole(index: number, expected: string): number {
    const number = wholeOf(this.word(index) ?? "");
    if (number === undefined) throw this.syntaxError(index, expected);
    return number;
  }

  /** The error for a word of the current row, or for the end of the text. */
  syntaxError(index: number, expected: string) {
    const word = this.word(index);
    return syntaxError(this.line, expected, word === undefined ? END : quote(word));
  }

  /**
   * Parses a number with at most 15 digits and no exponent; NaN for any other word.
   *
   * The integer of all digits and the power of ten are exact, so their quotient is correctly rounded, as by `Number`.
   */
  #simpleNumber(index: number): number {
    const { bytes, ends } = this;
    let at = ends[2 * index];
    const end = ends[2 * index + 1];
    const sign = bytes[at] === MINUS ? -1 : 1;
    if (sign < 0) at++;
    const first = at;
    let digits = 0;
    let point = end;
    for (; at < end; at++) {
      const byte = bytes[at];
      if (byte >= ZERO && byte <= NINE) digits = 10 * digits + byte - ZERO;
      else if (byte === POINT && point === end) point = at;
      else return NaN;
    }
    const count = end - first - (point < end ? 1 : 0);
    return count > 0 && count <= EXACT_DIGITS ? (sign * digits) / (point < end ? POWERS[end - point - 1] : 1) : NaN;
  }

  /** Skips separators and comments; returns whether a word starts on this line. */
  #findWord() {
    const { bytes } = this;
    let { at } = this;
    while (isBlank(bytes[at])) at++;
    if (bytes[at] === HASH) while (!isBreak(bytes[at])) at++;
    this.at = at;
    return !isBreak(bytes[at]);
  }

  #skipWord() {
    const { bytes } = this;
    let { at } = this;
    while (!isBlank(bytes[at]) && !isBreak(bytes[at]) && bytes[at] !== HASH) at++;
    this.at = at;
  }

  /** Moves to the start of the next line; returns false at the end of the text. */
  #nextLine() {
    const { bytes, at } = this;
    const width = bytes[at] === RETURN && bytes[at + 1] === LINE_FEED && at + 2 < bytes.length ? 2 : 1;
    if (at + width >= bytes.length) return false;
    this.at = at + width;
    this.line++;
    return true;
  }
}

/**
 * The number that a word is.
 *
 * @internal
 * @returns undefined if the word is no number; infinite if it is too large
 */
export const numberOf = (word: string): number | undefined => (NUMBER.test(word) ? Number(word) : undefined);

/**
 * The whole number that a word is.
 *
 * @internal
 * @returns undefined if the word is not a sequence of digits
 */
export const wholeOf = (word: string): number | undefined => (WHOLE.test(word) ? Number(word) : undefined);

/**
 * The error for a text that cannot be read.
 *
 * @internal
 */
export function syntaxError(line: number, expected: string, got: string | number) {
  return new RangeError(`line ${line}: expected ${expected}, got ${got}`);
}

/**
 * A word in quotation marks, shortened if it is long.
 *
 * @internal
 */
export function quote(word: string): string {
  // Twice as many UTF-16 units, so that no character is cut.
  const characters = [...word.slice(0, 2 * MAX_SHOWN_CHARACTERS + 2)];
  return JSON.stringify(
    characters.length > MAX_SHOWN_CHARACTERS ? `${characters.slice(0, MAX_SHOWN_CHARACTERS).join("")}…` : word,
  );
}
