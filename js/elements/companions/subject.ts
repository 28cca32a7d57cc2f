// What the companions speak of: one piece of a curve, its points with their names, and t.
import { MATRIX_DEGREE } from "./weights.js";
import type { Curve } from "../../index.js";
import type { Point2 } from "./points.js";
import type { Basis } from "./weights.js";

/** The figure of an applet, as far as companions read it. */
export interface Figure {
  points: Point2[];
  names?: string[];
  basis: string;
  matrix?: ArrayLike<number> | null;
  t: number;
  /** The piece that is looked at */
  segment?: number;
  pieces: { curve: Curve; indices: number[] }[];
  /** Instead of these, the pieces of points with weights */
  rational?: { indices: number[] }[];
  /** Of the points */
  weights?: readonly number[] | null;
}

export interface Subject {
  basis: Basis;
  degree: number;
  matrix: number[] | null;
  t: number;
  /** That the weights are for: control points, and for Hermite curves ends and tangent vectors */
  points: Point2[];
  /** Theirs */
  names: string[];
  /** Of the points of a rational curve */
  weights?: number[] | null;
  /** In Bézier form; null for a rational curve */
  curve: Curve | null;
  /** The points that the tangent vectors come from */
  control?: { points: Point2[]; names: string[] };
  /** Of the points in the figure; none where no point of the figure has a weight of its own */
  indices: number[];
}

/** Splines through all points have no weights that one could show: their pieces are told as Bézier curves. */
const THROUGH = ["natural", "centripetal"];

/** The piece that a figure looks at; null while there is none. */
export function subjectOf(figure: Figure | null | undefined): Subject | null {
  if (!figure) return null;
  const { t, matrix, segment = 0, weights } = figure;
  const pieces: { indices: number[] }[] = (weights ? figure.rational : figure.pieces) ?? [];
  const at = segment in pieces ? segment : 0;
  if (!pieces[at]) return null;
  const curve = weights ? null : figure.pieces[at].curve;
  const through = THROUGH.includes(figure.basis);
  const basis = through ? "bezier" : (figure.basis as Basis);
  const of = { basis, t, matrix: matrix ? Array.from(matrix) : null, curve };
  if (curve && through) return { ...of, ...bezierForm(curve), indices: [] };
  const { indices } = pieces[at];
  const points = indices.map((i) => figure.points[i]);
  const names = indices.map((i) => figure.names?.[i] || `P${i}`);
  return {
    ...of,
    degree: indices.length - 1,
    indices,
    weights: weights && indices.map((i) => weights[i]),
    ...(basis === "hermite" ? withTangents(points, names) : { points, names }),
  };
}

/** A curve's own control points. */
export function bezierForm(curve: Curve) {
  const flat = curve.controlPoints();
  const points = Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]] as Point2);
  return { points, names: points.map((_, i) => `b${i}`), degree: points.length - 1 };
}

/** Of four points: the ends, and the tangent vectors P1 − P0 and P3 − P2. The points themselves are `control`. */
export function withTangents([a, b, c, d]: Point2[], [nameA, nameB, nameC, nameD]: string[]) {
  const away = (to: Point2, from: Point2) => [to[0] - from[0], to[1] - from[1]] as Point2;
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
 * @param m for ends and tangent vectors
 */
export function inPoints(subject: Subject, m: number[]): Subject {
  if (!subject.control) return subject;
  const matrix = [0, 4, 8, 12].flatMap((row) => [
    m[row] - m[row + 2],
    m[row + 2],
    -m[row + 3] + 0,
    m[row + 1] + m[row + 3],
  ]);
  return { ...subject, ...subject.control, basis: "matrix", matrix };
}

/** Whether the weights of a basis are for ends and vectors. */
export function isVector(basis: string, i: number) {
  return basis === "hermite" && i > 1 && i <= MATRIX_DEGREE;
}
