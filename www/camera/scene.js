// A scene of lines, seen in perspective and drawn on a 2D canvas: the teapot, a floor, the path.
import { Surface } from "casteljau/surfaces";
import { cross, dot, minus, plus, times, unit } from "./path.js";

/** @typedef {import("./path.js").Vector} Vector */
/** @typedef {import("./path.js").Frame} Frame */
/** @typedef {{ eye: Vector, right: Vector, up: Vector, forward: Vector, angle: number }} Camera `angle`: half of what it sees across, in radians */
/** @typedef {{ ctx: CanvasRenderingContext2D, width: number, height: number, camera: Camera }} DrawContext */

/** Nothing nearer to the eye is drawn. */
const NEAR = 0.05;
const FLOOR = 14;
const FLOOR_STEP = 2;
const LINES = 3;
const PIECES = 10;

/** The teapot's curves as polylines, made once: 32 patches, each from a dozen numbers. */
const teapot = Surface.teapot({ up: "z" })
  .isocurves({ lines: LINES })
  .map((curve) => curve.sample(PIECES));
/** The middle of the teapot. */
export const TEAPOT_MIDDLE = /** @type {Vector} */ ([0, 0, 1.5]);

const floor = Array.from({ length: (2 * FLOOR) / FLOOR_STEP + 1 }, (_, i) => -FLOOR + i * FLOOR_STEP).flatMap((at) => [
  pieces([at, -FLOOR, 0], [at, FLOOR, 0]),
  pieces([-FLOOR, at, 0], [FLOOR, at, 0]),
]);

/** A line in pieces, so that those behind the eye can be left out. @param {Vector} from @param {Vector} to */
function pieces(from, to) {
  return Float64Array.from(
    { length: 3 * (FLOOR + 1) },
    (_, i) => from[i % 3] + ((to[i % 3] - from[i % 3]) * Math.floor(i / 3)) / FLOOR,
  );
}

/** A camera that stands in a frame. @param {Frame} frame @param {number} angle @returns {Camera} */
export const cameraIn = ({ point, tangent, normal, binormal }, angle) => ({
  eye: point,
  forward: tangent,
  up: normal,
  right: binormal,
  angle,
});

/**
 * Seen from outside.
 *
 * @param {number} turn degrees about the upright axis
 * @param {number} tilt degrees above the floor
 * @param {number} distance
 * @returns {Camera}
 */
export function orbiting(turn, tilt, distance) {
  const [a, b] = [(turn * Math.PI) / 180, (tilt * Math.PI) / 180];
  const outward = /** @type {Vector} */ ([Math.cos(a) * Math.cos(b), Math.sin(a) * Math.cos(b), Math.sin(b)]);
  const right = /** @type {Vector} */ ([-Math.sin(a), Math.cos(a), 0]);
  const forward = times(outward, -1);
  return {
    eye: plus([-2.2, 0, 1.4], times(outward, distance)),
    forward,
    right,
    up: unit(cross(right, forward)),
    angle: 0.36,
  };
}

/** Into the camera's own axes: right, up, ahead. @param {Camera} camera @param {Vector} point @returns {Vector} */
const seen = ({ eye, right, up, forward }, point) => {
  const from = minus(point, eye);
  return [dot(from, right), dot(from, up), dot(from, forward)];
};

/** @param {DrawContext} drawContext @param {Vector} p in the camera's axes @returns {[number, number]} */
function toPixels({ width, height, camera }, [x, y, z]) {
  const scale = width / 2 / Math.tan(camera.angle) / z;
  return [width / 2 + x * scale, height / 2 - y * scale];
}

/** The place on the canvas; null behind the eye. @param {DrawContext} drawContext @param {Vector} point */
export function project(drawContext, point) {
  const p = seen(drawContext.camera, point);
  return p[2] > NEAR ? toPixels(drawContext, p) : null;
}

/**
 * Adds a polyline to the canvas's path, cut where it comes too near to the eye.
 *
 * @param {DrawContext} drawContext
 * @param {ArrayLike<number>} flat
 */
export function line(drawContext, flat) {
  let before = seen(drawContext.camera, [flat[0], flat[1], flat[2]]);
  for (let i = 3; i < flat.length; i += 3) {
    const next = seen(drawContext.camera, [flat[i], flat[i + 1], flat[i + 2]]);
    segment(drawContext, before, next, i === 3);
    before = next;
  }
}

/** @param {DrawContext} drawContext @param {Vector} a @param {Vector} b @param {boolean} first */
function segment(drawContext, a, b, first) {
  if (a[2] <= NEAR && b[2] <= NEAR) return;
  const cut = (/** @type {Vector} */ hidden, /** @type {Vector} */ shown) =>
    plus(hidden, times(minus(shown, hidden), (NEAR - hidden[2]) / (shown[2] - hidden[2])));
  const from = a[2] <= NEAR ? cut(a, b) : a;
  const to = b[2] <= NEAR ? cut(b, a) : b;
  if (first || from !== a) drawContext.ctx.moveTo(...toPixels(drawContext, from));
  drawContext.ctx.lineTo(...toPixels(drawContext, to));
}

/** Strokes what `add` adds. @param {DrawContext} drawContext @param {string} colour @param {number} width @param {() => void} add */
export function stroke({ ctx }, colour, width, add) {
  ctx.beginPath();
  add();
  ctx.strokeStyle = colour;
  ctx.lineWidth = width;
  ctx.stroke();
}

/**
 * The floor and the teapot.
 *
 * @param {DrawContext} drawContext
 * @param {{ grid: string, curve: string }} colours
 */
export function drawScene(drawContext, colours) {
  drawContext.ctx.lineJoin = drawContext.ctx.lineCap = "round";
  stroke(drawContext, colours.grid, 1, () => floor.forEach((flat) => line(drawContext, flat)));
  stroke(drawContext, colours.curve, 1.25, () => teapot.forEach((flat) => line(drawContext, flat)));
}

/**
 * Little axes of frames: ahead, up and right.
 *
 * @param {DrawContext} drawContext
 * @param {Frame[]} frames
 * @param {number} size
 * @param {{ handle: string, level1: string, level2: string }} colours
 */
export function drawFrames(drawContext, frames, size, colours) {
  const axes = /** @type {const} */ ([
    ["binormal", colours.level2],
    ["normal", colours.level1],
    ["tangent", colours.handle],
  ]);
  for (const [axis, colour] of axes) {
    const length = axis === "tangent" ? size / 2 : size;
    stroke(drawContext, colour, 2, () =>
      frames.forEach((frame) => line(drawContext, [...frame.point, ...plus(frame.point, times(frame[axis], length))])),
    );
  }
}

/** A pyramid of sight. @param {DrawContext} drawContext @param {Camera} body @param {number} size @param {string} colour */
export function drawCamera(drawContext, body, size, colour) {
  const half = Math.tan(body.angle) * size;
  const corner = (/** @type {number} */ x, /** @type {number} */ y) =>
    plus(plus(body.eye, times(body.forward, size)), plus(times(body.right, x * half), times(body.up, y * half * 0.66)));
  const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  stroke(drawContext, colour, 2, () => {
    line(drawContext, [...corners, corners[0]].flat());
    for (const c of corners) line(drawContext, [...body.eye, ...c]);
    line(drawContext, [...corner(-0.5, 1), ...corner(0, 1.5), ...corner(0.5, 1)]); // which side is up
  });
}
