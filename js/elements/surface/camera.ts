// Where the eye is: it circles about the surface's middle, always upright.
import { aboutX, aboutZ, image, multiply, perspective, translation } from "./matrix.js";
import type { Matrix, Vector } from "./matrix.js";

/**
 * Degrees about the upright axis and above the horizon, enlargement, and the shift of the picture in radii of the sphere.
 */
export type View = { turn: number; tilt: number; zoom: number; panX: number; panY: number };

/** A sphere about the surface; `up`: the axis that points up. */
export type BoundingSphere = { centre: Vector; radius: number; up: "z" | "y" };

/** The camera's matrices, its directions and place in space, and the size of the picture in CSS pixels. */
export type CameraMatrices = {
  view: Matrix;
  projection: Matrix;
  viewProjection: Matrix;
  right: Vector;
  upward: Vector;
  forward: Vector;
  eye: Vector;
  width: number;
  height: number;
};

export const HOME: View = Object.freeze({ turn: -35, tilt: 24, zoom: 1, panX: 0, panY: 0 });
const MAX_TILT = 90;
const [MIN_ZOOM, MAX_ZOOM] = [0.25, 40];
const MAX_PAN = 2;
/** Of a key or a button. */
export const ZOOM_STEP = 1.2;
/** Half the smaller side of the picture at distance 1: a lens of about 28°, with little distortion. */
const SLOPE = 0.25;
/** So much of the picture the sphere takes; a little air remains. */
const FILLED = 0.95;
/** Most things are wider than they are tall: a picture that is too, by so much at most, is filled by its width. */
const WIDER = 1.2;
/** Points that are dragged out of the sphere remain visible within so many radii. */
const DEPTH_RADII = 8;
const NEAREST = 0.02;

/** The view with some of its numbers changed, within its limits. */
export function moved(view: View, changes: Partial<View>): View {
  const finite = Object.fromEntries(Object.entries(changes).filter(([, value]) => Number.isFinite(value)));
  const { turn, tilt, zoom, panX, panY } = { ...view, ...finite };
  const clamp = (x: number, min: number, max: number) => Math.min(Math.max(x, min), max);
  return {
    turn: ((((turn + 180) % 360) + 360) % 360) - 180,
    tilt: clamp(tilt, -MAX_TILT, MAX_TILT),
    zoom: clamp(zoom, MIN_ZOOM, MAX_ZOOM),
    panX: clamp(panX, -MAX_PAN, MAX_PAN),
    panY: clamp(panY, -MAX_PAN, MAX_PAN),
  };
}

/** The length that the sphere is fitted into. */
function fittedSide(width: number, height: number) {
  return Math.min(width, WIDER * height);
}

/** Radii of the sphere that a pixel spans, in the plane through the middle. */
export function radiiPerPixel({ zoom }: View, width: number, height: number) {
  return 2 / FILLED / zoom / fittedSide(width, height);
}

/** The sphere about the centre of the bounding box of some points that contains them. */
export function boundingSphereOf(points: ArrayLike<number>, up: "z" | "y"): BoundingSphere {
  const [min, max] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let i = 0; i < points.length; i++) {
    min[i % 3] = Math.min(min[i % 3], points[i]);
    max[i % 3] = Math.max(max[i % 3], points[i]);
  }
  if (points.length === 0) return { centre: [0, 0, 0], radius: 1, up };
  const centre = min.map((low, k) => low / 2 + max[k] / 2) as Vector;
  let radius = 0;
  for (let i = 0; i < points.length; i += 3)
    radius = Math.max(radius, Math.hypot(...centre.map((c, k) => points[i + k] - c)));
  return { centre, radius: radius || 1, up };
}

/** @param width of the picture, in CSS pixels */
export function cameraMatricesOf(
  { turn, tilt, zoom, panX, panY }: View,
  { centre, radius, up }: BoundingSphere,
  width: number,
  height: number,
): CameraMatrices {
  const min = fittedSide(width, height);
  const slope = SLOPE / zoom; // by the lens: the eye never gets into the surface
  const distance = radius / (SLOPE * FILLED);
  const projection = perspective(
    (slope * width) / min,
    (slope * height) / min,
    Math.max(distance - DEPTH_RADII * radius, NEAREST * distance),
    distance + DEPTH_RADII * radius,
  );
  const upright = up === "y" ? aboutX(90) : translation(0, 0, 0);
  const rotation = multiply(multiply(aboutX(tilt - 90), aboutZ(turn)), upright);
  const view = multiply(
    translation(panX * radius, panY * radius, -distance),
    multiply(rotation, translation(-centre[0], -centre[1], -centre[2])),
  );
  const row = (r: number) => [view[r], view[r + 4], view[r + 8]] as Vector;
  const [right, upward, backward] = [row(0), row(1), row(2)];
  const along = (k: number) => -(view[12] * right[k] + view[13] * upward[k] + view[14] * backward[k]);
  const forward = backward.map((x) => -x) as Vector;
  return {
    view,
    projection,
    viewProjection: multiply(projection, view),
    right,
    upward,
    forward,
    eye: [along(0), along(1), along(2)],
    width,
    height,
  };
}

/** Where a point appears, in the picture's units from its upper left corner; null behind the eye. */
export function placeOf(
  { viewProjection, width, height }: CameraMatrices,
  point: ArrayLike<number>,
  at: number,
): [number, number] | null {
  const [x, y, , w] = image(viewProjection, point, at);
  return w > 0 ? [((x / w + 1) * width) / 2, ((1 - y / w) * height) / 2] : null;
}

/** The way in space that moves a point by (dx, dy) in the picture, in the plane through it that faces the eye. */
export function shiftOf(
  { viewProjection, projection, right, upward, width, height }: CameraMatrices,
  point: ArrayLike<number>,
  dx: number,
  dy: number,
): Vector {
  const w = image(viewProjection, point)[3];
  const x = (2 * dx * w) / width / projection[0];
  const y = (-2 * dy * w) / height / projection[5];
  return right.map((r, k) => r * x + upward[k] * y) as Vector;
}

/** The ray from the eye through a place of the picture. */
export function rayThrough(
  { projection, right, upward, forward, eye, width, height }: CameraMatrices,
  x: number,
  y: number,
): { origin: Vector; direction: Vector } {
  const sx = ((2 * x) / width - 1) / projection[0];
  const sy = (1 - (2 * y) / height) / projection[5];
  const direction = forward.map((f, k) => f + right[k] * sx + upward[k] * sy) as Vector;
  return { origin: eye, direction };
}

/** From the surface's coordinates to the picture's: what a canvas in two dimensions draws with. */
export function pixelMatrix({ viewProjection }: CameraMatrices, width: number, height: number): Matrix {
  const toPixels = [width / 2, 0, 0, 0, 0, -height / 2, 0, 0, 0, 0, 1, 0, width / 2, height / 2, 0, 1];
  return multiply(toPixels, viewProjection);
}
