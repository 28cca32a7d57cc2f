// Compiled by tests/js/types.test.js: TypeScript knows the dimension of curves and splines.
import { Curve, Path, Spline } from "casteljau";
import * as core from "casteljau/core";
import {
  type Mesh,
  NurbsCurve,
  NurbsSurface,
  RationalCurve,
  type RationalPatch,
  RationalSurface,
} from "casteljau/nurbs";

type Same<A, B> = (<T>() => T extends A ? 1 : 2) extends <T>() => T extends B ? 1 : 2 ? true : false;
const expectTrue = <_T extends true>(): void => {};

const inPlane = new Curve([
  [0, 0],
  [1, 1],
]);
const inSpace = new Curve([
  [0, 0, 0],
  [1, 1, 1],
]);
expectTrue<Same<typeof inPlane, Curve<2>>>();
expectTrue<Same<typeof inSpace, Curve<3>>>();

// Points of a known dimension.
type Plane = { x: number; y: number };
type Space = { x: number; y: number; z: number };
expectTrue<Same<ReturnType<typeof inPlane.eval>, Plane>>();
expectTrue<Same<ReturnType<typeof inSpace.eval>, Space>>();
export const z: number =
  inSpace.pointAtLength(1).tangent.z + inSpace.nearest([0, 0, 0]).point.z + inSpace.bounds().max.z;
export const parts: [Curve<3>, Curve<3>] = inSpace.split(0.5);
export const several: Curve<3>[] = inSpace.split([0.2, 0.7]);
export const derivative: Space = inSpace.derivative().derivativeAt(0, 1);
export const offset: Spline<2> = inPlane.offset(1);
export const plain: 2 = inPlane.dimension;
// @ts-expect-error: no z in the plane
inPlane.eval(0).z;

// What decides: the length of arrays, the option, the type argument; otherwise nothing does.
const unknown: number[][] = [];
const byOption = new Curve(new Float64Array(6), { dimension: 3 });
const byArgument = new Curve<2>(unknown);
const byTuples = new Curve([[0, 0] as const, [1, 1] as const]);
const undecided = new Curve(unknown);
expectTrue<Same<typeof byOption, Curve<3>>>();
expectTrue<Same<typeof byArgument, Curve<2>>>();
expectTrue<Same<typeof byTuples, Curve<2>>>();
expectTrue<Same<typeof undecided, Curve>>();
expectTrue<Same<ReturnType<typeof undecided.eval>, { x: number; y: number; z?: number }>>();
export const objects: Curve = new Curve([
  { x: 0, y: 0 },
  { x: 1, y: 1 },
]);

// A curve of a known dimension is a curve, but not one of the other dimension.
export const curves: Curve[] = [inPlane, inSpace];
// @ts-expect-error: 2D instead of 3D
export const wrong: Curve<3> = inPlane;
export const along = <D extends 2 | 3>(curve: Curve<D>): number => curve.eval(0.5).x;
export const sum: number = along(inPlane) + along(inSpace) + along(undecided);

// Rational curves.
const arc = new RationalCurve(
  [
    [1, 0],
    [1, 1],
    [0, 1],
  ],
  [1, Math.SQRT1_2, 1],
);
expectTrue<Same<typeof arc, RationalCurve<2>>>();
expectTrue<Same<ReturnType<typeof arc.eval>, Plane>>();
expectTrue<Same<ReturnType<typeof NurbsCurve.circle>, NurbsCurve<2>>>();
const helix = new NurbsCurve({
  degree: 1,
  points: [
    [0, 0, 0],
    [1, 1, 1],
  ],
  knots: [0, 0, 1, 1],
});
expectTrue<Same<typeof helix, NurbsCurve<3>>>();
export const spaceParts: RationalCurve<3>[] = helix.segments();
export const rationalZ: number = helix.eval(0.5).z + RationalCurve.from(inSpace).nearest([0, 0, 0]).point.z;
export const planeSpline: { dimension: 2 } = arc.toSpline({ tolerance: 0.1 });
// @ts-expect-error: no z in the plane
arc.eval(0).z;
// Surfaces with weights.
const ball = NurbsSurface.sphere([0, 0, 0], 1);
expectTrue<Same<ReturnType<typeof ball.isocurveAtU>, NurbsCurve<3>>>();
export const patchesOfBall: RationalPatch[] = ball.patches();
export const meshOfBall: Mesh = ball.toSurface().tessellate({ tolerance: 0.1 });
export const vase: NurbsSurface = NurbsSurface.revolve(inSpace, { axis: [0, 0, 1], angle: 1 });
export const solid: RationalSurface = RationalSurface.solidOfRevolution(inSpace, { angle: 1 });
// @ts-expect-error: a surface needs knots in both directions
export const noKnots = new NurbsSurface({ degreeU: 1, degreeV: 1, points: [[0, 0, 0]] });
// @ts-expect-error: a grid of a surface with weights has one method
ball.toSurface().grid({ segments: 4, method: "bernstein" });

