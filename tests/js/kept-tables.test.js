// What splines and paths keep between calls: the results are those of the core, and repeated queries ask the core less.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { Path, Spline } from "#js/index.js";
import { curvesModule } from "#js/wasm/curves-module.js";
import { near, pointsOf, refused, untyped } from "./reference.js";

const SEGMENTS = 2000;
/** How often each function of the core was called since the start of the test. */
const calls = new Map();

const counted = (name, value) =>
  function count(...args) {
    calls.set(name, (calls.get(name) ?? 0) + 1);
    return value(...args);
  };
const entries = Object.entries(untyped(curvesModule.functions));
Object.defineProperty(curvesModule, "functions", {
  value: Object.fromEntries(
    entries.map(([name, value]) => [name, value instanceof Function ? counted(name, value) : value]),
  ),
});
beforeEach(() => calls.clear());

const waves = (closed, dimension = 2) => {
  const points = Array.from({ length: SEGMENTS }, (_, i) =>
    [i, 30 * Math.sin(i / 7), (i * i) % 11].slice(0, dimension),
  );
  return Spline.interpolate(points, { closed });
};
const open = (points, degrees) => Spline.fromJSON({ points, degrees, closed: false, dimension: 2 });
const MIXED = [0, 0, 3, 1, 3, 5, 9, 5, 9, 9, 2, 12, 2, 12, 2, 12, 2, 12, 0, 11, -4, 4, 3, 3];
const mixed = () => open(MIXED, [1, 2, 3, 1, 4]);
const called = (...names) => names.map((name) => calls.get(name) ?? 0);
/** The answer of the core's function of splines, which keeps nothing. */
function fromCore(spline, name, ...args) {
  return curvesModule.read(0, curvesModule.functions[name](spline._write(), ...args));
}

/** The first of the nearest points of all segments. */
function nearestOfAll(spline, p) {
  const found = spline.segments().map((segment, k) => {
    const { t, ...rest } = segment.nearest(p);
    return { t: k + t, ...rest };
  });
  return found.reduce((best, other) => (other.distance < best.distance ? other : best));
}

test("timeAtLength: the results of the core, inside, at joints, and outside", () => {
  for (const spline of [waves(false), waves(true), waves(false, 3), mixed()]) {
    const length = spline.length();
    assert.equal(length, fromCore(spline, "spline_length", 0)[0]);
    const before = spline.subsegment(0, 1).length();
    for (const s of [-1, 0, 1e-300, before, length / 7, length / 2, 0.999 * length, length, 2 * length]) {
      assert.equal(spline.timeAtLength(s), fromCore(spline, "spline_time_at_length", s, 0)[0], `s = ${s}`);
    }
  }
});

test("timeAtLength: a joint where a segment has no length is its end", () => {
  const spline = new Spline([0, 0, 3, 0, 3, 0, 3, 4], { degree: 1 });
  assert.deepEqual([spline.timeAtLength(3), spline.timeAtLength(1.5), spline.timeAtLength(5)], [2, 0.5, 2.5]);
});

test("timeAtLength: after the first call the core examines one segment, and is not passed the spline", () => {
  const spline = waves(false);
  spline.timeAtLength(10);
  assert.deepEqual(called("curve_length", "curve_time_at_length"), [SEGMENTS - 1, 1]);
  for (let s = 20; s < 120; s++) spline.timeAtLength(s);
  spline.length();
  assert.deepEqual(called("curve_length", "curve_time_at_length"), [SEGMENTS - 1, 101]);
  assert.deepEqual(called("spline_time_at_length", "spline_length"), [0, 0]);
});

test("timeAtLength: a tolerance is checked by the core until one as small was accepted", () => {
  const spline = waves(false);
  refused(() => spline.timeAtLength(10, 1e-300), RangeError, /tolerance/);
  refused(() => spline.timeAtLength(10, 1e-300), RangeError, /tolerance/);
  for (const [s, tolerance] of pointsOf("10,1e-3 20,1e-3 30,1e-2 40,1e-6 50,1e-6")) {
    const expected = fromCore(spline, "spline_time_at_length", s, tolerance)[0];
    assert.equal(spline.timeAtLength(s, tolerance), expected);
  }
  assert.deepEqual(called("spline_time_at_length"), [5 + 2 + 2]); // the expected times, the refusals, two new tolerances
  refused(() => spline.timeAtLength(Number.NaN), RangeError, /^s: /);
  refused(() => spline.timeAtLength(1, -1), RangeError, /^tolerance: /);
});

test("equidistantTimes: the results of the core for few and for many arcs", () => {
  for (const spline of [waves(false), waves(true, 3), mixed()]) {
    for (const segments of [1, 2, 3, 7, 1000, 3000]) {
      const expected = fromCore(spline, "spline_equidistant_times", segments);
      assert.deepEqual(spline.equidistantTimes(segments), expected, `${segments}`);
    }
  }
  const point = new Spline([1, 1, 1, 1, 1, 1, 1, 1], { degree: 1 });
  assert.deepEqual([...point.equidistantTimes(2)], [0, 1.5, 3]);
});

