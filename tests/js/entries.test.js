// The entry points casteljau, casteljau/core, casteljau/nurbs, casteljau/surfaces and casteljau/slim together in one program.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import * as complete from "casteljau";
import * as coreEntry from "casteljau/core";
import * as nurbs from "casteljau/nurbs";
import * as slim from "casteljau/slim";
import * as surfaces from "casteljau/surfaces";
import { build } from "esbuild";
import { refused, refusedAll, untyped } from "./reference.js";

const root = fileURLToPath(new URL("../../", import.meta.url));
await slim.init(await readFile(new URL("../../dist/casteljau.wasm", import.meta.url)));

const ARCH = [0, 0, 0, 2, 3, 2, 3, 0];
const LINE = [-1, 1, 4, 1];
/** The abscissas at which the arch y = 6t(1 − t) has the height 1. */
const ROOTS = [(3 - Math.sqrt(3)) / 6, (3 + Math.sqrt(3)) / 6];
const WITH_CURVES = /** @type {Record<string, typeof complete>} */ (
  /** @type {unknown} */ ({ complete, core: coreEntry, slim })
);

test("entries: what each one exports", () => {
  const all = ["Curve", "InkStroke", "Mesh", "Patch", "Path", "Spline", "Surface", "easing", "init"];
  assert.deepEqual(Object.keys(complete).sort(), all);
  assert.deepEqual(Object.keys(slim).sort(), all);
  assert.deepEqual(Object.keys(coreEntry).sort(), ["Curve", "Path", "Spline", "init"]);
  assert.deepEqual(
    Object.keys(nurbs).sort(),
    "Curve Mesh NurbsCurve NurbsSurface RationalCurve RationalPatch RationalSurface Spline init".split(" "),
  );
  assert.deepEqual(Object.keys(surfaces).sort(), ["Curve", "Mesh", "Patch", "Surface", "init"]);
});

test("entries: import and require give the same classes", () => {
  const require = createRequire(import.meta.url);
  assert.equal(require("casteljau").Curve, complete.Curve);
  assert.equal(require("casteljau/core").Curve, coreEntry.Curve);
  assert.equal(require("casteljau/nurbs").NurbsCurve, nurbs.NurbsCurve);
  assert.equal(require("casteljau/surfaces").Surface, surfaces.Surface);
});

test("entries: init is optional, and starts the module of its entry", async () => {
  await coreEntry.init();
  await nurbs.init();
  await surfaces.init();
  assert.deepEqual(new coreEntry.Curve(LINE).eval(0.5), { x: 1.5, y: 1 });
});

test("entries: every class of curves is accepted where a curve is expected", () => {
  for (const [name, { Curve }] of Object.entries(WITH_CURVES)) {
    const line = new Curve(LINE);
    for (const { Curve: Other, Path } of [complete, slim]) {
      const arch = new Other(ARCH);
      const found = arch.intersections(line).map(({ t }) => t);
      assert.ok(found.length === 2 && found.every((t, k) => Math.abs(t - ROOTS[k]) < 1e-14), `${name}: ${found}`);
      assert.equal(arch.distanceTo(line).distance, 0);
      assert.equal(arch.hausdorff(new Curve(ARCH)), 0);
      assert.ok(arch.equals(new Curve(ARCH)) && new Curve(ARCH).equals(arch) && !arch.equals(line));
      assert.equal(new Path([arch]).intersections(line).length, 2);
    }
  }
});

test("entries: every class of splines is accepted where a spline is expected", () => {
  for (const { Curve, Spline } of Object.values(WITH_CURVES)) {
    const spline = new Spline([...ARCH, 3, -2, 6, -2, 6, 0]);
    for (const { Spline: Other, Curve: OtherCurve, Path } of [complete, slim]) {
      const other = Other.fromCurves(spline.segments());
      assert.ok(other.equals(spline) && spline.equals(other));
      assert.equal(new OtherCurve(LINE).intersections(spline).length, 2);
      assert.equal(other.intersections(new Spline([...LINE, 5, 1], { degree: 1 })).length, 2);
      assert.equal(new Path([spline, new Curve(LINE)]).subpathCount, 2);
    }
  }
});

