// The types of public signatures by name: `import type { Intersection, PointLike } from "casteljau"`.
export type { PointLike, PointsLike, MatrixLike, TransformLike } from "./geometry/check.js";
export type { NetLike } from "./geometry/net.js";
export type { BasisName, BasisLike } from "./geometry/basis.js";
export type { CurveJSON } from "./geometry/curve/core-curve.js";
export type { Extrema, CurveKind, Distance, Nearest } from "./geometry/curve-queries.js";
export type {
  SelfIntersection,
  PathIntersection,
  PointIntersection,
  OverlapIntersection,
  Intersection,
} from "./geometry/intersections.js";
export type { Frames, FrameOptions } from "./geometry/frames.js";
export type { SplineOptions, SplineJSON } from "./geometry/spline/core-spline.js";
export type { InterpolateOptions } from "./geometry/interpolate.js";
export type { FitEffort, FitOptions, SimplifyOptions } from "./geometry/spline/spline.js";
export type { BSplineOptions, BSpline } from "./geometry/bspline.js";
export type { StrokeJoin } from "./geometry/joins.js";
export type { JointMode, Continuity } from "./geometry/joints.js";
export type { FillRule, RegionOptions } from "./geometry/path/fill-rule.js";
export type { SvgError, Face, Moments } from "./geometry/path/path.js";
export type {
  SideWidths,
  StrokeOptions,
  StrokeShape,
  StrokeCap,
  RegionOffsetOptions,
  CornerOptions,
  CornerRadius,
  WidthProfile,
} from "./geometry/path/path-stroke.js";
export type { CircularArc } from "./geometry/path/path-arcs.js";
export type { BooleanOperation } from "./geometry/path/path-boolean.js";
export type { PathTime, PathPoint, PathPointAtLength } from "./geometry/path/path-queries.js";
export type { PathExtrema } from "./geometry/path/path-coordinates.js";
export type { ArcOptions, RectOptions } from "./geometry/path/path-shapes.js";
export type { Shape } from "./geometry/path/core-path.js";
export type { NearestPath, PathIndex } from "./geometry/path/path-index.js";
export type { PathBuilder } from "./geometry/path/path-builder.js";
export type { PathSegment, CssOptions } from "./io/path-data.js";
export type { SvgOptions, PathSvgOptions, ArcSvgOptions } from "./io/svg-write.js";
export type { PatchJSON } from "./geometry/patch/core-patch.js";
export type { Partials } from "./geometry/patch/core-patch.js";
export type { Curvature, PatchDeCasteljau, PatchPoint, SurfacePoint } from "./geometry/surface-queries.js";
export type { TeapotOptions } from "./geometry/surface/network.js";
export type { SurfaceJSON } from "./geometry/surface-network.js";
export type { EdgeUse, Topology } from "./geometry/topology.js";
export type {
  Detail,
  SegmentDetail,
  ToleranceDetail,
  PixelDetail,
  MeshOptions,
  TessellationOptions,
} from "./geometry/tessellation.js";
export type { TubeOptions, RibbonOptions, WireframeOptions } from "./geometry/wireframe.js";
export type { FlatPiece } from "./geometry/flat-pieces.js";
export type { GridOptions, PatchRange } from "./geometry/mesh.js";
export type { WasmSource } from "./wasm/init.js";
export type { Subdivision } from "./geometry/subdivision.js";
export type { Three, ThreeCurves, ThreeShapes } from "./io/three.js";
export type { Point, PointArrays, Bounds } from "./geometry/points.js";
export type { PointAtLength } from "./geometry/arc-length.js";
export type { Reduced } from "./geometry/curve/curve.js";
