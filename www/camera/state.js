// What the page of the camera shows, as plain data that can be checked.

/** @typedef {import("./path.js").Vector} Vector */
/**
 * @typedef {{ points: readonly Vector[], kind: "natural" | "catmull-rom", closed: boolean, even: boolean, frames: import("./path.js").FrameKind,
 *   look: "ahead" | "teapot" }} State
 */

/** Where points may be: left, front, low; right, back, high. */
export const BOX = { min: [-13, -9, 0.3], max: [9, 9, 8] };
const MAX_POINTS = 24;
export const FEWEST_POINTS = 3;

/** @type {State} */
export const FIRST = {
  points: [
    [-12.5, -6, 1.4],
    [-9.5, -4.8, 1.4],
    [-5, -6, 1.8],
    [-0.5, -4.3, 3],
    [4.2, -6.6, 3],
    [7.8, -2, 4.6],
    [4.2, 4.8, 5],
    [-3.2, 5.8, 2.6],
    [-9, 2.2, 1.8],
  ],
  kind: "natural",
  closed: false,
  even: true,
  frames: "minimising",
  look: "ahead",
};

const CHOICES = /** @type {const} */ ({
  kind: ["natural", "catmull-rom"],
  closed: [true, false],
  even: [true, false],
  frames: ["minimising", "frenet", "upright"],
  look: ["ahead", "teapot"],
});

/** @param {number} value @param {number} axis */
const inside = (value, axis) => Math.min(Math.max(value, BOX.min[axis]), BOX.max[axis]);

/**
 * A state out of what an address says.
 *
 * @param {unknown} json
 * @returns {State}
 * @throws {RangeError} for anything else
 */
export function checked(json) {
  const given = /** @type {Record<string, unknown>} */ (json);
  if (typeof given !== "object" || given === null || !Array.isArray(given.points))
    throw new RangeError("state: expected an object with points");
  const { points } = given;
  const fine =
    points.length >= FEWEST_POINTS &&
    points.length <= MAX_POINTS &&
    points.every((point) => Array.isArray(point) && point.length === 3 && point.every(Number.isFinite));
  if (!fine) throw new RangeError(`points: expected ${FEWEST_POINTS} to ${MAX_POINTS} times three numbers`);
  for (const [name, values] of Object.entries(CHOICES)) {
    if (!(/** @type {readonly unknown[]} */ (values).includes(given[name])))
      throw new RangeError(`${name}: expected one of ${values.join(", ")}`);
  }
  const { kind, closed, even, frames, look } = /** @type {any} */ (given);
  return {
    points: points.map((/** @type {Vector} */ point) => /** @type {Vector} */ (point.map(inside))),
    kind,
    closed,
    even,
    frames,
    look,
  };
}

/**
 * @param {State} state
 * @param {number} index
 * @param {Vector} to
 * @returns {State}
 */
export const moved = (state, index, to) => ({
  ...state,
  points: state.points.map((point, k) => (k === index ? /** @type {Vector} */ (to.map(inside)) : point)),
});

/**
 * One more point behind `index`, in the middle of the path's next piece (or before the last point).
 *
 * @param {State} state
 * @param {number} index
 * @param {(t: number) => Vector} at the path
 * @returns {State}
 */
export function added(state, index, at) {
  if (state.points.length >= MAX_POINTS) return state;
  const k = Math.min(index, state.points.length - (state.closed ? 1 : 2));
  const points = [...state.points];
  points.splice(k + 1, 0, at(k + 0.5));
  return { ...state, points };
}

/** @param {State} state @param {number} index @returns {State} */
export const removed = (state, index) =>
  state.points.length <= FEWEST_POINTS ? state : { ...state, points: state.points.filter((_, k) => k !== index) };
