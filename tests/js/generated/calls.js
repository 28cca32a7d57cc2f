// For each public function the call that a generated case means.
import { Curve, easing, Mesh, Patch, Path, Spline, Surface } from "casteljau";
import * as THREE from "three";
import { recorder } from "../reference.js";

const curveOf = ({ points, dimension }) => new Curve(points, { dimension });
const splineOf = ({ points, degrees, closed, dimension }) => Spline.fromJSON({ points, degrees, closed, dimension });
const pathOf = (splines) => new Path(splines.map(splineOf));
const patchOf = ({ vertices, degrees: [[degreeU, degreeV]] }) => new Patch(vertices, { degreeU, degreeV });
const surfaceOf = ({ text }) => Surface.parse(text);

/** The arguments of a case as values of the package; what is left out is undefined. */
export function argumentsOf(given) {
  const a = {};
  for (const [name, value] of Object.entries(given)) a[name] = value ?? undefined;
  for (const name of ["curve", "other"]) if (a[name]?.points && !a[name].degrees) a[name] = curveOf(a[name]);
  for (const name of ["spline", "other"]) if (a[name]?.degrees) a[name] = splineOf(a[name]);
  if (a.path) a.path = pathOf(a.path);
  if (Array.isArray(a.other)) a.other = pathOf(a.other);
  if (a.patch) a.patch = patchOf(a.patch);
  if (a.surface) a.surface = surfaceOf(a.surface);
  return a;
}

/** An affine map: the columns as they come are those of a canvas, or of a 4 × 4 matrix. */
const matrix = ({ map: m }) =>
  m.length === 6 ? m : [...m.slice(0, 3), 0, ...m.slice(3, 6), 0, ...m.slice(6, 9), 0, ...m.slice(9), 1];
const dimensionOf = (points) => ({ dimension: points[0].length });
const axes = ["x", "y", "z", "w"];
const traced = (draw) => {
  const target = recorder();
  draw(target);
  return target.calls.map((call) => call.slice(1));
};
/** A location on one of the subpaths, if there is one, whose t is a part of the number of segments. */
const location = (a, k = a.k, part = a.t) => {
  const subpath = k % (a.path.subpathCount || 1);
  return { subpath, t: part * (a.path.subpaths[subpath]?.segmentCount ?? 1) };
};
const pointsOfPath = (path) => path.subpaths.flatMap((spline) => spline.toJSON().points);
const withPath2D = (act) => {
  /** @type {any} */ (globalThis).Path2D = recorder;
  try {
    return act();
  } finally {
    delete (/** @type {any} */ (globalThis).Path2D);
  }
};
const grid = (a) => ({ segments: { u: a.segments_u, v: a.segments_v }, quads: a.quads });
const fineness = (a) => (a.cells === undefined ? { tolerance: a.tolerance } : { segments: a.cells });
const view = (a) => ({ pixels: a.pixels, viewProjection: a.view, viewport: [640, 480] });
const wire = (a) =>
  a.wire === "tube" ? { lines: a.lines, radius: a.width, sides: a.sides } : { lines: a.lines, width: a.width };
const mesh = (a) => a.surface.grid({ segments: a.segments_u, quads: a.quads });
const parts = (a) =>
  Object.fromEntries(["rim", "body", "handle", "spout", "lid", "bottom"].map((part) => [part, a.parts.includes(part)]));
const svg = (a) => ({ precision: a.precision, tolerance: a.tolerance });

