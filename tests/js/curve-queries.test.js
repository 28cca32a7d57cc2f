// Queries of curves and splines (nearest, extrema, timesAtCoordinate …) by closed forms; the search itself is tested in Rust.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { CUBIC, near, SPACE } from "./reference.js";

const arch = new Curve(CUBIC); // (24t² − 16t³, 24t − 24t²)

test("nearest: parameter, point and distance, ends included", () => {
  const parabola = new Curve([
    [0, 0],
    [100, 0],
    [100, 100],
  ]);
  assert.deepEqual(parabola.nearest({ x: 80, y: 20 }), { t: 0.5, point: { x: 75, y: 25 }, distance: Math.hypot(5, 5) });
  assert.deepEqual(arch.nearest([-3, -4]), { t: 0, point: { x: 0, y: 0 }, distance: 5 });
  assert.deepEqual(arch.nearest([11, -4]), { t: 1, point: { x: 8, y: 0 }, distance: 5 });
  const top = arch.nearest([4, 9]);
  near([top.t, top.point.x, top.point.y, top.distance], [0.5, 4, 6, 3]);
  assert.deepEqual(arch.nearest({ x: 4, y: -1000 }).t, 0, "of equally near points the first");
});

test("nearest in space and of every degree", () => {
  for (const points of [
    SPACE,
    [
      [1, 2, 3],
      [4, 5, 6],
    ],
    [
      [0, 0, 0],
      [1, 3, 1],
      [2, -3, 0],
      [3, 3, 2],
      [4, 0, 1],
      [5, 1, 1],
    ],
  ]) {
    const curve = new Curve(points);
    for (const t of [0, 0.2, 0.5, 0.9, 1]) {
      const found = curve.nearest(curve.eval(t));
      near([found.t, found.distance], [t, 0], 1e-12);
    }
  }
  const line = new Curve([
    [0, 0, 0],
    [0, 0, 10],
  ]);
  assert.deepEqual(line.nearest([3, 4, 5]), { t: 0.5, point: { x: 0, y: 0, z: 5 }, distance: 5 });
});

test("nearest at every size", () => {
  for (const scale of [1e149, 1e-300, 1e100, 1e-100]) {
    const curve = new Curve(CUBIC.map(([x, y]) => [x * scale, y * scale]));
    const found = curve.nearest([4 * scale, 9 * scale]);
    near([found.t, found.distance / scale], [0.5, 3]);
  }
});

test("nearest on a spline: t over all segments", () => {
  const square = new Spline(
    [
      [0, 0],
      [2, 0],
      [2, 2],
      [0, 2],
    ],
    { degree: 1, closed: true },
  );
  assert.deepEqual(square.nearest([3, 1]), { t: 1.5, point: { x: 2, y: 1 }, distance: 1 });
  assert.deepEqual(square.nearest([-1, 1]), { t: 3.5, point: { x: 0, y: 1 }, distance: 1 });
  assert.deepEqual(square.nearest([1, 1]), { t: 0.5, point: { x: 1, y: 0 }, distance: 1 }, "the first of four");
  const space = Spline.fromCurves([
    new Curve([
      [0, 0, 0],
      [0, 0, 4],
    ]),
    new Curve([
      [0, 0, 4],
      [1, 2, 4],
      [4, 4, 4],
    ]),
  ]);
  assert.deepEqual(space.nearest([-3, -4, 2]), { t: 0.5, point: { x: 0, y: 0, z: 2 }, distance: 5 });
  assert.throws(() => square.nearest([1, NaN]), { name: "RangeError", message: /^p\[1\]/ });
});

test("extrema: inside only, where the derivative changes its sign", () => {
  assert.deepEqual(arch.extrema(), { x: new Float64Array(0), y: Float64Array.of(0.5) });
  const space = new Curve([
    [0, 0, 0],
    [1, 2, -1],
    [2, -2, 3],
    [3, 0, 0],
  ]).extrema();
  assert.deepEqual(Object.keys(space), ["x", "y", "z"]);
  near(space.y, [0.5 - Math.sqrt(1 / 12), 0.5 + Math.sqrt(1 / 12)]);
  // (t − ½)³ stops at ½ and goes on.
  assert.deepEqual(
    new Curve([
      [0, -1],
      [1, 1],
      [2, -1],
      [3, 1],
    ]).extrema().y.length,
    0,
  );
});

test("timesAtCoordinate: crossings, ends, touches", () => {
  near(arch.timesAtCoordinate({ x: 4 }), [0.5]);
  near(arch.timesAtCoordinate({ y: 0 }), [0, 1]);
  near(arch.timesAtCoordinate({ y: 6 }), [0.5], 1e-7);
  assert.equal(arch.timesAtCoordinate({ y: 6.001 }).length, 0);
  near(arch.timesAtCoordinate({ y: 4.5 }), [0.25, 0.75]);
  near(
    new Curve([
      [0, 0, 5],
      [1, 1, 5],
    ]).timesAtCoordinate({ z: 5 }),
    [0, 1],
  );
});

