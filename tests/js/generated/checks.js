// What every answer is checked for: finite numbers; for many functions what makes the answer true. The deep checks of the
// core are in tests/generated; here stands what could go wrong between the core and JavaScript.
import assert from "node:assert/strict";
import { Curve, easing, Path, Spline, Surface } from "casteljau";
import { coordinates, CUBIC } from "../reference.js";

/** Whose answers may be infinite by definition: the curvature at a cusp, and what is made from it. */
const INFINITE = new Set(["Curve.curvature", "Curve.torsion", "Spline.curvature", "Spline.torsion", "Path.curvature"]);

/** All numbers of an answer. @param {any} value @param {(x: number) => void} see */
function visit(value, see) {
  if (typeof value === "number") return see(value);
  if (typeof value !== "object" || value === null) return;
  if (ArrayBuffer.isView(value)) {
    for (const x of /** @type {Float64Array} */ (value)) see(x);
    return;
  }
  if (Array.isArray(value)) return value.forEach((item) => visit(item, see));
  if (value instanceof Path) return value.subpaths.forEach((spline) => visit(spline, see));
  if (value instanceof Surface) return visit(value.vertices, see);
  if (typeof value.controlPoints === "function") return visit(value.controlPoints(), see);
  Object.values(value).forEach((item) => visit(item, see));
}

/** No NaN, and no infinity unless coordinates lie near the ends of the range (mode "Extreme"). */
export function checkNumbers(name, { mode }, answer) {
  const bounded = mode !== "Extreme" && !INFINITE.has(name);
  visit(answer, (x) => {
    if (x - x !== 0) assert.ok(!Number.isNaN(x) && !bounded, `the answer holds ${x}`);
  });
}

/** A refusal: of the right class, with what was expected and what came. */
export function checkRefusal(error) {
  const isOfClass = error?.constructor === RangeError || error?.constructor === TypeError;
  assert.ok(isOfClass, `neither a RangeError nor a TypeError: ${error?.stack ?? error}`);
  assert.match(error.message, /expected .*(got |needs )/s);
}

/** After a refusal the package works on. */
export function works() {
  assert.deepEqual(new Curve(CUBIC).eval(0.5), { x: 4, y: 6 });
  assert.deepEqual(new Spline(CUBIC).flatten(100).points.length >= 4, true);
}

const distance = (p, q) => Math.hypot(...coordinates(p).map((x, k) => x - coordinates(q)[k]));
/** 64 (n + 2) roundings of the largest coordinate. */
const slackOf = (size, degree) => 64 * (degree + 2) * Number.EPSILON * size + Number.MIN_VALUE;
const close = (p, q, slack, what) =>
  assert.ok(distance(p, q) <= slack, `${what}: ${distance(p, q)} apart, more than ${slack}`);
const growth = (t, degree) => (Math.abs(t) + Math.abs(1 - t)) ** degree;
const ascend = (ts, least, most) => {
  const at = [...ts].findIndex((t, k) => !(t >= least && t <= most && (k === 0 || ts[k - 1] < t)));
  if (at >= 0) assert.fail(`${ts.slice(Math.max(at - 1, 0), at + 1)} at ${at} do not ascend from ${least} to ${most}`);
};
const inside = ({ min, max }, p, slack) =>
  coordinates(p).every((x, k) => x >= coordinates(min)[k] - slack && x <= coordinates(max)[k] + slack);

const isMesh = (mesh) => {
  const count = mesh.positions.length / 3;
  assert.equal(mesh.normals.length, 3 * count);
  const isIndex = mesh.indices.every((i) => i < count);
  assert.ok(isIndex, "an index past the vertices");
  assert.ok(mesh.indices.length % 3 === 0 && (mesh.quads ?? []).every((i) => i < count));
};