const CURVE = {
  "Curve.constructor": (a) => new Curve(a.points, dimensionOf(a.points)),
  "Curve.fromBasis": (a) => Curve.fromBasis(a.basis, a.points, dimensionOf(a.points)),
  "Curve.fromJSON": (a) => Curve.fromJSON(a.curve.toJSON()),
  "Curve.toJSON": (a) => a.curve.toJSON(),
  "Curve.bernstein": (a) => Curve.bernstein(a.degree, a.t),
  "Curve.basisMatrix": (a) => Curve.basisMatrix(a.basis),
  "Curve.interpolate": (a) => Curve.interpolate(a.points, a.ts, dimensionOf(a.points)),
  "Curve.degree": (a) => a.curve.degree,
  "Curve.dimension": (a) => a.curve.dimension,
  "Curve.controlPoints": (a) => a.curve.controlPoints(),
  "Curve.equals": (a) => a.curve.equals(a.other, a.tolerance),
  "Curve.eval": (a) => a.curve.eval(a.t),
  "Curve.evalAt": (a) => a.curve.evalAt(a.ts),
  "Curve.sample": (a) => a.curve.sample(a.segments),
  "Curve.derivative": (a) => a.curve.derivative(),
  "Curve.derivativeAt": (a) => a.curve.derivativeAt(a.t, a.k),
  "Curve.tangent": (a) => a.curve.tangent(a.t),
  "Curve.normal": (a) => a.curve.normal(a.t),
  "Curve.curvature": (a) => a.curve.curvature(a.t),
  "Curve.torsion": (a) => a.curve.torsion(a.t),
  "Curve.frames": (a) => a.curve.frames(a.segments),
  "Curve.length": (a) => a.curve.length(a.tolerance),
  "Curve.timeAtLength": (a) => a.curve.timeAtLength(a.s, a.tolerance),
  "Curve.pointAtLength": (a) => a.curve.pointAtLength(a.s),
  "Curve.equidistantTimes": (a) => a.curve.equidistantTimes(a.segments),
  "Curve.area": (a) => a.curve.area(),
  "Curve.split": (a) => a.curve.split(a.t),
  "Curve.halve": (a) => a.curve.halve(),
  "Curve.subsegment": (a) => a.curve.subsegment(a.t0, a.t1),
  "Curve.reverse": (a) => a.curve.reverse(),
  "Curve.elevate": (a) => a.curve.elevate(),
  "Curve.reduce": (a) => a.curve.reduce(),
  "Curve.transform": (a) => a.curve.transform(matrix(a)),
  "Curve.deCasteljau": (a) => a.curve.deCasteljau(a.t),
  "Curve.toBasis": (a) => a.curve.toBasis(a.basis),
  "Curve.flatten": (a) => a.curve.flatten(a.tolerance),
  "Curve.subdivide": (a) => a.curve.subdivide(a.tolerance),
  "Curve.bounds": (a) => a.curve.bounds(),
  "Curve.controlBounds": (a) => a.curve.controlBounds(),
  "Curve.hull": (a) => a.curve.hull(),
  "Curve.intersections": (a) => a.curve.intersections(a.other),
  "Curve.selfIntersections": (a) => a.curve.selfIntersections(),
  "Curve.nearest": (a) => a.curve.nearest(a.p),
  "Curve.extrema": (a) => a.curve.extrema(),
  "Curve.timesAtCoordinate": (a) => a.curve.timesAtCoordinate({ [axes[a.axis]]: a.value }),
  "Curve.inflections": (a) => a.curve.inflections(),
  "Curve.cusps": (a) => a.curve.cusps(),
  "Curve.classify": (a) => a.curve.classify(),
  "Curve.tangentsFrom": (a) => a.curve.tangentsFrom(a.p),
  "Curve.distanceTo": (a) => a.curve.distanceTo(a.other),
  "Curve.hausdorff": (a) => a.curve.hausdorff(a.other),
  "Curve.offset": (a) => a.curve.offset(a.distance, { tolerance: a.tolerance }),
  "Curve.trace": (a) => traced((target) => a.curve.trace(target, { tolerance: a.tolerance })),
  "Curve.toSVG": (a) => a.curve.toSVG(svg(a)),
};