test("entries: paths and patches of casteljau and casteljau/slim are accepted by each other", () => {
  const outlines = [complete, slim].map(({ Path }) => Path.fromSVG("M0 0H4V4H0Z"));
  const line = [complete, slim].map(({ Path }) => Path.fromSVG("M-1 1L5 1"));
  assert.ok(outlines[0].equals(outlines[1]) && outlines[1].equals(outlines[0]) && !outlines[0].equals(line[1]));
  assert.equal(outlines[0].intersections(line[1]).length, 2);
  assert.equal(outlines[1].intersections(line[0]).length, 2);
  const patches = [complete, slim, surfaces].map(({ Surface }) => Surface.teacup().patch(5));
  assert.ok(patches.every((patch) => patches.every((other) => patch.equals(other))));
});

/** The names of the methods of a class, inherited ones included, without those that are only for the package. */
function methodsOf(Class) {
  const names = new Set();
  for (let each = Class; each !== Function.prototype && each !== Object.prototype; each = Object.getPrototypeOf(each))
    for (const name of Object.getOwnPropertyNames(each)) if (/^[a-z]/.test(name)) names.add(name);
  return [...names].sort();
}

test("entries: a small entry point has every method of casteljau, or one that names it", () => {
  const refusals = { "casteljau/core": coreEntry, "casteljau/surfaces": surfaces };
  for (const [entry, classes] of Object.entries(refusals)) {
    for (const [name, Class] of Object.entries(classes)) {
      if (name === "init") continue;
      const Whole = Reflect.get(complete, name);
      assert.equal(Class.name, name);
      assert.deepEqual(methodsOf(Class), methodsOf(Whole), `${entry}: statics of ${name}`);
      assert.deepEqual(methodsOf(Class.prototype), methodsOf(Whole.prototype), `${entry}: ${name}`);
    }
  }
  const refused = (call, method) =>
    assert.throws(call, { name: "TypeError", message: `${method} is in "casteljau", not in "casteljau/core"` });
  refused(() => untyped(new coreEntry.Curve(ARCH)).offset(1), "Curve.offset");
  refused(() => untyped(coreEntry.Spline).fit([], {}), "Spline.fit");
  refused(() => untyped(coreEntry.Path.circle([0, 0], 1)).union(), "Path.union");
  refused(() => untyped(coreEntry.Path.circle([0, 0], 1).subpaths[0]).simplify(1), "Spline.simplify");
});

test("entries: the measures of casteljau/core are those of casteljau", () => {
  const d = "M0 0C10 40 60 -40 70 0S140 9 80 60Q40 90 0 50ZM5 5H9V9H5Z";
  const [small, whole] = [WITH_CURVES.core, complete].map(({ Curve, Spline, Path }) => {
    const [curve, path] = [new Curve(ARCH), Path.fromSVG(d)];
    const spline = new Spline([...ARCH, 3, -2, 6, -2, 6, 0]);
    return [curve, spline, path].map((each) => [
      each.length(),
      each.timeAtLength(3),
      each.pointAtLength(3),
      each.equidistantTimes(5),
      each.nearest([2, 1]),
      each.bounds(),
      each.area(),
      each.flatten(0.1),
      each instanceof Path && each.contains([4, 4]),
    ]);
  });
  assert.deepEqual(small, whole);
});

test("entries: paths of casteljau/core", () => {
  const { Path } = coreEntry;
  const ring = Path.circle([0, 0], 2);
  assert.ok([ring, ring.reverse(), Path.from(ring), Path.fromSVG("M0 0H1")].every((p) => p instanceof Path));
  assert.ok(Path.builder().build() instanceof Path && [ring].map(/** @type {any} */ (Path.from))[0] instanceof Path);
  const whole = complete.Path.circle([0, 0], 2);
  assert.ok(ring.equals(whole) && whole.equals(ring) && complete.Path.from(ring).union(whole).area() > 12.5);
  assert.equal(whole.union(/** @type {any} */ (ring)).area(), whole.union(whole).area());
  assert.equal(ring.length(), whole.length());
  assert.ok(ring.subpaths[0] instanceof coreEntry.Spline && ring.subpaths[0].segments()[0] instanceof coreEntry.Curve);
  assert.deepEqual(
    complete.Path.index([whole, ring]).nearest([3, 0]),
    complete.Path.index([ring, whole]).nearest([3, 0]),
  );
  const { circle } = /** @type {any} */ (Path);
  assert.throws(() => circle([0, 0], 2), {
    name: "TypeError",
    message: /^expected a call of a static method on its class, as Path\.circle/,
  });
  assert.throws(
    () => Path.fromSVG("M0 0L"),
    (/** @type {any} */ error) => error.path instanceof Path,
  );
});