test("nearest: the results of the segments and of the core", () => {
  for (const spline of [waves(false), waves(true), waves(false, 3), mixed()]) {
    for (const p of pointsOf("0,0,0 1000,200,3 -40,2,1 777.7,12.5,5 1e149,-1e149,0 2,12,0")) {
      const point = p.slice(0, spline.dimension);
      const found = spline.nearest(point);
      assert.deepEqual(found, nearestOfAll(spline, point));
    }
  }
});

test("nearest: far points, and of two points at the same distance the first", () => {
  const large = new Spline([0, 0, 1e149, 0, 1e149, 1e149], { degree: 1 });
  assert.deepEqual(large.nearest([1e149, 2e149]), { t: 2, point: { x: 1e149, y: 1e149 }, distance: 1e149 });
  // y = 2 from x = −5 to 5, then back on (−10u, 16u² − 2), whose box contains the origin
  const both = open([-5, 2, 5, 2, 0, -6, -5, 2], [1, 2]);
  assert.deepEqual(both.subsegment(1, 2).nearest([0, 0]), { t: 0.5, point: { x: 0, y: -2 }, distance: 2 });
  assert.deepEqual(both.nearest([0, 0]), { t: 0.5, point: { x: 0, y: 2 }, distance: 2 });
});

test("nearest examines only the segments whose boxes may be nearer", () => {
  const spline = waves(false);
  spline.nearest([1000, 80]);
  const [general, cubic] = called("curve_nearest", "cubic_nearest");
  assert.ok(general + cubic > 0 && general + cubic < 20, `${general} ${cubic}`);
});

test("eval: the results of the core, of every degree, inside and outside", () => {
  for (const spline of [waves(true), waves(false, 3), mixed()]) {
    for (const t of [-0.5, 0, 0.3, 1, 2.75, 4.9, spline.segmentCount, spline.segmentCount + 0.25]) {
      assert.deepEqual(Object.values(spline.eval(t)), [...spline.evalAt([t])], `t = ${t}`);
    }
  }
});

test("what is kept cannot be changed from outside", () => {
  const spline = mixed();
  const before = [spline.eval(2.5), spline.timeAtLength(5), spline.nearest([4, 4])];
  spline.segments().length = 0;
  spline.segments()[2].controlPoints().fill(7);
  spline.controlPoints().fill(7);
  spline.nearest([0, 0]).point.x = 7;
  assert.deepEqual([spline.eval(2.5), spline.timeAtLength(5), spline.nearest([4, 4])], before);
  near([mixed().length()], [spline.length()], 0);
});

const three = () => new Path([waves(true), mixed(), waves(false)]);
/** The answer of the core's function of paths, which keeps nothing. */
function ofPath(path, name, ...args) {
  curvesModule.write(path._packed);
  return [...curvesModule.read(0, curvesModule.functions[name](...args))];
}

test("paths: lengths and locations are those of the core", () => {
  for (const path of [
    three(),
    new Path([mixed()]),
    new Path([]),
    new Path([new Spline([1, 1, 1, 1], { degree: 1 })]),
  ]) {
    const length = path.length();
    assert.deepEqual([length], ofPath(path, "path_length", 0));
    for (const s of [-1, 0, 1e-300, length / 7, length / 2, 0.999 * length, length, 2 * length]) {
      const time = path.timeAtLength(s);
      assert.deepEqual(time ? [time.subpath, time.t] : [], ofPath(path, "path_time_at_length", s, 0), `s = ${s}`);
    }
  }
  const joints = Path.fromSVG("M0 0H4M0 1H3V5");
  assert.deepEqual(
    [4, 7, 11].map((s) => joints.timeAtLength(s)),
    [
      { subpath: 1, t: 0 },
      { subpath: 1, t: 1 },
      { subpath: 1, t: 2 },
    ],
  );
});

test("paths: the nearest point is the first of the nearest points of the subpaths", () => {
  const path = three();
  for (const p of pointsOf("0,0 1000,200 -40,2 777.7,12.5 1e149,-1e149 2,12")) {
    const all = path.subpaths.map((spline, subpath) => ({ subpath, ...nearestOfAll(spline, p) }));
    const expected = all.reduce((best, other) => (other.distance < best.distance ? other : best));
    assert.deepEqual(path.nearest(p), expected);
  }
  assert.equal(new Path([]).nearest([0, 0]), null);
});

test("paths: winding numbers are those of the core", () => {
  const star = Path.polygon(Array.from({ length: 101 }, (_, k) => [Math.cos(40 * k), Math.sin(40 * k)]));
  const scribbles = new Path([mixed(), mixed().reverse(), waves(true), waves(false)]);
  for (const path of [star, scribbles, Path.circle([0, 0], 1), Path.fromSVG("M0 0H4M9 9L8 8L9 7"), new Path([])]) {
    const { min, max } = path.bounds() ?? { min: { x: 0, y: 0 }, max: { x: 1, y: 1 } };
    const points = path.subpaths.flatMap((spline) => spline.points()).slice(0, 200);
    for (let i = 0; i <= 20; i++)
      for (let j = 0; j <= 20; j++)
        points.push({ x: min.x + ((max.x - min.x) * i) / 20, y: min.y + ((max.y - min.y) * j) / 20 });
    for (const { x, y } of points) {
      curvesModule.write(path._packed);
      const expected = curvesModule.functions.path_winding_number(x, y);
      assert.equal(path.windingNumber([x, y]), expected, `${x} ${y}`);
      assert.equal(path.contains([x, y]), expected !== 0);
    }
  }
});

