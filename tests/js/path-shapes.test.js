// Circles, ellipses, arcs, rectangles and polygons; the tolerance of arcs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Path, Spline } from "casteljau";
import { near, pairs, pointsOf, recorder, refused, withPath2D } from "./reference.js";

const TURN = 2 * Math.PI;

/** The largest distance of a path's points from a circle, by samples. */
function radialError(path, [cx, cy], radius) {
  const points = path.sample(64).flatMap((flat) => pairs(flat));
  return Math.max(...points.map(([x, y]) => Math.abs(Math.hypot(x - cx, y - cy) - radius)));
}

/** The largest distance of a cubic over the angle θ from the unit circle. */
const errorOfAngle = (theta) => ((2 / 27) * Math.sin(theta / 4) ** 6) / Math.cos(theta / 4) ** 2;

test("circle: closed, counter-clockwise, from the right, 8 cubics within 4.3e-6 of the radius", () => {
  for (const [x, y, radius] of pointsOf("0,0,1 30,-7,250 -1e3,5e3,1e-3")) {
    const center = /** @type {[number, number]} */ ([x, y]);
    const circle = Path.circle(center, radius);
    const [spline, ...more] = circle.subpaths;
    assert.ok(spline.closed && more.length === 0 && spline.degrees.every((degree) => degree === 3));
    assert.deepEqual(circle.eval({ subpath: 0, t: 0 }), { x: x + radius, y });
    const rounding = 4 * Number.EPSILON * (Math.abs(x) + Math.abs(y));
    assert.equal(spline.segmentCount, 8);
    assert.ok(radialError(circle, center, radius) <= 4.3e-6 * radius + rounding);
    near([circle.length()], [TURN * radius], 1e-5);
    near([circle.area() / radius ** 2], [Math.PI], 1e-5);
    const tolerance = Math.max(1e-9 * radius, rounding);
    const finer = Path.circle(center, radius, { tolerance });
    assert.ok(radialError(finer, center, radius) <= tolerance + rounding);
    near([finer.area() / radius ** 2], [Math.PI], 1e-8);
    assert.equal(circle.windingNumber(center), 1);
  }
});

test("circle: its extreme points are joints, exactly", () => {
  const circle = Path.circle([1, 2], 5);
  const { x, y } = circle.extrema();
  const points = [...x, ...y].map((time) => Object.values(circle.eval(time)));
  assert.deepEqual(points, pointsOf("6,2 -4,2 1,7 1,-3"));
});

test("tolerance: as few cubics as Goldapp's bound allows, and never a larger distance", () => {
  const segments = (tolerance) => Path.circle([0, 0], 10, { tolerance }).subpaths[0].segmentCount;
  assert.deepEqual([segments(1), segments(0.00273)], [4, 4]);
  for (const tolerance of [1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12]) {
    const circle = Path.circle([0, 0], 10, { tolerance });
    const perQuarter = circle.subpaths[0].segmentCount / 4;
    assert.ok(radialError(circle, [0, 0], 10) <= tolerance + 1e-14);
    assert.ok(10 * errorOfAngle(Math.PI / 2 / perQuarter) <= tolerance * (1 + 1e-9));
    if (perQuarter > 1) assert.ok(10 * errorOfAngle(Math.PI / 2 / (perQuarter - 1)) > tolerance);
  }
  for (const bad of [0, -1, NaN, 1e-15])
    refused(() => Path.circle([0, 0], 10, { tolerance: bad }), RangeError, /^tolerance: /);
});

test("ellipse: the affine image of a circle", () => {
  const [rx, ry, rotation] = [5, 2, 0.7];
  const ellipse = Path.ellipse([3, 4], rx, ry, rotation, { tolerance: 5e-9 });
  const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
  near(ellipse.eval({ subpath: 0, t: 0 }), { x: 3 + rx * cos, y: 4 + rx * sin });
  near([ellipse.area()], [Math.PI * rx * ry], 1e-8);
  for (const [x, y] of ellipse.sample(8).flatMap((points) => pairs(points))) {
    const [dx, dy] = [x - 3, y - 4];
    near([Math.hypot((dx * cos + dy * sin) / rx, (dy * cos - dx * sin) / ry)], [1], 3e-9);
  }
  assert.ok(Path.ellipse([1, 2], 3, 3).equals(Path.circle([1, 2], 3)));
  // A radius of 0 gives a line, traversed forth and back.
  near([Path.ellipse([0, 0], 3, 0).length()], [12]);
});

