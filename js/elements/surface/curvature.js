/**
 * @import { Patch } from "../../index.js"
 */

/** Where a point has no curvature (a side that is one point) that of a point so far towards the middle stands for it. */
const INSIDE = 1e-3;

/** @typedef {{ x: number, y: number, z?: number }} Vector */

const dot = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a.x * b.x + a.y * b.y + (a.z ?? 0) * (b.z ?? 0);

/**
 * Gaussian and mean curvature; zero for a patch that is a curve or a point.
 *
 * @param {Patch} patch
 * @param {number} u
 * @param {number} v
 * @returns {[number, number]}
 */
export function curvatureOf(patch, u, v) {
  return fundamental(patch, u, v) ?? fundamental(patch, u + (0.5 - u) * INSIDE, v + (0.5 - v) * INSIDE) ?? [0, 0];
}

/**
 * By the two fundamental forms.
 *
 * @param {Patch} patch
 * @param {number} u
 * @param {number} v
 * @returns {[number, number] | null}
 */
function fundamental(patch, u, v) {
  const d = patch.partials(u, v);
  const normal = patch.normal(u, v);
  const [e, f, g] = [dot(d.u, d.u), dot(d.u, d.v), dot(d.v, d.v)];
  const area = e * g - f * f;
  if (area <= 1e-12 * (e + g) ** 2) return null;
  const [l, m, n] = [dot(d.uu, normal), dot(d.uv, normal), dot(d.vv, normal)];
  return [(l * n - m * m) / area, (e * n - 2 * f * m + g * l) / (2 * area)];
}
