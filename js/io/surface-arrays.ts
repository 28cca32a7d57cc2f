// Parsing a surface from arrays of C source code; src/io/surface_arrays.rs does the same with the same messages.
import { MAX_COORDINATE } from "../geometry/check.js";
import { END, numberOf, quote, syntaxError, wholeOf } from "./text-reader.js";

export type Token = { word: string; line: number };

export type Output = { vertices: number[]; indices: number[]; degrees: number[] };

export type Parser = { tokens: Tokens; output: Output; min: number; largest: { index: number; token: Token | null } };

const VERTEX_ROW = 3;
const PATCH_ROW = 16;
/** Larger numbers are replaced by this one: it is out of range, too. */
const MAX_INDEX = 0xffffffff;
/** What a row of each length contains. */
const CONTENTS: Record<number, string> = { [VERTEX_ROW]: "coordinates", [PATCH_ROW]: "vertex numbers" };

/** Words, braces, comments and line breaks; everything between them separates words. */
const TOKEN = /\r\n|[\r\n]|#[^\r\n]*|\/\/[^\r\n]*|\/\*[\s\S]*?(?:\*\/|$)|[{}/]|[^ \t,;\v\f\r\n{}#/]+/g;
const LINE_BREAK = /\r\n|[\r\n]/g;
const SKIPPED = /^(?:[\r\n#]|\/[/*])/;

class Tokens {
  line = 1;
  #matches;

  constructor(text: string) {
    this.#matches = text.matchAll(TOKEN);
  }

  /** @returns null at the end of the text */
  next(): Token | null {
    for (const [word] of this.#matches) {
      if (!SKIPPED.test(word)) return { word, line: this.line };
      this.line += word.match(LINE_BREAK)?.length ?? 0;
    }
    return null;
  }

  syntaxError(expected: string, token: Token | null) {
    return syntaxError(token?.line ?? this.line, expected, token ? quote(token.word) : END);
  }
}

/**
 * Parses the array of vertices and the array of patches in C source code: rows of 3 coordinates and rows of 16 vertex
 * numbers, each row and each array in braces. Text outside of braces is skipped.
 *
 * @internal
 * @param output is filled
 * @throws {RangeError} with the line number
 */
export function readArrays(text: string, output: Output) {
  const tokens = new Tokens(text);
  const parser: Parser = { tokens, output, min: Infinity, largest: { index: -1, token: null } };
  for (let token = tokens.next(); token; token = tokens.next()) {
    if (token.word === "}") throw tokens.syntaxError('"{" or the end of the text', token);
    if (token.word === "{") readArray(parser);
  }
  if (output.degrees.length === 0) throw tokens.syntaxError("an array with rows of 16 vertex numbers", null);
  if (output.vertices.length === 0) throw tokens.syntaxError("an array with rows of 3 coordinates", null);
  subtractFirst(parser);
}

/** Reads an array after its opening brace. */
function readArray(parser: Parser) {
  const { tokens, output } = parser;
  let width = 0;
  for (let token = tokens.next(); token?.word !== "}"; token = tokens.next()) {
    if (token?.word !== "{") throw tokens.syntaxError('"{" or "}"', token);
    const { words, count } = readRow(tokens);
    if (width && count !== width) throw syntaxError(token.line, `${width} ${CONTENTS[width]}`, count);
    if (!(count in CONTENTS)) throw syntaxError(token.line, "3 coordinates or 16 vertex numbers", count);
    const read = count === VERTEX_ROW ? output.vertices.length : output.degrees.length;
    if (!width && read) throw syntaxError(token.line, `one array of ${CONTENTS[count]}`, "a second one");
    width = count;
    if (count === VERTEX_ROW) readVertex(parser, words);
    else readPatch(parser, words);
  }
}

/** Reads a row after its opening brace. Words after the 16th are only counted. */
function readRow(tokens: Tokens) {
  const words: Token[] = [];
  let count = 0;
  for (let token = tokens.next(); token?.word !== "}"; token = tokens.next()) {
    if (!token || token.word === "{") throw tokens.syntaxError('a number or "}"', token);
    if (count++ < PATCH_ROW) words.push(token);
  }
  return { words, count };
}

function readVertex({ tokens, output }: Parser, words: Token[]) {
  for (const token of words) {
    const number = numberOf(token.word.replace(/[fFlL]$/, ""));
    if (number === undefined) throw tokens.syntaxError("a number", token);
    if (!Number.isFinite(number)) throw tokens.syntaxError("a finite number", token);
    if (Math.abs(number) > MAX_COORDINATE) throw tokens.syntaxError("a number from -2^500 to 2^500", token);
    output.vertices.push(number);
  }
}

function readPatch(parser: Parser, words: Token[]) {
  const { tokens, output } = parser;
  for (const token of words) {
    const number = wholeOf(token.word.replace(/[uUlL]{1,3}$/, ""));
    if (number === undefined) throw tokens.syntaxError("a vertex number", token);
    const index = Math.min(number, MAX_INDEX);
    parser.min = Math.min(parser.min, index);
    if (index > parser.largest.index) parser.largest = { index, token };
    output.indices.push(index);
  }
  output.degrees.push(3, 3);
}

/** Makes the indices start at 0: they do if 0 occurs, and are from 1 otherwise. */
function subtractFirst({ tokens, output, min, largest }: Parser) {
  const first = min === 0 ? 0 : 1;
  const last = output.vertices.length / VERTEX_ROW - 1 + first;
  if (largest.index > last) throw tokens.syntaxError(`a vertex number from ${first} to ${last}`, largest.token);
  for (let i = 0; i < output.indices.length; i++) output.indices[i] -= first;
}
