// The curves that the points mean: pieces in Bézier form, for every basis and degree.
import { Curve, Spline } from "../../paths.js";
import { MOST_DEGREE } from "./state.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./state.js").Place} Place */
/** @typedef {import("./state.js").Labels} Labels */

/**
 * @typedef {object} Piece
 * @property {Curve} curve in Bézier form
 * @property {number[]} indices the points that it is made of
 */

/**
 * @typedef {object} Figure
 * @property {readonly Place[]} points the shown ones
 * @property {Piece[]} pieces
 * @property {Spline | null} spline the pieces as one chain; null where they do not meet, or there are none
 * @property {string[]} names of the points, in the notation that is set
 * @property {("on" | "off" | "wait")[]} kinds of the points: on the curve, off it, or waiting for more to come
 * @property {number} degree of the pieces
 * @property {number[] | null} matrix 16 numbers M, row-major, so that each piece is [t³ t² t 1]·M·P with its four points; else null
 */

/** Hermite's form asks for two tangent vectors: here they are P1 − P0 and P3 − P2. */
const TANGENTS = [
  [1, 0, 0, 0],
  [0, 0, 0, 1],
  [-1, 1, 0, 0],
  [0, 0, -1, 1],
];

/**
 * @param {State} state
 * @returns {Figure}
 */
export function figureOf(state) {
  const points = state.points.slice(0, state.shown);
  const degree = degreeOf(state);
  const matrix = matrixOf(state, degree);
  const { pieces, spline, kinds } = PLANS[state.basis](points, degree, matrix ?? []);
  return { points, pieces, spline, kinds, names: points.map((_, i) => nameOf(state.labels, i)), degree, matrix };
}

/**
 * The degree of the pieces.
 *
 * @param {Pick<State, "basis" | "degree" | "shown">} state
 * @returns {number}
 */
export function degreeOf({ basis, degree, shown }) {
  if (basis !== "bezier" && basis !== "b-spline") return 3;
  return degree === "n" ? Math.min(Math.max(shown - 1, 1), MOST_DEGREE) : degree;
}

/**
 * @param {State} state
 * @param {number} degree
 * @returns {number[] | null}
 */
function matrixOf({ basis, matrix }, degree) {
  if (basis === "matrix") return [...matrix];
  if (degree !== 3 || basis === "natural" || basis === "centripetal") return null;
  const numbers = [...Curve.basisMatrix(basis)];
  return basis === "hermite" ? product(numbers, TANGENTS) : numbers;
}

/**
 * @param {number[]} a 4×4, row-major
 * @param {number[][]} b four rows
 * @returns {number[]}
 */
function product(a, b) {
  return a.map((_, at) => b.reduce((sum, row, k) => sum + a[4 * Math.floor(at / 4) + k] * row[at % 4], 0));
}

/** @typedef {Pick<Figure, "pieces" | "spline" | "kinds">} Plan */

/** @type {Record<State["basis"], (points: Place[], degree: number, matrix: number[]) => Plan>} */
const PLANS = {
  bezier: (points, degree) => {
    const groups = groupsOf(points, degree);
    const used = groups.length * degree + 1;
    const spline = groups.length ? new Spline(points.slice(0, used), { degree, dimension: 2 }) : null;
    return { pieces: joined(spline?.segments() ?? [], groups), spline, kinds: kindsOf(points, groups, degree) };
  },
  hermite: byGroups,
  matrix: byGroups,
  "b-spline": (points, degree) => {
    const spline = points.length > degree ? Spline.fromBSpline(points, { degree, dimension: 2 }) : null;
    const pieces = joined(spline?.segments() ?? [], windows(points, degree));
    return { pieces, spline, kinds: points.map(() => (spline ? "off" : "wait")) };
  },
  "catmull-rom": (points, _, matrix) => {
    const pieces = windows(points, 3).map((indices) => piece(points, indices, matrix));
    const kind = (/** @type {number} */ i) => (i > 0 && i < points.length - 1 ? "on" : "off");
    return { pieces, spline: chain(pieces), kinds: points.map((_, i) => (pieces.length ? kind(i) : "wait")) };
  },
  natural: (points) => through(points, "natural"),
  centripetal: (points) => through(points, "catmull-rom"),
};

