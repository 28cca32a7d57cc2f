// What every answer is checked for: finite numbers; what makes the answers true of functions that only JavaScript has or writes
// itself. Those that Rust has as well are compared with it (parity.test.js).
import assert from "node:assert/strict";
import { Curve, easing, Path, Spline, Surface } from "casteljau";
import { RationalSurface } from "casteljau/nurbs";
import { coordinates, CUBIC } from "../reference.js";

/** Whose answers may be infinite by definition: the curvature at a cusp, and what is made from it. */
const INFINITE = new Set([
  "Curve.curvature",
  "RationalCurve.curvature",
  "NurbsCurve.curvature",
  "RationalPatch.curvature",
  "NurbsSurface.curvature",
  "Curve.torsion",
  "Spline.curvature",
  "Spline.torsion",
  "Path.curvature",
]);

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
  if (value instanceof Surface || value instanceof RationalSurface) return visit(value.vertices, see);
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
const ascend = (ts, least, most) => {
  const at = [...ts].findIndex((t, k) => !(t >= least && t <= most && (k === 0 || ts[k - 1] < t)));
  if (at >= 0) assert.fail(`${ts.slice(Math.max(at - 1, 0), at + 1)} at ${at} do not ascend from ${least} to ${most}`);
};

/** Checks of single functions: the answer, the arguments, the size of the coordinates. */
const CHECKS = {
  "Curve.fromJSON": (again, { curve }) => assert.ok(again.equals(curve)),
  "Curve.toSVG": (text, { curve, precision }) => {
    const path = Path.fromSVG(text);
    if (precision === undefined && curve.degree <= 3) assert.ok(path.equals(new Path([curve])), text);
  },
  "RationalPatch.fromJSON": (again, { rationalpatch }) => assert.ok(again.equals(rationalpatch)),
  "NurbsSurface.fromJSON": (again, { nurbssurface }) => assert.ok(again.equals(nurbssurface)),
  "RationalCurve.fromJSON": (again, { rationalcurve }) => assert.ok(again.equals(rationalcurve)),
  "NurbsCurve.fromJSON": (again, { nurbscurve }) => assert.ok(again.equals(nurbscurve)),
  "Spline.fromJSON": (again, { spline }) => assert.ok(again.equals(spline)),
  "Spline.toBSpline": ({ points, ...options }, { spline }) =>
    assert.ok(Spline.fromBSpline(points, options).equals(spline)),
  "Spline.pointAtLength": ({ t, point }, { spline }, size) => {
    assert.ok(t >= 0 && t <= spline.segmentCount, `t = ${t}`);
    close(point, spline.eval(t), slackOf(size, 24), "the point at t");
  },
  "Spline.extrema": (extrema, { spline }) => {
    for (const ts of Object.values(extrema)) ascend(ts, 0, spline.segmentCount);
  },
  "Spline.timesAtCoordinate": (ts, { spline }) => ascend(ts, 0, spline.segmentCount),
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
  "Path.fromSVG": (path, { text }) => {
    const written = path.toSVG();
    assert.ok(isReadBack(path, written), "another path is read from what was written");
    assert.ok(path.toSVG().length <= 600 * (text.length + 1), "the output is not linear in the input");
  },
  "Path.toSVG": (text, { path, precision }) => {
    const low = path.subpaths.every(({ degrees }) => degrees.every((degree) => degree <= 3));
    if (precision === undefined && low) assert.ok(isReadBack(path, text), text);
  },
  "Patch.fromJSON": (again, { patch }) => assert.ok(again.equals(patch)),
  "Surface.toText": (text) => assert.equal(Surface.parse(text).toText(), text),
  "Surface.fromPatches": (joined, { surface }) => {
    for (let k = 0; k < surface.patchCount; k++) assert.ok(joined.patch(k).equals(surface.patch(k)), `patch ${k}`);
  },
  "Surface.fromJSON": (again, { surface }) => assert.equal(again.toText(), surface.toText()),
  "Surface.parse": (surface, { text }) => {
    assert.equal(Surface.parse(surface.toText()).toText(), surface.toText());
    assert.ok(surface.vertices.length / 3 + surface.patchCount <= text.length, "more than the text can say");
  },
  "RationalSurface.toText": (text) => assert.equal(RationalSurface.parse(text).toText(), text),
  "RationalSurface.from": (weighted, { surface }) => assert.equal(weighted.toText(), surface.toText()),
  "RationalSurface.fromPatches": (joined, { rationalsurface }) => {
    assert.equal(joined.patchCount, rationalsurface.patchCount);
    for (let k = 0; k < joined.patchCount; k++) {
      const [a, b] = [joined.patch(k), rationalsurface.patch(k)];
      // Points that become one vertex may differ in the signs of zeros.
      const [points, given] = [a, b].map((patch) => patch.controlPoints().map((x) => x + 0));
      assert.deepEqual(points, given, `patch ${k}`);
      // The quotients of weights are c·rⁱ·sʲ.
      const columns = a.degreeU + 1;
      const weights = b.weights();
      const logarithms = a.weights().map((w, i) => Math.log(w / weights[i]));
      const [c, r, s] = [0, 1, columns].map((i, at) => logarithms[i] - (at && logarithms[0]));
      logarithms.forEach((logarithm, i) => {
        const expected = c + (i % columns) * r + Math.floor(i / columns) * s;
        assert.ok(Math.abs(logarithm - expected) < 1e-9, `weight ${i} of patch ${k}`);
      });
    }
  },
  "RationalSurface.fromJSON": (again, { rationalsurface }) => assert.equal(again.toText(), rationalsurface.toText()),
  "RationalSurface.parse": (surface, { text }) => {
    assert.equal(RationalSurface.parse(surface.toText()).toText(), surface.toText());
    assert.ok(surface.vertices.length / 3 + surface.patchCount <= text.length, "more than the text can say");
  },
  "Mesh.toSTL": (bytes) => assert.equal((bytes.length - 84) % 50, 0),
  "Easing.toLinear": (text, { x1, y1, x2, y2, tolerance }) => {
    const [ease, linear] = [easing(x1, y1, x2, y2), easing(text)];
    for (let k = 0; k <= 100; k++)
      assert.ok(Math.abs(ease(k / 100) - linear(k / 100)) <= tolerance * (1 + 1e-9), `${text} at ${k / 100}`);
  },
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
