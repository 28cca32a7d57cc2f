// @ts-nocheck: these calls pass what the types refuse.
// What would be ignored silently is refused: unknown and contradictory options, surplus arguments.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Patch, Path, Spline, Surface } from "casteljau";
import { CUBIC, pointsOf, SEVEN, SPACE } from "./reference.js";

const cubic = new Curve(CUBIC);
const space = new Curve(SPACE);
const seven = new Spline(SEVEN);
const path = new Path([seven]);
const patch = new Patch(Array.from({ length: 16 }, (_, k) => [k % 4, k >> 2, 0]));
const surface = Surface.fromPatches([patch]);
const START = { subpath: 0, t: 0 };
const mesh = surface.grid({ segments: 1 });
const target = { moveTo() {}, lineTo() {}, quadraticCurveTo() {}, bezierCurveTo() {}, closePath() {} };

const refuses = (act, message) => assert.throws(act, { name: "TypeError", message });

/** Every function with options: a call with the given ones. */
const CALLS = {
  "new Curve": (options) => new Curve(CUBIC, options),
  "Curve.fromBasis": (options) => Curve.fromBasis("bezier", CUBIC, options),
  "Curve.interpolate": (options) => Curve.interpolate(CUBIC, undefined, options),
  "curve.sample": (options) => cubic.sample(2, options),
  "curve.evalAt": (options) => cubic.evalAt([0], options),
  "curve.frames": (options) => space.frames(2, options),
  "curve.offset": (options) => cubic.offset(1, options),
  "curve.toSVG": (options) => cubic.toSVG(options),
  "curve.trace": (options) => cubic.trace(target, options),
  "new Spline": (options) => new Spline(SEVEN, options),
  "Spline.fromCurves": (options) => Spline.fromCurves([cubic], options),
  "Spline.interpolate": (options) => Spline.interpolate(SEVEN, options),
  "Spline.fromBSpline": (options) => Spline.fromBSpline(SEVEN, options),
  "spline.sample": (options) => seven.sample(2, options),
  "spline.evalAt": (options) => seven.evalAt([0], options),
  "spline.offset": (options) => seven.offset(1, options),
  "spline.movePoint": (options) => seven.movePoint(1, [0, 0], options),
  "spline.toSVG": (options) => seven.toSVG(options),
  "spline.trace": (options) => seven.trace(target, options),
  "path.toSVG": (options) => path.toSVG(options),
  "path.trace": (options) => path.trace(target, options),
  "new Patch": (options) => new Patch(new Float64Array(48), options),
  "patch.grid": (options) => patch.grid({ segments: 1, ...options }),
  "patch.tessellate": (options) => patch.tessellate({ segments: 1, ...options }),
  "new Surface": (options) => new Surface({ vertices: [], patches: [] }, options),
  "Surface.teapot": (options) => Surface.teapot(options),
  "Surface.teacup": (options) => Surface.teacup(options),
  "Surface.teaspoon": (options) => Surface.teaspoon(options),
  "surface.grid": (options) => surface.grid({ segments: 1, ...options }),
  "surface.tessellate": (options) => surface.tessellate({ segments: 1, ...options }),
  "surface.isocurves": (options) => surface.isocurves(options),
  "surface.wireframe": (options) => surface.wireframe({ radius: 0.1, ...options }),
  "surface.trace": (options) => surface.trace(target, { matrix: [1, 0, 0, 1, 0, 0], ...options }),
  "mesh.toOBJ": (options) => mesh.toOBJ(options),
};

for (const [name, call] of Object.entries(CALLS)) {
  test(`${name}: unknown options`, () => {
    refuses(() => call({ zzz: 1 }), /^zzz: unknown option; expected \w/);
    call({ zzz: undefined });
    call({});
  });
}

