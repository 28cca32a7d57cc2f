// The types of public signatures by name: `import type { Intersection, PointLike } from "casteljau"`.
export {};

/** @typedef {import("./geometry/check.js").PointLike} PointLike */
/** @typedef {import("./geometry/check.js").PointsLike} PointsLike */
/** @typedef {import("./geometry/check.js").MatrixLike} MatrixLike */
/** @typedef {import("./geometry/net.js").NetLike} NetLike */
/** @typedef {import("./geometry/points.js").Point} Point */
/** @typedef {import("./geometry/basis.js").BasisName} BasisName */
/** @typedef {import("./geometry/basis.js").BasisLike} BasisLike */
/** @typedef {import("./geometry/curve/curve-value.js").CurveJSON} CurveJSON */
/** @typedef {import("./geometry/curve/curve.js").Reduced} Reduced */
/** @typedef {import("./geometry/curve-queries.js").Nearest} Nearest */
/** @typedef {import("./geometry/curve-queries.js").Extrema} Extrema */
/** @typedef {import("./geometry/curve-queries.js").CurveKind} CurveKind */
/** @typedef {import("./geometry/curve-queries.js").Distance} Distance */
/** @typedef {import("./geometry/intersections.js").PointIntersection} PointIntersection */
/** @typedef {import("./geometry/intersections.js").OverlapIntersection} OverlapIntersection */
/** @typedef {import("./geometry/intersections.js").Intersection} Intersection */
/** @typedef {import("./geometry/intersections.js").SelfIntersection} SelfIntersection */
/** @typedef {import("./geometry/frames.js").Frames} Frames */
/** @typedef {import("./geometry/frames.js").FrameOptions} FrameOptions */
/** @typedef {import("./geometry/spline/spline-value.js").SplineOptions} SplineOptions */
/** @typedef {import("./geometry/spline/spline-value.js").SplineJSON} SplineJSON */
/** @typedef {import("./geometry/interpolate.js").InterpolateOptions} InterpolateOptions */
/** @typedef {import("./geometry/bspline.js").BSplineOptions} BSplineOptions */
/** @typedef {import("./geometry/bspline.js").BSpline} BSpline */
/** @typedef {import("./geometry/joints.js").JointMode} JointMode */
/** @typedef {import("./geometry/joints.js").Continuity} Continuity */
/** @typedef {import("./geometry/path.js").FillRule} FillRule */
/** @typedef {import("./geometry/path.js").Moments} Moments */
/** @typedef {import("./geometry/path.js").SvgError} SvgError */
/** @typedef {import("./geometry/path-queries.js").PathTime} PathTime */
/** @typedef {import("./geometry/path-queries.js").PathPoint} PathPoint */
/** @typedef {import("./geometry/path-queries.js").PathPointIntersection} PathPointIntersection */
/** @typedef {import("./geometry/path-queries.js").PathOverlapIntersection} PathOverlapIntersection */
/** @typedef {import("./geometry/path-queries.js").PathIntersection} PathIntersection */
/** @typedef {import("./io/svg-write.js").SvgOptions} SvgOptions */
/** @typedef {import("./geometry/patch.js").PatchJSON} PatchJSON */
/** @typedef {import("./geometry/patch.js").Partials} Partials */
/** @typedef {import("./geometry/surface-queries.js").Curvature} Curvature */
/** @typedef {import("./geometry/surface-queries.js").PatchDeCasteljau} PatchDeCasteljau */
/** @typedef {import("./geometry/surface-queries.js").PatchPoint} PatchPoint */
/** @typedef {import("./geometry/surface-queries.js").SurfacePoint} SurfacePoint */
/** @typedef {import("./geometry/surface.js").TeapotOptions} TeapotOptions */
/** @typedef {import("./geometry/surface-network.js").SurfaceJSON} SurfaceJSON */
/** @typedef {import("./geometry/topology.js").EdgeUse} EdgeUse */
/** @typedef {import("./geometry/topology.js").Topology} Topology */
/** @typedef {import("./geometry/tessellation.js").Detail} Detail */
/** @typedef {import("./geometry/tessellation.js").TessellationOptions} TessellationOptions */
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
