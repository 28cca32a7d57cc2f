// Every type of a public signature can be imported by name, and calls with mistakes are type errors.
import { Curve, type Mesh, Patch, Path, Spline, Surface } from "casteljau";
import type {
  BasisLike,
  BasisName,
  BSpline,
  BSplineOptions,
  Continuity,
  Curvature,
  CurveJSON,
  CurveKind,
  Detail,
  Distance,
  EdgeUse,
  Extrema,
  FillRule,
  FlatPiece,
  FrameOptions,
  Frames,
  GridOptions,
  InterpolateOptions,
  Intersection,
  JointMode,
  MatrixLike,
  MeshOptions,
  Moments,
  Nearest,
  NetLike,
  OverlapIntersection,
  Partials,
  PatchDeCasteljau,
  PatchJSON,
  PatchPoint,
  PatchRange,
  PathIntersection,
  PathPoint,
  PathTime,
  PixelDetail,
  Point,
  PathSvgOptions,
  PointIntersection,
  PointLike,
  PointsLike,
  Reduced,
  SegmentDetail,
  SelfIntersection,
  SplineJSON,
  SplineOptions,
  Subdivision,
  SurfaceJSON,
  SurfacePoint,
  SvgError,
  SvgOptions,
  TeapotOptions,
  TessellationOptions,
  Three,
  ToleranceDetail,
  Topology,
  WasmSource,
  WireframeOptions,
} from "casteljau";
import * as THREE from "three";

const points: PointsLike = [[0, 0], { x: 1, y: 2 }, [2, 0]];
const curve = new Curve(points);
const spline = Spline.interpolate(points, { kind: "catmull-rom", alpha: 0.5 } satisfies InterpolateOptions);
const path = Path.fromSVG("M0 0H1V1Z");
const patch = new Patch(new Float64Array(48));
const surface = Surface.fromPatches([patch]);

// A matrix has 6 or 16 numbers, and the level of detail is given in one way.
// @ts-expect-error
curve.transform([1, 2]);
// @ts-expect-error
path.transform([1, 0, 0, 1, 5]);
// @ts-expect-error
surface.tessellate({ tolerance: 0.1, segments: 4 });
// @ts-expect-error
patch.tessellate({ segments: 4, viewport: [100, 100] });
export const moved: [Curve, Path, Surface, Curve, Path] = [
  curve.transform([1, 0, 0, 1, 5, 5]),
  path.transform("rotate(30)"),
  surface.transform(new THREE.Matrix4()),
  curve.transform([1, 0, 0, 1].concat([5, 5])),
  path.transform({ a: 1, b: 0, c: 0, d: 1, e: 5, f: 5 }),
];

// Results have the named types.
export const results: [
  Point,
  Intersection[],
  SelfIntersection[],
  Nearest,
  Extrema,
  CurveKind,
  Distance,
  Reduced,
  Subdivision<Curve>,
  Frames,
  Continuity,
  BSpline,
  Moments,
  PathTime | null,
  PathPoint | null,
  PathIntersection[],
  Partials,
  Curvature,
  PatchDeCasteljau,
  PatchPoint,
  SurfacePoint | null,
  Topology,
  FlatPiece[],
  PatchRange[],
  EdgeUse[],
] = [
  curve.eval(0.5),
  curve.intersections(spline),
  curve.selfIntersections(),
  curve.nearest([0, 1]),
  curve.extrema(),
  curve.classify(),
  curve.distanceTo(curve),
  curve.reduce(),
  curve.subdivide(0.1),
  spline.frames(4, { normal: [0, 0, 1] } satisfies FrameOptions),
  spline.continuity(1),
  spline.toBSpline(),
  path.moments(),
  path.timeAtLength(1),
  path.nearest([0, 0]),
  path.intersections(path),
  patch.partials(0, 0),
  patch.curvature(0, 0),
  patch.deCasteljau(0, 0),
  patch.nearest([0, 0, 0]),
  surface.nearest({ x: 0, y: 0, z: 0 }),
  surface.topology(),
  surface.subdivide(0.1),
  surface.grid({ segments: 2, quads: true } satisfies GridOptions).patchRanges,
  surface.topology().open,
];

// Arguments have the named types.
export function draw(
  detail: Detail,
  tessellation: TessellationOptions,
  wires: WireframeOptions,
  svg: PathSvgOptions & SvgOptions,
  matrix: MatrixLike,
  net: NetLike,
  basis: BasisLike,
  rule: FillRule,
  mode: JointMode,
  teapot: TeapotOptions,
  point: PointLike,
): Mesh[] {
  path.contains(point, { fillRule: rule });
  path.transform(matrix).toSVG(svg);
  spline.setJoint(1, mode);
  new Patch(net).equals(Patch.fromBasis(basis, net));
  return [surface.tessellate(detail), surface.tessellate(tessellation), Surface.teapot(teapot).wireframe(wires)];
}
surface.transform(new THREE.Matrix4());
surface.transform(new DOMMatrix());

// What toJSON returns is what fromJSON takes.
export const copies: [CurveJSON, SplineJSON, PatchJSON, SurfaceJSON] = [
  curve.toJSON(),
  spline.toJSON(),
  patch.toJSON(),
  surface.toJSON(),
];
export const options: [SplineOptions, BSplineOptions, BasisName] = [{ closed: true }, { degree: 2 }, "bezier"];
export const details: [SegmentDetail, ToleranceDetail, PixelDetail, MeshOptions] = [
  { segments: { u: 2, v: 3 } },
  { tolerance: 0.1 },
  { pixels: 1, viewProjection: new THREE.Matrix4(), viewport: [800, 600] },
  { weld: "none", precision: "f64" },
];
export type Sources = WasmSource | SvgError["offset"];
export type Kinds = PointIntersection["kind"] | OverlapIntersection["kind"];

// three.js
const geometry: THREE.BufferGeometry = surface.tessellate({ tolerance: 0.01 }).toThree(THREE);
export const object = new THREE.Mesh(geometry, new THREE.MeshNormalMaterial());
export const classes: Three = THREE;

// Mistakes
// @ts-expect-error
curve.split(0.2, 0.6);
// @ts-expect-error
curve.bounds(0, 0.5);
// @ts-expect-error
curve.derivative(0.5);
// @ts-expect-error
spline.intersections(curve, 0.5);
// @ts-expect-error
path.nearest([0, 0], 5);
// @ts-expect-error
Path.from(curve, spline);
// @ts-expect-error
patch.splitU(0.5, 0.5);
// @ts-expect-error
surface.volume(0.1);
// @ts-expect-error
curve.toSVG({ precison: 2 });
// @ts-expect-error
Surface.teapot({ lid: 0 });
// @ts-expect-error
patch.transform({ a: 1 });
// @ts-expect-error
const wrong: THREE.Material = surface.grid({ segments: 1 }).toThree(THREE);
export { wrong };