test("entries: methods return the classes of their own entry", () => {
  for (const { Curve, Spline } of Object.values(WITH_CURVES)) {
    const curve = new Curve(ARCH);
    const curves = [...curve.split(0.3), curve.derivative(), curve.reverse(), curve.subdivide(10).curve];
    assert.ok(curves.every((each) => each instanceof Curve));
    assert.ok(Curve.fromJSON(curve.toJSON()) instanceof Curve);
    const spline = Spline.fromCurves(curve.split(0.5));
    assert.ok([spline, spline.reverse(), spline.insert(0.5)].every((each) => each instanceof Spline));
    assert.ok(spline.segments().every((each) => each instanceof Curve));
    assert.ok(Spline.fromJSON(spline.toJSON()) instanceof Spline);
  }
  const { Patch, Surface } = surfaces;
  const surface = Surface.teapot().movePoint(0, [0, 0, 9]);
  const patch = surface.patch(0);
  assert.ok(surface instanceof Surface && patch instanceof Patch && patch.splitU(0.5)[0] instanceof Patch);
  assert.ok(Patch.fromJSON(patch.toJSON()).equals(patch) && Patch.fromBasis("bezier", new Float64Array(48)));
});

test("entries: the curves and splines of casteljau/nurbs have the methods of casteljau/core", () => {
  const spline = nurbs.NurbsCurve.circle([0, 0], 1).toSpline();
  assert.ok(spline instanceof nurbs.Spline && spline.segments()[0] instanceof nurbs.Curve);
  assert.ok(new complete.Path([spline]).contains([0, 0]) && spline.nearest([2, 0]).distance > 0.999);
  assert.throws(() => untyped(spline).offset(1), {
    message: /^Spline\.offset is in "casteljau", not in "casteljau\/nurbs"$/,
  });
});

test("entries: the curves of surfaces have the methods of casteljau/core, but for measures", () => {
  const patch = surfaces.Surface.teapot().patch(4);
  const curve = patch.isocurveAtU(0.25);
  assert.deepEqual(curve.eval(0.5), patch.eval(0.25, 0.5));
  assert.ok(curve.equals(complete.Surface.teapot().patch(4).isocurveAtU(0.25)));
  assert.ok(new complete.Curve(curve.controlPoints(), { dimension: 3 }).distanceTo(curve).distance === 0);
  assert.throws(() => curve.nearest([0, 0, 0]), {
    message: /^Curve\.nearest is in "casteljau", not in "casteljau\/surfaces"$/,
  });
  assert.equal(surfaces.Surface.teapot().isocurves({ lines: 1 })[0].flatten(0.01).points.length % 3, 0);
});

test("entries: casteljau/core gives the same numbers as casteljau, and refuses the same arguments", () => {
  const points = [0, 0, 1, 3, 4, -1, 5, 2, 7, 1];
  const results = ({ Curve, Spline }) => {
    const curve = new Curve(points);
    const spline = new Spline([...points.slice(0, 6), 6, 1], { degree: 3 });
    return [
      curve.eval(0.3),
      curve.sample(7),
      curve.evalAt([0.1, 0.9]),
      curve.derivativeAt(0.2, 2),
      curve.tangent(0.4),
      curve.normal(0.4),
      curve.curvature(0.4),
      curve.deCasteljau(0.3),
      curve.elevate().controlPoints(),
      curve.transform([1, 2, 3, 4, 5, 6]).controlPoints(),
      curve.flatten(0.01).ts,
      curve.bounds(),
      curve.hull(),
      curve.toSVG(),
      Curve.bernstein(3, 0.2),
      spline.insert(0.5).continuity(1),
      spline.append([8, 8]).toJSON(),
      spline.movePoint(3, [1, 1], { joints: ["free", "c1"] }).toJSON(),
      spline.toSVG({ precision: 2 }),
    ];
  };
  assert.deepEqual(results(coreEntry), results(complete));
  const least = /^tolerance: expected at least 3.552713678800501e-15 .*got 1e-30$/;
  for (const { Curve } of [coreEntry, complete]) refused(() => new Curve(points).flatten(1e-30), RangeError, least);
});

test("entries: a class that is called without new is refused by its name", () => {
  for (const entry of [complete, coreEntry, nurbs, slim, surfaces].map(untyped)) {
    for (const name of Object.keys(entry).filter((each) => /^[A-Z]/.test(each))) {
      assert.equal(entry[name].name, name);
      assert.throws(entry[name], { message: `Class constructor ${name} cannot be invoked without 'new'` });
    }
  }
});