test("unknown options: the nearest known one is suggested", () => {
  refuses(() => cubic.offset(1, { tol: 1 }), "tol: unknown option; did you mean tolerance?");
  refuses(() => cubic.toSVG({ precison: 2 }), "precison: unknown option; did you mean precision?");
  refuses(() => cubic.toSVG({ Tolerance: 2 }), "Tolerance: unknown option; did you mean tolerance?");
  refuses(() => surface.grid({ segment: 2 }), "segment: unknown option; did you mean segments?");
  refuses(() => seven.offset(1, { jion: "miter" }), "jion: unknown option; expected tolerance, join");
  refuses(() => new Spline(SEVEN, { isClosed: true }), "isClosed: unknown option; did you mean closed?");
  refuses(() => cubic.offset(1, { ["x".repeat(1e6)]: 1 }), /^x{40}…: unknown option; expected tolerance$/);
});

const hintOf = (got, option) => `options: expected an object, got ${got}; did you mean { ${option} }?`;

test("options: not an object of options", () => {
  refuses(() => cubic.sample(2, new Float64Array(6)), /^options: expected an object, got an object \(Float64Array\)$/);
  refuses(() => new Curve(CUBIC, [2]), /^options: expected an object, got an array of 1$/);
  refuses(() => cubic.toSVG(2), "options: expected an object, got 2; did you mean { precision: 2 }?");
  refuses(() => cubic.offset(1, 2), "options: expected an object, got 2; did you mean { tolerance: 2 }?");
  refuses(() => surface.grid(8), "options: expected an object, got 8; did you mean { segments: 8 }?");
  refuses(() => surface.tessellate(0.1), "options: expected an object, got 0.1; did you mean { tolerance: 0.1 }?");
  refuses(() => new Curve(CUBIC, 2), "options: expected an object, got 2");
  refuses(() => path.contains([0, 0], "evenodd"), hintOf('"evenodd"', 'fillRule: "evenodd"'));
  refuses(() => path.area("nonzero"), hintOf('"nonzero"', 'fillRule: "nonzero"'));
  refuses(() => path.offset(1, "round"), hintOf('"round"', 'join: "round"'));
  refuses(() => Spline.interpolate(SEVEN, "natural"), hintOf('"natural"', 'kind: "natural"'));
  refuses(() => new Spline(SEVEN, true), hintOf("true", "closed: true"));
  refuses(() => cubic.toSVG("2"), 'options: expected an object, got "2"');
  cubic.toSVG(/** @type {any} */ (null));
});

test("words: the nearest known one is suggested", () => {
  const range = (act, message) => assert.throws(act, { name: "RangeError", message });
  const operations = 'operation: expected one of "union", "intersect", "exclude", got';
  range(() => Path.combine([path], "unite"), `${operations} "unite"; did you mean "union"?`);
  range(() => Path.combine([path], "intersection"), `${operations} "intersection"; did you mean "intersect"?`);
  for (const other of ["subtract", "xor", "difference", ""])
    range(() => Path.combine([path], other), `${operations} "${other}"`);
  range(() => seven.setJoint(1, "G1"), /, got "G1"; did you mean "g1"\?$/);
});

test("widths and points in other forms", () => {
  const got = "width: expected a number or a profile, got an array of 2; did you mean { stops: [[0, 1], …] }?";
  refuses(() => path.stroke(pointsOf("0,1 1,2")), got);
  refuses(() => path.strokeContains([0, 0], [2, 4]), got);
  refuses(() => path.contains(1, 2), /^point: expected a point .*got 1; did you mean \[x, y\]\?$/);
});

