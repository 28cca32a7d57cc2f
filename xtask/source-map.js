// Edits of built JavaScript that keep its source map correct.
const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/**
 * Replaces text, and moves the columns of the source map accordingly. No replacement contains a line break.
 *
 * @param {string} code
 * @param {string} mappings of the source map: the lines of `code`, separated by semicolons
 * @param {RegExp} pattern with the flag g
 * @param {(found: string) => string} replacement
 */
export function replaceMapped(code, mappings, pattern, replacement) {
  const mapped = mappings.split(";");
  const lines = code.split("\n").map((line, k) => {
    /** @type {{ end: number, by: number }[]} */
    const shifts = [];
    const result = line.replace(pattern, (found, ...rest) => {
      const text = replacement(found);
      const start = /** @type {number} */ (rest.find((each) => typeof each === "number"));
      shifts.push({ end: start + found.length, by: text.length - found.length });
      return text;
    });
    if (shifts.length > 0 && mapped[k]) mapped[k] = shiftColumns(mapped[k], shifts);
    return result;
  });
  return { code: lines.join("\n"), mappings: mapped.join(";") };
}

/**
 * The segments of a line after some of its text changed its length. The first number of a segment is the distance of its
 * column from that of the segment before it.
 *
 * @param {string} line
 * @param {{ end: number, by: number }[]} shifts ascending
 */
function shiftColumns(line, shifts) {
  let [column, before] = [0, 0];
  return line
    .split(",")
    .map((segment) => {
      const { value, rest } = decodeFirst(segment);
      column += value;
      const shifted = shifts.reduce((sum, { end, by }) => (column >= end ? sum + by : sum), column);
      const distance = shifted - before;
      before = shifted;
      return encode(distance) + rest;
    })
    .join(",");
}

/**
 * The first number of a segment, as base-64 digits of five bits each, of which the lowest bit is the sign.
 *
 * @param {string} segment
 */
function decodeFirst(segment) {
  let [bits, at] = [0, 0];
  for (let shift = 0; ; shift += 5) {
    const digit = DIGITS.indexOf(segment[at++]);
    bits |= (digit & 31) << shift;
    if (digit < 32) break;
  }
  return { value: bits & 1 ? -(bits >> 1) : bits >> 1, rest: segment.slice(at) };
}

/** @param {number} value */
function encode(value) {
  let bits = value < 0 ? (-value << 1) | 1 : value << 1;
  let text = "";
  do {
    const more = bits > 31 ? 32 : 0;
    text += DIGITS[(bits & 31) | more];
    bits >>>= 5;
  } while (bits > 0);
  return text;
}

/**
 * A source map without the contents of some sources.
 *
 * @param {string} map
 * @param {(source: string) => boolean} isLeftOut
 */
export function withoutContents(map, isLeftOut) {
  const { sourcesContent, ...rest } = JSON.parse(map);
  const contents = rest.sources.map((source, k) => (isLeftOut(source) ? null : sourcesContent[k]));
  return JSON.stringify({ ...rest, sourcesContent: contents });
}
