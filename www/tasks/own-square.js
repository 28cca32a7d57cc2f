import { Surface } from "casteljau/surfaces";
import { verdict } from "./utils/surfaces.js";

/** @param {{ surface: any, degreeU: number, degreeV: number }} figure */
export function check({ surface, degreeU, degreeV }) {
  if (surface.patchCount !== 1 || degreeU !== 1 || degreeV !== 1)
    return verdict(
      false,
      "The figure does not show a single patch of degree 1 × 1. Edit the text and press “Show it”.",
    );
  const area = surface.area();
  const { min, max } = surface.bounds();
  const flat = max.z === min.z;
  const square = max.x - min.x === 1 && max.y - min.y === 1 && Math.abs(area - 1) < 1e-9;
  if (!flat) return verdict(false, "The patch is not flat: its fourth corner is not in the plane of the other three.");
  return verdict(
    square,
    square ? "This is a flat square of area 1." : "The patch is flat, but it is not a square with sides of length 1.",
  );
}

/** @param {any} element */
export function reveal(element) {
  element.surface = Surface.parse("1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
}
