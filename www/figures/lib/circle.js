// Circles: one of the radius 1 made of equal cubic arcs whose handles have the length h.
import { Curve } from "casteljau";

/** Samples of an arc. */
const STEPS = 200;

/** The length of the handles for which the middle of each arc lies on the circle. @param {number} arcs */
export const standardHandle = (arcs) => (4 / 3) * Math.tan(Math.PI / (2 * arcs));

/**
 * The first arc, from (1, 0) on.
 *
 * @param {number} arcs
 * @param {number} handle
 */
export function arcOf(arcs, handle) {
  const angle = (2 * Math.PI) / arcs;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return new Curve([
    [1, 0],
    [1, handle],
    [c + handle * s, s - handle * c],
    [c, s],
  ]);
}

/**
 * How far the points of an arc are from the circle, outside of it above 0.
 *
 * @param {number} arcs
 * @param {number} handle
 */
export function radialErrors(arcs, handle) {
  const flat = arcOf(arcs, handle).sample(STEPS);
  return Array.from({ length: STEPS + 1 }, (_, i) => Math.hypot(flat[2 * i], flat[2 * i + 1]) - 1);
}

/** The greatest of these distances. @param {number} arcs @param {number} handle */
export const maxRadialError = (arcs, handle) => Math.max(...radialErrors(arcs, handle).map(Math.abs));
