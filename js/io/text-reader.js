// The rows of a text, and what can be wrong with them; src/io/text_reader.rs reads the same.

/** What comes when nothing comes. */
const END = "the end of the text";

const BYTE_ORDER_MARK = 0xfeff;

/** How much of a word a message shows. */
const SHOWN_CHARACTERS = 40;

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
/** So many digits make a whole number below 2⁵³. */
const EXACT_DIGITS = 15;
const POWERS = Array.from({ length: EXACT_DIGITS + 1 }, (_, k) => Number(`1e${k}`));
const WHOLE = /^\d+$/;

const [TAB, LINE_FEED, RETURN, BLANK, HASH, COMMA] = [9, 10, 13, 32, 35, 44];
const [MINUS, POINT, ZERO, NINE] = [45, 46, 48, 57];

/** @param {number} byte */
const isBreak = (byte) => byte === LINE_FEED || byte === RETURN;
/** @param {number} byte */
const isBlank = (byte) => byte === BLANK || byte === TAB || byte === COMMA || (byte > LINE_FEED && byte < RETURN);

/**
 * A text as rows of words.
 *
 * Blanks, tabs and commas separate words; `#` starts a comment, which ends with its line; lines end with a line feed, a
 * carriage return or both. Lines without words are numbered, but are no rows.
 *
 * @internal
 */
export class Reader {
  /** @param {string} text */
  constructor(text) {
    /** What the text counts as its length, in UTF-16. */
    this.length = text.length;
    const marked = text.charCodeAt(0) === BYTE_ORDER_MARK;
    /** In bytes, which are read several times as fast as characters; with a line break behind, which ends the last word. */
    this.bytes = new TextEncoder().encode(`${marked ? text.slice(1) : text}\n`);
    this.at = 0;
    /** The number of the line that was read last. */
    this.line = 1;
    /**
     * Where the words of the row that was read last start and end, up to those wanted: a string for each would take
     * more time than all the rest.
     *
     * @type {number[]}
     */
    this.ends = [];
    /** How many words of it are kept. */
    this.count = 0;
  }

  /**
   * A word of the row that was read last.
   *
   * @param {number} place
   * @returns {string | undefined} nothing past the words that were wanted
   */
  word(place) {
    if (place >= this.count) return undefined;
    return new TextDecoder("utf-8", { ignoreBOM: true }).decode(
      this.bytes.subarray(this.ends[2 * place], this.ends[2 * place + 1]),
    );
  }

  /**
   * Reads the next row. Words beyond those wanted are only counted: a row may be as long as the text.
   *
   * @param {number} wanted
   * @returns {number} how many words it has, 0 at the end of the text
   */
  next(wanted) {
    this.count = 0;
    while (!this.#findWord()) if (!this.#nextLine()) return 0;
    let count = 0;
    for (; this.#findWord(); count++) {
      const from = this.at;
      this.#skipWord();
      if (count >= wanted) continue;
      this.ends[2 * count] = from;
      this.ends[2 * count + 1] = this.at;
    }
    this.count = Math.min(count, wanted);
    return count;
  }

  /**
   * Reads the next row, which must have exactly that many words.
   *
   * @param {number} count
   * @param {string} what
   */
  words(count, what) {
    const got = this.next(count);
    if (got !== count) throw refusal(this.line, `${count} ${what}`, got || END);
  }

  /**
   * The number at a place of the row that was read last.
   *
   * @param {number} place
   * @returns {number}
   */
  number(place) {
    const plain = this.#plain(place);
    if (!Number.isNaN(plain)) return plain;
    const word = this.word(place) ?? "";
    if (!NUMBER.test(word)) throw this.refusal(place, "a number");
    const number = Number(word);
    if (!Number.isFinite(number)) throw this.refusal(place, "a finite number");
    return number;
  }

  /**
   * The whole number at a place of the row that was read last.
   *
   * @param {number} place
   * @param {string} expected
   * @returns {number}
   */
  whole(place, expected) {
    const word = this.word(place) ?? "";
    if (!WHOLE.test(word)) throw this.refusal(place, expected);
    return Number(word);
  }

  /**
   * A refusal of the word at a place of the row that was read last, or of the text's end.
   *
   * @param {number} place
   * @param {string} expected
   */
  refusal(place, expected) {
    const word = this.word(place);
    return refusal(this.line, expected, word === undefined ? END : shown(word));
  }

  /**
   * A number of few digits and no exponent, NaN for any other word.
   *
   * Digits and power of ten are exact, so that their quotient is the nearest number, as `Number` would give it.
   *
   * @param {number} place
   * @returns {number}
   */
  #plain(place) {
    const { bytes, ends } = this;
    let at = ends[2 * place];
    const end = ends[2 * place + 1];
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

  /** Whether a word starts here or after some blanks, on this line. */
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

  /** Goes to the start of the next line; false at the end of the text. */
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
 * @internal
 * @param {number} line
 * @param {string} expected
 * @param {string | number} got
 */
export function refusal(line, expected, got) {
  return new RangeError(`line ${line}: expected ${expected}, got ${got}`);
}

/**
 * A word in quotes, or its beginning.
 *
 * @internal
 * @param {string} word
 * @returns {string}
 */
export function shown(word) {
  // Twice as many units, so that no character is cut.
  const characters = [...word.slice(0, 2 * SHOWN_CHARACTERS + 2)];
  return JSON.stringify(
    characters.length > SHOWN_CHARACTERS ? `${characters.slice(0, SHOWN_CHARACTERS).join("")}…` : word,
  );
}
