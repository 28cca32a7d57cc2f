// Where the points of a figure are in its picture: a parallel projection, and the view that shows a set of points.

/**
 * @typedef {[number, number, number]} Point3
 * @typedef {{ width: number, height: number, scale: number, center: number[], down: boolean, space: boolean, turn: number }} View
 *   scale in picture units per unit; center in projected coordinates; down: y points down, as in SVG; space: points have three
 *   coordinates, z up; turn: the angle about the vertical axis in degrees
 */

/** The picture's width, and its least and largest height. */
const [WIDTH, MIN_HEIGHT, MAX_HEIGHT] = [480, 200, 340];
/** Around what has to be in view. */
const MARGIN = 36;
/** How far the view is from the horizontal, in radians. */
const TILT = 0.45;

export class Projection {
  /** @param {View} view */
  constructor(view) {
    this.view = view;
    const angle = (view.turn * Math.PI) / 180;
    const [s, c] = [Math.sin(angle), Math.cos(angle)];
    /** The directions to the right, up and towards the reader. */
    this.right = view.space ? [c, s, 0] : [1, 0, 0];
    this.up = view.space ? [-s * Math.sin(TILT), c * Math.sin(TILT), Math.cos(TILT)] : [0, view.down ? -1 : 1, 0];
    this.towards = view.space ? [s * Math.cos(TILT), -c * Math.cos(TILT), Math.sin(TILT)] : [0, 0, 1];
  }

  /** Where a point is in the picture. @param {Point3} point */
  place(point) {
    const { width, height, scale, center } = this.view;
    const x = width / 2 + (dot(this.right, point) - center[0]) * scale;
    const y = height / 2 - (dot(this.up, point) - center[1]) * scale;
    return [round(x), round(y)];
  }

  /** The point that is moved in the plane of the picture by some units of the picture. @param {Point3} point @param {number} dx @param {number} dy */
  moved(point, dx, dy) {
    const [right, up] = [dx / this.view.scale, -dy / this.view.scale];
    return /** @type {Point3} */ (point.map((x, k) => x + right * this.right[k] + up * this.up[k]));
  }

  /** A length in units of the picture. @param {number} length */
  length(length) {
    return round(length * this.view.scale);
  }

  /** @param {Point3[]} points */
  linesThrough(points) {
    return points.length === 0 ? "" : `M${points.map((point) => this.place(point).join(" ")).join("L")}`;
  }

  /** SVG path data of a curve or a spline: an affine map of its control points. @param {any} shape a Curve or a plane Spline */
  pathOf(shape) {
    if (shape.dimension === 2) {
      const [[e, f], [x1, y1], [x2, y2]] = [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
      ].map((p) => this.#exactPlace(p));
      return shape.transform([x1 - e, y1 - f, x2 - e, y2 - f, e, f]).toSVG({ precision: 1 });
    }
    const flat = flattened(shape.controlPoints(), 3).flatMap((point) => this.#exactPlace(point));
    // The projection is parallel, so that weights stay.
    return new shape.constructor(flat, shape.weights?.()).toSVG({ precision: 1 });
  }

  /** @param {number[]} point */
  #exactPlace(point) {
    const { width, height, scale, center } = this.view;
    return [
      width / 2 + (dot(this.right, point) - center[0]) * scale,
      height / 2 - (dot(this.up, point) - center[1]) * scale,
    ];
  }

  /** Triangles from back to front with their light from 0 to 1. @param {Point3[]} points @param {ArrayLike<number>} indices */
  triangles(points, indices) {
    const faces = [];
    for (let i = 0; i < indices.length; i += 3) {
      const corners = [0, 1, 2].map((k) => points[indices[i + k]]);
      const depth = corners.reduce((sum, corner) => sum + dot(this.towards, corner), 0);
      faces.push({ depth, corners: corners.map((corner) => this.place(corner)), light: light(corners) });
    }
    return faces.sort((a, b) => a.depth - b.depth);
  }
}

/** How much light falls on a triangle from above, on either side. @param {Point3[]} corners */
function light([a, b, c]) {
  const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...n);
  return length > 0 ? Math.abs(0.3 * n[0] - 0.5 * n[1] + 0.8 * n[2]) / length : 0;
}

/**
 * The view that shows all the points.
 *
 * @param {Point3[]} points
 * @param {{ down?: boolean, space?: boolean, turn?: number }} options
 * @returns {View}
 */
export function viewOf(points, { down = false, space = false, turn = space ? 30 : 0 }) {
  const view = { width: WIDTH, height: MIN_HEIGHT, scale: 1, center: [0, 0], down, space, turn };
  const { right, up } = new Projection(view);
  const [xs, ys] = [right, up].map((axis) => range(points.map((point) => dot(axis, point))));
  const size = (/** @type {number[]} */ [min, max]) => Math.max(max - min, 1e-9);
  const room = [WIDTH - 2 * MARGIN, MAX_HEIGHT - 2 * MARGIN];
  view.scale = Math.min(room[0] / size(xs), room[1] / size(ys));
  view.center = [(xs[0] + xs[1]) / 2, (ys[0] + ys[1]) / 2];
  view.height = Math.round(Math.max(MIN_HEIGHT, size(ys) * view.scale + 2 * MARGIN));
  return view;
}

/** @param {number[]} numbers */
const range = (numbers) => (numbers.length === 0 ? [0, 1] : [Math.min(...numbers), Math.max(...numbers)]);

/**
 * Points with three coordinates, from a list of points or a flat array of coordinates.
 *
 * @param {any} points
 * @param {2 | 3} [dimension] of a flat array
 * @returns {Point3[]}
 */
export function flattened(points, dimension = 2) {
  const list = Array.from(points);
  if (typeof list[0] !== "number") return list.map(coordinates);
  const count = list.length / dimension;
  return Array.from({ length: count }, (_, k) => coordinates(list.slice(k * dimension, (k + 1) * dimension)));
}

/** @param {any} point @returns {Point3} */
const coordinates = (point) => ("x" in point ? [point.x, point.y, point.z ?? 0] : [point[0], point[1], point[2] ?? 0]);

/** @param {number[]} a @param {number[]} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {number} x */
const round = (x) => Math.round(x * 10) / 10;
