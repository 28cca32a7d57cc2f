// The coordinates of a figure: a box of width × height units, y down, drawn as large as there is room, with points to drag.
import { html, svg } from "lit";
import { short } from "./numbers.js";
import { disc, handle, square } from "./parts.js";

/** @typedef {[number, number]} Point */
/** @typedef {import("casteljau").Curve} Curve */

/**
 * @typedef {object} Plane
 * @property {Point} size in CSS pixels
 * @property {number} scale CSS pixels of a unit
 * @property {(point: readonly [number, number]) => Point} place units to pixels
 * @property {(pixels: readonly [number, number]) => Point} unplace and back
 * @property {[number, number, number, number, number, number]} matrix the same map, for `transform`
 * @property {{ min: Point, max: Point }} box where points may be
 */

/** Points stay so far away from the border, in units. */
const MARGIN = 3;

/**
 * @param {number} wide in CSS pixels
 * @param {{ width: number, height: number, maxHeight?: number }} options
 * @returns {Plane}
 */
export function planeOf(wide, { width, height, maxHeight = 400 }) {
  const tall = Math.round(Math.min(maxHeight, (wide * height) / width));
  const scale = tall / height;
  const left = (wide - width * scale) / 2;
  return {
    size: [wide, tall],
    scale,
    place: ([x, y]) => [left + x * scale, y * scale],
    unplace: ([x, y]) => [(x - left) / scale, y / scale],
    matrix: [scale, 0, 0, scale, left, 0],
    box: { min: [MARGIN, MARGIN], max: [width - MARGIN, height - MARGIN] },
  };
}

/** A flat list of coordinates as points. @param {ArrayLike<number>} flat */
export const pairs = (flat) =>
  Array.from({ length: flat.length / 2 }, (_, i) => /** @type {Point} */ ([flat[2 * i], flat[2 * i + 1]]));

/** The points of a curve, of which the first and the last lie on it. @param {number} i @param {number} count */
const kindOf = (i, count) => (i === 0 || i === count - 1 ? "on" : "off");

/** Names are so far away from their points, in CSS pixels. */
const NAME_DISTANCE = 19;
/** Names keep so much of the stage's border free. */
const NAME_MARGIN = 14;

/**
 * Marks and names of the points of control polygons.
 *
 * @param {Plane} plane
 * @param {readonly Point[]} points
 * @param {(i: number) => string} name
 * @param {{ kind?: (i: number) => "on" | "off", count?: number }} [options] `count`: the points of one polygon
 */
export const marks = (plane, points, name, { kind, count = points.length } = {}) => {
  const places = points.map(plane.place);
  return places.map(([x, y], i) => {
    const neighbours = [i - 1, i + 1].filter((k) => places[k] && Math.floor(k / count) === Math.floor(i / count));
    const [dx, dy] = awayFrom(
      [x, y],
      neighbours.map((k) => places[k]),
    );
    const [nx, ny] = [dx, dy].map((d, axis) =>
      Math.min(Math.max([x, y][axis] + NAME_DISTANCE * d, NAME_MARGIN), plane.size[axis] - NAME_MARGIN),
    );
    const mark = (kind?.(i) ?? kindOf(i, points.length)) === "on" ? disc : square;
    return svg`${mark(x, y)}<text class="strong haloed middle" x=${nx} y=${ny + 4.5}>${name(i)}</text>`;
  });
};

/** The direction from the mean of other places to this one; up if there is none. @param {Point} place @param {Point[]} others @returns {Point} */
function awayFrom([x, y], others) {
  const [mx, my] = [0, 1].map((axis) => others.reduce((sum, other) => sum + other[axis], 0) / others.length);
  const length = Math.hypot(x - mx, y - my);
  return length > 1 ? [(x - mx) / length, (y - my) / length] : [0, -1];
}

/**
 * Handles that move the points of a figure.
 *
 * @param {import("./figure.js").Figure} figure
 * @param {Plane} plane
 * @param {readonly Point[]} points
 * @param {{ name: (i: number) => string, move: (points: Point[]) => void, kind?: (i: number) => "on" | "off" }} options
 */
export const handles = (figure, plane, points, { name, move, kind = (i) => kindOf(i, points.length) }) =>
  html`${points.map((at, i) =>
    handle({
      name: name(i),
      kind: kind(i),
      at,
      place: plane.place,
      unplace: plane.unplace,
      size: plane.size,
      box: plane.box,
      step: 1,
      say: (value) => short(value, 1),
      move: (to) => {
        move(points.map((point, k) => (k === i ? to : point)));
        figure.notifyInput();
      },
      done: () => figure.notifyChange(),
    }),
  )}`;

/**
 * An arrow from one place to another, in pixels.
 *
 * @param {readonly [number, number]} from
 * @param {readonly [number, number]} to
 * @param {string} colour
 */
export function arrow([x0, y0], [x1, y1], colour) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 1) return "";
  const [dx, dy] = [(x1 - x0) / length, (y1 - y0) / length];
  const head = `M${x1 - 10 * dx + 5 * dy} ${y1 - 10 * dy - 5 * dx}L${x1} ${y1}L${x1 - 10 * dx - 5 * dy} ${y1 - 10 * dy + 5 * dx}Z`;
  return svg`<path d="M${x0} ${y0}L${x1 - 8 * dx} ${y1 - 8 * dy}" fill="none" stroke=${colour} stroke-width="2.5" /><path d=${head} fill=${colour} />`;
}

/** The path of a curve on the screen. @param {Plane} plane @param {{ transform(matrix: any): { toSVG(options?: any): string } }} curve */
export const drawn = (plane, curve) => curve.transform(plane.matrix).toSVG({ precision: 2 });

/** P0, P1 … @param {number} i */
export const pointName = (i) => `P${i}`;
