// Where words stand: beside what they name, clear of marks and of each other where there is room.
import { label } from "../../../applet/pen.js";

/** @typedef {import("./sheet.js").Sheet} Sheet */
/** @typedef {[number, number]} Place */

/**
 * @typedef {object} Word
 * @property {string} text
 * @property {Place} at what is named, on the picture
 * @property {Place} away the direction in which the word would best stand, of length 1
 * @property {number} gap from there to the middle of the word, in CSS pixels
 * @property {number} rank the smallest are placed first; from 1 on they are light
 */

/** About the size of a character, in CSS pixels: of the names of the control points, and of all else. */
const CHARACTER = { width: 8.5, height: 16 };
const LIGHT_WIDTH = 7.5;
/** Turns of the best direction that are tried, in this order, in eighths of a circle. */
const TURNS = [0, 1, -1, 2, -2, 3, -3, 4];
/** How far away, in gaps. */
const RINGS = [1, 1.5, 2.1];
/** Words keep this far from the edge of the picture, in CSS pixels. */
const MARGIN = 11;
/** The font of all but the names of the control points: weight and size. */
const LIGHT = /** @type {const} */ ([450, 12]);
/** Beyond so many words the picture is full anyway. */
const MOST_WORDS = 120;

/**
 * Places all words of a sheet and writes them.
 *
 * @param {Sheet} sheet
 */
export function writeWords(sheet) {
  const words = sheet.words.sort((a, b) => a.rank - b.rank).slice(0, MOST_WORDS);
  const { taken } = sheet;
  for (const word of words) {
    const halfWidth = ((word.rank ? LIGHT_WIDTH : CHARACTER.width) * [...word.text].length * sheet.px) / 2;
    const halfHeight = (CHARACTER.height * sheet.px) / 2;
    const at = bestPlace(sheet, word, taken, halfWidth, halfHeight);
    taken.push(at[0], at[1], halfWidth, halfHeight);
    label(sheet, word.text, at, word.rank ? LIGHT : undefined);
  }
}

/**
 * The first free place; where none is, the one that overlaps least.
 *
 * @param {Sheet} sheet
 * @param {Word} word
 * @param {number[]} taken
 * @param {number} halfWidth
 * @param {number} halfHeight
 * @returns {Place}
 */
function bestPlace({ box, px }, { at, away, gap }, taken, halfWidth, halfHeight) {
  /** @type {Place} */
  let best = at;
  let least = Infinity;
  for (const ring of RINGS) {
    for (const turn of TURNS) {
      const [c, s] = [Math.cos((turn * Math.PI) / 4), Math.sin((turn * Math.PI) / 4)];
      const [dx, dy] = [c * away[0] - s * away[1], s * away[0] + c * away[1]];
      const long = Math.max(0, halfWidth - MARGIN * px) * Math.abs(dx);
      const reach = gap * px * ring + long;
      const place = inside(box, [at[0] + dx * reach, at[1] + dy * reach], halfWidth, MARGIN * px);
      const cost = overlap(taken, place[0], place[1], halfWidth, halfHeight, least);
      if (cost < least) [best, least] = [place, cost];
      if (least === 0) return best;
    }
  }
  return best;
}

/**
 * @param {Sheet["box"]} box
 * @param {Place} place
 * @param {number} across how far from the left and the right edge
 * @param {number} down from the upper and the lower one
 * @returns {Place}
 */
function inside({ width, height }, [x, y], across, down) {
  return [Math.max(Math.min(x, width - across), across), Math.max(Math.min(y, height - down), down)];
}

/**
 * The area that a box shares with those that are taken.
 *
 * @param {number[]} taken
 * @param {number} x
 * @param {number} y
 * @param {number} halfWidth
 * @param {number} halfHeight
 * @param {number} most where this much is reached the rest does not matter
 * @returns {number}
 */
function overlap(taken, x, y, halfWidth, halfHeight, most) {
  let sum = 0;
  for (let i = 0; i < taken.length && sum < most; i += 4) {
    const width = halfWidth + taken[i + 2] - Math.abs(x - taken[i]);
    const height = halfHeight + taken[i + 3] - Math.abs(y - taken[i + 1]);
    if (width > 0 && height > 0) sum += width * height;
  }
  return sum;
}
