// Splines through points, and B-splines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { coordinates, near, owned, pairs, refused, untyped } from "./reference.js";

const FOUR = [
  [0, 0],
  [1, 1],
  [3, 1],
  [4, 0],
];
const SPACE = [
  [0, 0, 0],
  [1, 2, 3],
  [3, 3, -1],
  [4, 0, 2],
  [5, 5, 5],
];
const joints = (spline) =>
  Array.from({ length: spline.segmentCount + (spline.closed ? 0 : 1) }, (_, k) => coordinates(spline.eval(k)));

test("interpolate: natural by default, C2 at the joints, which are the points", () => {
  for (const closed of [false, true]) {
    for (const points of [FOUR, SPACE, SPACE.slice(0, 3)]) {
      const spline = Spline.interpolate(points, { closed });
      assert.deepEqual(joints(spline), points);
      assert.ok(spline.equals(Spline.interpolate(points, { kind: "natural", closed })));
      for (let k = closed ? 0 : 1; k < spline.segmentCount; k++) assert.ok(spline.continuity(k).c2, `${k}`);
    }
  }
  assert.deepEqual(
    Spline.interpolate([
      { x: 0, y: 0 },
      { x: 3, y: 0 },
    ]).degrees,
    [3],
  );
  assert.equal(Spline.interpolate([0, 0, 0, 1, 1, 1], { dimension: 3 }).dimension, 3);
});

test("interpolate: Catmull-Rom with classical handles", () => {
  const uniform = Spline.interpolate(FOUR, { kind: "catmull-rom", alpha: 0 });
  near(uniform.segments()[1].controlPoints(), Curve.fromBasis("catmull-rom", FOUR).controlPoints());
  for (const alpha of [0.5, 1, 0.3]) {
    const spline = Spline.interpolate(SPACE, { kind: "catmull-rom", alpha });
    const [a, b, c] = SPACE;
    const [d1, d2] = [
      [a, b],
      [b, c],
    ].map(([p, q]) => Math.hypot(...p.map((x, i) => q[i] - x)) ** alpha);
    const tangent = a.map((_, i) => (b[i] - a[i]) / d1 - (c[i] - a[i]) / (d1 + d2) + (c[i] - b[i]) / d2);
    const points = pairs(spline.controlPoints(), 3);
    near(
      points[2],
      b.map((x, i) => x - (tangent[i] * d1) / 3),
    );
    near(
      points[4],
      b.map((x, i) => x + (tangent[i] * d2) / 3),
    );
    near(
      points[1],
      a.map((x, i) => x + (b[i] - x) / 3),
    );
  }
  assert.ok(
    Spline.interpolate(FOUR, { kind: "catmull-rom" }).equals(
      Spline.interpolate(FOUR, { kind: "catmull-rom", alpha: 0.5 }),
    ),
  );
});

test("interpolate: refusals", () => {
  refused(() => Spline.interpolate([[0, 0]]), RangeError, /^points: expected at least 2 points, got 1$/);
  refused(() => Spline.interpolate([]), RangeError, /^points: expected at least 2 points, got 0$/);
  refused(
    () =>
      Spline.interpolate([
        [0, 0],
        [NaN, 0],
      ]),
    RangeError,
    /^points\[1\]\[0\]: expected a finite number, got NaN$/,
  );
  refused(
    () => Spline.interpolate(FOUR, { kind: untyped("akima") }),
    RangeError,
    /^kind: expected one of "natural", "catmull-rom", got "akima"$/,
  );
  refused(
    () => Spline.interpolate(FOUR, { kind: "catmull-rom", alpha: 1.5 }),
    RangeError,
    /^alpha: expected a number from 0 to 1, got 1.5$/,
  );
  refused(
    () => Spline.interpolate(FOUR, { kind: "catmull-rom", alpha: untyped("1") }),
    TypeError,
    /^alpha: expected a number, got "1"$/,
  );
  refused(
    () => Spline.interpolate(untyped(5)),
    TypeError,
    /^points: expected an array of points, got 5; did you mean \[\[x, y\], …\]\?$/,
  );
});

