// Which part of the plane is seen: the left upper corner and how many units are as wide as the picture.

/** @typedef {{ x: number, y: number, units: number }} View */

/** A unit becomes at most so many pixels: closer, 32-bit pictures have no digits left. */
const MAX_PIXELS_PER_UNIT = 2000;
const MAX_UNITS = 1e5;
/** Room around what is fitted. */
const MARGIN = 0.09;

/**
 * @param {{ min: { x: number, y: number }, max: { x: number, y: number } }} box
 * @param {number} aspect height by width of the picture
 * @returns {View}
 */
export function fitted({ min, max }, aspect) {
  const [width, height] = [max.x - min.x, max.y - min.y];
  const units = Math.max(width, height / aspect, 1) * (1 + 2 * MARGIN);
  return { x: (min.x + max.x - units) / 2, y: (min.y + max.y - units * aspect) / 2, units };
}

/**
 * Closer by a factor, with a place staying where it is.
 *
 * @param {View} view
 * @param {number} factor
 * @param {readonly [number, number]} around in units
 * @param {number} width of the picture in pixels
 * @returns {View}
 */
export function zoomed(view, factor, [x, y], width) {
  const units = Math.min(Math.max(view.units / factor, width / MAX_PIXELS_PER_UNIT), MAX_UNITS);
  const k = units / view.units;
  return { x: x - (x - view.x) * k, y: y - (y - view.y) * k, units };
}

/** @param {View} view @param {number} dx pixels @param {number} dy @param {number} width @returns {View} */
export const panned = (view, dx, dy, width) => ({
  ...view,
  x: view.x - (dx * view.units) / width,
  y: view.y - (dy * view.units) / width,
});
