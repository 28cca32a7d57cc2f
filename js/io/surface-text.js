// Surfaces from text and to text; src/io/surface_text.rs does the same with the same words.
import { refusal, Reader, shown } from "./text-reader.js";
import { written } from "./format-number.js";

/**
 * @import { Network } from "../geometry/surface.js"
 */

/** The shortest vertex, `0 0 0` and a line break. */
const VERTEX_CHARACTERS = 6;
/** The shortest patch of vertex numbers: `1 1` and twice `0 0`, with line breaks. */
const NET_CHARACTERS = 4 + 2 * 4;
/** The shortest patch of points: `1 1` and four vertices. A row of 16 vertex numbers is longer. */
const PATCH_CHARACTERS = 4 + 4 * VERTEX_CHARACTERS;
/** The vertex numbers of a patch in a listing. */
const LISTED = 16;
/** Of what is larger, one is as bad as the other. */
const MOST_INDEX = 0xffffffff;

/**
 * What is being read.
 *
 * @typedef {{ reader: Reader, vertices: number[], indices: number[], degrees: number[] }} Parser
 */

/**
 * @internal
 * @param {string} text
 * @param {(vertices: Float64Array) => Float64Array} joinedOf gives for each vertex the first at the same place
 * @returns {Network}
 * @throws {RangeError} with the number of the line
 */
export function parseSurface(text, joinedOf) {
  const reader = new Reader(text);
  /** @type {Parser} */
  const parser = { reader, vertices: [], indices: [], degrees: [] };
  const words = reader.next(1);
  if (words === 1 && reader.word(0) === "surface") readIndexed(parser);
  else {
    const count = reader.whole(0, '"surface" or the number of patches');
    if (words > 1) throw refusal(reader.line, "the number of patches alone", `${words} words`);
    readNumbered(parser, count);
  }
  if (reader.next(1)) throw reader.refusal(0, "the end of the text");
  const vertices = new Float64Array(parser.vertices);
  const { degrees } = parser;
  const joined = joinedOf(vertices);
  // Patches without vertex numbers: points at the same place are one vertex.
  if (degrees.length > parser.indices.length) return { degrees, ...sharedVertices(vertices, joined) };
  return { vertices, joined, degrees, indices: new Uint32Array(parser.indices) };
}

/**
 * Keeps the first of equal vertices.
 *
 * @param {Float64Array} vertices overwritten
 * @param {Float64Array} joined
 * @returns {{ vertices: Float64Array, joined: Float64Array, indices: Uint32Array }}
 */
function sharedVertices(vertices, joined) {
  const indices = new Uint32Array(joined.length);
  let count = 0;
  for (let k = 0; k < joined.length; k++) {
    if (joined[k] < k) {
      indices[k] = indices[joined[k]];
      continue;
    }
    for (let axis = 0; axis < 3; axis++) vertices[3 * count + axis] = vertices[3 * k + axis];
    indices[k] = count++;
  }
  return { vertices: vertices.slice(0, 3 * count), joined: new Float64Array(count).map((_, k) => k), indices };
}

/**
 * The form that `surfaceText` writes, after its first row.
 *
 * @param {Parser} parser
 */
function readIndexed(parser) {
  const { reader, vertices } = parser;
  const count = namedCount(reader, "vertices", VERTEX_CHARACTERS);
  for (let k = 0; k < count; k++) readPoint(reader, vertices);
  const patches = namedCount(reader, "patches", NET_CHARACTERS);
  for (let k = 0; k < patches; k++) {
    reader.words(2, "degrees");
    const [degreeU, degreeV] = readDegrees(parser);
    for (let j = 0; j <= degreeV; j++) {
      reader.words(degreeU + 1, "vertex numbers");
      readIndices(parser, 0, count);
    }
  }
}

/**
 * The forms that start with the number of patches, after it.
 *
 * @param {Parser} parser
 * @param {number} count
 */
function readNumbered(parser, count) {
  const { reader } = parser;
  checkCount(reader, count, "patches", 0, PATCH_CHARACTERS);
  if (count === 0) return;
  const words = reader.next(LISTED);
  if (words === LISTED) readListing(parser, count);
  else if (words === 2) readPoints(parser, count);
  else throw refusal(reader.line, "2 degrees or 16 vertex numbers", words || "the end of the text");
}

/**
 * The .bpt form from the first degrees on, which were read.
 *
 * @param {Parser} parser
 * @param {number} count
 */