test("fromBSpline: uniform, with knots, closed", () => {
  const uniform = Spline.fromBSpline(FOUR);
  near(uniform.controlPoints(), Curve.fromBasis("b-spline", FOUR).controlPoints());
  const quadratic = Spline.fromBSpline(
    [
      [0, 0],
      [1, 2],
      [3, 2],
      [4, 0],
    ],
    { degree: 2, knots: [0, 0, 0, 1, 2, 2, 2] },
  );
  assert.deepEqual(quadratic.degrees, [2, 2]);
  near(quadratic.eval(0.5), [1, 1.5]);
  assert.deepEqual(
    [quadratic.eval(0), quadratic.eval(2)],
    [
      { x: 0, y: 0 },
      { x: 4, y: 0 },
    ],
  );
  const ring = Spline.fromBSpline(SPACE, { closed: true });
  assert.deepEqual([ring.segmentCount, ring.closed, ring.dimension], [5, true, 3]);
  for (let k = 0; k < 5; k++) assert.ok(ring.continuity(k).c2);
});

test("toBSpline and back gives the same spline", () => {
  const several = [
    Spline.interpolate(FOUR),
    Spline.interpolate(SPACE, { closed: true }),
    new Spline(
      [
        [0, 0],
        [1, 1],
        [2, 0],
        [5, 5],
      ],
      { degree: 1 },
    ),
    new Spline(
      [
        [0, 0],
        [1, 1],
        [2, 0],
        [5, 5],
      ],
      { degree: 2, closed: true },
    ),
    Spline.fromBSpline(SPACE, { degree: 4, closed: true }),
  ];
  for (const spline of several) {
    const { points, ...options } = spline.toBSpline();
    [points, options.knots].forEach(owned);
    assert.ok(Spline.fromBSpline(points, options).equals(spline));
  }
  const { knots, degree, closed } = Spline.interpolate(FOUR.slice(1)).toBSpline();
  assert.deepEqual([[...knots], degree, closed], [[0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], 3, false]);
});

test("fromBSpline and toBSpline: refusals", () => {
  const with_ =
    (options, points = FOUR) =>
    () =>
      Spline.fromBSpline(points, options);
  refused(with_({ degree: 4 }), RangeError, /^points: expected at least degree \+ 1 points .*, got 4$/);
  refused(with_({ degree: 0 }), RangeError, /^degree: expected a whole number from 1 to 64, got 0$/);
  refused(with_({ knots: [0, 1] }), RangeError, /^knots: expected points \+ degree \+ 1 knots .*, got 2$/);
  refused(with_({ knots: [] }), RangeError, /^knots: expected 8 .*, got 0$/);
  refused(
    with_({ knots: [0, 1, 2, 3, 2.5, 5, 6, 7] }),
    RangeError,
    /^knots\[4\]: expected a knot not below the one before it, got 2.5$/,
  );
  refused(
    with_({ degree: 1, knots: [0, 1, 2, 2, 3, 4] }),
    RangeError,
    /^knots\[3\]: expected at most degree times .*, got 2$/,
  );
  refused(
    with_({ knots: [0, 0, 0, 0, 0, 0, 0, 0] }),
    RangeError,
    /^knots\[4\]: expected a knot above that where the curve starts, got 0$/,
  );
  refused(with_({ knots: [0, 1, NaN, 3, 4, 5, 6, 7] }), RangeError, /^knots\[2\]: expected a finite number, got NaN$/);
  refused(with_({ knots: "01234567" }), TypeError, /^knots: expected an array of numbers, got "01234567"$/);
  const mixed = Spline.fromCurves([
    new Curve([
      [0, 0],
      [1, 0],
    ]),
    new Curve([
      [1, 0],
      [2, 0],
      [3, 1],
    ]),
  ]);
  refused(() => mixed.toBSpline(), RangeError, /^degrees\[1\]: expected the degree of the first segment \(1\), got 2$/);
});

test("a million points", () => {
  const numbers = Float64Array.from({ length: 2e6 }, (_, i) => (i * 7919) % 1009);
  for (const spline of [
    Spline.interpolate(numbers),
    Spline.interpolate(numbers, { kind: "catmull-rom", closed: true }),
    Spline.fromBSpline(numbers),
  ]) {
    assert.ok(spline.segmentCount > 999_990);
    assert.ok(spline.controlPoints().every(Number.isFinite));
  }
});
