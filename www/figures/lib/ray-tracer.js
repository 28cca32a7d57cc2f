// Ray traces a surface: one ray through each pixel, one more to the light from each hit.
import { rayThrough } from "#js/elements/surface/camera.js";

/**
 * @import { Patch } from "casteljau/surfaces"
 * @import { CameraMatrices } from "#js/elements/surface/camera.js"
 */

/** @typedef {readonly number[]} Vector three numbers */
/** @typedef {{ patch: Patch, u: number, v: number, distance: number, point: Vector }} Hit */
/** @typedef {{ patch: Patch, min: Vector, max: Vector }} BoundedPatch */
/** @typedef {{ matrices: CameraMatrices, radius: number, front: Vector, back: Vector, hasShadows: boolean }} View colours from 0 to 1; radius of the surface */

/** Sides of the blocks of pixels in each pass: each pass halves them. */
const BLOCK_SIZES = [8, 4, 2, 1];
/** The lights in the coordinates of the eye (x to the right, y up, z towards the eye), as in <bezier-surface>. */
const KEY_LIGHT = [-0.4, 0.62, 0.68];
const FILL_LIGHT = [0.78, -0.1, 0.61];
const GLOSS_EXPONENT = 48;
/** Rays to the light start so far above the surface, in radii of the surface: otherwise they would hit where they start. */
const SHADOW_OFFSET = 1e-4;

export class RayTracer {
  #patches;
  #view;
  #toLight;

  /**
   * @param {Patch[]} patches
   * @param {View} view
   */
  constructor(patches, view) {
    this.#patches = patches.map(bounded);
    this.#view = view;
    this.#toLight = toWorld(KEY_LIGHT, view.matrices);
  }

  /**
   * The nearest hit of a ray. Patches whose box the ray misses, or enters behind the nearest hit so far, are not asked.
   *
   * @param {Vector} origin
   * @param {Vector} direction
   * @returns {Hit | null}
   */
  firstHit(origin, direction) {
    const length = Math.hypot(...direction);
    const candidates = this.#patches
      .map(({ patch, min, max }) => ({ patch, entry: boxEntry(origin, direction, min, max) * length }))
      .filter(({ entry }) => entry < Infinity)
      .sort((a, b) => a.entry - b.entry);
    /** @type {Hit | null} */
    let nearest = null;
    for (const { patch, entry } of candidates) {
      if (nearest && entry > nearest.distance) break;
      const hit = patch.intersectRay([...origin], [...direction])[0];
      if (hit && (!nearest || hit.distance < nearest.distance)) {
        const { x, y, z = 0 } = hit.point;
        nearest = { patch, u: hit.u, v: hit.v, distance: hit.distance, point: [x, y, z] };
      }
    }
    return nearest;
  }

  /**
   * The colour of a pixel, from 0 to 1; null for the background.
   *
   * @param {number} x of the pixel's centre
   * @param {number} y
   * @returns {number[] | null}
   */
  colour(x, y) {
    const { matrices, radius, front, back, hasShadows } = this.#view;
    const { origin, direction } = rayThrough(matrices, x, y);
    const hit = this.firstHit(origin, direction);
    if (!hit) return null;
    const normal = hit.patch.normal(hit.u, hit.v);
    const outside = [normal.x, normal.y, normal.z ?? 0];
    const isFront = dot(outside, direction) <= 0;
    const n = isFront ? outside : outside.map((c) => -c);
    const start = hit.point.map((c, k) => c + SHADOW_OFFSET * radius * n[k]);
    const isLit = !hasShadows || (dot(n, this.#toLight) > 0 && !this.firstHit(start, this.#toLight));
    return shaded(isFront ? front : back, toEye(n, matrices), toEye(direction, matrices), isLit);
  }
}

/**
 * The blocks of all passes: first coarse ones, then finer ones between them. The upper left pixel of a block gives its colour,
 * and each pixel of the picture is that pixel of exactly one block.
 *
 * @param {number} width
 * @param {number} height
 * @returns {Generator<{ x: number, y: number, size: number }>}
 */
export function* progressiveBlocks(width, height) {
  for (const size of BLOCK_SIZES) {
    const isKnown = (/** @type {number} */ x, /** @type {number} */ y) =>
      size < BLOCK_SIZES[0] && x % (2 * size) === 0 && y % (2 * size) === 0;
    for (let y = 0; y < height; y += size)
      for (let x = 0; x < width; x += size) if (!isKnown(x, y)) yield { x, y, size };
  }
}

/** @param {Patch} patch @returns {BoundedPatch} */
function bounded(patch) {
  const { min, max } = patch.bounds();
  return { patch, min: [min.x, min.y, min.z ?? 0], max: [max.x, max.y, max.z ?? 0] };
}

/**
 * Where a ray enters a box, as a multiple of the direction; 0 from inside, Infinity if it misses.
 *
 * @param {Vector} origin
 * @param {Vector} direction
 * @param {Vector} min
 * @param {Vector} max
 */
export function boxEntry(origin, direction, min, max) {
  let [entry, exit] = [0, Infinity];
  for (let k = 0; k < 3; k++) {
    if (direction[k] === 0) {
      if (origin[k] < min[k] || origin[k] > max[k]) return Infinity;
      continue;
    }
    const [a, b] = [(min[k] - origin[k]) / direction[k], (max[k] - origin[k]) / direction[k]];
    entry = Math.max(entry, Math.min(a, b));
    exit = Math.min(exit, Math.max(a, b));
  }
  return entry <= exit ? entry : Infinity;
}

/**
 * The shading of <bezier-surface>, with the main light switched off in the shadow.
 *
 * @param {Vector} base
 * @param {Vector} n the normal in the coordinates of the eye
 * @param {Vector} ray from the eye, in these coordinates
 * @param {boolean} isLit
 */
function shaded(base, n, ray, isLit) {
  const toEyePoint = normalized(ray.map((c) => -c));
  const half = normalized(KEY_LIGHT.map((c, k) => c + toEyePoint[k]));
  const key = isLit ? Math.max(dot(n, KEY_LIGHT), 0) : 0;
  const light = 0.4 + 0.58 * key + 0.16 * Math.max(dot(n, FILL_LIGHT), 0);
  const gloss = isLit ? Math.max(dot(n, half), 0) ** GLOSS_EXPONENT : 0;
  const rim = (1 - Math.max(dot(n, toEyePoint), 0)) ** 3;
  const white = 0.55 * Math.max(light - 1, 0) + 0.3 * gloss;
  return base.map((c) => c * Math.min(light + 0.12 * rim, 1) * (1 - white) + white);
}

/** @param {Vector} a @param {Vector} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {Vector} a @returns {Vector} */
const normalized = (a) => a.map((c) => c / Math.hypot(...a));

/** @param {Vector} a @param {CameraMatrices} matrices @returns {Vector} */
const toEye = (a, { right, upward, forward }) => [dot(a, right), dot(a, upward), -dot(a, forward)];

/** @param {Vector} a @param {CameraMatrices} matrices @returns {Vector} */
const toWorld = (a, { right, upward, forward }) =>
  right.map((_, k) => a[0] * right[k] + a[1] * upward[k] - a[2] * forward[k]);
