// Intersections of curves, splines and paths, read from the arena.
import { curvesModule } from "../wasm/curves-module.js";
import { packedPath, splineData, typeOf } from "./brand.js";
import { require2D } from "./check.js";
import { packedShape, subpathsOf } from "./path/packed-shape.js";
import { packedSplines } from "../wasm/packed-path.js";
import type { SplineData } from "./brand.js";
import type { PathTime } from "./path/path-queries.js";
import type { Point } from "./points.js";

/**
 * An intersection of two shapes: t on the first, u on the second. Both are numbers for curves and splines, and locations
 * {subpath, t} for paths. At a "tangent" intersection, both have the same or opposite directions. An "overlap" is a
 * shared part from t and u to tEnd and uEnd; `point` is its start.
 */
export type Intersection<T = number, U = number> = PointIntersection<T, U> | OverlapIntersection<T, U>;

/** A single point where two shapes intersect. */
export interface PointIntersection<T = number, U = number> {
  /** The parameter on the first shape */
  t: T;
  /** The parameter on the second shape */
  u: U;
  point: Point;
  kind: "cross" | "tangent";
}

/** A part that two shapes share. */
export interface OverlapIntersection<T = number, U = number> {
  /** The start of the shared part on the first shape */
  t: T;
  /** Its start on the second shape */
  u: U;
  /** Its start */
  point: Point;
  kind: "overlap";
  /** The end of the shared part on the first shape */
  tEnd: T;
  /** Its end on the second shape, before `u` if the directions are opposite */
  uEnd: U;
}

/** An intersection of two paths, or of a path with itself. */
export type PathIntersection = Intersection<PathTime, PathTime>;

/** A point that a curve passes twice: at t and at u, t < u. */
export type SelfIntersection = { t: number; u: number; point: Point };

/** The numbers of an intersection: t, u, x, y, the kind, t and u of its end. */
const RECORD_LENGTH = 7;

/** Those of an intersection of paths: the same ones, then the subpath of the first path and that of the second. */
const PATH_RECORD_LENGTH = RECORD_LENGTH + 2;

/**
 * Reads intersections from the arena.
 *
 * @internal
 */
export function readIntersections(length: number): Intersection[] {
  const view = curvesModule.arena(length);
  const intersections: Intersection[] = [];
  for (let i = 0; i < length; i += RECORD_LENGTH) {
    const t = view[i];
    const u = view[i + 1];
    const point = { x: view[i + 2], y: view[i + 3] };
    const kind = view[i + 4];
    if (kind === 2) intersections.push({ t, u, point, kind: "overlap", tEnd: view[i + 5], uEnd: view[i + 6] });
    else intersections.push({ t, u, point, kind: kind === 1 ? "tangent" : "cross" });
  }
  curvesModule.release();
  return intersections;
}

/**
 * Reads the intersections of a shape with itself from the arena.
 *
 * @internal
 */
export function readSelfIntersections(length: number): SelfIntersection[] {
  return readIntersections(length).map(({ t, u, point }) => ({ t, u, point }));
}

/**
 * Whether a value is one of `casteljau/nurbs`. It finds its intersections with a 2D spline itself, t on the spline, so that
 * `casteljau` does not contain their code.
 */
function isRational(value: unknown): value is { casteljauIntersections(spline: SplineData): Intersection[] } {
  const type = typeOf(value);
  return type === "rationalcurve" || type === "nurbscurve";
}

/**
 * The intersections of a 2D spline with a curve, a spline, a path or a value of `casteljau/nurbs`.
 *
 * @internal
 * @throws {TypeError} for any other value, and for a 3D one
 */
export function intersectSplines(spline: SplineData, other: unknown): Intersection<number, number | PathTime>[] {
  if (isRational(other)) return other.casteljauIntersections(spline);
  const packed = packedPath(other);
  if (packed) return intersectPacked(packedSplines([spline]), packed, timeOnSpline, timeOnPath);
  const data = splineData(other, "other", "a Curve, a Spline or a Path");
  require2D("intersections", typeOf(other) as string, data.dimension);
  writeSplines([spline, data]);
  return readIntersections(curvesModule.functions.spline_intersect());
}