test("modes of joints: each is checked, and none is ignored", () => {
  const range = (joints, message) =>
    assert.throws(() => seven.movePoint(1, [0, 0], { joints }), { name: "RangeError", message });
  range({ 2: "smooth" }, /^joints\[2\]: expected one of "free", .* got "smooth"$/);
  range({ 3: "g1" }, "joints: expected joints from 0 to 2, got 3");
  range({ "-1": "g1" }, "joints: expected joints from 0 to 2, got -1");
  range({ first: "g1" }, "joints: expected joints from 0 to 2, got first");
  const closed = new Spline(SEVEN.slice(1), { closed: true });
  const act = () => closed.movePoint(1, [0, 0], { joints: ["g1", "g1", "g1"] });
  assert.throws(act, { name: "RangeError", message: "joints: expected joints from 0 to 1, got 2" });
  const ends = seven.movePoint(2, [1, 2], { joints: ["free", "c1", undefined, undefined] });
  assert.ok(ends.equals(seven.movePoint(2, [1, 2], { joints: { 1: "c1" } })));
});

test("arcs of SVG text take the place of the tolerance", () => {
  refuses(() => path.toSVG({ arcs: 0.1, tolerance: 0.01 }), "tolerance: expected none with arcs 0.1, got 0.01");
  assert.match(path.toSVG({ arcs: 0.1, tolerance: undefined, precision: 1 }), /^M0 0A/);
});

test("structured clones of values lose their class: the message says what to do", () => {
  const hint = "got an object without keys; structuredClone and postMessage need toJSON() and fromJSON()";
  /** @type {[() => unknown, string][]} */
  const calls = [
    [() => cubic.equals(structuredClone(cubic)), "other: expected a Curve"],
    [() => cubic.intersections(structuredClone(path)), "other: expected a Curve, a Spline or a Path"],
    [() => seven.equals(structuredClone(seven)), "other: expected a Spline"],
    [() => Spline.fromCurves([structuredClone(cubic)]), "curves[0]: expected a Curve"],
    [() => path.equals(structuredClone(path)), "other: expected a Path"],
    [() => path.union(structuredClone(path)), "other: expected a Path"],
    [() => path.clip(structuredClone(path)), "region: expected a Path"],
    [() => Path.combine([structuredClone(path)], "union"), "paths[0]: expected a Path"],
    [() => Path.index([structuredClone(path)]), "paths[0]: expected a Path"],
    [() => Path.from(structuredClone(path)), "shapes: expected a Path, a Spline or a Curve"],
    [() => new Path([structuredClone(seven)]), "splines[0]: expected a Spline or a Curve"],
    [() => Surface.fromPatches([structuredClone(patch)]), "patches[0]: expected a Patch"],
    [() => Curve.fromJSON(structuredClone(cubic)), "json: expected an object with points"],
    [() => Spline.fromJSON(structuredClone(seven)), "json: expected an object with points, degrees and closed"],
    [() => Path.fromJSON(structuredClone(path)), "json: expected an object with subpaths"],
    [() => Patch.fromJSON(structuredClone(patch)), "json: expected an object with net"],
    [() => Surface.fromJSON(structuredClone(surface)), "json: expected an object with vertices and patches"],
  ];
  for (const [act, expected] of calls) refuses(act, `${expected}, ${hint}`);
  for (const value of [cubic, seven, patch])
    assert.ok(value.constructor.fromJSON(structuredClone(value.toJSON())).equals(value));
  refuses(() => cubic.equals({ x: 1 }), "other: expected a Curve, got an object with x");
});

test("coordinates instead of points", () => {
  for (const make of [(...a) => new Curve(...a), (...a) => new Spline(...a), (...a) => Path.polygon(...a)]) {
    refuses(() => make(0, 0, 100, 100), "points: expected an array of points, got 0; did you mean [[x, y], …]?");
    refuses(() => make("0 0"), 'points: expected an array of points, got "0 0"');
  }
});