const SPLINE = {
  "Spline.constructor": (a) => new Spline(a.points, { degree: a.degree, closed: a.closed, ...dimensionOf(a.points) }),
  "Spline.fromCurves": (a) => Spline.fromCurves(a.spline.segments(), { closed: a.spline.closed }),
  "Spline.fromBSpline": (a) =>
    Spline.fromBSpline(a.points, { degree: a.degree, knots: a.knots, closed: a.closed, ...dimensionOf(a.points) }),
  "Spline.fromJSON": (a) => Spline.fromJSON(a.spline.toJSON()),
  "Spline.toJSON": (a) => a.spline.toJSON(),
  "Spline.interpolate": (a) =>
    Spline.interpolate(a.points, { kind: a.kind, alpha: a.alpha, closed: a.closed, ...dimensionOf(a.points) }),
  "Spline.fit": (a) =>
    Spline.fit(a.points, {
      tolerance: a.tolerance,
      cornerAngle: a.corner_angle,
      closed: a.closed,
      ...dimensionOf(a.points),
    }),
  "Spline.controlPoints": (a) => a.spline.controlPoints(),
  "Spline.dimension": (a) => a.spline.dimension,
  "Spline.closed": (a) => a.spline.closed,
  "Spline.segmentCount": (a) => a.spline.segmentCount,
  "Spline.degrees": (a) => a.spline.degrees,
  "Spline.segments": (a) => a.spline.segments(),
  "Spline.equals": (a) => a.spline.equals(a.spline.reverse(), a.tolerance),
  "Spline.eval": (a) => a.spline.eval(a.t),
  "Spline.evalAt": (a) => a.spline.evalAt(a.ts),
  "Spline.sample": (a) => a.spline.sample(a.segments),
  "Spline.derivativeAt": (a) => a.spline.derivativeAt(a.t, a.k),
  "Spline.tangent": (a) => a.spline.tangent(a.t),
  "Spline.normal": (a) => a.spline.normal(a.t),
  "Spline.curvature": (a) => a.spline.curvature(a.t),
  "Spline.torsion": (a) => a.spline.torsion(a.t),
  "Spline.split": (a) => a.spline.split(a.t),
  "Spline.subsegment": (a) => a.spline.subsegment(a.t0, a.t1),
  "Spline.hull": (a) => a.spline.hull(),
  "Spline.extrema": (a) => a.spline.extrema(),
  "Spline.timesAtCoordinate": (a) => a.spline.timesAtCoordinate({ [axes[a.axis]]: a.value }),
  "Spline.frames": (a) => a.spline.frames(a.segments),
  "Spline.length": (a) => a.spline.length(a.tolerance),
  "Spline.timeAtLength": (a) => a.spline.timeAtLength(a.s, a.tolerance),
  "Spline.pointAtLength": (a) => a.spline.pointAtLength(a.s),
  "Spline.equidistantTimes": (a) => a.spline.equidistantTimes(a.segments),
  "Spline.area": (a) => a.spline.area(),
  "Spline.bounds": (a) => a.spline.bounds(),
  "Spline.controlBounds": (a) => a.spline.controlBounds(),
  "Spline.continuity": (a) => a.spline.continuity(a.joint, a.tolerance),
  "Spline.append": (a) => a.spline.append(a.p),
  "Spline.insert": (a) => a.spline.insert(a.t),
  "Spline.remove": (a) => a.spline.remove(a.joint),
  "Spline.movePoint": (a) => a.spline.movePoint(a.index, a.to, { joints: a.modes }),
  "Spline.setJoint": (a) => a.spline.setJoint(a.joint, a.mode),
  "Spline.reverse": (a) => a.spline.reverse(),
  "Spline.transform": (a) => a.spline.transform(matrix(a)),
  "Spline.nearest": (a) => a.spline.nearest(a.p),
  "Spline.flatten": (a) => a.spline.flatten(a.tolerance),
  "Spline.intersections": (a) => a.spline.intersections(a.other),
  "Spline.selfIntersections": (a) => a.spline.selfIntersections(),
  "Spline.simplify": (a) => a.spline.simplify(a.tolerance),
  "Spline.offset": (a) => a.spline.offset(a.distance, { tolerance: a.tolerance, join: a.join }),
  "Spline.trace": (a) => traced((target) => a.spline.trace(target, { tolerance: a.tolerance })),
  "Spline.toBSpline": (a) => a.spline.toBSpline(),
  "Spline.toSVG": (a) => a.spline.toSVG(svg(a)),
};

