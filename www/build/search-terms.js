// What people type who do not know our names, and what they look for that the library does not have.

/** Words by the address that answers them; commas separate phrases. @type {Record<string, string>} */
export const TERMS = {
  "curves/parameter/": "polyline, line segments, parametric",
  "curves/quadratic/": "lerp, linear interpolation",
  "curves/bernstein/": "blending function, basis function, binomial",
  "curves/properties/": "convex hull, affine map, affine invariance, end tangent",
  "curves/shapes/": "inflection, loop, cusp, S-curve, serpentine, self-intersection",
  "curves/splitting/": "split, subdivision, subdivide, insert a point, cut",
  "curves/derivatives/": "curvature, cusp, velocity, speed, hodograph, osculating circle, radius, kappa",
  "curves/joining/": "smooth corner, smooth joint, corner, G1, G2, C1, C2, handle, handles",
  "curves/higher-degrees/": "degree elevation, quadratic to cubic",
  "curves/splines/":
    "catmull-rom, b-spline, natural spline, cardinal spline, interpolating spline, tension, hermite, matrix form, basis matrix",
  "curves/fitting/":
    "curve fitting, least squares, simplify, simplification, fewer points, Douglas-Peucker, Schneider, noise",
  "curves/recursive-rendering/": "flattening, polyline, tolerance",
  "curves/arc-length/": "constant speed, even spacing, reparametrize",
  "curves/bounding-boxes/": "bounding box, extrema, points at extrema",
  "curves/nearest-point/": "closest point, projection, distance to a curve",
  "curves/offsets/": "parallel curve, offset, stroke, thickness, outline",
  "curves/varying-width/": "variable width, varying width, taper, calligraphy, pressure",
  "curves/circles/": "kappa, 0.5523, 0.5522847498, 0.551915, magic number, circle, circular arc",
  "curves/rational-curves/": "nurbs, conic, weight, rational, knots",
  "curves/boolean-operations/": "pathfinder, union, winding number, fill rule",
  "curves/uses/": "ease-in-out, fonts, animation",
  "surfaces/tessellation/": "triangulate, triangulation, triangles, mesh",
  "surfaces/splitting/": "split, subdivide a patch",
  "surfaces/normals/": "shading normal",
  "surfaces/cracks/": "watertight, T-junction",
  "recipes/#stl-for-printing": "lathe, surface of revolution, vase, 3D printing",
  "recipes/#vase": "surface of revolution, NURBS, pottery, revolve, turning",
  "recipes/#brush-stroke": "nib, brush, calligraphy, variable width, thickness",
  "recipes/#text-along-path": "textPath, letters on a curve",
  "recipes/#hit-testing": "isPointInPath, isPointInStroke, mouse over",
  "recipes/#camera-flight": "camera path, constant speed",
  "recipes/#ink": "pen, pressure, nib, signature, handwriting",
  "ink/": "nib, pen, pressure, handwriting",
  "easing/": "ease-in-out, ease-in, ease-out, transition-timing-function",
  "api/path/#pointAtLength": "getPointAtLength, point along a path",
  "api/path/#length": "getTotalLength",
  "api/path/#moments": "centroid, centre of mass, center of mass, centre of gravity",
  "api/path/#roundCorners": "smooth corner, corner radius, fillet, rounded corners",
  "api/path/#stroke": "thickness, line width, stroke-width, outline stroke",
  "api/path/#flatten": "polyline, polygon",
  "api/curve/#flatten": "polyline",
  "api/spline/#fit": "fit, fit points, curve through noisy points",
  "api/curve/#offset": "parallel curve",
  "api/surface/#tessellate": "triangulate, triangulation, triangles",
  "api/inkstroke/#constructor": "nib, pen",
};

/**
 * What is not available, with what to do instead. The address is that of the instead.
 *
 * @type {{ title: string, text: string, address: string, terms: string }[]}
 */
export const ABSENT = [
  {
    title: "Triangles of a filled path: not available",
    text: "Do this instead: flatten the path and triangulate the polygons, for example with earcut; in three.js give path.toThree() to ShapeGeometry. Surfaces have tessellate.",
    address: "api/path/#flatten",
    terms: "triangulate, triangulation, triangulate path, triangulate polygon, earcut, libtess",
  },
  {
    title: "Morphing of paths: not available",
    text: "Do this instead: take equally many points of both paths with equidistantTimes and evalAt, mix them, and join the results. Curves of equal degree can be interpolated point by point.",
    address: "api/path/#equidistantTimes",
    terms: "morph, morphing, tween, shape interpolation, flubber",
  },
  {
    title: "Outlines of text: not available",
    text: "Do this instead: read the font with another library, for example opentype.js, and give its path data to Path.fromSVG.",
    address: "api/path/#fromSVG",
    terms: "text to path, text outlines, font file, opentype, fontkit, glyph outlines",
  },
  {
    title: "Tracing of images: not available",
    text: "Do this instead: trace the image with another library, for example potrace, and simplify its path.",
    address: "api/path/#simplify",
    terms: "trace image, potrace, vectorize, bitmap to vector",
  },
  {
    title: "Subdivision surfaces: not available",
    text: "The chapter says what they are. A mesh without extraordinary vertices has a limit surface of bicubic patches, which Surface.fromPatches takes.",
    address: "surfaces/other-representations/",
    terms: "catmull-clark, subdivision surface, loop subdivision",
  },
];