test("options that are true or false", () => {
  const json = { ...seven.toJSON(), closed: "false" };
  refuses(() => Spline.fromJSON(json), 'closed: expected true or false, got "false"');
  refuses(() => Path.fromJSON({ subpaths: [json] }), 'closed: expected true or false, got "false"');
  refuses(() => Surface.teapot({ lid: 0 }), "lid: expected true or false, got 0");
  refuses(() => new Spline(SEVEN.slice(1), { closed: 1 }), "closed: expected true or false, got 1");
  refuses(() => Spline.fromCurves([cubic], { closed: "no" }), 'closed: expected true or false, got "no"');
  refuses(() => surface.grid({ segments: 1, quads: null }), "quads: expected true or false, got null");
  assert.equal(Surface.teapot({ lid: false }).patchCount, 24);
  assert.equal(Surface.teapot({ lid: undefined }).patchCount, 32);
});

test("contradictory options", () => {
  const detail = /^options: expected \{segments\}, \{tolerance\} or \{pixels, viewProjection, viewport\}, got /;
  refuses(() => surface.tessellate({ tolerance: 0.1, segments: 2 }), /, got segments and tolerance$/);
  refuses(() => surface.tessellate({ tolerance: 0.1, pixels: 2 }), detail);
  refuses(() => surface.tessellate({}), /, got none of them$/);
  refuses(() => surface.tessellate({ segments: 2, viewport: [1, 1] }), "viewport: expected pixels, got segments");
  refuses(() => surface.wireframe({ width: 0.1, sides: 3 }), "sides: expected radius (tubes have sides), got width");
  refuses(() => Spline.interpolate(SEVEN, { alpha: 1 }), /^alpha: expected kind "catmull-rom".* got "natural"$/);
  surface.tessellate({ tolerance: 0.1, segments: undefined });
});

/** Methods without arguments, and methods with one. @type {[any, string, string][]} */
const METHODS = [
  [cubic, "reduce extrema selfIntersections area", "flatten intersections nearest pointAtLength subdivide"],
  [seven, "extrema selfIntersections area", "flatten intersections length nearest pointAtLength insert"],
  [path, "bounds extrema selfIntersections", "flatten intersections length"],
  [patch, "elevate bounds area flatness", "nearest"],
  [surface, "bounds area volume toText", "nearest subdivide"],
  [mesh, "toSTL toGLB", ""],
];

test("surplus arguments", () => {
  for (const [shape, without, withOne] of METHODS) {
    for (const name of without.split(" ")) refuses(() => shape[name](0.1), `${name}: expected no arguments, got 1`);
    for (const name of withOne.split(" ").filter(Boolean)) {
      const point = shape === patch || shape === surface ? [0, 0, 0] : [0, 0];
      const argument = name === "intersections" ? cubic : name === "nearest" ? point : 0.1;
      refuses(() => shape[name](argument, 0.5), `${name}: expected 1 argument, got 2`);
    }
  }
  const calls = [
    [() => cubic.split(0.2, 0.6), "split: expected 1 argument, got 2; did you mean subsegment(t0, t1)?"],
    [() => cubic.halve(0.2), "halve: expected no arguments, got 1; did you mean split(t)?"],
    [() => cubic.subsegment(0, 1, 2), "subsegment: expected 2 arguments, got 3"],
    [() => cubic.derivative(0.5), "derivative: expected no arguments, got 1; did you mean derivativeAt(t)?"],
    [() => cubic.hull(0.5), "hull: expected no arguments, got 1; did you mean deCasteljau(t)?"],
    [() => cubic.length(0.1, 0.5), "length: expected 1 argument, got 2; did you mean subsegment(t0, t1).length()?"],
    [() => cubic.bounds(0, 0.5), "bounds: expected no arguments, got 2; did you mean subsegment(t0, t1).bounds()?"],
    [() => seven.bounds(0, 0.5), "bounds: expected no arguments, got 2; did you mean subsegment(t0, t1).bounds()?"],
    [() => path.split(START, START), "split: expected 1 argument, got 2; did you mean subsegment(from, to)?"],
    [
      () => path.nearest([0, 0], 5),
      "nearest: expected 1 argument, got 2; did you mean Path.index([path]).nearest(point, { maxDistance })?",
    ],
    [() => path.subsegment(START, START, 1), "subsegment: expected 2 arguments, got 3"],
    [() => Path.from(cubic, seven), "from: expected 1 argument, got 2; did you mean from([a, b])?"],
    [() => patch.splitU(0.5, 0.5), "splitU: expected 1 argument, got 2; did you mean split(u, v)?"],
    [() => patch.splitV(0.5, 0.5), "splitV: expected 1 argument, got 2; did you mean split(u, v)?"],
  ];
  for (const [act, message] of calls) refuses(act, message);
  cubic.split(0.5, undefined);
  assert.equal([cubic, seven].map(Path.from).length, 2);
  assert.deepEqual([cubic.toJSON()].map(Curve.fromJSON)[0].toJSON(), cubic.toJSON()); // other functions can be callbacks
});