test("inflections, cusps, classify, tangentsFrom", () => {
  near(
    new Curve([
      [0, 0],
      [1, 0.25],
      [0, 1],
      [1, 0],
    ]).inflections(),
    [0.5, 0.8],
  );
  const cusp = new Curve([
    [0, 0],
    [1, 1],
    [0, 1],
    [1, 0],
  ]);
  near(cusp.cusps(), [0.5]);
  assert.equal(cusp.inflections().length, 0);
  const classes = {
    point: [
      [2, 2],
      [2, 2],
    ],
    line: [
      [0, 0],
      [2, 2],
      [1, 1],
    ],
    quadratic: [
      [0, 0],
      [2, 2],
      [4, 0],
    ],
    arch: CUBIC,
    serpentine: [
      [0, 0],
      [1, 2],
      [2, -2],
      [3, 0],
    ],
    loop: [
      [0, 0],
      [4, 2],
      [-2, 2],
      [2, 0],
    ],
    cusp: [
      [0, 0],
      [1, 1],
      [0, 1],
      [1, 0],
    ],
    twisted: [
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [1, 1, 1],
    ],
  };
  for (const [name, points] of Object.entries(classes)) {
    assert.equal(new Curve(points).classify(), name);
    assert.equal(new Curve(points.map(([x, y, z = x + y]) => [x, z, y])).classify(), name);
  }
  assert.equal(new Curve(classes.quadratic).elevate().elevate().classify(), "quadratic");
  near(arch.tangentsFrom([10, 6]), [0.5]);
  near(
    new Curve([
      [0, 0],
      [1, 1],
    ]).tangentsFrom({ x: 3, y: 3 }),
    [0, 1],
  );
});

test("distanceTo and hausdorff", () => {
  const line = new Curve([
    [0, 8],
    [8, 8],
  ]);
  near(Object.values(arch.distanceTo(line)), [2, 0.5, 0.5], 1e-7);
  assert.equal(arch.distanceTo(line).distance, 2);
  assert.equal(arch.distanceTo(arch).distance, 0);
  assert.equal(
    arch.distanceTo(
      new Curve([
        [4, 0],
        [4, 9],
      ]),
    ).distance,
    0,
  );
  assert.equal(arch.hausdorff(arch.reverse()), 0);
  assert.equal(
    arch.hausdorff(
      new Curve([
        [0, 0],
        [8, 0],
      ]),
    ),
    6,
  );
  const [low, high] = [0, 3].map((z) => new Curve(CUBIC.map(([x, y]) => [x, y, z])));
  assert.equal(low.distanceTo(high).distance, 3);
  near([low.hausdorff(high)], [3]);
});

test("refusals name what came", () => {
  assert.throws(() => arch.nearest([1, NaN]), {
    name: "RangeError",
    message: /^p\[1\]: expected a finite number, got NaN/,
  });
  assert.throws(() => arch.nearest({ x: 1, y: Infinity }), { name: "RangeError", message: /^p\.y/ });
  for (const bad of [null, undefined, 5, "x", {}, [1], [1, 2, 3], { x: "1", y: 2 }]) {
    assert.throws(() => arch.nearest(/** @type {any} */ (bad)), /^(Range|Type)Error: p/);
  }
  assert.throws(() => arch.timesAtCoordinate({ z: 1 }), {
    name: "TypeError",
    message: /^where: expected exactly one of x, y/,
  });
  assert.throws(() => arch.timesAtCoordinate(/** @type {any} */ ({})), TypeError);
  assert.throws(() => arch.timesAtCoordinate(/** @type {any} */ ({ x: 1, y: 2 })), TypeError);
  assert.throws(() => new Curve(SPACE).inflections(), {
    name: "TypeError",
    message: /^inflections: expected a 2D curve/,
  });
  assert.throws(() => new Curve(SPACE).tangentsFrom([0, 0, 0]), {
    name: "TypeError",
    message: /^tangentsFrom: expected a 2D/,
  });
  assert.throws(() => arch.tangentsFrom([NaN, 0]), { name: "RangeError", message: /^p\[0\]/ });
  assert.throws(() => arch.distanceTo(new Curve(SPACE)), {
    name: "TypeError",
    message: /^curve: expected a 2D curve, got a 3D/,
  });
  assert.throws(
    () =>
      arch.hausdorff(
        /** @type {any} */ ([
          [0, 0],
          [1, 1],
        ]),
      ),
    { name: "TypeError", message: /^curve: / },
  );
  assert.throws(() => arch.timesAtCoordinate({ x: Infinity }), { name: "RangeError", message: /^x: / });
});
