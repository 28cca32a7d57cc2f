// The curves that the points mean: pieces in Bézier form, for every basis and degree.
import { Curve } from "../geometry/curve/curve.js";
import { Spline } from "../geometry/spline/spline.js";
import { MAX_DEGREE, weightsOf } from "./state.js";
import type { RationalCurve } from "../nurbs.js";
import type { State } from "./state.js";
import type { Point2 } from "./state.js";
import type { Labels } from "./state.js";

export interface Piece {
  /** In Bézier form */
  curve: Curve;
  /** The points that it is made of */
  indices: number[];
}

export interface RationalPiece {
  curve: RationalCurve<2>;
  /** The points that it is made of */
  indices: number[];
}

export interface Figure {
  /** The shown ones */
  points: readonly Point2[];
  pieces: Piece[];
  /** Of points with weights, which have no other pieces; none before the code for weights is loaded */
  rational: RationalPiece[];
  /** Of the shown points; null for curves without weights */
  weights: readonly number[] | null;
  /** The pieces as one chain; null where they do not meet, or there are none */
  spline: Spline | null;
  /** Of the points, in the notation that is set */
  names: string[];
  /** Of the points: on the curve, off it, or waiting for more to come */
  kinds: ("on" | "off" | "wait")[];
  /** Of the pieces */
  degree: number;
  /** 16 numbers M, row-major, so that each piece is [t³ t² t 1]·M·P with its four points; else null */
  matrix: number[] | null;
}

/** Hermite's form asks for two tangent vectors: here they are P1 − P0 and P3 − P2. */
const TANGENTS = [
  [1, 0, 0, 0],
  [0, 0, 0, 1],
  [-1, 1, 0, 0],
  [0, 0, -1, 1],
];

/** @param Rational the class of curves with weights, once it is loaded */
export function figureOf(state: State, Rational: typeof RationalCurve | null = null): Figure {
  const points = state.points.slice(0, state.shown);
  const degree = degreeOf(state);
  const weights = weightsOf(state)?.slice(0, state.shown) ?? null;
  const names = points.map((_, i) => nameOf(state.labels, i));
  if (weights) {
    const groups = groupsOf(points, degree);
    const kinds = kindsOf(points, groups, degree);
    const rational = Rational ? rationalPieces(Rational, points, weights, groups) : [];
    return { points, pieces: [], rational, weights, spline: null, kinds, names, degree, matrix: null };
  }
  const matrix = matrixOf(state, degree);
  const { pieces, spline, kinds } = PLANS[state.basis](points, degree, matrix ?? [], state.points);
  return { points, pieces, rational: [], weights, spline, kinds, names, degree, matrix };
}

/** The figure of Bézier curves without weights, without code for other bases. */
export function bezierFigure(state: State): Figure {
  const points = state.points.slice(0, state.shown);
  const degree = degreeOf(state);
  const names = points.map((_, i) => nameOf(state.labels, i));
  return {
    points,
    ...bezierPlan(points, degree, state.points),
    rational: [],
    weights: null,
    names,
    degree,
    matrix: null,
  };
}

function rationalPieces(
  Rational: typeof RationalCurve,
  points: readonly Point2[],
  weights: readonly number[],
  groups: number[][],
): RationalPiece[] {
  return groups.map((indices) => {
    const own = indices.map((i) => weights[i]);
    return {
      curve: new Rational(
        indices.map((i) => points[i]),
        own,
        { dimension: 2 },
      ) as RationalCurve<2>,
      indices,
    };
  });
}

/** The degree of the pieces. */
export function degreeOf({ basis, degree, shown }: Pick<State, "basis" | "degree" | "shown">): number {
  if (basis !== "bezier" && basis !== "b-spline") return 3;
  return degree === "n" ? Math.min(Math.max(shown - 1, 1), MAX_DEGREE) : degree;
}

function matrixOf({ basis, matrix }: State, degree: number): number[] | null {
  if (basis === "matrix") return [...matrix];
  if (degree !== 3 || basis === "natural" || basis === "centripetal") return null;
  const numbers = [...Curve.basisMatrix(basis)];
  return basis === "hermite" ? product(numbers, TANGENTS) : numbers;
}

/**
 * @param a 4×4, row-major
 * @param b four rows
 */
function product(a: number[], b: number[][]): number[] {
  return a.map((_, at) => b.reduce((sum, row, k) => sum + a[4 * Math.floor(at / 4) + k] * row[at % 4], 0));
}

export type Plan = Pick<Figure, "pieces" | "spline" | "kinds">;

/** The last spline of each list of points, and its degree. */
const splines: WeakMap<readonly Point2[], { spline: Spline; degree: number }> = new WeakMap();

/** Keeps the spline from which a list of points comes: neither the figure nor the next change makes it again. */
export function keepSpline(points: readonly Point2[], spline: Spline, degree: number) {
  splines.set(points, { spline, degree });
}