test("timesAtCoordinate: exactly one coordinate", () => {
  const one = (axes, got) => `where: expected exactly one of ${axes}, got an object ${got}`;
  refuses(() => cubic.timesAtCoordinate({ x: 1, y: 2 }), one("x, y", "with x, y"));
  refuses(() => cubic.timesAtCoordinate({ x: 1, z: 2 }), one("x, y", "with x, z"));
  refuses(() => space.timesAtCoordinate({}), one("x, y, z", "without keys"));
});

test("matrices with elements", () => {
  const elements = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1];
  assert.deepEqual(space.transform({ elements }).eval(0), space.transform(elements).eval(0));
  assert.deepEqual(new Curve([0, 0, 1, 1]).transform({ elements }).eval(0), { x: 5, y: 6 });
  const wrong = { name: "RangeError", message: "matrix.elements: expected 16 numbers, got 9" };
  assert.throws(() => space.transform({ elements: new Float32Array(9) }), wrong);
  refuses(
    () => space.transform({ element: elements }),
    "matrix: expected 6 or 16 numbers, a DOMMatrix or an object with elements, got an object with element",
  );
  refuses(() => space.transform(undefined), /^matrix: expected 6 or 16 numbers.* got undefined$/);
});

test("nets as rows of points", () => {
  const flat = Array.from({ length: 6 }, (_, k) => [k % 3, k, k * k]);
  const rows = [flat.slice(0, 3), flat.slice(3)];
  const degrees = { degreeU: 2, degreeV: 1 };
  assert.ok(new Patch(rows, degrees).equals(new Patch(flat, degrees)));
  const objects = rows.map((row) => row.map(([x, y, z]) => ({ x, y, z })));
  assert.ok(new Patch(objects, degrees).equals(new Patch(flat, degrees)));
  const range = (act, message) => assert.throws(act, { name: "RangeError", message });
  assert.ok(new Patch(rows).equals(new Patch(flat, degrees)));
  assert.deepEqual([new Patch(objects).degreeU, new Patch(objects).degreeV], [2, 1]);
  range(() => new Patch(rows, { degreeV: 3 }), "net: expected 4 rows of 3 points (degrees 2 × 3), got 2 rows");
  range(() => new Patch([rows[0], flat.slice(4)]), "net[1]: expected a row of 3 points, got 2");
  range(() => new Patch([flat.slice(0, 3), flat.slice(4)], degrees), "net[1]: expected a row of 3 points, got 2");
  range(() => new Patch(flat), "net: expected 16 control points in rows of 4 along u (degrees 3 × 3), got 6");
  refuses(() => new Patch([rows[0], null], degrees), "net[1]: expected a row of 3 points, got null");
});

test("messages contain no names of classes that minifiers change", () => {
  class Renamed {
    member = 1;
  }
  const got = (value, expected) => refuses(() => cubic.equals(value), `other: expected a Curve, got ${expected}`);
  got(new Renamed(), "an object with member");
  got(Renamed, "a function");
  got(new Date(0), "an object (Date)");
  got(seven, "a Spline");
  got(path, "a Path");
  got(patch, "a Patch");
  got(surface, "a Surface");
  got(mesh, "a Mesh");
});