test("entries: other values are refused by name", () => {
  const { Curve, Path, Spline } = complete;
  const curve = new Curve(ARCH);
  const spline = Spline.fromCurves([curve]);
  for (const value of [null, undefined, 1, {}, { casteljauType: "mesh" }, surfaces.Surface.teapot()]) {
    const other = untyped(value);
    refusedAll(TypeError, [
      [() => curve.intersections(other), /^other: expected a Curve, a Spline or a Path, got /],
      [() => curve.equals(other), /^other: expected a Curve, got /],
      [() => spline.equals(other), /^other: expected a Spline, got /],
      [() => new Path([other]), /^splines\[0\]: expected a Spline or a Curve/],
    ]);
  }
  refused(() => Spline.fromCurves([untyped(spline)]), TypeError, /^curves\[0\]: expected a Curve, got /);
});

/** The functions of the core that the sources of an entry call. */
async function calledFunctions(entry) {
  const withoutGlue = {
    name: "without-glue",
    setup: (build) => build.onResolve({ filter: /\/glue\// }, ({ path }) => ({ path, external: true })),
  };
  const options = /** @type {const} */ ({ bundle: true, format: "esm", write: false });
  const { outputFiles } = await build({
    entryPoints: [entry],
    absWorkingDir: root,
    plugins: [withoutGlue],
    ...options,
  });
  const calls = outputFiles[0].text.matchAll(/\bfunctions\.([a-z]+_\w+)/g);
  return [...new Set([...calls].map(([, name]) => name))].sort();
}

/** The functions that a module exports, without those of wasm-bindgen. */
async function exportedFunctions(name) {
  const module = new WebAssembly.Module(await readFile(new URL(`../../js/glue/${name}.wasm`, import.meta.url)));
  const names = WebAssembly.Module.exports(module).map((each) => each.name);
  return names.filter((each) => !each.startsWith("__") && each !== "memory").sort();
}

test("entries: the modules of casteljau/core, casteljau/nurbs and casteljau/surfaces export what their classes call, and no more", async () => {
  assert.deepEqual(await exportedFunctions("core"), await calledFunctions("js/core.ts"));
  // The trees of splines also serve paths, which ask for crossings.
  const ofSplines = (await calledFunctions("js/nurbs.ts")).filter((name) => name !== "curve_crossings");
  const isOfSurfaces = (name) => /^(nurbssurface|rationalpatch|rationalsurface|mesh)_|^points_joined$/.test(name);
  assert.deepEqual(
    await exportedFunctions("nurbs"),
    ofSplines.filter((name) => !isOfSurfaces(name)),
  );
  const shared = ["arena_length", "arena_reserve", "arena_trim", "points_transform"];
  assert.deepEqual(await exportedFunctions("nurbs-surfaces"), [...ofSplines.filter(isOfSurfaces), ...shared].sort());
  const measures = /^(cubic_(length|nearest)|curve_(area|equidistant_times|length|nearest|time_at_length))$/;
  const called = await calledFunctions("js/surfaces.ts");
  assert.deepEqual(
    await exportedFunctions("core-surfaces"),
    called.filter((name) => !measures.test(name)),
  );
});

/** Node prints the line of the script in which an error was thrown; with the text of a wasm module that would be 400 kB. */
test("entries: an error that nothing catches prints little", () => {
  const programs = {
    casteljau: 'import { Path } from "casteljau"; Path.circle(0, 0, 10);',
    "casteljau/core": 'import { Curve } from "casteljau/core"; new Curve(7);',
    "./dist/index.js": 'import { Path } from "./dist/index.js"; Path.circle(0, 0, 10);',
    "casteljau/nurbs": 'import { NurbsCurve } from "casteljau/nurbs"; new NurbsCurve({ degree: "2" });',
    "casteljau/surfaces": 'import { Patch } from "casteljau/surfaces"; new Patch(7);',
    "casteljau/easing": 'import { easing } from "casteljau/easing"; easing(7);',
  };
  for (const [name, program] of Object.entries(programs)) {
    const options = ["--input-type=module", "--eval", program];
    const { status, stderr } = spawnSync(process.execPath, options, { cwd: root, encoding: "utf8" });
    assert.equal(status, 1, name);
    assert.match(stderr, /TypeError: .*: expected /, name);
    assert.ok(stderr.length < 4000, `${name}: ${stderr.length} characters`);
  }
});