/**
 * The spline of the first segments of a list of points.
 *
 * @param count the number of segments, at least 1
 */
export function splineOf(points: readonly Point2[], degree: number, count: number): Spline {
  const known = splines.get(points);
  if (known?.degree === degree && known.spline.segmentCount === count) return known.spline;
  const spline = new Spline(points.slice(0, count * degree + 1), { degree, dimension: 2 });
  keepSpline(points, spline, degree);
  return spline;
}

const PLANS: Record<
  State["basis"],
  (points: Point2[], degree: number, matrix: number[], all: readonly Point2[]) => Plan
> = {
  bezier: (points, degree, _, all) => bezierPlan(points, degree, all),
  hermite: byGroups,
  matrix: byGroups,
  "b-spline": (points, degree) => {
    const spline = points.length > degree ? Spline.fromBSpline(points, { degree, dimension: 2 }) : null;
    const pieces = joined(spline?.segments() ?? [], windows(points, degree));
    return { pieces, spline, kinds: points.map(() => (spline ? "off" : "wait")) };
  },
  "catmull-rom": (points, _, matrix) => {
    const pieces = windows(points, 3).map((indices) => piece(points, indices, matrix));
    const kind = (i: number) => (i > 0 && i < points.length - 1 ? "on" : "off");
    return { pieces, spline: chain(pieces), kinds: points.map((_, i) => (pieces.length ? kind(i) : "wait")) };
  },
  natural: (points) => through(points, "natural"),
  centripetal: (points) => through(points, "catmull-rom"),
};

function bezierPlan(points: readonly Point2[], degree: number, all: readonly Point2[]): Plan {
  const groups = groupsOf(points, degree);
  const spline = groups.length ? splineOf(all, degree, groups.length) : null;
  return { pieces: joined(spline?.segments() ?? [], groups), spline, kinds: kindsOf(points, groups, degree) };
}

/** Groups of four points that share ends, blended by a matrix. */
function byGroups(points: Point2[], _: number, matrix: number[]): Plan {
  const groups = groupsOf(points, 3);
  const pieces = groups.map((indices) => piece(points, indices, matrix));
  return { pieces, spline: chain(pieces), kinds: kindsOf(points, groups, 3) };
}

function through(points: Point2[], kind: "natural" | "catmull-rom"): Plan {
  const spline = points.length > 1 ? Spline.interpolate(points, { kind, dimension: 2 }) : null;
  const near = (k: number) => points.map((_, i) => i).filter((i) => kind === "natural" || (i >= k - 1 && i <= k + 2));
  const pieces = (spline?.segments() ?? []).map((curve, k) => ({ curve, indices: near(k) }));
  return { pieces, spline, kinds: points.map(() => "on") };
}

function piece(points: Point2[], indices: number[], matrix: number[]): Piece {
  return {
    curve: Curve.fromBasis(
      matrix,
      indices.map((i) => points[i]),
      { dimension: 2 },
    ),
    indices,
  };
}

function joined(curves: Curve[], groups: number[][]): Piece[] {
  return curves.map((curve, k) => ({ curve, indices: groups[k] }));
}

/** The groups of degree + 1 points that share ends. */
function groupsOf(points: readonly Point2[], degree: number): number[][] {
  const count = Math.max(0, Math.floor((points.length - 1) / degree));
  return Array.from({ length: count }, (_, k) => Array.from({ length: degree + 1 }, (_, i) => k * degree + i));
}

/** All runs of degree + 1 points. */
function windows(points: readonly Point2[], degree: number): number[][] {
  return Array.from({ length: Math.max(0, points.length - degree) }, (_, k) =>
    Array.from({ length: degree + 1 }, (_, i) => k + i),
  );
}

function kindsOf(points: readonly Point2[], groups: number[][], degree: number): Figure["kinds"] {
  const used = groups.length ? groups.length * degree + 1 : 0;
  return points.map((_, i) => (i >= used ? "wait" : i % degree === 0 ? "on" : "off"));
}

/** Ends that differ by rounding alone meet: so much of the picture's size. */
const ROUNDING = 1e-9;

/**
 * @param pieces cubics
 * @returns null where they do not meet
 */
function chain(pieces: Piece[]): Spline | null {
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

export type Continuity = ReturnType<Spline["continuity"]>;

/**
 * What holds at each inner joint.
 *
 * @returns none where there is no chain
 */
export function continuityOf({ spline }: Figure): Continuity[] {
  return spline ? Array.from({ length: spline.segmentCount - 1 }, (_, k) => spline.continuity(k + 1)) : [];
}

const SUBSCRIPTS = "₀₁₂₃₄₅₆₇₈₉";

/** What a point is called. */
export function nameOf(labels: Labels, index: number): string {
  if (labels === "P1") return `P${index + 1}`;
  if (labels === "b0") return `b${[...String(index)].map((digit) => SUBSCRIPTS[Number(digit)]).join("")}`;
  return labels === "p0" ? `p${index}` : `P${index}`;
}
