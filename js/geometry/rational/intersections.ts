// Intersections of rational and NURBS curves with all shapes of the plane.
import { curvesModule } from "../../wasm/curves-module.js";
import { packedPath, typeOf } from "../brand.js";
import { require2D } from "../check.js";
import { readIntersections, readSelfIntersections, withPathTimes } from "../intersections.js";
import { subpathsOf } from "../path/packed-shape.js";
import { nurbsDataOf, nurbsOfSpline, writeNurbs } from "./nurbs-data.js";
import type { NurbsData, SplineData } from "../brand.js";
import type { Intersection, SelfIntersection } from "../intersections.js";
import type { PathTime } from "../path/path-queries.js";

/**
 * The intersections of a curve with any other shape.
 *
 * @internal
 * @throws {TypeError} for any other value, and for a 3D one
 */
export function intersectNurbs(curve: NurbsData, other: unknown): Intersection<number, number | PathTime>[] {
  require2D("intersections", "curve", curve.dimension);
  const packed = packedPath(other);
  if (packed) {
    return subpathsOf(packed).flatMap((spline, subpath) =>
      withPathTimes(intersectPair(curve, nurbsOfSpline(spline)), "u", subpath),
    );
  }
  const data = nurbsDataOf(other, "other", "a Curve, a RationalCurve, a NurbsCurve, a Spline or a Path");
  require2D("intersections", typeOf(other) === "spline" ? "spline" : "curve", data.dimension);
  return intersectPair(curve, data);
}

/**
 * The intersections of a 2D spline with a curve; t is on the spline.
 *
 * @internal
 */
export function intersectSplineWithNurbs(spline: SplineData, curve: NurbsData): Intersection[] {
  require2D("intersections", "curve", curve.dimension);
  return intersectPair(nurbsOfSpline(spline), curve);
}

/**
 * The points that a curve passes twice.
 *
 * @internal
 */
export function selfIntersectNurbs(curve: NurbsData): SelfIntersection[] {
  require2D("selfIntersections", "curve", curve.dimension);
  writeNurbs([curve]);
  return readSelfIntersections(curvesModule.count(curvesModule.functions.nurbs_self_intersections()));
}

function intersectPair(a: NurbsData, b: NurbsData): Intersection[] {
  writeNurbs([a, b]);
  return readIntersections(curvesModule.count(curvesModule.functions.nurbs_intersect()));
}
