// How curves, splines, paths, patches and surfaces of one copy of this package are recognised by another copy: each entry point
// is a bundle with its own classes, so that `instanceof` does not answer that question. All of them have the two members
// of `Branded`, whose names are strings because bundlers keep an unused class that has a computed name.
import { describe, EMPTY } from "./describe.js";

/**
 * The data of a spline: its control points (joints once), the degree of each segment, whether it is closed.
 *
 * @internal
 */
export type SplineData = { flat: Float64Array; dimension: 2 | 3; degrees: readonly number[]; closed: boolean };

/**
 * Control points: the data of a curve, whose degree is one less than their number.
 *
 * @internal
 */
export type ControlPoints = Pick<SplineData, "flat" | "dimension">;

/**
 * The data of a patch: its net and its degrees.
 *
 * @internal
 */
export type PatchData = { flat: Float64Array; degreeU: number; degreeV: number };

/**
 * The data of a rational curve: its control points and their weights.
 *
 * @internal
 */
export type RationalData = { flat: Float64Array; dimension: 2 | 3; weights: Float64Array };

/**
 * The data of a NURBS curve: its control points, their weights, and its knots.
 *
 * @internal
 */
export type NurbsData = RationalData & { degree: number; knots: Float64Array; closed: boolean };

/**
 * The data of a rational patch: its net, the weights and its degrees.
 *
 * @internal
 */
export type RationalPatchData = PatchData & { weights: Float64Array };

/**
 * The data of a NURBS surface: as of a patch, and its knots.
 *
 * @internal
 */
export type NurbsSurfaceData = RationalPatchData & { knotsU: Float64Array; knotsV: Float64Array };

/**
 * The nets of a surface: the vertices; for each vertex the index of the first one that had the same position when the
 * surface was created (`joined`); two degrees for each patch; the vertex indices of all nets, one net after the other.
 *
 * @internal
 */
export type Network = { vertices: Float64Array; joined: Float64Array; degrees: number[]; indices: Uint32Array };

/**
 * The data of a surface of rational patches: that of a surface, and a weight for each index.
 *
 * @internal
 */
export type RationalSurfaceData = Network & { weights: Float64Array };

/**
 * The values of `casteljauType`, one for each class.
 *
 * @internal
 */
export type BrandedType =
  | "curve"
  | "rationalcurve"
  | "nurbscurve"
  | "spline"
  | "path"
  | "patch"
  | "rationalpatch"
  | "nurbssurface"
  | "surface"
  | "rationalsurface"
  | "mesh";

/**
 * What all instances have: the name of their class, and their data.
 *
 * @internal
 */
export type Branded<T> = { readonly casteljauType: BrandedType; casteljauData(): T };

/**
 * The type of an object of this package, also of another bundle.
 *
 * @internal
 * @returns undefined for any other value
 */
export function typeOf(value: unknown): BrandedType | undefined {
  return (value as Partial<Branded<unknown>> | null | undefined)?.casteljauType;
}

/**
 * The data of a curve.
 *
 * @internal
 * @throws {TypeError} for anything but a curve
 */
export function curveData(value: unknown, name: string): SplineData {
  return dataOf(value, name, typeOf(value) === "curve", "a Curve");
}

/**
 * The data of a spline, or of a curve as a spline of one segment.
 *
 * @internal
 * @throws {TypeError} for anything else
 */
export function splineData(value: unknown, name: string, expected = "a Curve or a Spline"): SplineData {
  const type = typeOf(value);
  return dataOf(value, name, type === "curve" || type === "spline", expected);
}

/**
 * The data of a rational curve.
 *
 * @internal
 * @throws {TypeError} for anything but a rational curve
 */
export function rationalData(value: unknown, name: string): RationalData {
  return dataOf(value, name, typeOf(value) === "rationalcurve", "a RationalCurve");
}

/**
 * The data of a NURBS curve.
 *
 * @internal
 * @throws {TypeError} for anything but a NURBS curve
 */
export function nurbsData(value: unknown, name: string): NurbsData {
  return dataOf(value, name, typeOf(value) === "nurbscurve", "a NurbsCurve");
}

/**
 * The data of a spline.
 *
 * @internal
 * @throws {TypeError} for anything but a spline
 */
export function onlySplineData(value: unknown, name: string): SplineData {
  return dataOf(value, name, typeOf(value) === "spline", "a Spline");
}

/**
 * The packed path of a path.
 *
 * @internal
 * @returns see `packed-path.js`
 * @throws {TypeError} for anything but a path
 */
export function pathData(value: unknown, name: string): Float64Array {
  return dataOf(value, name, typeOf(value) === "path", "a Path");
}

/**
 * The data of a patch.
 *
 * @internal
 * @throws {TypeError} for anything but a patch
 */
export function patchData(value: unknown, name: string): PatchData {
  return dataOf(value, name, typeOf(value) === "patch", "a Patch");
}

/**
 * The data of a rational patch.
 *
 * @internal
 * @throws {TypeError} for anything but a rational patch
 */
export function rationalPatchData(value: unknown, name: string): RationalPatchData {
  return dataOf(value, name, typeOf(value) === "rationalpatch", "a RationalPatch");
}

/**
 * The data of a NURBS surface.
 *
 * @internal
 * @throws {TypeError} for anything but a NURBS surface
 */
export function nurbsSurfaceData(value: unknown, name: string): NurbsSurfaceData {
  return dataOf(value, name, typeOf(value) === "nurbssurface", "a NurbsSurface");
}

/**
 * The network of a surface.
 *
 * @internal
 * @throws {TypeError} for anything but a surface without weights
 */
export function surfaceData(value: unknown, name: string): Network {
  return dataOf(value, name, typeOf(value) === "surface", "a Surface");
}

/**
 * The network of a surface of rational patches.
 *
 * @internal
 * @throws {TypeError} for anything but a surface of rational patches
 */
export function rationalSurfaceData(value: unknown, name: string): RationalSurfaceData {
  return dataOf(value, name, typeOf(value) === "rationalsurface", "a RationalSurface");
}

/**
 * The packed path of a path.
 *
 * @internal
 * @returns undefined for any other value
 */
export function packedPath(value: unknown): Float64Array | undefined {
  return typeOf(value) === "path" ? (value as Branded<Float64Array>).casteljauData() : undefined;
}

/**
 * Checks what `fromJSON` gets.
 *
 * @internal
 * @param hasMembers whether an object has the members that are needed
 * @throws {TypeError} for anything but an object with these members
 */
export function requireJSON<T>(json: T, expected: string, hasMembers: (json: T & object) => boolean) {
  if (typeof json === "object" && json !== null && hasMembers(json)) return;
  throw new TypeError(`json: expected an object with ${expected}, got ${describeWithCloneHint(json)}`);
}

/** Describes what came instead of a value of this package or its JSON. */
function describeWithCloneHint(value: unknown): string {
  const text = describe(value);
  return text === EMPTY ? `${text}; structuredClone and postMessage need toJSON() and fromJSON()` : text;
}

function dataOf<T>(value: unknown, name: string, isExpected: boolean, expected: string): T {
  if (isExpected) return (value as Branded<T>).casteljauData();
  throw new TypeError(`${name}: expected ${expected}, got ${describeWithCloneHint(value)}`);
}
