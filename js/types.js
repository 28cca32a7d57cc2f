// The types of public signatures by name: `import type { Intersection, PointLike } from "casteljau"`.
export {};

/** @typedef {import("./geometry/check.js").PointLike} PointLike */
/** @typedef {import("./geometry/check.js").PointsLike} PointsLike */
/** @typedef {import("./geometry/check.js").MatrixLike} MatrixLike */
/** @typedef {import("./geometry/check.js").TransformLike} TransformLike */
/** @typedef {import("./geometry/net.js").NetLike} NetLike */
/** @typedef {import("./geometry/basis.js").BasisName} BasisName */
/** @typedef {import("./geometry/basis.js").BasisLike} BasisLike */
/** @typedef {import("./geometry/curve/curve-value.js").CurveJSON} CurveJSON */
/** @typedef {import("./geometry/curve-queries.js").Extrema} Extrema */
/** @typedef {import("./geometry/curve-queries.js").CurveKind} CurveKind */
/** @typedef {import("./geometry/curve-queries.js").Distance} Distance */
/** @typedef {import("./geometry/intersections.js").SelfIntersection} SelfIntersection */
/** @typedef {import("./geometry/frames.js").Frames} Frames */
/** @typedef {import("./geometry/frames.js").FrameOptions} FrameOptions */
/** @typedef {import("./geometry/spline/spline-value.js").SplineOptions} SplineOptions */
/** @typedef {import("./geometry/spline/spline-value.js").SplineJSON} SplineJSON */
/** @typedef {import("./geometry/interpolate.js").InterpolateOptions} InterpolateOptions */
/** @typedef {import("./geometry/spline/spline.js").FitOptions} FitOptions */
/** @typedef {import("./geometry/spline/spline.js").SimplifyOptions} SimplifyOptions */
/** @typedef {import("./geometry/bspline.js").BSplineOptions} BSplineOptions */
/** @typedef {import("./geometry/bspline.js").BSpline} BSpline */
/** @typedef {import("./geometry/joints.js").JointMode} JointMode */
/** @typedef {import("./geometry/joints.js").Continuity} Continuity */
/** @typedef {import("./geometry/path/path-measures.js").FillRule} FillRule */
/** @typedef {import("./geometry/path/path-measures.js").Moments} Moments */
/** @typedef {import("./geometry/path/path.js").SvgError} SvgError */
/** @typedef {import("./geometry/path/path-measures.js").RegionOptions} RegionOptions */
/** @typedef {import("./geometry/path/path.js").Face} Face */
/** @typedef {import("./geometry/path/path-stroke.js").StrokeOptions} StrokeOptions */
/** @typedef {import("./geometry/path/path-stroke.js").StrokeShape} StrokeShape */
/** @typedef {import("./geometry/path/path-stroke.js").StrokeJoin} StrokeJoin */
/** @typedef {import("./geometry/path/path-stroke.js").StrokeCap} StrokeCap */
/** @typedef {import("./geometry/path/path-stroke.js").RegionOffsetOptions} RegionOffsetOptions */
/** @typedef {import("./geometry/path/path-boolean.js").BooleanOperation} BooleanOperation */
/** @typedef {import("./geometry/path/path-queries.js").PathTime} PathTime */
/** @typedef {import("./geometry/path/path-queries.js").PathPoint} PathPoint */
/** @typedef {import("./geometry/path/path-queries.js").PathPointAtLength} PathPointAtLength */
/** @typedef {import("./geometry/path/path-coordinates.js").PathExtrema} PathExtrema */
/** @typedef {import("./geometry/path/path-shapes.js").ArcOptions} ArcOptions */
/** @typedef {import("./geometry/path/path-shapes.js").RectOptions} RectOptions */
/** @typedef {import("./geometry/path/core-path.js").NearestPath} NearestPath */
/** @typedef {import("./geometry/path/core-path.js").Shape} Shape */
/** @typedef {import("./geometry/path/path-builder.js").PathBuilder} PathBuilder */
/** @typedef {import("./io/path-data.js").PathSegment} PathSegment */
/** @typedef {import("./io/path-data.js").CssOptions} CssOptions */
/** @typedef {import("./geometry/intersections.js").PathIntersection} PathIntersection */
/** @typedef {import("./io/svg-write.js").SvgOptions} SvgOptions */
/** @typedef {import("./io/svg-write.js").PathSvgOptions} PathSvgOptions */
/** @typedef {import("./geometry/patch/patch-value.js").PatchJSON} PatchJSON */
/** @typedef {import("./geometry/patch/core-patch.js").Partials} Partials */
/** @typedef {import("./geometry/surface-queries.js").Curvature} Curvature */
/** @typedef {import("./geometry/surface-queries.js").PatchDeCasteljau} PatchDeCasteljau */
/** @typedef {import("./geometry/surface-queries.js").PatchPoint} PatchPoint */
/** @typedef {import("./geometry/surface-queries.js").SurfacePoint} SurfacePoint */
/** @typedef {import("./geometry/surface/network.js").TeapotOptions} TeapotOptions */
/** @typedef {import("./geometry/surface-network.js").SurfaceJSON} SurfaceJSON */
/** @typedef {import("./geometry/topology.js").EdgeUse} EdgeUse */
/** @typedef {import("./geometry/topology.js").Topology} Topology */
/** @typedef {import("./geometry/tessellation.js").Detail} Detail */
/** @typedef {import("./geometry/tessellation.js").SegmentDetail} SegmentDetail */
/** @typedef {import("./geometry/tessellation.js").ToleranceDetail} ToleranceDetail */
/** @typedef {import("./geometry/tessellation.js").PixelDetail} PixelDetail */
/** @typedef {import("./geometry/tessellation.js").MeshOptions} MeshOptions */
/** @typedef {import("./geometry/tessellation.js").TessellationOptions} TessellationOptions */
/** @typedef {import("./geometry/wireframe.js").TubeOptions} TubeOptions */
/** @typedef {import("./geometry/wireframe.js").RibbonOptions} RibbonOptions */
/** @typedef {import("./geometry/wireframe.js").WireframeOptions} WireframeOptions */
/** @typedef {import("./geometry/flat-pieces.js").FlatPiece} FlatPiece */
/** @typedef {import("./geometry/mesh.js").GridOptions} GridOptions */
/** @typedef {import("./geometry/mesh.js").PatchRange} PatchRange */
/** @typedef {import("./wasm/init.js").WasmSource} WasmSource */