/**
 * The points that a spline passes twice.
 *
 * @internal
 */
export function selfIntersectSpline(spline: SplineData): SelfIntersection[] {
  writeSplines([spline]);
  return readSelfIntersections(curvesModule.functions.spline_self_intersections());
}

/**
 * The intersections of a packed path with a curve, a spline, a path or a value of `casteljau/nurbs`.
 *
 * @internal
 * @throws {TypeError} for any other value, and for a 3D one
 */
export function intersectPathWith(packed: Float64Array, other: unknown): Intersection<PathTime, number | PathTime>[] {
  if (isRational(other)) {
    return subpathsOf(packed).flatMap((spline, subpath) =>
      withPathTimes(other.casteljauIntersections(spline), "t", subpath),
    ) as any;
  }
  const otherPacked = packedShape(other, "other");
  if (typeOf(other) === "path") return intersectPacked(packed, otherPacked, timeOnPath, timeOnPath);
  return intersectPacked(packed, otherPacked, timeOnPath, timeOnSpline);
}

/**
 * The points that a path passes twice.
 *
 * @internal
 */
export function selfIntersectPath(packed: Float64Array): PathIntersection[] {
  curvesModule.write(packed);
  return readPathIntersections(curvesModule.functions.path_intersect(false), timeOnPath, timeOnPath);
}

/**
 * Intersections of a subpath with t or u as a location on its path.
 *
 * @internal
 */
export function withPathTimes(found: Intersection[], name: "t" | "u", subpath: number): Intersection<any, any>[] {
  return found.map((intersection: Record<string, any>) => {
    const located = { ...intersection };
    for (const key of [name, `${name}End`]) if (key in located) located[key] = { subpath, t: located[key] };
    return located as Intersection<any, any>;
  });
}

function timeOnPath(subpath: number, t: number): PathTime {
  return { subpath, t };
}

/**
 * @param _ the subpath of a path with one subpath
 */
function timeOnSpline(_: number, t: number) {
  return t;
}

/**
 * @param a a packed path
 * @param b a packed path
 */
function intersectPacked<T, U>(
  a: Float64Array,
  b: Float64Array,
  timeOnA: (subpath: number, t: number) => T,
  timeOnB: (subpath: number, t: number) => U,
): Intersection<T, U>[] {
  curvesModule.write(a, b.length).set(b, a.length);
  return readPathIntersections(curvesModule.functions.path_intersect(true), timeOnA, timeOnB);
}

function readPathIntersections<T, U>(
  length: number,
  timeOnA: (subpath: number, t: number) => T,
  timeOnB: (subpath: number, t: number) => U,
): Intersection<T, U>[] {
  const numbers = curvesModule.read(0, length);
  curvesModule.release();
  return Array.from({ length: length / PATH_RECORD_LENGTH }, (_, k) => {
    const record = numbers.subarray(PATH_RECORD_LENGTH * k, PATH_RECORD_LENGTH * (k + 1));
    const [t, u, x, y, kind, tEnd, uEnd, a, b] = record;
    const shared = { t: timeOnA(a, t), u: timeOnB(b, u), point: { x, y } };
    return kind === 2
      ? { ...shared, kind: "overlap", tEnd: timeOnA(a, tEnd), uEnd: timeOnB(b, uEnd) }
      : { ...shared, kind: kind === 1 ? "tangent" : "cross" };
  });
}

function writeSplines(splines: SplineData[]) {
  const length = splines.reduce((sum, { flat, degrees }) => sum + 2 + degrees.length + flat.length, 0);
  const view = curvesModule.write(new Float64Array(0), length);
  let at = 0;
  for (const { flat, degrees, closed } of splines) {
    view[at] = degrees.length;
    view[at + 1] = closed ? 1 : 0;
    view.set(degrees, at + 2);
    view.set(flat, at + 2 + degrees.length);
    at += 2 + degrees.length + flat.length;
  }
}