test("arc: from the first angle to the second, in the direction of their difference", () => {
  const angles = [...pointsOf("0,1 1,0 -2,4 10,10.000001"), [0.3, 0.3 - TURN], [0, TURN], [0, Math.PI]];
  for (const [start, end] of angles) {
    const arc = Path.arc([1, 2], 3, start, end, { tolerance: 3e-9 });
    const [spline] = arc.subpaths;
    assert.ok(!spline.closed);
    near(spline.eval(0), { x: 1 + 3 * Math.cos(start), y: 2 + 3 * Math.sin(start) });
    near(spline.eval(spline.segmentCount), { x: 1 + 3 * Math.cos(end), y: 2 + 3 * Math.sin(end) });
    near([arc.length()], [3 * Math.abs(end - start)], 1e-8);
    assert.ok(radialError(arc, [1, 2], 3) <= 3e-9 + 1e-14);
    const { x, y } = arc.tangent({ subpath: 0, t: 0 });
    const side = Math.sign(end - start);
    near([x, y], [-Math.sin(start) * side, Math.cos(start) * side], 1e-6);
  }
  const quarter = Path.arc([0, 0], 1, 0, Math.PI / 2, { tolerance: 1 });
  assert.deepEqual(quarter.toSVG({ precision: 4 }), "M1 0C1 .5523.5523 1 0 1");
  assert.equal(Path.arc([0, 0], 1, 0, 0).toSVG(), "M1,0 L1,0");
  refused(() => Path.arc([0, 0], 1, 0, 7), RangeError, /^endAngle: expected at most a full turn/);
});

test("rect: sharp and rounded corners, counter-clockwise", () => {
  assert.equal(Path.rect([1, 2], 3, 4).toSVG(), "M1,2 L4,2 L4,6 L1,6 Z");
  assert.equal(Path.rect([1, 2], 3, 4).area(), 12);
  const rounded = Path.rect([0, 0], 10, 6, { radii: 2, tolerance: 2e-9 });
  near([rounded.area()], [60 - (4 - Math.PI) * 4], 1e-8);
  const { min, max } = /** @type {any} */ (rounded.bounds());
  near([min, max].flatMap(Object.values), [0, 0, 10, 6]);
  assert.deepEqual(rounded.eval({ subpath: 0, t: 0 }), { x: 2, y: 0 });
  const uneven = Path.rect([0, 0], 10, 6, { radii: [0, 1, 0, 2], tolerance: 0.01 });
  assert.equal(uneven.toSVG({ precision: 2 }), "M0 0H9C9.55 0 10 .45 10 1V6H2C.9 6 0 5.1 0 4Z");
});

test("rect: radii that do not fit are reduced by one factor", () => {
  const pill = Path.rect([0, 0], 10, 4, { radii: 100, tolerance: 0.01 });
  assert.deepEqual(pill.subpaths[0].degrees, [1, 3, 3, 1, 3, 3]);
  near([pill.area()], [6 * 4 + Math.PI * 4], 1e-3);
  const uneven = Path.rect([0, 0], 10, 10, { radii: [15, 5, 0, 0], tolerance: 1e-6 });
  near([uneven.area()], [100 - (1 - Math.PI / 4) * (7.5 ** 2 + 2.5 ** 2)], 1e-6);
  // Rounding leaves no lines between two arcs that meet.
  for (let k = 1; k < 50; k++) {
    const { degrees } = Path.rect([0.1 * k, 0.7], 1, k / 7, { radii: 100, tolerance: 1 }).subpaths[0];
    assert.equal(degrees.filter((degree) => degree === 1).length, k === 7 ? 0 : 2, `height ${k / 7}`);
  }
});

