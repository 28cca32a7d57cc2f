// Parsing and writing the text of surfaces; src/io/surface_text.rs does the same with the same messages.
import { END, quote, Reader, syntaxError, wholeOf } from "./text-reader.js";
import { readArrays } from "./surface-arrays.js";
import { formatNumber } from "./format-number.js";
import { sharedVertices } from "../geometry/surface-network.js";
import type { Network } from "../geometry/brand.js";

/** The length of the shortest vertex, `0 0 0` and a line break. */
const MIN_VERTEX_CHARACTERS = 6;
/** The length of the shortest patch of vertex numbers: `1 1` and twice `0 0`, with line breaks. */
const MIN_NET_CHARACTERS = 4 + 2 * 4;
/** The length of the shortest patch of points: `1 1` and four vertices. A row of 16 vertex numbers is longer. */
const MIN_PATCH_CHARACTERS = 4 + 4 * MIN_VERTEX_CHARACTERS;
/** The number of vertex numbers per patch in a listing. */
const LISTING_ROW = 16;
/** Larger indices are replaced by this one: it is out of range, too. */
const MAX_INDEX = 0xffffffff;

/**
 * A text that is being read, and what has been read of it.
 *
 * @internal
 */
export type Parser = {
  reader: Reader;
  vertices: number[];
  indices: number[];
  degrees: number[];
  /** Reads what follows the net of a patch */
  readMore?: ReadMore;
};

type ReadMore = (reader: Reader, degreeU: number, degreeV: number) => void;

/**
 * Reads the text form of a surface.
 *
 * @internal
 * @param joinedOf returns for each vertex the index of the first one with the same position
 * @param readMore reads what follows the net of a patch in the format of `surfaceText`
 * @throws {RangeError} with the line number
 */
export function parseSurface(
  text: string,
  joinedOf: (vertices: Float64Array) => Float64Array,
  readMore?: ReadMore,
): Network {
  const reader = new Reader(text);
  const parser: Parser = { reader, vertices: [], indices: [], degrees: [], readMore };
  const words = reader.next(1);
  if (words === 1 && reader.word(0) === "surface") readIndexed(parser);
  else if (text.includes("{") && wholeOf(reader.word(0) ?? "") === undefined) readArrays(text, parser);
  else readNumbered(parser, words);
  const vertices = new Float64Array(parser.vertices);
  const { degrees } = parser;
  const joined = joinedOf(vertices);
  // The text has points instead of vertex numbers: points with the same position become one vertex.
  if (degrees.length > parser.indices.length) return { degrees, ...sharedVertices(vertices, joined) };
  return { vertices, joined, degrees, indices: new Uint32Array(parser.indices) };
}

/** Parses the format of `surfaceText` after its first row. */
function readIndexed(parser: Parser) {
  const { reader, vertices } = parser;
  const count = namedCount(reader, "vertices", MIN_VERTEX_CHARACTERS);
  for (let k = 0; k < count; k++) readPoint(reader, vertices);
  const patches = namedCount(reader, "patches", MIN_NET_CHARACTERS);
  for (let k = 0; k < patches; k++) {
    reader.words(2, "degrees");
    const [degreeU, degreeV] = readDegrees(parser);
    for (let j = 0; j <= degreeV; j++) {
      reader.words(degreeU + 1, "vertex numbers");
      readIndices(parser, 0, count);
    }
    parser.readMore?.(reader, degreeU, degreeV);
  }
  checkEnd(reader);
}

/**
 * Parses the formats that start with the number of patches, from that row on.
 *
 * @param words the number of words in that row
 */
function readNumbered(parser: Parser, words: number) {
  const { reader } = parser;
  const count = reader.whole(0, '"surface" or the number of patches');
  if (words > 1) throw syntaxError(reader.line, "the number of patches alone", `${words} words`);
  checkCount(reader, count, "patches", 0, MIN_PATCH_CHARACTERS);
  if (count > 0) readPatches(parser, count);
  checkEnd(reader);
}

/** Parses the patches of a listing or of the .bpt format, which the length of the first row distinguishes. */
function readPatches(parser: Parser, count: number) {
  const { reader } = parser;
  const words = reader.next(LISTING_ROW);
  if (words === LISTING_ROW) readListing(parser, count);
  else if (words === 2) readPoints(parser, count);
  else throw syntaxError(reader.line, "2 degrees or 16 vertex numbers", words || END);
}

function checkEnd(reader: Reader) {
  if (reader.next(1)) throw reader.syntaxError(0, "the end of the text");
}