const PATH = {
  "Path.constructor": (a) => new Path(a.path.subpaths),
  "Path.fromSVG": (a) => Path.fromSVG(a.text),
  "Path.fromJSON": (a) => Path.fromJSON(a.path.toJSON()),
  "Path.toJSON": (a) => a.path.toJSON(),
  "Path.subpathCount": (a) => a.path.subpathCount,
  "Path.subpaths": (a) => [...a.path.subpaths],
  "Path.equals": (a) => a.path.equals(a.path.reverse(), a.tolerance),
  "Path.bounds": (a) => a.path.bounds(),
  "Path.controlBounds": (a) => a.path.controlBounds(),
  "Path.length": (a) => a.path.length(a.tolerance),
  "Path.timeAtLength": (a) => a.path.timeAtLength(a.s, a.tolerance),
  "Path.equidistantTimes": (a) => a.path.equidistantTimes(a.segments),
  "Path.area": (a) => a.path.area(),
  "Path.moments": (a) => a.path.moments(),
  "Path.nearest": (a) => a.path.nearest(a.p),
  "Path.windingNumber": (a) => a.path.windingNumber(a.p),
  "Path.contains": (a) => a.path.contains(a.p, { fillRule: a.rule }),
  "Path.flatten": (a) => a.path.flatten(a.tolerance),
  "Path.intersections": (a) => a.path.intersections(a.other),
  "Path.union": (a) => a.path.union(a.other, { fillRule: a.rule }),
  "Path.intersect": (a) => a.path.intersect(a.other, { fillRule: a.rule }),
  "Path.subtract": (a) => a.path.subtract(a.other, { fillRule: a.rule }),
  "Path.exclude": (a) => a.path.exclude(a.other, { fillRule: a.rule }),
  "Path.combine": (a) => Path.combine([a.path, a.other], "exclude", { fillRule: a.rule }),
  "Path.removeOverlaps": (a) => a.path.removeOverlaps({ fillRule: a.rule }),
  "Path.faces": (a) => Path.faces([a.path, a.other], { fillRule: a.rule }),
  "Path.divide": (a) => a.path.divide(a.other, { fillRule: a.rule }),
  "Path.clip": (a) => a.path.clip(a.other, { fillRule: a.rule }),
  "Path.stroke": (a) => a.path.stroke(Math.abs(a.width), { join: a.join, tolerance: a.tolerance }),
  "Path.strokeContains": (a) => a.path.strokeContains(a.p, Math.abs(a.width), { join: a.join }),
  "Path.dash": (a) => a.path.dash([Math.abs(a.s), Math.abs(a.width)], a.offset),
  "Path.offset": (a) => a.path.offset(a.distance, { join: a.join, tolerance: a.tolerance }),
  "Path.roundCorners": (a) => a.path.roundCorners(Math.abs(a.radius)),
  "Path.filledArea": (a) => a.path.area({ fillRule: a.rule }),
  "Path.filledMoments": (a) => a.path.moments({ fillRule: a.rule }),
  "Path.selfIntersections": (a) => a.path.selfIntersections(),
  "Path.transform": (a) => a.path.transform(matrix(a)),
  "Path.reverse": (a) => a.path.reverse(),
  "Path.trace": (a) => traced((target) => a.path.trace(target, { tolerance: a.tolerance })),
  "Path.toSVG": (a) => a.path.toSVG(svg(a)),
  "Path.eval": (a) => a.path.eval(location(a)),
  "Path.evalAt": (a) => a.path.evalAt(a.path.equidistantTimes(a.segments)),
  "Path.sample": (a) => a.path.sample(a.segments),
  "Path.derivativeAt": (a) => a.path.derivativeAt(location(a), a.order),
  "Path.tangent": (a) => a.path.tangent(location(a)),
  "Path.normal": (a) => a.path.normal(location(a)),
  "Path.curvature": (a) => a.path.curvature(location(a)),
  "Path.pointAtLength": (a) => a.path.pointAtLength(a.s, a.tolerance),
  "Path.split": (a) => a.path.split(location(a)),
  "Path.subsegment": (a) => a.path.subsegment(location(a, a.k, a.t0), location(a, a.last, a.t1)),
  "Path.extrema": (a) => a.path.extrema(),
  "Path.timesAtCoordinate": (a) => a.path.timesAtCoordinate({ [axes[a.axis]]: a.value }),
  "Path.toPath2D": (a) => withPath2D(() => a.path.toPath2D({ tolerance: a.tolerance })).calls,
  "Path.from": (a) => Path.from([a.path, ...a.path.subpaths]),
  "Path.circle": (a) => Path.circle(a.p, Math.abs(a.radius), { tolerance: a.tolerance }),
  "Path.ellipse": (a) => Path.ellipse(a.p, Math.abs(a.radius), Math.abs(a.other_radius), a.rotation),
  "Path.arc": (a) => Path.arc(a.p, Math.abs(a.radius), a.t0, a.t1),
  "Path.rect": (a) => Path.rect(a.p, Math.abs(a.width), Math.abs(a.height), { radii: Math.abs(a.radius) }),
  "Path.polygon": (a) => Path.polygon(pointsOfPath(a.path), { closed: a.closed }),
};

