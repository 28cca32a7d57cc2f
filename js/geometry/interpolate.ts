// Interpolating splines.
import { curvesModule } from "../wasm/curves-module.js";
import * as check from "./check.js";
import { flatten } from "./points.js";
import type { PointsLike } from "./check.js";

/**
 * The kind of interpolating spline: "natural", whose second derivatives are equal at all joints and zero at open ends,
 * or "catmull-rom", whose tangent at a point depends on the point and its two neighbours. `alpha` is the exponent of
 * the chord lengths of a Catmull-Rom spline: 0 uniform, ½ centripetal, 1 chordal.
 */
export interface InterpolateOptions {
  /** "natural" by default */
  kind?: "natural" | "catmull-rom";
  /** 0 to 1, by default ½ */
  alpha?: number;
  closed?: boolean;
  dimension?: 2 | 3;
}

const KINDS: readonly ("natural" | "catmull-rom")[] = ["natural", "catmull-rom"];

/**
 * Computes a spline through points and leaves it in the arena.
 *
 * @internal
 */
export function interpolate(points: PointsLike, options?: InterpolateOptions): { length: number; dimension: 2 | 3 } {
  const checked = check.options(options, ["kind", "alpha", "closed", "dimension"]);
  const { kind = "natural", alpha = 0.5, dimension: requested } = checked;
  check.oneOf(kind, "kind", KINDS);
  const closed = check.optionalBoolean(checked.closed, "closed");
  if (kind === "natural" && checked.alpha !== undefined) {
    throw new TypeError('alpha: expected kind "catmull-rom", which has an alpha, got "natural"');
  }
  const exponent = check.finite(alpha, "alpha");
  if (!(exponent >= 0 && exponent <= 1)) {
    throw new RangeError(`alpha: expected a number from 0 to 1, got ${exponent}`);
  }
  const { flat, dimension } = flatten(points, requested, 2);
  curvesModule.write(flat);
  const count = flat.length / dimension;
  return {
    length: curvesModule.functions.spline_interpolate(dimension, count, closed, kind === "natural" ? -1 : exponent),
    dimension,
  };
}
