// A stroke whose radius changes in proportion to the length of the centre line.
import { Curve } from "../modules/strokes.js";

/** @typedef {[number, number]} Point */

/**
 * Where the sides of the stroke touch the disc at t: at B − r r′ T ± r √(1 − r′²) N, where r′ is the change of the radius for each
 * unit of length. If |r′| ≥ 1, they touch no disc inside of the curve: there is no contact.
 *
 * @param {readonly Point[]} points of a cubic
 * @param {readonly [number, number]} radii at its ends
 * @param {number} t
 */
export function discAt(points, [r0, r1], t) {
  const curve = new Curve(/** @type {Point[]} */ ([...points]));
  const length = curve.length();
  const slope = length > 0 ? (r1 - r0) / length : 0;
  const radius = r0 + slope * curve.subsegment(0, t).length();
  const [{ x, y }, tangent, normal] = [curve.eval(t), curve.tangent(t), curve.normal(t)];
  const across = Math.sqrt(Math.max(0, 1 - slope * slope));
  const contact = (/** @type {1 | -1} */ side) =>
    /** @type {Point} */ ([
      x - radius * slope * tangent.x + side * radius * across * normal.x,
      y - radius * slope * tangent.y + side * radius * across * normal.y,
    ]);
  return {
    center: /** @type {Point} */ ([x, y]),
    radius,
    slope,
    contacts: Math.abs(slope) < 1 ? [contact(1), contact(-1)] : [],
  };
}