const PATCH = {
  "Patch.constructor": (a) => a.patch,
  "Patch.fromBasis": (a) => Patch.fromBasis(a.basis, a.points),
  "Patch.fromJSON": (a) => Patch.fromJSON(a.patch.toJSON()),
  "Patch.toJSON": (a) => a.patch.toJSON(),
  "Patch.degreeU": (a) => a.patch.degreeU,
  "Patch.degreeV": (a) => a.patch.degreeV,
  "Patch.controlPoints": (a) => a.patch.controlPoints(),
  "Patch.equals": (a) => a.patch.equals(a.patch, a.tolerance),
  "Patch.eval": (a) => a.patch.eval(a.u, a.v),
  "Patch.partials": (a) => a.patch.partials(a.u, a.v),
  "Patch.normal": (a) => a.patch.normal(a.u, a.v),
  "Patch.curvature": (a) => a.patch.curvature(a.u, a.v),
  "Patch.deCasteljau": (a) => a.patch.deCasteljau(a.u, a.v),
  "Patch.isocurveAtU": (a) => a.patch.isocurveAtU(a.u),
  "Patch.isocurveAtV": (a) => a.patch.isocurveAtV(a.v),
  "Patch.splitU": (a) => a.patch.splitU(a.u),
  "Patch.splitV": (a) => a.patch.splitV(a.v),
  "Patch.split": (a) => a.patch.split(a.u, a.v),
  "Patch.elevate": (a) => a.patch.elevate(),
  "Patch.transform": (a) => a.patch.transform(matrix(a)),
  "Patch.movePoint": (a) => a.patch.movePoint(a.index, a.to),
  "Patch.bounds": (a) => a.patch.bounds(),
  "Patch.flatness": (a) => a.patch.flatness(),
  "Patch.area": (a) => a.patch.area(),
  "Patch.nearest": (a) => a.patch.nearest(a.p),
  "Patch.intersectRay": (a) => a.patch.intersectRay(a.origin, a.direction),
  "Patch.grid": (a) => a.patch.grid(grid(a)),
  "Patch.tessellate": (a) => a.patch.tessellate({ ...fineness(a), weld: a.weld }),
};

const SURFACE = {
  "Surface.constructor": ({ patch }) =>
    new Surface(
      {
        vertices: patch.controlPoints(),
        patches: [[...patch.controlPoints().keys()].slice(0, patch.controlPoints().length / 3)],
      },
      { degreeU: patch.degreeU, degreeV: patch.degreeV },
    ),
  "Surface.teapot": (a) => Surface.teapot({ ...parts(a), height: a.height, up: a.up }),
  "Surface.teacup": (a) => Surface.teacup({ up: a.up }),
  "Surface.teaspoon": (a) => Surface.teaspoon({ up: a.up }),
  "Surface.parse": (a) => Surface.parse(a.text),
  "Surface.toText": (a) => a.surface.toText(),
  "Surface.fromPatches": ({ surface }) =>
    Surface.fromPatches(Array.from({ length: surface.patchCount }, (_, k) => surface.patch(k))),
  "Surface.fromJSON": (a) => Surface.fromJSON(a.surface.toJSON()),
  "Surface.toJSON": (a) => a.surface.toJSON(),
  "Surface.vertices": (a) => a.surface.vertices,
  "Surface.patches": (a) => a.surface.patches,
  "Surface.patchCount": (a) => a.surface.patchCount,
  "Surface.patch": (a) => a.surface.patch(a.k),
  "Surface.movePoint": (a) => a.surface.movePoint(a.index, a.to),
  "Surface.topology": (a) => a.surface.topology(),
  "Surface.transform": (a) => a.surface.transform(matrix(a)),
  "Surface.bounds": (a) => a.surface.bounds(),
  "Surface.area": (a) => a.surface.area(),
  "Surface.volume": (a) => a.surface.volume(),
  "Surface.nearest": (a) => a.surface.nearest(a.p),
  "Surface.intersectRay": (a) => a.surface.intersectRay(a.origin, a.direction),
  "Surface.grid": (a) => a.surface.grid(grid(a)),
  "Surface.tessellate": (a) => a.surface.tessellate({ ...fineness(a), weld: a.weld }),
  "Surface.tessellateView": (a) => a.surface.tessellate({ ...view(a), weld: a.weld, precision: "f64" }),
  "Surface.isocurves": (a) => a.surface.isocurves({ lines: a.lines }),
  "Surface.wireframe": (a) => a.surface.wireframe(wire(a)),
  "Surface.subdivide": (a) => a.surface.subdivide(a.tolerance),
  "Surface.trace": (a) =>
    traced((target) => a.surface.trace(target, { matrix: a.view, lines: a.lines, tolerance: a.tolerance })),
  "Mesh.constructor": (a) => new Mesh(mesh(a)),
  "Mesh.toOBJ": (a) => mesh(a).toOBJ(),
  "Mesh.toSTL": (a) => mesh(a).toSTL(),
  "Mesh.toGLB": (a) => mesh(a).toGLB(),
  "Mesh.toThree": (a) => mesh(a).toThree(THREE).getAttribute("position").array,
  easing: (a) => easing(a.x1, a.y1, a.x2, a.y2)(a.x),
  "Easing.toLinear": (a) => easing(a.x1, a.y1, a.x2, a.y2).toLinear(a.tolerance),
};

/** Calls by the names of functions, in pieces of about equal work. */
export const GROUPS = [{ ...CURVE }, { ...SPLINE }, { ...PATH, ...PATCH }, { ...SURFACE }];
