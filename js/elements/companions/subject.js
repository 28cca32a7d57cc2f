// What the companions speak of: one piece of a curve, its points with their names, and t.
import { MATRIX_DEGREE } from "./weights.js";

/**
 * @import { Curve } from "../../index.js"
 * @import { Place } from "./points.js"
 * @import { Basis } from "./weights.js"
 */

/**
 * The figure of an applet, as far as companions read it.
 *
 * @typedef {object} Figure
 * @property {Place[]} points
 * @property {string[]} [names]
 * @property {string} basis
 * @property {ArrayLike<number> | null} [matrix]
 * @property {number} t
 * @property {number} [segment] the piece that is looked at
 * @property {{ curve: Curve, indices: number[] }[]} pieces
 */

/**
 * @typedef {object} Subject
 * @property {Basis} basis
 * @property {number} degree
 * @property {number[] | null} matrix
 * @property {number} t
 * @property {Place[]} points that the weights are for: control points, and for Hermite curves ends and tangent vectors
 * @property {string[]} names theirs
 * @property {Curve | null} curve in Bézier form
 * @property {{ points: Place[], names: string[] }} [control] the points that the tangent vectors come from
 * @property {number[]} indices of the points in the figure; none where no point of the figure has a weight of its own
 */

/** Splines through all points have no weights that one could show: their pieces are told as Bézier curves. */
const THROUGH = ["natural", "centripetal"];

/**
 * The piece that a figure looks at; null while there is none.
 *
 * @param {Figure | null | undefined} figure
 * @returns {Subject | null}
 */
export function subjectOf(figure) {
  const piece = figure?.pieces[figure.segment ?? 0] ?? figure?.pieces[0];
  if (!figure || !piece) return null;
  const { t, matrix } = figure;
  const through = THROUGH.includes(figure.basis);
  const basis = through ? "bezier" : /** @type {Basis} */ (figure.basis);
  const of = { basis, t, matrix: matrix ? Array.from(matrix) : null, curve: piece.curve };
  if (through) return { ...of, ...bezierForm(piece.curve), indices: [] };
  const { indices } = piece;
  const points = indices.map((i) => figure.points[i]);
  const names = indices.map((i) => figure.names?.[i] || `P${i}`);
  return {
    ...of,
    degree: indices.length - 1,
    indices,
    ...(basis === "hermite" ? withTangents(points, names) : { points, names }),
  };
}

/**
 * A curve's own control points.
 *
 * @param {Curve} curve
 */
export function bezierForm(curve) {
  const flat = curve.controlPoints();
  const points = Array.from(
    { length: flat.length / 2 },
    (_, i) => /** @type {Place} */ ([flat[2 * i], flat[2 * i + 1]]),
  );
  return { points, names: points.map((_, i) => `b${i}`), degree: points.length - 1 };
}

/**
 * Of four points: the ends, and the tangent vectors P1 − P0 and P3 − P2. The points themselves are `control`.
 *
 * @param {Place[]} points
 * @param {string[]} names
 */
export function withTangents([a, b, c, d], [nameA, nameB, nameC, nameD]) {
  const away = (/** @type {Place} */ to, /** @type {Place} */ from) =>
    /** @type {Place} */ ([to[0] - from[0], to[1] - from[1]]);
  const control = { points: [a, b, c, d], names: [nameA, nameB, nameC, nameD] };
  return {
    points: [a, d, away(b, a), away(d, c)],
    names: [nameA, nameD, `${nameB}−${nameA}`, `${nameD}−${nameC}`],
    control,
  };
}

/**
 * A Hermite curve by a matrix for its points, so that any other matrix can take its place.
 *
 * @param {Subject} subject
 * @param {number[]} m for ends and tangent vectors
 * @returns {Subject}
 */
export function inPoints(subject, m) {
  if (!subject.control) return subject;
  const matrix = [0, 4, 8, 12].flatMap((row) => [
    m[row] - m[row + 2],
    m[row + 2],
    -m[row + 3] + 0,
    m[row + 1] + m[row + 3],
  ]);
  return { ...subject, ...subject.control, basis: "matrix", matrix };
}

/**
 * Whether the weights of a basis are for ends and vectors.
 *
 * @param {string} basis
 * @param {number} i
 */
export function isVector(basis, i) {
  return basis === "hermite" && i > 1 && i <= MATRIX_DEGREE;
}