// @ts-expect-error: a curve has no weights
export const noWeights: RationalCurve<2> = inPlane;

// Splines and static functions.
const spline = new Spline([
  [0, 0],
  [1, 0],
  [2, 0],
  [3, 0],
]);
expectTrue<Same<typeof spline, Spline<2>>>();
const spaceSpline = Spline.fromCurves([inSpace]);
expectTrue<Same<typeof spaceSpline, Spline<3>>>();
expectTrue<Same<ReturnType<typeof spaceSpline.segments>, Curve<3>[]>>();
const through = Spline.interpolate([
  [0, 0, 0],
  [1, 2, 3],
]);
expectTrue<Same<typeof through, Spline<3>>>();
const interpolated = Curve.interpolate([
  [0, 0],
  [1, 2],
]);
expectTrue<Same<typeof interpolated, Curve<2>>>();
const catmullRom = Curve.fromBasis("catmull-rom", new Float64Array(12), { dimension: 3 });
expectTrue<Same<typeof catmullRom, Curve<3>>>();
export const directions: Plane[] = [spline.eval(0.5), spline.tangent(0), spline.normal(0), spline.derivativeAt(0, 2)];
export const halves: [Spline<2>, Spline<2>] = spline.split(0.5);
export const part: Spline<2> = spline.subsegment(0.2, 0.1);
export const depth: number = spaceSpline.pointAtLength(1).point.z + spaceSpline.torsion(0.5);
export const splines: Spline[] = [spline, spaceSpline];
// @ts-expect-error: no z in the plane
spline.tangent(0).z;

// Subpaths are in the plane.
const path = Path.fromSVG("M0 0H1");
const [subpath] = path.subpaths;
expectTrue<Same<typeof subpath, Spline<2>>>();
export const moved: Spline<2> = path.subpaths[0].movePoint(0, [0, 0]);

// Arcs in SVG text have a distance of their own.
export const withArcs: string[] = [path.toSVG({ arcs: 0.1, precision: 2 }), path.toSVG({ arcs: true, tolerance: 0.1 })];
// @ts-expect-error: contradictory options
path.toSVG({ arcs: 0.1, tolerance: 0.01 });
// @ts-expect-error: casteljau/core cannot do this
core.Path.fromSVG("M0 0H1").toSVG({ arcs: 0.1 });

// The classes of casteljau/core have the same types, and are accepted by the other classes.
const coreCurve = new core.Curve([
  [0, 0],
  [1, 1],
]);
const coreSpline = core.Spline.fromCurves([new core.Curve(new Float64Array(6), { dimension: 3 })]);
expectTrue<Same<typeof coreCurve, core.Curve<2>>>();
expectTrue<Same<typeof coreSpline, core.Spline<3>>>();
const [coreSubpath] = core.Path.fromSVG("M0 0H1").subpaths;
expectTrue<Same<typeof coreSubpath, core.Spline<2>>>();
// @ts-expect-error: casteljau/core cannot do this
coreCurve.offset(1);
export const corePart: core.Spline<3> = coreSpline.split(0.5)[0];
export const corePoints: Plane[] = [coreCurve.eval(0), coreCurve.tangent(0)];
export const meetings: number = inPlane.intersections(coreCurve).length;

// @ts-expect-error: a curve is made of points
new Curve(7);
// @ts-expect-error: there are two dimensions to choose from
new Curve([0, 0, 1, 1], { dimension: 4 });