function readPoints(parser, count) {
  const { reader, vertices } = parser;
  for (let k = 0; k < count; k++) {
    if (k > 0) reader.words(2, "degrees");
    const [degreeU, degreeV] = readDegrees(parser);
    for (let i = (degreeU + 1) * (degreeV + 1); i > 0; i--) readPoint(reader, vertices);
  }
}

/**
 * The listing from its first row of vertex numbers on, which was read.
 *
 * @param {Parser} parser
 * @param {number} count
 */
function readListing(parser, count) {
  const { reader, vertices, indices, degrees } = parser;
  // The vertices come later; only then is it known how many there are.
  let largest = { index: -1, line: 0, word: "" };
  for (let k = 0; k < count; k++) {
    if (k > 0) reader.words(LISTED, "vertex numbers");
    readIndices(parser, 1, Infinity);
    for (let place = 0; place < LISTED; place++) {
      const index = Math.min(indices[LISTED * k + place], MOST_INDEX);
      if (index >= largest.index) largest = { index, line: reader.line, word: reader.word(place) ?? "" };
    }
    degrees.push(3, 3);
  }
  reader.words(1, "number of vertices");
  const vertexCount = reader.whole(0, "the number of vertices");
  checkCount(reader, vertexCount, "vertices", 0, VERTEX_CHARACTERS);
  for (let k = 0; k < vertexCount; k++) readPoint(reader, vertices);
  if (largest.index >= vertexCount) throw refusal(largest.line, vertexRange(1, vertexCount), shown(largest.word));
}

/**
 * The count in the next row, behind its name.
 *
 * @param {Reader} reader
 * @param {string} name
 * @param {number} least characters of each
 * @returns {number}
 */
function namedCount(reader, name, least) {
  const expected = `"${name}" and their number`;
  if (reader.next(2) !== 2 || reader.word(0) !== name) throw reader.refusal(0, expected);
  const count = reader.whole(1, expected);
  checkCount(reader, count, name, 1, least);
  return count;
}

/**
 * Refuses more than the text can hold.
 *
 * @param {Reader} reader
 * @param {number} count
 * @param {string} name
 * @param {number} place of the count in its row
 * @param {number} least characters of each
 */
function checkCount(reader, count, name, place, least) {
  const { length } = reader;
  const most = Math.floor(length / least);
  if (count > most) throw reader.refusal(place, `at most ${most} ${name} in a text of ${length} characters`);
}

/**
 * The next row as a point.
 *
 * @param {Reader} reader
 * @param {number[]} vertices
 */
function readPoint(reader, vertices) {
  reader.words(3, "coordinates");
  vertices.push(reader.number(0), reader.number(1), reader.number(2));
}

/**
 * The degrees in the row that was read last.
 *
 * @param {Parser} parser
 * @returns {number[]}
 */
function readDegrees({ reader, degrees }) {
  const expected = "a degree from 1 to 64";
  const both = [0, 1].map((place) => {
    const degree = reader.whole(place, expected);
    if (degree < 1 || degree > 64) throw reader.refusal(place, expected);
    return degree;
  });
  degrees.push(...both);
  return both;
}

/**
 * The vertex numbers in the row that was read last.
 *
 * @param {Parser} parser
 * @param {number} first
 * @param {number} count how many are allowed, from the first on
 */
function readIndices({ reader, indices }, first, count) {
  for (let place = 0; place < reader.count; place++) {
    const number = reader.whole(place, "a vertex number");
    const index = number - first;
    if (!(index >= 0 && index < count)) throw reader.refusal(place, vertexRange(first, count));
    indices.push(index);
  }
}

/**
 * @param {number} first
 * @param {number} count
 * @returns {string}
 */
function vertexRange(first, count) {
  if (count === 0) return "no vertex numbers, as there are no vertices";
  return count === Infinity ? `a vertex number from ${first}` : `a vertex number from ${first} to ${first + count - 1}`;
}

/**
 * @internal
 * @param {Network} network
 * @returns {string}
 */
export function surfaceText({ vertices, degrees, indices }) {
  const rows = ["surface", `vertices ${vertices.length / 3}`];
  for (let i = 0; i < vertices.length; i += 3)
    rows.push(`${written(vertices, i)} ${written(vertices, i + 1)} ${written(vertices, i + 2)}`);
  rows.push(`patches ${degrees.length / 2}`);
  for (let k = 0, at = 0; k < degrees.length; k += 2) {
    rows.push(`${degrees[k]} ${degrees[k + 1]}`);
    for (let j = 0; j <= degrees[k + 1]; j++) {
      rows.push(indices.subarray(at, at + degrees[k] + 1).join(" "));
      at += degrees[k] + 1;
    }
  }
  return `${rows.join("\n")}\n`;
}