test("paths: of many subpaths the core examines those near the point", () => {
  const centers = Array.from({ length: 2000 }, (_, k) => [20 * (k % 50), 20 * Math.floor(k / 50)]);
  const circles = centers.map((center) => Path.circle(center, 9));
  const path = new Path(circles.flatMap((circle) => circle.subpaths));
  path.nearest([0, 0]);
  for (const [x, y] of pointsOf("3,3 500,400 333,70 -2000,400 985,795 512.5,12 -5,400")) {
    const found = circles.map((circle) => /** @type {any} */ (circle.nearest([x, y])).distance);
    calls.clear();
    assert.equal(/** @type {any} */ (path.nearest([x, y])).distance, Math.min(...found));
    assert.equal(path.windingNumber([x, y]), centers.filter(([cx, cy]) => Math.hypot(x - cx, y - cy) < 9).length);
    const [general, cubic, crossings] = called("curve_nearest", "cubic_nearest", "curve_crossings");
    assert.ok(general + cubic < 40 && crossings <= 8, `${general + cubic} and ${crossings} segments`);
  }
});

test("paths: after the first call the core is not passed the path", () => {
  const path = three();
  const ask = () => [
    path.length(),
    path.area(),
    path.bounds(),
    path.controlBounds(),
    path.pointAtLength(99),
    path.nearest([1, 2]),
    path.windingNumber([1000, 0]),
  ];
  const answers = ask();
  assert.deepEqual(ask(), answers);
  calls.clear();
  for (let k = 0; k < 10; k++) assert.deepEqual(ask(), answers);
  assert.deepEqual(
    [...calls.keys()].filter((name) => name.startsWith("path_")),
    [],
  );
  /** @type {any} */ (path.bounds()).min.x = 77;
  assert.deepEqual(ask(), answers);
});

test("Path.index: the first of the nearest paths, those that contain a point, those within a box", () => {
  const paths = Array.from({ length: 200 }, (_, k) => Path.circle([20 * (k % 20), 20 * Math.floor(k / 20)], 9));
  paths.splice(100, 0, new Path([]));
  paths.push(Path.rect([-10, -10], 100, 100), Path.fromSVG("M0 0H40V40H0Z M10 10H30V30H10Z"));
  const index = Path.index(paths);
  for (const p of pointsOf("0,0 10,10 33,71 399,1 -50,60 200,190.5 20,20")) {
    const all = paths
      .map((path, k) => ({ index: k, .../** @type {any} */ (path.nearest(p)) }))
      .filter(({ point }) => point);
    const expected = all.reduce((best, other) => (other.distance < best.distance ? other : best));
    assert.deepEqual(index.nearest(p), expected);
    assert.deepEqual(index.nearest(p, { maxDistance: expected.distance }), expected);
    if (expected.distance > 0) assert.equal(index.nearest(p, { maxDistance: 0.999 * expected.distance }), null);
    for (const fillRule of /** @type {const} */ (["nonzero", "evenodd"])) {
      const containing = paths.flatMap((path, k) => (path.contains(p, { fillRule }) ? [k] : [])).reverse();
      assert.deepEqual(index.containing(p, { fillRule }), containing);
    }
  }
  const box = { min: [-9, -9], max: { x: 49, y: 60 } };
  assert.deepEqual(index.within(box), [0, 1, 2, 20, 21, 22, 40, 41, 42, 202]);
  index.nearest([33, 71]);
  calls.clear();
  index.nearest([33, 71]);
  const [general, cubic] = called("curve_nearest", "cubic_nearest");
  assert.ok(general + cubic < 30, "most paths are not searched");
  const empty = Path.index([]);
  assert.deepEqual([empty.nearest([0, 0]), empty.containing([0, 0]), empty.within(box)], [null, [], []]);
  refused(() => Path.index(untyped(paths[0])), TypeError, /^paths: expected an array of paths, got a Path$/);
  refused(() => index.nearest([0, 0], { maxDistance: Number.NaN }), RangeError, /^maxDistance: /);
  refused(() => index.containing([0, 0], untyped({ fillRule: "odd" })), RangeError, /^fillRule: /);
  refused(() => index.within(untyped([0, 0])), TypeError, /^box.min: /);
});

test("boxes are asked for once, also those of an empty path", () => {
  for (const path of [new Path([]), three()]) {
    calls.clear();
    const boxes = () => [path.bounds(), path.controlBounds()];
    assert.deepEqual(boxes(), boxes());
    assert.deepEqual(called("path_bounds"), [2]);
  }
});
