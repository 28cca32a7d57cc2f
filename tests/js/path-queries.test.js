// Queries of paths that take and give locations {subpath, t}.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Path } from "casteljau";
import { near, pairs, pointsOf, refused } from "./reference.js";

/** A closed square of side 4, an open line, and a cubic with a quadratic after it. */
const SVG = "M0 0H4V4H0Z M10 0H14 M0 10C0 12 2 12 2 10Q3 8 4 10";
const path = Path.fromSVG(SVG);
const empty = new Path([]);

test("points and derivatives at locations are those of the segments", () => {
  path.subpaths.forEach((spline, subpath) => {
    const segments = spline.segments();
    for (const [k, curve] of segments.entries()) {
      for (const rest of [0, 0.25, 0.7]) {
        const at = { subpath, t: k + rest };
        near(path.eval(at), curve.eval(rest));
        near(path.tangent(at), curve.tangent(rest));
        near(path.normal(at), curve.normal(rest));
        near(path.derivativeAt(at), curve.derivativeAt(rest));
        near(path.derivativeAt(at, 2), curve.derivativeAt(rest, 2));
        near([path.curvature(at)], [curve.curvature(rest)]);
      }
    }
    const end = { subpath, t: segments.length };
    const last = /** @type {any} */ (segments.at(-1));
    near(path.eval(end), last.eval(1));
    near(path.tangent(end), last.tangent(1));
  });
});

test("at a joint the segment that starts there counts; values outside extrapolate", () => {
  assert.deepEqual(path.tangent({ subpath: 0, t: 1 }), { x: 0, y: 1 });
  assert.deepEqual(path.normal({ subpath: 0, t: 1 }), { x: -1, y: 0 });
  assert.deepEqual(path.tangent({ subpath: 0, t: 4 }), { x: 0, y: -1 });
  assert.deepEqual(path.eval({ subpath: 1, t: -0.5 }), { x: 8, y: 0 });
  assert.deepEqual(path.eval({ subpath: 1, t: 1.5 }), { x: 16, y: 0 });
});

test("many points: evalAt and sample", () => {
  const times = path.equidistantTimes(7);
  const points = path.evalAt(times);
  const expected = times.map((time) => Object.values(path.eval(time)));
  assert.deepEqual(pairs(points), expected);
  const into = new Float64Array(20).fill(9);
  assert.equal(path.evalAt(times, { into }), into);
  assert.deepEqual([...into], [...points, 9, 9, 9, 9]);
  refused(() => path.evalAt(times, { into: new Float64Array(3) }), RangeError, /^into: expected at least 16/);
  assert.deepEqual(pairs(path.sample(2)[1]), pointsOf("10,0 12,0 14,0"));
  assert.deepEqual([empty.sample(3), [...empty.evalAt([])]], [[], []]);
});

test("the point at an arc length has the unit tangent and normal there", () => {
  const vectors = { point: { x: 4, y: 1 }, tangent: { x: 0, y: 1 }, normal: { x: -1, y: 0 } };
  assert.deepEqual(path.pointAtLength(5), { subpath: 0, t: 1.25, ...vectors });
  assert.deepEqual(path.pointAtLength(17)?.point, { x: 11, y: 0 });
  const last = /** @type {any} */ (path.pointAtLength(1e9));
  near(last.point, { x: 4, y: 10 });
  const { tangent, normal, ...time } = /** @type {any} */ (path.pointAtLength(path.length() * 0.93));
  near([Math.hypot(tangent.x, tangent.y)], [1]);
  assert.deepEqual(normal, { x: -tangent.y, y: tangent.x });
  near(time.point, path.eval(time));
  assert.equal(empty.pointAtLength(1), null);
});

test("split: the parts before and after a location", () => {
  const parts = (location) => path.split(location).map((part) => part.toSVG({ precision: 3 }));
  assert.deepEqual(parts({ subpath: 0, t: 1.5 }), ["M0 0H4V2", "M4 2V4H0V0M10 0H14M0 10C0 12 2 12 2 10Q3 8 4 10"]);
  assert.deepEqual(parts({ subpath: 1, t: 0.25 }), ["M0 0H4V4H0ZM10 0H11", "M11 0H14M0 10C0 12 2 12 2 10Q3 8 4 10"]);
  // Nothing is divided at the ends of subpaths.
  const [before, after] = path.split({ subpath: 1, t: 0 });
  assert.ok(before.equals(new Path(path.subpaths.slice(0, 1))) && after.equals(new Path(path.subpaths.slice(1))));
  const [all, nothing] = path.split({ subpath: 2, t: 2 });
  assert.ok(all.equals(path) && nothing.equals(empty));
  const [none, whole] = path.split({ subpath: 0, t: 0 });
  assert.ok(none.equals(empty) && whole.equals(path));
});

test("split: a list gives the parts between its locations in the order of the path", () => {
  const parts = (locations) => path.split(locations).map((part) => part.toSVG({ precision: 3 }));
  const [a, b] = [
    { subpath: 0, t: 1.5 },
    { subpath: 1, t: 0.25 },
  ];
  const rest = "M11 0H14M0 10C0 12 2 12 2 10Q3 8 4 10";
  assert.deepEqual(parts([b, a]), ["M0 0H4V2", "M4 2V4H0V0M10 0H11", rest]);
  assert.deepEqual(parts([a, a, b]), ["M0 0H4V2", "", "M4 2V4H0V0M10 0H11", rest]);
  assert.deepEqual(
    parts([a]),
    path.split(a).map((part) => part.toSVG({ precision: 3 })),
  );
  const [whole, nothing] = path.split([]);
  assert.ok(whole.equals(path) && nothing === undefined);
  assert.deepEqual(
    empty.split([]).map((part) => part.subpathCount),
    [0],
  );
  refused(
    () => path.split([a, { subpath: 9, t: 0 }]),
    RangeError,
    /^locations\[1\]\.subpath: expected a whole number from 0 to 2/,
  );
  refused(() => empty.split([a]), RangeError, /^locations\[0\]: expected a path with a subpath/);
});

