// Intersections of rational and NURBS curves as JavaScript sees them: closed forms of circles and lines, and all shapes on
// either side.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as complete from "casteljau";
import { Curve, NurbsCurve, RationalCurve, Spline } from "casteljau/nurbs";
import { near, refused } from "./reference.js";

const circle = NurbsCurve.circle([0, 0], 5);
const quarter = RationalCurve.conic([5, 0], [5, 5], [0, 5], Math.SQRT1_2);
const kinds = (found) => found.map(({ kind }) => kind);
const places = (found) => found.map(({ point }) => point);

/** Checks that both shapes are at the point at their parameters. */
function onBoth(a, b, found) {
  for (const { t, u, point } of found) {
    near(a.eval(t), point, 1e-14, `t = ${JSON.stringify(t)}`);
    near(b.eval(u), point, 1e-14, `u = ${JSON.stringify(u)}`);
  }
}

test("intersections of a circle and lines", () => {
  const crossing = new Curve([
    [3, -9],
    [3, 9],
  ]);
  const found = circle.intersections(crossing);
  onBoth(circle, crossing, found);
  near(places(found)[0], { x: 3, y: 4 }, 1e-14);
  near(places(found)[1], { x: 3, y: -4 }, 1e-14);
  assert.deepEqual(kinds(found), ["cross", "cross"]);
  const touching = circle.intersections(new Curve([5, -9, 5, 9]));
  assert.deepEqual([kinds(touching), touching[0].t, touching[0].point], [["tangent"], 0, { x: 5, y: 0 }]);
  near(touching[0].u, 0.5, 1e-15);
  assert.deepEqual(circle.intersections(new Curve([6, -9, 6, 9])), []);
  near(quarter.intersections(new Curve([0, 0, 6, 8]))[0].point, { x: 3, y: 4 }, 1e-14);
});

test("intersections of two circles", () => {
  const other = NurbsCurve.circle([6, 0], 5);
  const found = circle.intersections(other);
  onBoth(circle, other, found);
  assert.equal(found.length, 2);
  near(places(found)[0], { x: 3, y: 4 }, 1e-14);
  assert.deepEqual(kinds(circle.intersections(NurbsCurve.circle([10, 0], 5))), ["tangent"]);
  assert.deepEqual(circle.intersections(NurbsCurve.circle([0, 0], 4)), []);
});

test("arcs of one circle overlap however they are parametrized", () => {
  const [part] = quarter.intersections(quarter.subsegment(0.75, 0.25));
  assert.ok(part.kind === "overlap");
  near([part.t, part.tEnd, part.u, part.uEnd], [0.25, 0.75, 1, 0], 1e-12);
  const third = NurbsCurve.arc([0, 0], 5, Math.PI / 3, Math.PI);
  const [shared] = third.intersections(circle);
  assert.ok(shared.kind === "overlap");
  assert.deepEqual([shared.t, shared.tEnd], [0, 1]);
  near(circle.eval(shared.u), third.eval(0), 1e-14);
  near(circle.eval(shared.uEnd), third.eval(1), 1e-14);
});

test("self-intersections of rational and NURBS curves", () => {
  const loop = new RationalCurve([0, 0, 4, 4, -2, 4, 2, 0], [1, 2, 2, 1]);
  for (const curve of [loop, NurbsCurve.from(loop)]) {
    const found = curve.selfIntersections();
    assert.equal(found.length, 1);
    near([found[0].t + found[0].u, found[0].point.x], [1, 1], 1e-14);
    onBoth(curve, curve, found);
  }
  assert.deepEqual(quarter.selfIntersections(), []);
});

test("all shapes of both entry points, on either side", () => {
  const square = [0, 0, 6, 0, 6, 6, 0, 6];
  for (const classes of [/** @type {typeof complete} */ (/** @type {any} */ ({ Curve, Spline })), complete]) {
    const closed = new classes.Spline(square, { degree: 1, closed: true });
    const shapes = [new classes.Curve([4, -1, 4, 9]), closed, circle, quarter];
    for (const shape of shapes) {
      for (const curve of [circle, quarter]) {
        const found = curve.intersections(/** @type {any} */ (shape));
        onBoth(curve, shape, found);
        assert.equal(found.length, shape === closed ? 2 : 1);
      }
    }
    const [start, end] = places(circle.intersections(closed));
    near(start, { x: 5, y: 0 }, 1e-14);
    near(end, { x: 0, y: 5 }, 1e-14);
  }
});

test("shapes of casteljau intersect rational curves", () => {
  const line = new complete.Curve([3, -9, 3, 9]);
  const square = new complete.Spline([0, 0, 6, 0, 6, 6, 0, 6], { degree: 1, closed: true });
  for (const shape of [line, square]) {
    for (const curve of [circle, quarter]) {
      const found = shape.intersections(curve);
      onBoth(shape, curve, found);
      assert.deepEqual(kinds(found), kinds(curve.intersections(shape)));
      assert.ok(found.every(({ t }, k) => k === 0 || found[k - 1].t <= t));
    }
  }
  const path = new complete.Path([square, line]);
  const found = path.intersections(circle);
  onBoth(path, circle, found);
  assert.deepEqual(
    found.map(({ t }) => t.subpath),
    [0, 0, 1, 1],
  );
  const swapped = circle.intersections(path);
  onBoth(circle, path, swapped);
  assert.deepEqual(
    swapped.map(({ u }) => u.subpath),
    [0, 0, 1, 1],
  );
  const arc = complete.Path.from(new complete.Curve([0, -5, 0, 5])).intersections(
    NurbsCurve.from(new Curve([0, 2, 0, 9])),
  );
  assert.deepEqual(arc, [
    {
      t: { subpath: 0, t: 0.7 },
      u: 0,
      point: { x: 0, y: 2 },
      kind: "overlap",
      tEnd: { subpath: 0, t: 1 },
      uEnd: 3 / 7,
    },
  ]);
});

test("intersections of curves in space are refused", () => {
  const space = NurbsCurve.arc([0, 0, 0], 1, 0, 1);
  const line = new complete.Curve([0, 0, 1, 1]);
  for (const act of [
    () => space.intersections(line),
    () => space.selfIntersections(),
    () => circle.intersections(space),
    () => line.intersections(space),
    () => complete.Path.from(line).intersections(space),
    () => quarter.intersections(new Spline([0, 0, 0, 1, 1, 1], { degree: 1, dimension: 3 })),
  ])
    refused(act, TypeError, /ntersections: expected a 2D (curve|spline), got a 3D one/);
});
