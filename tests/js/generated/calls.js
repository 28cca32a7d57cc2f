// For each public function the call that a generated case means.
import assert from "node:assert/strict";
import { Curve, easing, InkStroke, Mesh, Patch, Path, Spline, Surface } from "casteljau";
import { NurbsCurve, NurbsSurface, RationalCurve, RationalPatch, RationalSurface } from "casteljau/nurbs";
import * as THREE from "three";
import { recorder, withPath2D } from "../reference.js";

const curveOf = ({ points, dimension }) => new Curve(points, { dimension });
const rationalOf = ({ points, weights, dimension }) => new RationalCurve(points, weights, { dimension });
const rationalPatchOf = ({ points, weights, degrees: [degreeU, degreeV] }) =>
  new RationalPatch(points, weights, { degreeU, degreeV });
const nurbsSurfaceOf = ({ points, weights, degrees: [degreeU, degreeV], knots: [knotsU, knotsV] }) =>
  new NurbsSurface({ degreeU, degreeV, points, weights, knotsU, knotsV });
const splineOf = ({ points, degrees, closed, dimension }) => Spline.fromJSON({ points, degrees, closed, dimension });
const pathOf = (splines) => new Path(splines.map(splineOf));
const patchOf = ({ vertices, degrees: [[degreeU, degreeV]] }) => new Patch(vertices, { degreeU, degreeV });
const surfaceOf = ({ text }) => Surface.parse(text);
const rationalSurfaceOf = ({ text }) => RationalSurface.parse(text);

