// Curves as arguments of surfaces: the sections of a loft, the profile of a surface of revolution. This file imports no class.
import * as check from "../check.js";
import { surfacesModule } from "../../wasm/surfaces-module.js";
import { writePoint } from "../points.js";
import { nurbsDataOf, writeNurbs } from "./nurbs-data.js";
import type { NurbsData } from "../brand.js";
import type { PointLike } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { CoreSpline } from "../spline/core-spline.js";
import type { NurbsCurve } from "./nurbs-curve.js";
import type { RationalCurve } from "./rational-curve.js";

/** A curve of the plane (which lies in z = 0) or of space. */
export type SectionLike = NurbsCurve | RationalCurve | CoreCurve | CoreSpline;

/** How a profile turns around an axis. */
export interface TurningOptions {
  /** A point of the axis, by default [0, 0, 0] */
  origin?: PointLike;
  /** The direction of the axis, of any length above 0, by default [0, 0, 1] */
  axis?: PointLike;
  /** In radians, by default a full turn */
  angle?: number;
}

const SECTION = "a Curve, a RationalCurve, a NurbsCurve or a Spline";

/**
 * The data of a curve as a NURBS curve in space.
 *
 * @internal
 */
export function section(curve: SectionLike, name: string): NurbsData {
  const data = nurbsDataOf(curve, name, SECTION);
  if (data.dimension === 3) return data;
  const flat = new Float64Array(3 * data.weights.length);
  for (let k = 0; k < data.weights.length; k++) flat.set(data.flat.subarray(2 * k, 2 * k + 2), 3 * k);
  return { ...data, flat, dimension: 3 };
}

/**
 * Writes curves, and then further numbers, to the arena of the module of surfaces.
 *
 * @internal
 */
export function writeCurves(curves: NurbsData[], further?: Float64Array) {
  writeNurbs(curves, further, surfacesModule);
}

/**
 * The coordinates of points in space, checked.
 *
 * @internal
 */
export function pointsOf(...named: [PointLike, string][]): Float64Array {
  const flat = new Float64Array(3 * named.length);
  named.forEach(([point, name], k) => writePoint(flat, 3 * k, point, 3, name));
  return flat;
}

/**
 * Writes a profile, the origin and the axis; returns the angle.
 *
 * @internal
 */
export function writeTurning(profile: SectionLike, options?: TurningOptions): number {
  const data = section(profile, "profile");
  const {
    origin = [0, 0, 0],
    axis = [0, 0, 1],
    angle = 2 * Math.PI,
  } = check.options(options, ["origin", "axis", "angle"]);
  check.finite(angle, "angle");
  writeCurves([data], pointsOf([origin, "origin"], [axis, "axis"]));
  return angle;
}
