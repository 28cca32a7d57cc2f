import { Surface } from "casteljau/surfaces";
import { formatNumber, pointsOf, verdict } from "./utils/surfaces.js";

/** How much rounding may change a length. */
const ROUNDING = 1e-9;

/** @param {number[]} a @param {number[]} b */
const dot = (a, b) => a.reduce((sum, x, axis) => sum + x * b[axis], 0);
/** @param {number[]} a @param {number[]} b */
const cross = ([ax, ay, az], [bx, by, bz]) => [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];

/** @param {{ surface: any, degreeU: number, degreeV: number }} figure */
export function check({ surface, degreeU, degreeV }) {
  if (surface.patchCount !== 1 || degreeU !== 1 || degreeV !== 1)
    return verdict(
      false,
      "The figure does not show a single patch of degree 1 × 1. Edit the text and press “Show it”.",
    );
  const [p00, p10, p01, p11] = pointsOf(surface);
  const [along, across, beyond] = [p10, p01, p11].map((p) => p.map((x, axis) => x - p00[axis]));
  const [lu, lv] = [Math.hypot(...along), Math.hypot(...across)];
  const volume = dot(cross(along, across), beyond);
  if (Math.abs(volume) > ROUNDING * lu * lv * Math.hypot(...beyond))
    return verdict(false, "The patch is not flat: its fourth corner is not in the plane of the other three.");
  const gap = Math.hypot(...beyond.map((x, axis) => x - along[axis] - across[axis]));
  const sides = `The sides that meet in P00 have the lengths ${formatNumber(lu)} and ${formatNumber(lv)}`;
  if (
    gap > ROUNDING ||
    Math.abs(dot(along, across)) > ROUNDING ||
    Math.max(Math.abs(lu - 1), Math.abs(lv - 1)) > ROUNDING
  )
    return verdict(false, `The patch is flat, but it is not a square with sides of length 1. ${sides}.`);
  return verdict(true, "This is a flat square of area 1.");
}

/** @param {any} element */
export function reveal(element) {
  element.surface = Surface.parse("1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
}
