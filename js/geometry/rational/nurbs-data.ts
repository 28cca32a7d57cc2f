// NURBS curves as data, in the arena and made of other shapes. This file imports no class.
import { curvesModule } from "../../wasm/curves-module.js";
import { nurbsData, rationalData, splineData, typeOf } from "../brand.js";
import type { NurbsData, RationalData, SplineData } from "../brand.js";

/**
 * Writes curves, and then further numbers, to the arena.
 *
 * @internal
 * @param module of which the arena is
 */
export function writeNurbs(curves: NurbsData[], further: ArrayLike<number> = [], module = curvesModule) {
  const parts = curves.flatMap(({ degree, closed, flat, weights, knots }) => [
    [degree, Number(closed), weights.length, knots.length],
    flat,
    weights,
    knots,
  ]);
  parts.push(further as Float64Array);
  const view = module.arena(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const numbers of parts) {
    view.set(numbers, at);
    at += numbers.length;
  }
}

/**
 * Reads a curve from the arena.
 *
 * @internal
 * @param end the index after it, negative if the core reported an error
 */
export function readNurbsData(end: number, dimension: 2 | 3, from = 0): NurbsData {
  return nurbsOfNumbers(curvesModule.read(from, end), dimension);
}

/**
 * The curve that numbers of the arena describe.
 *
 * @internal
 */
export function nurbsOfNumbers(numbers: Float64Array, dimension: 2 | 3): NurbsData {
  const [degree, closed, count] = numbers;
  const [weights, knots] = [4 + count * dimension, 4 + count * (dimension + 1)];
  return {
    degree,
    dimension,
    flat: numbers.slice(4, weights),
    weights: numbers.slice(weights, knots),
    knots: numbers.slice(knots),
    closed: closed === 1,
  };
}

/**
 * A rational curve as a NURBS curve of one span, over [0, 1].
 *
 * @internal
 */
export function nurbsOfRational({ flat, dimension, weights }: RationalData): NurbsData {
  const degree = weights.length - 1;
  const knots = new Float64Array(2 * degree + 2).fill(1, degree + 1);
  return { degree, flat, dimension, weights, knots, closed: false };
}

/**
 * A spline as an open NURBS curve with a span over [k, k + 1] for segment k.
 *
 * @internal
 */
export function nurbsOfSpline({ flat, dimension, degrees, closed }: SplineData): NurbsData {
  const head = Float64Array.of(degrees.length, Number(closed), ...degrees);
  curvesModule.write(head, flat.length).set(flat, head.length);
  return readNurbsData(curvesModule.functions.nurbs_from_spline(dimension), dimension);
}

/**
 * The data of a curve or a spline as a NURBS curve.
 *
 * @internal
 * @throws {TypeError} for any other value
 */
export function nurbsDataOf(shape: unknown, name: string, expected: string): NurbsData {
  const type = typeOf(shape);
  if (type === "nurbscurve") return nurbsData(shape, name);
  if (type === "rationalcurve") return nurbsOfRational(rationalData(shape, name));
  return nurbsOfSpline(splineData(shape, name, expected));
}

/**
 * Whether numbers are equal within a part of the largest one.
 *
 * @internal
 */
export function alike(a: Float64Array, b: Float64Array, tolerance: number): boolean {
  if (a.length !== b.length) return false;
  const largest = [...a, ...b].reduce((size, x) => Math.max(size, Math.abs(x)), 0);
  return a.every((x, i) => Math.abs(x - b[i]) <= tolerance * largest);
}