/** The arguments of a case as values of the package; what is left out is undefined. */
export function argumentsOf(given) {
  const a = {};
  for (const [name, value] of Object.entries(given)) a[name] = value ?? undefined;
  for (const name of ["curve", "other"])
    if (a[name]?.points && !a[name].degrees && !a[name].weights) a[name] = curveOf(a[name]);
  if (given.curve?.knots?.length) a.curve = new NurbsCurve(a.curve);
  for (const name of ["spline", "other"]) if (a[name]?.degrees) a[name] = splineOf(a[name]);
  if (given.other?.knots?.length) a.other = new NurbsCurve(given.other);
  else if (given.other?.weights) a.other = rationalOf(given.other);
  if (a.rationalcurve) a.rationalcurve = rationalOf(a.rationalcurve);
  if (a.nurbscurve) a.nurbscurve = new NurbsCurve(a.nurbscurve);
  if (a.rationalpatch) a.rationalpatch = rationalPatchOf(a.rationalpatch);
  if (a.nurbssurface) a.nurbssurface = nurbsSurfaceOf(a.nurbssurface);
  if (a.path) a.path = pathOf(a.path);
  if (Array.isArray(a.other)) a.other = pathOf(a.other);
  if (a.patch) a.patch = patchOf(a.patch);
  if (a.surface) a.surface = surfaceOf(a.surface);
  if (a.rationalsurface) a.rationalsurface = rationalSurfaceOf(a.rationalsurface);
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
/** What a path draws on a builder. */
const drawn = (a) => {
  const builder = Path.builder();
  a.path.trace(/** @type {any} */ (builder), { tolerance: a.tolerance });
  return builder.build();
};
/** The point of a curve of three.js at an arc length, and its tangent. */
const coordinatesOf = (curve, s) => {
  const u = curve.getUtoTmapping(0, s);
  return [...curve.getPoint(u).toArray(), ...curve.getTangent(u).toArray()];
};
/** Joints from the start on, and that of the end of an open spline. */
const jointsOf = ({ segmentCount, closed }) => segmentCount + (closed ? 0 : 1);
const pointsOfPath = (path) => path.subpaths.flatMap((spline) => spline.toJSON().points);
const grid = (a) => ({ segments: { u: a.segments_u, v: a.segments_v }, quads: a.quads });
const fineness = (a) => (a.cells === undefined ? { tolerance: a.tolerance } : { segments: a.cells });
const view = (a) => ({ pixels: a.pixels, viewProjection: a.view, viewport: [640, 480] });
const wire = (a) =>
  a.wire === "tube" ? { lines: a.lines, radius: a.width, sides: a.sides } : { lines: a.lines, width: a.width };
const mesh = (a) => a.surface.grid({ segments: a.segments_u, quads: a.quads });
const parts = (a) =>
  Object.fromEntries(["rim", "body", "handle", "spout", "lid", "bottom"].map((part) => [part, a.parts.includes(part)]));
/** The join and the cap of a stroke. */
const ends = ({ join }) => ({ join, cap: { round: "round", miter: "square", bevel: "butt" }[join] });
const fitting = (a) => ({ tolerance: a.tolerance, cornerAngle: a.corner_angle });
const svg = (a) => ({ precision: a.precision, tolerance: a.tolerance });

/**
 * Rows of methods and fields whose arguments a case gives by name.
 *
 * @param {string} name a class
 * @param {string} list names with those of their arguments: "length tolerance; degree"
 */
function methods(name, list) {
  const receiver = name.toLowerCase();
  const rows = list.split(";").map((text) => {
    const [member, ...names] = text.trim().split(" ");
    const call = (a) => {
      assert.ok(member in a[receiver], `${name}.${member} is absent`);
      const value = a[receiver][member];
      const values = names.map((each) => a[each]);
      return typeof value === "function" ? value.apply(a[receiver], values) : value;
    };
    return [`${name}.${member}`, call];
  });
  return Object.fromEntries(rows);
}

const CURVE = {
  ...methods(
    "Curve",
    `
    toJSON; toString; degree; dimension; controlPoints; points; equals other tolerance; eval t; evalAt ts; sample segments; derivative;
    derivativeAt t k; tangent t; normal t; curvature t; torsion t; frames segments; length tolerance;
    timeAtLength s tolerance; pointAtLength s; equidistantTimes segments; area; split t; halve; subsegment t0 t1;
    reverse; elevate; reduce; deCasteljau t; toBasis basis; flatten tolerance; subdivide tolerance; bounds;
    controlBounds; hull; intersections other; selfIntersections; nearest p; extrema; inflections; cusps; classify;
    tangentsFrom p; distanceTo other; hausdorff other
  `,
  ),
  "Curve.constructor": (a) => new Curve(a.points, dimensionOf(a.points)),
  "Curve.splitAt": (a) => a.curve.split(a.ts),
  "Curve.fromBasis": (a) => Curve.fromBasis(a.basis, a.points, dimensionOf(a.points)),
  "Curve.fromJSON": (a) => Curve.fromJSON(a.curve.toJSON()),
  "Curve.bernstein": (a) => Curve.bernstein(a.degree, a.t),
  "Curve.basisMatrix": (a) => Curve.basisMatrix(a.basis),
  "Curve.interpolate": (a) => Curve.interpolate(a.points, a.ts, dimensionOf(a.points)),
  "Curve.framesAt": (a) => a.curve.frames(a.ts, { normal: a.normal }),
  "Curve.transform": (a) => a.curve.transform(matrix(a)),
  "Curve.timesAtCoordinate": (a) => a.curve.timesAtCoordinate({ [axes[a.axis]]: a.value }),
  "Curve.offset": (a) => a.curve.offset(a.distance, { tolerance: a.tolerance }),
  "Curve.trace": (a) => traced((target) => a.curve.trace(target, { tolerance: a.tolerance })),
  "Curve.toSVG": (a) => a.curve.toSVG(svg(a)),
  "Curve.toThree": (a) => coordinatesOf(a.curve.toThree(THREE), a.s),
};

const RATIONAL = {
  ...methods(
    "RationalCurve",
    `
    toJSON; toString; degree; dimension; controlPoints; points; weights; eval t; evalAt ts; sample segments; derivativeAt t k;
    tangent t; normal t; curvature t; split t; halve; subsegment t0 t1; reverse; elevate; reparametrize; bounds; controlBounds;
    extrema; inflections; intersections other; selfIntersections; length; timeAtLength s; pointAtLength s; area; nearest p;
    flatten tolerance
  `,
  ),
  "RationalCurve.constructor": (a) => new RationalCurve(a.points, a.weights, dimensionOf(a.points)),
  "RationalCurve.conic": ({ points: [p0, p1, p2], w }) => RationalCurve.conic(p0, p1, p2, w),
  "RationalCurve.from": (a) => RationalCurve.from(a.curve),
  "RationalCurve.fromJSON": (a) => RationalCurve.fromJSON(a.rationalcurve.toJSON()),
  "RationalCurve.splitAt": (a) => a.rationalcurve.split(a.ts),
  "RationalCurve.equals": (a) => a.rationalcurve.equals(a.rationalcurve.reverse(), a.tolerance),
  "RationalCurve.transform": (a) => a.rationalcurve.transform(matrix(a)),
  "RationalCurve.project": (a) => a.rationalcurve.transform(a.map),
  "RationalCurve.intersectionsWithCurve": (a) => a.rationalcurve.intersections(a.curve),
  "RationalCurve.toSpline": (a) => a.rationalcurve.toSpline({ tolerance: a.tolerance }),
  "RationalCurve.trace": (a) => traced((target) => a.rationalcurve.trace(target, { tolerance: a.tolerance })),
  "RationalCurve.toSVG": (a) => a.rationalcurve.toSVG({ tolerance: a.tolerance }),
};

/** A radius, which is not negative. */
const radius = (x) => Math.abs(x);
const start = (a) => a.nurbscurve.segments()[0].points()[0];

const NURBS = {
  ...methods(
    "NurbsCurve",
    `
    toJSON; toString; degree; dimension; closed; domain; controlPoints; points; weights; knots; greville; segments; joints; eval t;
    evalAt ts; sample segments; derivativeAt t k; tangent t; normal t; curvature t; insertKnot t times; removeKnot t; refine ts;
    elevate; split t; subsegment t0 t1; reverse; bounds; controlBounds; extrema; length; timeAtLength s; pointAtLength s; area;
    nearest p; flatten tolerance; intersections other; selfIntersections
  `,
  ),
  "NurbsCurve.constructor": (a) => new NurbsCurve(a.nurbscurve.toJSON()),
  "NurbsCurve.arc": (a) => NurbsCurve.arc(start(a), 2, a.start, a.end),
  "NurbsCurve.circle": (a) => NurbsCurve.circle(start(a), radius(a.radius)),
  "NurbsCurve.ellipse": (a) => NurbsCurve.ellipse(start(a), radius(a.radius), radius(a.other_radius), a.rotation),
  "NurbsCurve.interpolate": (a) => NurbsCurve.interpolate(a.points, { degree: a.degree, ...dimensionOf(a.points) }),
  "NurbsCurve.from": (a) => NurbsCurve.from(a.spline),
  "NurbsCurve.fromJSON": (a) => NurbsCurve.fromJSON(a.nurbscurve.toJSON()),
  "NurbsCurve.equals": (a) => a.nurbscurve.equals(a.nurbscurve.reverse(), a.tolerance),
  "NurbsCurve.transform": (a) => a.nurbscurve.transform(matrix(a)),
  "NurbsCurve.project": (a) => a.nurbscurve.transform(a.map),
  "NurbsCurve.toSpline": (a) => a.nurbscurve.toSpline({ tolerance: a.tolerance }),
  "NurbsCurve.trace": (a) => traced((target) => a.nurbscurve.trace(target, { tolerance: a.tolerance })),
  "NurbsCurve.toSVG": (a) => a.nurbscurve.toSVG({ tolerance: a.tolerance }),
};

const RATIONAL_PATCH = {
  ...methods(
    "RationalPatch",
    `
    toJSON; toString; degreeU; degreeV; controlPoints; weights; eval u v; partials u v; normal u v; curvature u v; isocurveAtU u;
    isocurveAtV v; splitU u; splitV v; elevate; bounds
  `,
  ),
  "RationalPatch.constructor": (a) => a.rationalpatch,
  "RationalPatch.from": (a) => RationalPatch.from(a.patch),
  "RationalPatch.fromJSON": (a) => RationalPatch.fromJSON(a.rationalpatch.toJSON()),
  "RationalPatch.equals": (a) => a.rationalpatch.equals(a.rationalpatch, Math.abs(a.tolerance)),
  "RationalPatch.transform": (a) => a.rationalpatch.transform(matrix(a)),
  "RationalPatch.project": (a) => a.rationalpatch.transform(a.map),
};

const axisOf = (a) => ({ axis: a.points[1] });

/** The parameters of the domain that are nearest to u and v. */
const inside = ({ nurbssurface: { domain }, u, v }) => [
  Math.min(Math.max(u, domain.u[0]), domain.u[1]),
  Math.min(Math.max(v, domain.v[0]), domain.v[1]),
];

const NURBS_SURFACE = {
  ...methods(
    "NurbsSurface",
    `
    toJSON; toString; degreeU; degreeV; domain; controlPoints; weights; knotsU; knotsV; jointsU; jointsV; patches; eval u v;
    insertKnotU u times; insertKnotV v times; elevateU; elevateV; splitU u; splitV v;
    isocurveAtU u; isocurveAtV v; reverse; bounds; toSurface
  `,
  ),
  "NurbsSurface.partials": (a) => a.nurbssurface.partials(...inside(a)),
  "NurbsSurface.normal": (a) => a.nurbssurface.normal(...inside(a)),
  "NurbsSurface.curvature": (a) => a.nurbssurface.curvature(...inside(a)),
  "NurbsSurface.constructor": (a) => a.nurbssurface,
  "NurbsSurface.fromJSON": (a) => NurbsSurface.fromJSON(a.nurbssurface.toJSON()),
  "NurbsSurface.equals": (a) => a.nurbssurface.equals(a.nurbssurface.reverse(), a.tolerance),
  "NurbsSurface.transform": (a) => a.nurbssurface.transform(matrix(a)),
  "NurbsSurface.project": (a) => a.nurbssurface.transform(a.map),
  "NurbsSurface.plane": (a) => NurbsSurface.plane(a.points[0], a.points[1], a.points[2]),
  "NurbsSurface.cylinder": (a) => NurbsSurface.cylinder(a.points[0], a.radius, a.height, axisOf(a)),
  "NurbsSurface.cone": (a) => NurbsSurface.cone(a.points[0], a.radius, a.height, axisOf(a)),
  "NurbsSurface.sphere": (a) => NurbsSurface.sphere(a.points[0], a.radius, axisOf(a)),
  "NurbsSurface.torus": (a) => NurbsSurface.torus(a.points[0], a.major, a.minor, axisOf(a)),
  "NurbsSurface.ruled": (a) => NurbsSurface.ruled(a.curve, a.other),
  "NurbsSurface.extrude": (a) => NurbsSurface.extrude(a.curve, a.vector),
  "NurbsSurface.revolve": (a) =>
    NurbsSurface.revolve(a.curve, { origin: a.origin, axis: a.axis, angle: 2 * Math.PI * (2 * a.angle - 1) }),
  "NurbsSurface.loft": (a) => NurbsSurface.loft([a.curve, a.other, a.curve.reverse()], { degree: a.degree }),
};

const SPLINE = {
  ...methods(
    "Spline",
    `
    toJSON; toString; controlPoints; points; dimension; closed; segmentCount; degrees; segments; eval t; evalAt ts; sample segments;
    derivativeAt t k; tangent t; normal t; curvature t; torsion t; split t; subsegment t0 t1; hull; extrema;
    frames segments; length tolerance; timeAtLength s tolerance; pointAtLength s; equidistantTimes segments; area;
    bounds; controlBounds; continuity joint tolerance; append p; insert t; remove joint; setJoint joint mode; reverse;
    nearest p; flatten tolerance; intersections other; selfIntersections; simplify tolerance; toBSpline
  `,
  ),
  "Spline.constructor": (a) => new Spline(a.points, { degree: a.degree, closed: a.closed, ...dimensionOf(a.points) }),
  "Spline.splitAt": (a) => a.spline.split(a.ts),
  "Spline.fromCurves": (a) => Spline.fromCurves(a.spline.segments(), { closed: a.spline.closed }),
  "Spline.fromBSpline": (a) =>
    Spline.fromBSpline(a.points, { degree: a.degree, knots: a.knots, closed: a.closed, ...dimensionOf(a.points) }),
  "Spline.fromJSON": (a) => Spline.fromJSON(a.spline.toJSON()),
  "Spline.interpolate": (a) =>
    Spline.interpolate(a.points, {
      kind: a.kind,
      alpha: a.kind === "natural" ? undefined : a.alpha,
      closed: a.closed,
      ...dimensionOf(a.points),
    }),
  "Spline.fit": (a) => Spline.fit(a.points, { ...fitting(a), closed: a.closed, ...dimensionOf(a.points) }),
  "Spline.equals": (a) => a.spline.equals(a.spline.reverse(), a.tolerance),
  "Spline.timesAtCoordinate": (a) => a.spline.timesAtCoordinate({ [axes[a.axis]]: a.value }),
  "Spline.movePoint": (a) => a.spline.movePoint(a.index, a.to, { joints: a.modes.slice(0, jointsOf(a.spline)) }),
  "Spline.framesAt": (a) => a.spline.frames(a.ts, { normal: a.normal }),
  "Spline.transform": (a) => a.spline.transform(matrix(a)),
  "Spline.offset": (a) => a.spline.offset(a.distance, { tolerance: a.tolerance, join: a.join }),
  "Spline.trace": (a) => traced((target) => a.spline.trace(target, { tolerance: a.tolerance })),
  "Spline.toSVG": (a) => a.spline.toSVG(svg(a)),
  "Spline.toThree": (a) => coordinatesOf(a.spline.toThree(THREE), a.s),
};

const PATH = {
  ...methods(
    "Path",
    `
    toJSON; toString; subpathCount; bounds; controlBounds; length tolerance; timeAtLength s tolerance; equidistantTimes segments;
    area; moments; nearest p; windingNumber p; flatten tolerance; simplify tolerance; intersections other; selfIntersections; reverse;
    sample segments; pointAtLength s tolerance; extrema
  `,
  ),
  "Path.constructor": (a) => new Path(a.path.subpaths),
  "Path.fromSVG": (a) => Path.fromSVG(a.text),
  "Path.fromJSON": (a) => Path.fromJSON(a.path.toJSON()),
  "Path.subpaths": (a) => [...a.path.subpaths],
  "Path.equals": (a) => a.path.equals(a.path.reverse(), a.tolerance),
  "Path.contains": (a) => a.path.contains(a.p, { fillRule: a.rule }),
  "Path.union": (a) => a.path.union(a.other, { fillRule: a.rule }),
  "Path.intersect": (a) => a.path.intersect(a.other, { fillRule: a.rule }),
  "Path.subtract": (a) => a.path.subtract(a.other, { fillRule: a.rule }),
  "Path.exclude": (a) => a.path.exclude(a.other, { fillRule: a.rule }),
  "Path.combine": (a) => Path.combine([a.path, a.other, a.path], "exclude", { fillRule: a.rule }),
  "Path.removeOverlaps": (a) => a.path.removeOverlaps({ fillRule: a.rule }),
  "Path.faces": (a) => Path.faces([a.path, a.other], { fillRule: a.rule }),
  "Path.divide": (a) => a.path.divide(a.other, { fillRule: a.rule }),
  "Path.clip": (a) => a.path.clip(a.other, { fillRule: a.rule }),
  "Path.stroke": (a) => a.path.stroke(a.width, { ...ends(a), tolerance: a.tolerance }),
  "Path.strokeSides": (a) =>
    a.path.stroke({ left: a.width, right: a.distance }, { join: a.join, tolerance: a.tolerance }),
  "Path.strokeContains": (a) => a.path.strokeContains(a.p, a.width, ends(a)),
  "Path.dash": (a) => a.path.dash([a.s, a.width], a.offset),
  "Path.offset": (a) => a.path.offset(a.distance, { join: a.join, tolerance: a.tolerance }),
  // The radius of a line is infinite.
  "Path.toArcs": (a) => a.path.toArcs(a.tolerance).map((list) => list.map((arc) => ({ ...arc, radius: 0 }))),
  "Path.roundCorners": (a) => a.path.roundCorners(a.radius),
  "Path.roundCornersBy": (a) => a.path.roundCorners(({ t }) => a.radius * ((0.25 * t) % 1)),
  "Path.filledArea": (a) => a.path.area({ fillRule: a.rule }),
  "Path.filledMoments": (a) => a.path.moments({ fillRule: a.rule }),
  "Path.transform": (a) => a.path.transform(matrix(a)),
  "Path.trace": (a) => traced((target) => a.path.trace(target, { tolerance: a.tolerance })),
  "Path.toSVG": (a) => a.path.toSVG(svg(a)),
  "Path.eval": (a) => a.path.eval(location(a)),
  "Path.evalAt": (a) => a.path.evalAt(a.path.equidistantTimes(a.segments)),
  "Path.derivativeAt": (a) => a.path.derivativeAt(location(a), a.order),
  "Path.tangent": (a) => a.path.tangent(location(a)),
  "Path.normal": (a) => a.path.normal(location(a)),
  "Path.curvature": (a) => a.path.curvature(location(a)),
  "Path.split": (a) => a.path.split(location(a)),
  "Path.splitAt": (a) => a.path.split([location(a), location(a, 0, 0.5)]),
  "Path.subsegment": (a) => a.path.subsegment(location(a, a.k, a.t0), location(a, a.last, a.t1)),
  "Path.timesAtCoordinate": (a) => a.path.timesAtCoordinate({ [axes[a.axis]]: a.value }),
  "Path.toPath2D": (a) => withPath2D(recorder(), () => a.path.toPath2D({ tolerance: a.tolerance })).calls,
  "Path.toPathData": (a) => a.path.toPathData({ tolerance: a.tolerance }).map(({ values }) => values),
  "Path.fromPathData": (a) => Path.fromPathData(a.path.toPathData({ tolerance: a.tolerance })),
  "Path.builder": (a) => drawn(a),
  "Path.toCSS": (a) => a.path.toCSS(svg(a)),
  "Path.toThree": (a) => a.path.toThree(THREE, { fillRule: a.rule }).map(({ holes }) => holes.length),
  "Path.index": (a) => {
    const index = Path.index(a.path.subpaths.map((spline) => new Path([spline])));
    return [index.nearest(a.p), index.containing(a.p, { fillRule: a.rule })];
  },
  "Path.lengthAt": (a) => a.path.lengthAt(location(a)),
  "Path.from": (a) => Path.from([a.path, ...a.path.subpaths]),
  "Path.circle": (a) => Path.circle(a.p, Math.abs(a.radius), { tolerance: a.tolerance }),
  "Path.ellipse": (a) => Path.ellipse(a.p, Math.abs(a.radius), Math.abs(a.other_radius), a.rotation),
  "Path.arc": (a) => Path.arc(a.p, Math.abs(a.radius), a.t0, a.t1),
  "Path.rect": (a) => Path.rect(a.p, Math.abs(a.width), Math.abs(a.height), { radii: Math.abs(a.radius) }),
  "Path.polygon": (a) => Path.polygon(pointsOfPath(a.path), { closed: a.closed }),
};

const PATCH = {
  ...methods(
    "Patch",
    `
    toJSON; degreeU; degreeV; controlPoints; equals patch tolerance; eval u v; partials u v; normal u v; curvature u v;
    deCasteljau u v; isocurveAtU u; isocurveAtV v; splitU u; splitV v; split u v; elevate; movePoint index to; bounds;
    flatness; area; nearest p; intersectRay origin direction
  `,
  ),
  "Patch.constructor": (a) => a.patch,
  "Patch.fromBasis": (a) => Patch.fromBasis(a.basis, a.points),
  "Patch.fromJSON": (a) => Patch.fromJSON(a.patch.toJSON()),
  "Patch.transform": (a) => a.patch.transform(matrix(a)),
  "Patch.grid": (a) => a.patch.grid(grid(a)),
  "Patch.tessellate": (a) => a.patch.tessellate({ ...fineness(a), weld: a.weld }),
};

const SURFACE = {
  ...methods(
    "Surface",
    `
    toText; toJSON; vertices; patches; patchCount; patch k; movePoint index to; topology; bounds; area; volume;
    nearest p; intersectRay origin direction; subdivide tolerance
  `,
  ),
  "Surface.constructor": ({ patch }) => {
    const vertices = patch.controlPoints();
    const { degreeU, degreeV } = patch;
    return new Surface({ vertices, patches: [[...Array(vertices.length / 3).keys()]] }, { degreeU, degreeV });
  },
  "Surface.teapot": (a) => Surface.teapot({ ...parts(a), height: a.height, up: a.up }),
  "Surface.teacup": (a) => Surface.teacup({ up: a.up }),
  "Surface.teaspoon": (a) => Surface.teaspoon({ up: a.up }),
  "Surface.parse": (a) => Surface.parse(a.text),
  "Surface.fromPatches": ({ surface }) =>
    Surface.fromPatches(Array.from({ length: surface.patchCount }, (_, k) => surface.patch(k))),
  "Surface.fromJSON": (a) => Surface.fromJSON(a.surface.toJSON()),
  "Surface.transform": (a) => a.surface.transform(matrix(a)),
  "Surface.grid": (a) => a.surface.grid(grid(a)),
  "Surface.tessellate": (a) => a.surface.tessellate({ ...fineness(a), weld: a.weld }),
  "Surface.tessellateF64": (a) => a.surface.tessellate({ ...fineness(a), weld: a.weld, precision: "f64" }),
  "Surface.tessellateView": (a) => a.surface.tessellate({ ...view(a), weld: a.weld }),
  "Surface.isocurves": (a) => a.surface.isocurves({ lines: a.lines }),
  "Surface.wireframe": (a) => a.surface.wireframe(wire(a)),
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

const RATIONAL_SURFACE = {
  ...methods(
    "RationalSurface",
    `
    toText; toJSON; vertices; patches; patchCount; weights; patch k; movePoint index to; topology; bounds; area; volume;
    nearest p; intersectRay origin direction
  `,
  ),
  "RationalSurface.constructor": ({ rationalpatch }) => {
    const [vertices, weights] = [rationalpatch.controlPoints(), [rationalpatch.weights()]];
    const patches = [[...Array(weights[0].length).keys()]];
    const { degreeU, degreeV } = rationalpatch;
    return new RationalSurface({ vertices, patches, weights }, { degreeU, degreeV });
  },
  "RationalSurface.from": (a) => RationalSurface.from(a.surface),
  "RationalSurface.parse": (a) => RationalSurface.parse(a.text),
  "RationalSurface.fromPatches": ({ rationalsurface: surface }) =>
    RationalSurface.fromPatches(Array.from({ length: surface.patchCount }, (_, k) => surface.patch(k))),
  "RationalSurface.solidOfRevolution": (a) =>
    RationalSurface.solidOfRevolution(a.curve, {
      origin: a.origin,
      axis: a.axis,
      angle: 2 * Math.PI * Math.max(-1, Math.min(2 * (2 * a.angle - 1), 1)),
    }),
  "RationalSurface.fromJSON": (a) => RationalSurface.fromJSON(a.rationalsurface.toJSON()),
  "RationalSurface.transform": (a) => a.rationalsurface.transform(matrix(a)),
  "RationalSurface.grid": (a) => a.rationalsurface.grid(grid(a)),
  "RationalSurface.tessellate": (a) => a.rationalsurface.tessellate({ ...fineness(a), weld: a.weld }),
  "RationalSurface.tessellateF64": (a) =>
    a.rationalsurface.tessellate({ ...fineness(a), weld: a.weld, precision: "f64" }),
  "RationalSurface.tessellateView": (a) => a.rationalsurface.tessellate({ ...view(a), weld: a.weld }),
  "RationalSurface.isocurves": (a) => a.rationalsurface.isocurves({ lines: a.lines }),
  "RationalSurface.wireframe": (a) => a.rationalsurface.wireframe(wire(a)),
  "RationalSurface.trace": (a) =>
    traced((target) => a.rationalsurface.trace(target, { matrix: a.view, lines: a.lines, tolerance: a.tolerance })),
};

/** Calls by the names of functions, in pieces of about equal work. */
/** A stroke of the samples of a case. */
const ink = (a) => {
  const options = { size: Math.abs(a.width), thinning: 2 * a.part - 1, smoothing: a.part, streamline: 1 - a.part };
  const stroke = new InkStroke({ ...options, pressure: a.pressure ? "device" : "simulated" });
  for (const [x, y] of a.points) stroke.append(x, y, { pressure: a.part });
  return stroke;
};
const INK = {
  "InkStroke.constructor": (a) => ink(a).widths(),
  "InkStroke.append": (a) => ink(a).append(0, 0).spline(),
  "InkStroke.changes": (a) => ink(a).changes(a.points.slice(0, 1)),
  "InkStroke.outline": (a) => ink(a).outline(),
  "InkStroke.spline": (a) => ink(a).spline(),
  "InkStroke.widths": (a) => ink(a).widths(),
};

export const GROUPS = [
  { ...CURVE, ...RATIONAL },
  { ...NURBS, ...SPLINE },
  { ...PATH, ...INK, ...PATCH },
  { ...SURFACE, ...RATIONAL_PATCH },
  { ...NURBS_SURFACE, ...RATIONAL_SURFACE },
];