/** Parses the .bpt format after the row with the first degrees. */
function readPoints(parser: Parser, count: number) {
  const { reader, vertices } = parser;
  for (let k = 0; k < count; k++) {
    if (k > 0) reader.words(2, "degrees");
    const [degreeU, degreeV] = readDegrees(parser);
    for (let i = (degreeU + 1) * (degreeV + 1); i > 0; i--) readPoint(reader, vertices);
  }
}

/** Parses a listing after its first row of vertex numbers. */
function readListing(parser: Parser, count: number) {
  const { reader, vertices, indices, degrees } = parser;
  // The number of vertices is only known later: it follows these rows.
  let largest = { index: -1, line: 0, word: "" };
  for (let k = 0; k < count; k++) {
    if (k > 0) reader.words(LISTING_ROW, "vertex numbers");
    readIndices(parser, 1, Infinity);
    for (let i = 0; i < LISTING_ROW; i++) {
      const index = Math.min(indices[LISTING_ROW * k + i], MAX_INDEX);
      if (index >= largest.index) largest = { index, line: reader.line, word: reader.word(i) ?? "" };
    }
    degrees.push(3, 3);
  }
  reader.words(1, "number of vertices");
  const vertexCount = reader.whole(0, "the number of vertices");
  checkCount(reader, vertexCount, "vertices", 0, MIN_VERTEX_CHARACTERS);
  for (let k = 0; k < vertexCount; k++) readPoint(reader, vertices);
  if (largest.index >= vertexCount) throw syntaxError(largest.line, vertexRange(1, vertexCount), quote(largest.word));
}

/**
 * Reads a row with a name and a count.
 *
 * @param minCharacters the length of the shortest item
 */
function namedCount(reader: Reader, name: string, minCharacters: number): number {
  const expected = `"${name}" and their number`;
  if (reader.next(2) !== 2 || reader.word(0) !== name) throw reader.syntaxError(0, expected);
  const count = reader.whole(1, expected);
  checkCount(reader, count, name, 1, minCharacters);
  return count;
}

/**
 * Throws a RangeError if the text is too short for that many items.
 *
 * @param index the index of the count in its row
 * @param minCharacters the length of the shortest item
 */
function checkCount(reader: Reader, count: number, name: string, index: number, minCharacters: number) {
  const { length } = reader;
  const max = Math.floor(length / minCharacters);
  if (count > max) throw reader.syntaxError(index, `at most ${max} ${name} in a text of ${length} characters`);
}

/** Reads the next row as a point. */
function readPoint(reader: Reader, vertices: number[]) {
  reader.words(3, "coordinates");
  vertices.push(reader.number(0), reader.number(1), reader.number(2));
}

/** Reads the degrees in the current row. */
function readDegrees({ reader, degrees }: Parser): number[] {
  const expected = "a degree from 1 to 64";
  const both = [0, 1].map((index) => {
    const degree = reader.whole(index, expected);
    if (degree < 1 || degree > 64) throw reader.syntaxError(index, expected);
    return degree;
  });
  degrees.push(...both);
  return both;
}

/**
 * Reads the vertex numbers in the current row.
 *
 * @param first the smallest vertex number
 * @param count the number of vertices
 */
function readIndices({ reader, indices }: Parser, first: number, count: number) {
  for (let i = 0; i < reader.count; i++) {
    const index = reader.whole(i, "a vertex number") - first;
    if (!(index >= 0 && index < count)) throw reader.syntaxError(i, vertexRange(first, count));
    indices.push(index);
  }
}

function vertexRange(first: number, count: number): string {
  if (count === 0) return "no vertex numbers, as there are no vertices";
  return count === Infinity ? `a vertex number from ${first}` : `a vertex number from ${first} to ${first + count - 1}`;
}

/**
 * See `Surface.toText`.
 *
 * @internal
 * @param addMore adds rows that follow the net of patch k
 */
export function surfaceText(
  { vertices, degrees, indices }: Network,
  addMore?: (rows: string[], k: number) => void,
): string {
  const rows = ["surface", `vertices ${vertices.length / 3}`];
  for (let i = 0; i < vertices.length; i += 3)
    rows.push(`${formatNumber(vertices, i)} ${formatNumber(vertices, i + 1)} ${formatNumber(vertices, i + 2)}`);
  rows.push(`patches ${degrees.length / 2}`);
  for (let k = 0, at = 0; k < degrees.length; k += 2) {
    rows.push(`${degrees[k]} ${degrees[k + 1]}`);
    for (let j = 0; j <= degrees[k + 1]; j++) {
      rows.push(indices.subarray(at, at + degrees[k] + 1).join(" "));
      at += degrees[k] + 1;
    }
    addMore?.(rows, k / 2);
  }
  return `${rows.join("\n")}\n`;
}