test("polygon and polyline", () => {
  const corners = pointsOf("0,0 4,0 4,3");
  const triangle = Path.polygon(corners);
  assert.equal(triangle.toSVG(), "M0,0 L4,0 L4,3 Z");
  assert.deepEqual([triangle.area(), triangle.length()], [6, 12]);
  assert.ok(Path.polygon(corners.flat()).equals(triangle));
  assert.equal(Path.polygon(corners, { closed: false }).toSVG(), "M0,0 L4,0 L4,3");
  assert.equal(Path.polygon([[1, 2]]).toSVG(), "M1,2 Z");
  refused(() => Path.polygon([]), RangeError, /^points: expected at least 1 points, got 0/);
  refused(() => Path.polygon([[1, 2]], { closed: false }), RangeError, /^points: expected at least 2 points, got 1/);
});

test("from: curves, splines, paths, and arrays of them", () => {
  const curve = new Curve([0, 0, 1, 1, 2, 0]);
  const spline = new Spline([0, 0, 1, 0, 0, 1], { degree: 1, closed: true });
  const path = new Path([curve, spline]);
  for (const shape of [curve, spline]) assert.ok(Path.from(shape).equals(new Path([shape])));
  assert.ok(Path.from(path).equals(path));
  assert.ok(Path.from([path, curve]).equals(new Path([curve, spline, curve])));
  assert.equal(Path.from([]).subpathCount, 0);
  assert.equal(Path.from([new Path([]), path]).toSVG(), path.toSVG());
  for (const bad of /** @type {any[]} */ ([undefined, null, 5, "M0 0H1", {}])) {
    refused(() => Path.from(bad), TypeError, /^shapes: expected a Path, a Spline or a Curve, got/);
    refused(() => Path.from([path, bad]), TypeError, /^shapes\[1\]: expected a Path/);
  }
  refused(() => Path.from(new Curve(pointsOf("0,0,0 1,1,1"))), TypeError, /^shapes: .*2D.*3D/);
});

test("SVG arcs within the tolerance, by default 1e-5 of the radius", () => {
  const d = "M0 0A50 50 0 1 1 100 0";
  const plain = Path.fromSVG(d);
  assert.ok(Path.fromSVG(d, {}).equals(plain) && Path.fromSVG(d, { tolerance: undefined }).equals(plain));
  const count = (tolerance) => Path.fromSVG(d, { tolerance }).subpaths[0].segmentCount;
  assert.deepEqual([count(1), plain.subpaths[0].segmentCount], [2, 4]);
  for (const tolerance of [1e-2, 1e-5, 1e-10])
    assert.ok(radialError(Path.fromSVG(d, { tolerance }), [50, 0], 50) <= tolerance + 1e-13);
  // The radii are enlarged until they reach from end to end: the tolerance holds for the enlarged ones.
  const small = Path.fromSVG("M0 0A1 1 0 0 1 100 0", { tolerance: 1e-3 });
  assert.ok(radialError(small, [50, 0], 50) <= 1e-3);
  for (const bad of [0, -1, NaN, 1e-15]) refused(() => Path.fromSVG(d, { tolerance: bad }), RangeError, /^tolerance: /);
  refused(() => Path.fromSVG(d, { tolerance: /** @type {any} */ ("1") }), TypeError, /^tolerance: /);
});

test("toPath2D draws what trace draws, and says so where there is no Path2D", () => {
  const path = Path.fromSVG("M0 0H4V4H0Z M1 1Q2 2 3 1");
  refused(() => path.toPath2D(), Error, /^toPath2D: expected an environment with Path2D/);
  const [drawn, traced] = [recorder(), recorder()];
  const made = withPath2D(drawn, () => path.toPath2D());
  assert.equal(made, drawn);
  path.trace(traced);
  assert.deepEqual(drawn.calls, traced.calls);
  assert.ok(drawn.calls.length > 5);
});