test("split and subsegment keep the length and the points", () => {
  const total = path.length();
  for (const s of [0.1, 3, 8, 17.3, 19.99, 21, 25]) {
    const [before, after] = path.split(/** @type {any} */ (path.timeAtLength(s)));
    near([before.length(), after.length()], [s, total - s], 1e-10);
  }
  const part = path.subsegment({ subpath: 2, t: 0.25 }, { subpath: 2, t: 1.5 });
  assert.equal(part.subpathCount, 1);
  const [spline] = part.subpaths;
  assert.deepEqual(spline.degrees, [3, 2]);
  near(spline.eval(0.5), path.eval({ subpath: 2, t: 0.25 + 0.5 * 0.75 }));
  near(spline.eval(1.5), path.eval({ subpath: 2, t: 1.25 }));
});

test("subsegment: whole subpaths stay closed, the opposite order reverses", () => {
  const part = (from, to) => path.subsegment({ subpath: from[0], t: from[1] }, { subpath: to[0], t: to[1] });
  assert.ok(part([0, 0], [2, 2]).equals(path));
  assert.equal(part([0, 2.5], [1, 0.5]).toSVG(), "M2,4 L0,4 L0,0 M10,0 L12,0");
  assert.equal(part([1, 0.5], [0, 2.5]).toSVG(), "M12,0 L10,0 M0,0 L0,4 L2,4");
  assert.equal(part([0, 3], [0, 1]).toSVG(), "M0,4 L4,4 L4,0");
  assert.equal(part([1, 0.5], [1, 0.5]).toSVG(), "M12,0 L12,0");
  assert.equal(part([0, 4], [1, 0]).toSVG(), "");
  assert.equal(part([1, -0.5], [1, 0.5]).toSVG(), "M8,0 L12,0");
});

test("locations of a coordinate: joints once, the end of a closed subpath as its start", () => {
  const square = Path.fromSVG("M0 0H4V4H0Z");
  const ts = (where) => square.timesAtCoordinate(where).map(({ t }) => t);
  assert.deepEqual([ts({ x: 2 }), ts({ x: 0 }), ts({ y: 4 }), ts({ y: 5 })], [[0.5, 2.5], [0, 3], [2, 3], []]);
  const zigzag = Path.fromSVG("M0 0L1 1L2 0L3 1M0 1H3");
  const times = zigzag.timesAtCoordinate({ y: 1 }).map(({ subpath, t }) => [subpath, t]);
  assert.deepEqual(times, pointsOf("0,1 0,3 1,0 1,1"));
  for (const time of path.timesAtCoordinate({ y: 11 })) near([path.eval(time).y], [11]);
  assert.equal(path.timesAtCoordinate({ y: 11 }).length, 2);
  assert.deepEqual(empty.timesAtCoordinate({ x: 0 }), []);
  for (const bad of /** @type {any[]} */ ([{}, { x: 1, y: 1 }, { z: 1 }, undefined]))
    refused(() => path.timesAtCoordinate(bad), TypeError, /^where: expected exactly one of x, y, got/);
  refused(() => path.timesAtCoordinate({ x: NaN }), RangeError, /^x: /);
});

test("extrema: those of the subpaths", () => {
  /** Path data with the parameters of the extrema in x and in y. @type {[string, number[], number[]][]} */
  const cases = [
    ["M0 0L1 1L2 0L3 1", [], [1, 2]],
    ["M0 0Q1 2 2 0Q3 -2 4 0", [], [0.5, 1.5]],
    ["M0 0L1 1H2L3 0", [], [1, 2]], // both joints of a plateau between increasing and decreasing
    ["M0 0L1 1H2L3 2", [], []], // a step does not count
    ["M0 0H4V4H0Z", [0, 1, 2, 3], [0, 1, 2, 3]],
    ["M2 0L0 2L-2 0L0 -2Z", [0, 2], [1, 3]],
    ["M1 1Z", [], []],
    ["", [], []],
  ];
  for (const [d, ...expected] of cases) {
    const { x, y } = Path.fromSVG(d).extrema();
    const found = [x, y].map((times) => times.map(({ t }) => t));
    assert.deepEqual(found, expected, d);
  }
  const { min, max } = /** @type {any} */ (path.bounds());
  const ys = [...path.extrema().y, { subpath: 2, t: 0 }].map((time) => path.eval(time).y);
  near([Math.min(...ys), Math.max(...ys)], [min.y, max.y]);
});

test("degenerate: one point, closed and open", () => {
  const point = Path.fromSVG("M3 4Z");
  assert.deepEqual(point.eval({ subpath: 0, t: 0.5 }), { x: 3, y: 4 });
  assert.deepEqual(point.tangent({ subpath: 0, t: 0.5 }), { x: 0, y: 0 });
  assert.deepEqual(point.pointAtLength(2)?.point, { x: 3, y: 4 });
  const [before, after] = point.split({ subpath: 0, t: 0.5 });
  assert.deepEqual([before.length(), after.length()], [0, 0]);
  assert.deepEqual(point.subsegment({ subpath: 0, t: 0 }, { subpath: 0, t: 1 }).toSVG(), "M3,4 Z");
});
