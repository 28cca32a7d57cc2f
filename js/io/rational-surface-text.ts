// The text of surfaces with weights; src/io/surface_text.rs does the same with the same messages.
import { formatNumber } from "./format-number.js";
import { parseSurface, surfaceText } from "./surface-text.js";
import { numberOf } from "./text-reader.js";
import { MAX_COORDINATE } from "../geometry/check.js";
import type { Reader } from "./text-reader.js";
import type { RationalSurfaceData } from "../geometry/brand.js";
import type { JoinedOf } from "../geometry/surface-network.js";

/** The largest weight, and the inverse of the smallest. */
const MAX_WEIGHT = MAX_COORDINATE;

/**
 * See `RationalSurface.toText`.
 *
 * @internal
 */
export function rationalSurfaceText(data: RationalSurfaceData): string {
  const { degrees, weights } = data;
  let at = 0;
  return surfaceText(data, (rows, k) => {
    const [columns, count] = [degrees[2 * k] + 1, degrees[2 * k + 1] + 1];
    const own = weights.subarray(at, at + columns * count);
    at += own.length;
    if (own.every((w) => w === 1)) return;
    for (let j = 0; j < own.length; j += columns) {
      const row = Array.from({ length: columns }, (_, i) => formatNumber(own, j + i));
      rows.push(`w ${row.join(" ")}`);
    }
  });
}

/**
 * See `RationalSurface.parse`.
 *
 * @internal
 * @param joinedOf returns for each vertex the index of the first one with the same position
 * @throws {RangeError} with the line number
 */
export function parseRationalSurface(text: string, joinedOf: JoinedOf): RationalSurfaceData {
  const weights: number[] = [];
  const network = parseSurface(text, joinedOf, (reader, degreeU, degreeV) => {
    const isWeighted = beginsWithW(reader);
    for (let j = 0; j <= degreeV; j++) {
      if (isWeighted) readWeights(reader, degreeU + 1, weights);
      else for (let i = 0; i <= degreeU; i++) weights.push(1);
    }
  });
  const all = new Float64Array(network.indices.length).fill(1);
  all.set(weights);
  return { ...network, weights: all };
}

/** Whether the row after the current one begins with the letter w. */
function beginsWithW(reader: Reader): boolean {
  const { at, line } = reader;
  reader.next(1);
  const found = reader.word(0) === "w";
  Object.assign(reader, { at, line });
  return found;
}

/** Reads a row of weights. */
function readWeights(reader: Reader, columns: number, weights: number[]) {
  reader.words(columns + 1, "words: w and weights");
  if (reader.word(0) !== "w") throw reader.syntaxError(0, '"w"');
  for (let i = 1; i <= columns; i++) {
    const w = numberOf(reader.word(i) ?? "") ?? 0;
    if (!(w >= 1 / MAX_WEIGHT && w <= MAX_WEIGHT)) {
      throw reader.syntaxError(i, "a number above 0, from 2^-500 to 2^500");
    }
    weights.push(w);
  }
}