/**
 * Groups of four points that share ends, blended by a matrix.
 *
 * @param {Place[]} points
 * @param {number} _
 * @param {number[]} matrix
 * @returns {Plan}
 */
function byGroups(points, _, matrix) {
  const groups = groupsOf(points, 3);
  const pieces = groups.map((indices) => piece(points, indices, matrix));
  return { pieces, spline: chain(pieces), kinds: kindsOf(points, groups, 3) };
}

/**
 * @param {Place[]} points
 * @param {"natural" | "catmull-rom"} kind
 * @returns {Plan}
 */
function through(points, kind) {
  const spline = points.length > 1 ? Spline.interpolate(points, { kind, dimension: 2 }) : null;
  const near = (/** @type {number} */ k) =>
    points.map((_, i) => i).filter((i) => kind === "natural" || (i >= k - 1 && i <= k + 2));
  const pieces = (spline?.segments() ?? []).map((curve, k) => ({ curve, indices: near(k) }));
  return { pieces, spline, kinds: points.map(() => "on") };
}

/**
 * @param {Place[]} points
 * @param {number[]} indices
 * @param {number[]} matrix
 * @returns {Piece}
 */
function piece(points, indices, matrix) {
  return {
    curve: Curve.fromBasis(
      matrix,
      indices.map((i) => points[i]),
      { dimension: 2 },
    ),
    indices,
  };
}

/**
 * @param {Curve[]} curves
 * @param {number[][]} groups
 * @returns {Piece[]}
 */
function joined(curves, groups) {
  return curves.map((curve, k) => ({ curve, indices: groups[k] }));
}

/**
 * The groups of degree + 1 points that share ends.
 *
 * @param {readonly Place[]} points
 * @param {number} degree
 * @returns {number[][]}
 */
function groupsOf(points, degree) {
  const count = Math.max(0, Math.floor((points.length - 1) / degree));
  return Array.from({ length: count }, (_, k) => Array.from({ length: degree + 1 }, (_, i) => k * degree + i));
}

/**
 * All runs of degree + 1 points.
 *
 * @param {readonly Place[]} points
 * @param {number} degree
 * @returns {number[][]}
 */
function windows(points, degree) {
  return Array.from({ length: Math.max(0, points.length - degree) }, (_, k) =>
    Array.from({ length: degree + 1 }, (_, i) => k + i),
  );
}

/**
 * @param {readonly Place[]} points
 * @param {number[][]} groups
 * @param {number} degree
 * @returns {Figure["kinds"]}
 */
function kindsOf(points, groups, degree) {
  const used = groups.length ? groups.length * degree + 1 : 0;
  return points.map((_, i) => (i >= used ? "wait" : i % degree === 0 ? "on" : "off"));
}

/** Ends that differ by rounding alone meet: so much of the picture's size. */
const ROUNDING = 1e-9;

/**
 * @param {Piece[]} pieces cubics
 * @returns {Spline | null} null where they do not meet
 */
function chain(pieces) {
  const flat = pieces.map(({ curve }) => curve.controlPoints());
  const size = Math.max(1, ...flat.flatMap((numbers) => [...numbers].map(Math.abs)));
  const meet = flat.every(
    (next, k) => k === 0 || Math.hypot(next[0] - flat[k - 1][6], next[1] - flat[k - 1][7]) <= ROUNDING * size,
  );
  if (!flat.length || !meet) return null;
  return new Spline(
    flat.flatMap((numbers, k) => [...(k === 0 ? numbers : numbers.subarray(2))]),
    { dimension: 2 },
  );
}

const SUBSCRIPTS = "₀₁₂₃₄₅₆₇₈₉";

/**
 * What a point is called.
 *
 * @param {Labels} labels
 * @param {number} index
 * @returns {string}
 */
export function nameOf(labels, index) {
  if (labels === "P1") return `P${index + 1}`;
  if (labels === "b0") return `b${[...String(index)].map((digit) => SUBSCRIPTS[Number(digit)]).join("")}`;
  return labels === "p0" ? `p${index}` : `P${index}`;
}
