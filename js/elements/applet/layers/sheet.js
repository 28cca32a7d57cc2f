// What the layers draw on, and the few ways in which all of them do.
import { DASH, hollow, stroke } from "../../../applet/pen.js";
import { Lens } from "./lens.js";

/** @typedef {import("../../../index.js").Curve} Curve */
/** @typedef {import("./theme.js").Theme} Theme */
/** @typedef {import("./theme.js").Role} Role */
/** @typedef {import("./words.js").Word} Word */
/** @typedef {import("../state.js").State} State */
/** @typedef {[number, number]} Place */

/**
 * A paper with a lens before it. Paths go through the lens; marks and words stand on the picture, at `lens.place`.
 *
 * @typedef {object} Sheet
 * @property {CanvasRenderingContext2D} ctx scaled to the view box
 * @property {Theme} theme
 * @property {number} px the length of a CSS pixel on the picture
 * @property {Lens} lens
 * @property {State["box"]} box
 * @property {Word[]} words to be placed when all is drawn
 * @property {number[]} taken what words keep clear of: the middle of a box and half its width and height, one after the other
 */

/**
 * @param {import("../../../applet/pen.js").Paper<Role>} paper
 * @param {State} state
 * @returns {Sheet}
 */
export function sheetOn({ ctx, theme, px }, state) {
  return { ctx, theme, px, lens: new Lens(ctx, state), box: state.box, words: [], taken: [] };
}

/**
 * Begins a path along curves.
 *
 * @param {Sheet} sheet
 * @param {readonly Curve[]} curves
 */
export function along({ lens }, curves) {
  lens.beginPath();
  for (const curve of curves) lens.curve(curve.controlPoints());
}

/**
 * Begins a path through points.
 *
 * @param {Sheet} sheet
 * @param {ArrayLike<number>} flat
 */
export function through(sheet, flat) {
  sheet.lens.beginPath();
  addThrough(sheet, flat);
}

/**
 * @param {Sheet} sheet
 * @param {ArrayLike<number>} flat
 */
export function addThrough({ lens }, flat) {
  for (let i = 0; i < flat.length; i += 2) {
    if (i) lens.lineTo(flat[i], flat[i + 1]);
    else lens.moveTo(flat[0], flat[1]);
  }
}

/**
 * Separate lines: four numbers each.
 *
 * @param {Sheet} sheet
 * @param {ArrayLike<number>} flat
 */
export function lines({ lens }, flat) {
  lens.beginPath();
  for (let i = 0; i < flat.length; i += 4) {
    lens.moveTo(flat[i], flat[i + 1]);
    lens.lineTo(flat[i + 2], flat[i + 3]);
  }
}

/**
 * The path that there is, dashed.
 *
 * @param {Sheet} sheet
 * @param {string} colour
 * @param {number} width
 */
export function dashed(sheet, colour, width) {
  sheet.ctx.setLineDash(DASH.map((length) => length * sheet.px));
  stroke(sheet, colour, width);
  sheet.ctx.setLineDash([]);
}

/**
 * Faintly, what is drawn meanwhile.
 *
 * @param {Sheet} sheet
 * @param {number} opacity
 * @param {() => void} draw
 */
export function faint({ ctx }, opacity, draw) {
  ctx.globalAlpha = opacity;
  draw();
  ctx.globalAlpha = 1;
}

/**
 * Hollow marks at points.
 *
 * @param {Sheet} sheet
 * @param {ArrayLike<number>} flat
 * @param {string} colour
 */
export function hollows(sheet, flat, colour) {
  for (let i = 0; i < flat.length; i += 2) {
    const at = mark(sheet, flat[i], flat[i + 1], HOLLOW_ROOM);
    if (at) hollow(sheet, at, colour);
  }
}

/** Words keep this far from the middle of a hollow mark, in CSS pixels. */
const HOLLOW_ROOM = 5;

/**
 * The picture's place of a point, of which words will keep clear.
 *
 * @param {Sheet} sheet
 * @param {number} x
 * @param {number} y
 * @param {number} radius in CSS pixels
 * @returns {Place | null} null where it is too far outside to be seen
 */
export function mark(sheet, x, y, radius) {
  const at = sheet.lens.place(x, y);
  if (!isSeen(sheet, at)) return null;
  take(sheet, at, radius);
  return at;
}

/**
 * Keeps words away.
 *
 * @param {Sheet} sheet
 * @param {Place} at
 * @param {number} radius in CSS pixels
 */
export function take({ taken, px }, [x, y], radius) {
  if (radius > 0) taken.push(x, y, radius * px, radius * px);
}

/** What lies this far outside, in CSS pixels, shows nothing of itself inside. */
const OUTSIDE = 200;

/**
 * @param {Pick<Sheet, "box" | "px">} sheet
 * @param {Place} at
 */
export function isSeen({ box, px }, [x, y]) {
  const most = OUTSIDE * px;
  return x >= -most && y >= -most && x <= box.width + most && y <= box.height + most;
}

/**
 * @param {Sheet} sheet
 * @param {ArrayLike<number>} flat points of the plane
 * @returns {number[]} their places on the picture
 */
export function onPicture({ lens }, flat) {
  const places = [];
  for (let i = 0; i < flat.length; i += 2) places.push(...lens.place(flat[i], flat[i + 1]));
  return places;
}