/** Checks of single functions: the answer, the arguments, the size of the coordinates. */
const CHECKS = {
  "Curve.eval": (p, { curve, t }, size) =>
    close(p, curve.evalAt([t]), slackOf(size, curve.degree) * growth(t, curve.degree), "eval and evalAt"),
  "Curve.split": ([left, right], { curve, t }, size) => {
    const slack = slackOf(size, curve.degree) * growth(t, curve.degree);
    close(left.eval(1), right.eval(0), 0, "the pieces at the joint");
    close(left.eval(1), curve.eval(t), slack, "the joint");
  },
  "Curve.reverse": (reversed, { curve }) => assert.ok(reversed.reverse().equals(curve)),
  "Curve.fromJSON": (again, { curve }) => assert.ok(again.equals(curve)),
  "Curve.equidistantTimes": (ts, { segments }) =>
    assert.deepEqual([ts.length, ts[0], ts[segments]], [segments + 1, 0, 1]),
  "Curve.sample": (points, { curve, segments }) => assert.equal(points.length, (segments + 1) * curve.dimension),
  "Curve.flatten": ({ points, ts }, { curve }, size) => {
    ascend(ts, 0, 1);
    assert.equal(points.length, ts.length * curve.dimension);
    close(points.slice(-curve.dimension), curve.eval(1), slackOf(size, 1), "the last vertex");
  },
  "Curve.bounds": (box, { curve }, size) => {
    for (let k = 0; k <= 8; k++)
      assert.ok(inside(box, curve.eval(k / 8), slackOf(size, curve.degree)), `B(${k / 8}) lies outside`);
  },
  "Curve.length": (length, { curve }, size) => {
    const chord = distance(curve.eval(0), curve.eval(1));
    assert.ok(length >= chord * (1 - 1e-11) - slackOf(size, curve.degree), "less than the chord");
  },
  "Curve.nearest": (answer, { curve, p }, size) => {
    const slack = slackOf(size, curve.degree);
    close(answer.point, curve.eval(answer.t), slack, "the point at t");
    for (let k = 0; k <= 16; k++)
      assert.ok(answer.distance <= distance(curve.eval(k / 16), p) + slack, `B(${k / 16}) is nearer`);
  },
  "Curve.intersections": (found, { curve, other }, size) => {
    const slack = slackOf(size, Math.max(curve.degree, other.degree));
    for (const { t, u } of found) close(curve.eval(t), other.eval(u), slack, `the curves at ${t}, ${u}`);
  },
  "Curve.selfIntersections": (found, { curve }, size) => {
    for (const { t, u } of found)
      close(curve.eval(t), curve.eval(u), slackOf(size, curve.degree), `the curve at ${t}, ${u}`);
  },
  "Curve.distanceTo": ({ distance: d, t, u }, { curve, other }, size) => {
    const slack = slackOf(size, Math.max(curve.degree, other.degree)) + 1e-11 * d;
    assert.ok(Math.abs(distance(curve.eval(t), other.eval(u)) - d) <= slack, "another distance there");
  },
  "Curve.inflections": (ts) => ascend(ts, 0, 1),
  "Curve.cusps": (ts) => ascend(ts, 0, 1),
  "Curve.tangentsFrom": (ts) => ascend(ts, 0, 1),
  "Curve.toSVG": (text, { curve, precision }) => {
    const path = Path.fromSVG(text);
    if (precision === undefined && curve.degree <= 3) assert.ok(path.equals(new Path([curve])), text);
  },
  "Spline.fromJSON": (again, { spline }) => assert.ok(again.equals(spline)),
  "Spline.reverse": (reversed, { spline }) => assert.ok(reversed.reverse().equals(spline)),
  "Spline.fromCurves": (again, { spline }) => assert.ok(again.equals(spline)),
  "Spline.toBSpline": ({ points, ...options }, { spline }) =>
    assert.ok(Spline.fromBSpline(points, options).equals(spline)),
  "Spline.split": ([left, right], { spline, t }, size) => {
    assert.ok(!left.closed && !right.closed);
    close(left.eval(left.segmentCount), right.eval(0), 0, "the parts at the joint");
    const outside = Math.max(0, -t, t - spline.segmentCount);
    close(right.eval(0), spline.eval(t), slackOf(size, 24) * growth(1 + outside, 24), "the joint");
  },
  "Spline.subsegment": (part, { spline, t0, t1 }, size) => {
    const inside = t0 >= 0 && t1 >= 0 && Math.max(t0, t1) <= spline.segmentCount;
    if (!inside) return;
    close(part.eval(0), spline.eval(t0), slackOf(size, 24), "the start");
    close(part.eval(part.segmentCount), spline.eval(t1), slackOf(size, 24), "the end");
  },
  "Spline.pointAtLength": ({ t, point }, { spline }, size) => {
    assert.ok(t >= 0 && t <= spline.segmentCount, `t = ${t}`);
    close(point, spline.eval(t), slackOf(size, 24), "the point at t");
  },
  "Spline.extrema": (extrema, { spline }) => {
    for (const ts of Object.values(extrema)) ascend(ts, 0, spline.segmentCount);
  },
  "Spline.timesAtCoordinate": (ts, { spline }) => ascend(ts, 0, spline.segmentCount),
  "Spline.nearest": (answer, { spline }, size) => {
    assert.ok(answer.t >= 0 && answer.t <= spline.segmentCount, `t = ${answer.t}`);
    close(answer.point, spline.eval(answer.t), slackOf(size, 24), "the point at t");
  },
  "Spline.flatten": ({ points, ts }, { spline }) => {
    ascend(ts, 0, spline.segmentCount);
    assert.equal(points.length, ts.length * spline.dimension);
  },
  "Spline.intersections": (found, { spline, other }, size) => {
    for (const { t, u } of found) close(spline.eval(t), other.eval(u), slackOf(size, 24), `the splines at ${t}, ${u}`);
  },
  "Spline.movePoint": (moved, { index, to }) =>
    close(moved.controlPoints().slice(index * to.length, (index + 1) * to.length), to, 0, "the point"),
  "Path.fromJSON": (again, { path }) => assert.ok(again.equals(path)),
  "Path.constructor": (again, { path }) => assert.ok(again.equals(path)),
  "Path.from": (twice, { path }) => assert.ok(twice.equals(new Path([...path.subpaths, ...path.subpaths]))),
  "Path.pointAtLength": (found, { path }) => found && assert.deepEqual(found.point, path.eval(found)),
  "Path.timesAtCoordinate": (times, { path, axis, value }, size) => {
    for (const time of times)
      assert.ok(Math.abs(coordinates(path.eval(time))[axis] - value) <= 1e-9 * (size + Math.abs(value)));
  },
  "Path.fromPathData": (again, { path, tolerance }) =>
    assert.equal(again.toSVG(), Path.fromSVG(path.toSVG({ tolerance, arcs: false })).toSVG()),
  "Path.builder": (again, { path, tolerance }) =>
    assert.equal(again.toSVG(), Path.fromSVG(path.toSVG({ tolerance, arcs: false })).toSVG()),
  "Path.reverse": (reversed, { path }) => assert.ok(reversed.reverse().equals(path)),
  "Path.fromSVG": (path, { text }) => {
    const written = path.toSVG();
    assert.ok(isReadBack(path, written), "another path is read from what was written");
    assert.ok(path.toSVG().length <= 600 * (text.length + 1), "the output is not linear in the input");
  },
  "Path.toSVG": (text, { path, precision }) => {
    const low = path.subpaths.every(({ degrees }) => degrees.every((degree) => degree <= 3));
    if (precision === undefined && low) assert.ok(isReadBack(path, text), text);
  },
  "Patch.eval": (p, { patch, u, v }, size) => {
    const slack = slackOf(size, patch.degreeU + patch.degreeV) * growth(u, patch.degreeU) * growth(v, patch.degreeV);
    close(p, patch.isocurveAtU(u).eval(v), slack, "eval and the isocurve");
  },
  "Patch.fromJSON": (again, { patch }) => assert.ok(again.equals(patch)),
  "Patch.nearest": (answer, { patch, p }, size) => {
    const slack = slackOf(size, 48);
    close(answer.point, patch.eval(answer.u, answer.v), slack, "the point at (u, v)");
    assert.ok(Math.abs(distance(answer.point, p) - answer.distance) <= slack, "another distance");
  },
  "Patch.bounds": (box, { patch }, size) => {
    for (let k = 0; k <= 4; k++)
      assert.ok(inside(box, patch.eval(k / 4, 0.5), slackOf(size, 48)), "a point lies outside");
  },
  "Patch.grid": isMesh,
  "Patch.tessellate": isMesh,
  "Surface.grid": isMesh,
  "Surface.tessellate": isMesh,
  "Surface.tessellateView": isMesh,
  "Surface.wireframe": isMesh,
  "Surface.toText": (text) => assert.equal(Surface.parse(text).toText(), text),
  "Surface.fromPatches": (joined, { surface }) => {
    for (let k = 0; k < surface.patchCount; k++) assert.ok(joined.patch(k).equals(surface.patch(k)), `patch ${k}`);
  },
  "Surface.fromJSON": (again, { surface }) => assert.equal(again.toText(), surface.toText()),
  "Surface.parse": (surface, { text }) => {
    assert.equal(Surface.parse(surface.toText()).toText(), surface.toText());
    assert.ok(surface.vertices.length / 3 + surface.patchCount <= text.length, "more than the text can say");
  },
  "Mesh.toSTL": (bytes) => assert.equal((bytes.length - 84) % 50, 0),
  "Easing.toLinear": (text, { x1, y1, x2, y2, tolerance }) => {
    const [ease, linear] = [easing(x1, y1, x2, y2), easing(text)];
    for (let k = 0; k <= 100; k++)
      assert.ok(Math.abs(ease(k / 100) - linear(k / 100)) <= tolerance * (1 + 1e-9), `${text} at ${k / 100}`);
  },
  easing: (y, { x }) => assert.ok((x !== 0 && x !== 1) || y === x, `${y} at ${x}`),
};

/** @param {string} name @param {{ mode: string, size: number }} given @param {unknown} answer @param {object} values */
export function checkAnswer(name, given, answer, values) {
  checkNumbers(name, given, answer);
  if (given.mode !== "Extreme") CHECKS[name]?.(answer, values, given.size, given.mode);
}

/** Whether a text is read as the path that was written; arcs are read up to rounding. */
function isReadBack(path, text) {
  let size = 0;
  if (text.includes("A"))
    for (const spline of path.subpaths) for (const x of spline.controlPoints()) size = Math.max(size, Math.abs(x));
  return Path.fromSVG(text).equals(path, 1e-13 * size);
}