/**
 * @template [C=import("./geometry/curve/curve.js").Curve]
 * @typedef {import("./geometry/subdivision.js").Subdivision<C>} Subdivision
 */

/**
 * @template {{ new (): any, prototype: any }} [GeometryClass={ new (): any, prototype: any }]
 * @typedef {import("./io/three.js").Three<GeometryClass>} Three
 */

/**
 * @template {{ new (): any, prototype: any }} [ShapeClass={ new (): any, prototype: any }]
 * @typedef {import("./io/three.js").ThreeShapes<ShapeClass>} ThreeShapes
 */

/**
 * @template {{ prototype: any }} [CurveClass={ prototype: any }]
 * @typedef {import("./io/three.js").ThreeCurves<CurveClass>} ThreeCurves
 */

/**
 * @template {2 | 3} [D=2 | 3]
 * @typedef {import("./geometry/points.js").Point<D>} Point
 */

/**
 * @template {2 | 3} [D=2 | 3]
 * @typedef {import("./geometry/points.js").PointArrays<D>} PointArrays
 */

/**
 * @template {2 | 3} [D=2 | 3]
 * @typedef {import("./geometry/arc-length.js").PointAtLength<D>} PointAtLength
 */

/**
 * @template {2 | 3} [D=2 | 3]
 * @typedef {import("./geometry/curve/curve.js").Reduced<D>} Reduced
 */

/**
 * @template {2 | 3} [D=2 | 3]
 * @typedef {import("./geometry/curve-queries.js").Nearest<D>} Nearest
 */

/**
 * @template {2 | 3} [D=2 | 3]
 * @typedef {import("./geometry/points.js").Bounds<D>} Bounds
 */

/**
 * @template [T=number]
 * @template [U=number]
 * @typedef {import("./geometry/intersections.js").PointIntersection<T, U>} PointIntersection
 */

/**
 * @template [T=number]
 * @template [U=number]
 * @typedef {import("./geometry/intersections.js").OverlapIntersection<T, U>} OverlapIntersection
 */

/**
 * @template [T=number]
 * @template [U=number]
 * @typedef {import("./geometry/intersections.js").Intersection<T, U>} Intersection
 */
