// Rational curves of degree 2 that are arcs of ellipses, as the command A of SVG path data.
import { arc } from "./svg-arc.js";
import { axesOf, CANDIDATES, MORE_DIGITS, ROUNDING, significant } from "./svg-arcs.js";
import { draw, MAX_DIGITS, roundTrip, shortNumber, svgWriter } from "./svg-write.js";
import type { RationalData } from "../geometry/brand.js";

/** The number of cubics of an arc that is compared with the curve: even, and enough for half a turn. */
const PIECES = 4;

/**
 * The arguments of the command A that draws a conic section, if it is an arc of an ellipse; undefined for any other curve.
 *
 * With the weights 1, w, 1 and w < 1, M = (P₀ + P₂)/2 and s = 1 − w², the center is M − (w²/s) (P₁ − M), and
 * u = (w/s) (P₁ − M) and v = (P₂ − P₀)/(2 √s) are conjugate radii; u leads to the point at t = ½ of the standard form. The arc is
 * shorter than half a turn. It is written if it is read back as passing that point, which rounded radii of nearly half an
 * ellipse can prevent.
 *
 * @param p the coordinates of three points
 * @param w w₁/√(w₀w₂)
 */
function arcOfConic(p: Float64Array, w: number, precision: number | undefined): string[] | undefined {
  const s = (1 - w) * (1 + w);
  if (!(s > 0)) return undefined;
  const [x0, y0, x1, y1, x2, y2] = p;
  const [mx, my] = [0.5 * x0 + 0.5 * x2, 0.5 * y0 + 0.5 * y2];
  const [ux, uy] = [(x1 - mx) * (w / s), (y1 - my) * (w / s)];
  const half = 0.5 / Math.sqrt(s);
  const { radii, degrees, sweep } = axesOf(ux, uy, (x2 - x0) * half, (y2 - y0) * half);
  const [middleX, middleY] = [(mx + w * x1) / (1 + w), (my + w * y1) / (1 + w)];
  const word = (x: number) => (precision === undefined ? roundTrip(x) : shortNumber(x, precision));
  const [startX, startY, endX, endY] = [x0, y0, x2, y2].map((x) => Number(word(x)));
  const size = p.reduce((largest, x) => Math.max(largest, Math.abs(x)), 0);
  const unit = precision === undefined ? ROUNDING * size : 10 ** -precision;
  const candidates = precision === undefined ? exactWords(radii, degrees) : shortWords(radii, degrees, precision);
  for (const [rx, ry, angle] of candidates) {
    const numbers = Float64Array.of(Number(rx), Number(ry), Number(angle), 0, Number(sweep));
    const cubics = arc(startX, startY, numbers, endX, endY, 0, PIECES);
    if (cubics?.length !== 6 * PIECES) continue;
    const middle = 3 * PIECES - 2;
    if (!(Math.abs(cubics[middle] - middleX) <= unit && Math.abs(cubics[middle + 1] - middleY) <= unit)) continue;
    return [rx, ry, angle, "0", sweep ? "1" : "0", word(x2), word(y2)];
  }
  return undefined;
}

/** The radii and the angle with the fewest digits first. */
function exactWords(radii: number[], degrees: number): string[][] {
  return CANDIDATES.map(([digits, less]) =>
    [...radii.map((r) => r * (1 - less)), degrees].map((x) => roundTrip(significant(x, digits))),
  );
}

/** The radii are rounded, or smaller by one unit of the last digit, but not below 0. */
function shortWords(radii: number[], degrees: number, precision: number): string[][] {
  const angle = shortNumber(degrees, Math.min(precision + MORE_DIGITS, MAX_DIGITS));
  return [0, 10 ** -precision].map((less) => [
    ...radii.map((r) => shortNumber(Math.max(r - less, 0), precision)),
    angle,
  ]);
}

/**
 * Rational curves that join, as SVG path data: arcs of ellipses as arcs, the others as the packed path that `cubicsOf` gives.
 *
 * @internal
 * @param tolerance of degrees above 3; 0 for the default
 */
export function svgOfRational(
  segments: readonly RationalData[],
  closed: boolean,
  precision: number | undefined,
  tolerance: number,
  cubicsOf: (k: number) => Float64Array,
): string {
  const writer = svgWriter(precision);
  const rest = { move() {}, curve: writer.curve.bind(writer), close() {} };
  writer.move(segments[0].flat[0], segments[0].flat[1]);
  for (const [k, { flat, weights }] of segments.entries()) {
    const [a, b, c] = weights;
    const words = weights.length === 3 ? arcOfConic(flat, b / Math.sqrt(a) / Math.sqrt(c), precision) : undefined;
    if (words) writer.arc(words);
    else draw(cubicsOf(k), rest, tolerance, true);
  }
  if (closed) writer.close(false);
  return writer.text;
}
