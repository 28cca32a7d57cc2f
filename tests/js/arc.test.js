// Lengths, even steps, areas, torsion and frames through the package's door, by closed forms.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { CUBIC, near, owned, refused, SEVEN, SPACE, untyped } from "./reference.js";

/** A part of the larger number. */
const agree = (got, expected, part = 1e-12) =>
  assert.ok(Math.abs(got - expected) <= part * Math.abs(expected), `${got} instead of ${expected}`);

test("length: closed forms, at turn-backs and cusps too", () => {
  assert.equal(
    new Curve([
      [0, 0],
      [3, 4],
    ]).length(),
    5,
  );
  assert.equal(
    new Curve([
      [0, 0, 0],
      [1, 2, 2],
    ]).length(),
    3,
  );
  assert.equal(
    new Curve([
      [0.1, 0.1],
      [0.1, 0.1],
      [0.1, 0.1],
      [0.1, 0.1],
    ]).length(),
    0,
  );
  agree(
    new Curve([
      [0, 0],
      [0.5, 1],
      [1, 0],
    ]).length(),
    Math.sqrt(5) / 2 + Math.asinh(2) / 4,
    1e-15,
  );
  agree(
    new Curve([
      [1, 3],
      [2, 5],
      [-9, -17],
    ]).length(),
    22.733357771247864,
    1e-15,
  );
  agree(
    new Curve([
      [0, 0],
      [1, 0],
      [1, 0],
      [0, 0],
    ]).length(),
    1.5,
  );
  // (t², t³) from −1 to 1, in the plane and turned into space.
  const cusp = [
    [1, -1],
    [-1 / 3, 1],
    [-1 / 3, -1],
    [1, 1],
  ];
  const expected = (2 * (13 * Math.sqrt(13) - 8)) / 27;
  agree(new Curve(cusp).length(), expected);
  agree(new Curve(cusp.map(([x, y]) => [0.6 * x, y, 0.8 * x])).length(), expected);
  for (const size of [1e-300, 1e-9, 1e9, 1e149]) {
    agree(new Curve(cusp.map((p) => p.map((x) => x * size))).length(), expected * size);
  }
});

test("length: additive, and as the polyline's limit", () => {
  for (const points of [
    CUBIC,
    SPACE,
    [
      [0, 0],
      [9, 1],
      [-3, 4],
      [5, 5],
      [2, 0],
      [0, 7],
    ],
  ]) {
    const curve = new Curve(points);
    for (const t of [0.1, 0.5, 0.77]) {
      const [left, right] = curve.split(t);
      agree(left.length() + right.length(), curve.length());
    }
    agree(curve.reverse().length(), curve.length());
    agree(curve.elevate().length(), curve.length());
    const { points: vertices } = curve.flatten(1e-6);
    let sum = 0;
    for (let i = curve.dimension; i < vertices.length; i += curve.dimension) {
      sum += Math.hypot(
        ...[0, 1, 2].slice(0, curve.dimension).map((k) => vertices[i + k] - vertices[i + k - curve.dimension]),
      );
    }
    agree(sum, curve.length(), 1e-5);
    for (const tolerance of [1, 1e-3, 1e-6, 1e-9]) near([curve.length(tolerance)], [curve.length()], tolerance);
  }
});

test("length: refusals", () => {
  for (const curve of [new Curve(CUBIC), new Curve(SPACE)]) {
    for (const tolerance of [0, -1])
      refused(() => curve.length(tolerance), RangeError, /^tolerance: expected a number above 0, got /);
    for (const tolerance of [NaN, Infinity])
      refused(() => curve.length(tolerance), RangeError, /^tolerance: expected a finite number, got /);
    for (const tolerance of [null, "1", {}])
      refused(() => curve.length(untyped(tolerance)), TypeError, /^tolerance: expected a number, got /);
    refused(
      () => curve.length(1e-17),
      RangeError,
      /^tolerance: expected at least .* \(4 ulps of the largest coordinate\), got 1e-17$/,
    );
  }
});

test("area: swept from the origin", () => {
  near(
    [
      new Curve([
        [1, 0],
        [2 / 3, 1],
        [1 / 3, 1],
        [0, 1],
      ]).area(),
    ],
    [0.75],
    1e-15,
  );
  assert.equal(
    new Curve([
      [2, 0],
      [0, 3],
    ]).area(),
    3,
  );
  assert.equal(
    new Curve([
      [0, 3],
      [2, 0],
    ]).area(),
    -3,
  );
  refused(() => new Curve(SPACE).area(), TypeError, /^area: expected a 2D curve, got a 3D one$/);
});

const CURVES = [
  [
    [0, 0],
    [3, 4],
  ],
  [
    [0, 0],
    [1, 0],
    [0, 0],
  ],
  CUBIC,
  SPACE,
  [
    [0, 0],
    [9, 1],
    [-3, 4],
    [5, 5],
    [2, 0],
    [0, 7],
  ],
];

test("timeAtLength and equidistantTimes: the length up to t is s", () => {
  for (const points of CURVES) {
    const curve = new Curve(points);
    const whole = curve.length();
    const upTo = (t) => curve.split(t)[0].length();
    for (const part of [1e-6, 0.25, 0.5, 0.9])
      near([upTo(curve.timeAtLength(part * whole))], [part * whole], 4e-12 * whole);
    near([upTo(curve.timeAtLength(0.3 * whole, 1e-3))], [0.3 * whole], 1e-3);
    assert.deepEqual(
      [-1, 0, whole, 1e9].map((s) => curve.timeAtLength(s)),
      [0, 0, 1, 1],
    );
    const ts = curve.equidistantTimes(7);
    owned(ts);
    assert.deepEqual([ts.length, ts[0], ts[7]], [8, 0, 1]);
    ts.forEach((t, i) => near([upTo(t)], [(i * whole) / 7], 4e-12 * whole));
  }
  assert.deepEqual(
    [
      ...new Curve([
        [0, 0],
        [3, 4],
      ]).equidistantTimes(4),
    ],
    [0, 0.25, 0.5, 0.75, 1],
  );
  assert.deepEqual(
    [
      ...new Curve([
        [1, 1],
        [1, 1],
      ]).equidistantTimes(2),
    ],
    [0, 0.5, 1],
  );
});

test("splines: length, timeAtLength, equidistantTimes, area", () => {
  const open = new Spline(SEVEN);
  const lengths = open.segments().map((curve) => curve.length());
  agree(open.length(), lengths[0] + lengths[1]);
  near([open.length(1e-3)], [open.length()], 1e-3);
  assert.equal(open.timeAtLength(lengths[0]), 1);
  assert.deepEqual(
    [-1, open.length(), 1e9].map((s) => open.timeAtLength(s)),
    [0, 2, 2],
  );
  const ts = open.equidistantTimes(10);
  owned(ts);
  assert.deepEqual([ts.length, ts[0], ts[10]], [11, 0, 2]);
  ts.slice(1, 10).forEach((t, i) => {
    near([open.timeAtLength(((i + 1) * open.length()) / 10)], [t], 1e-13);
    const first =
      t < 1
        ? open.segments()[0].split(t)[0].length()
        : lengths[0] +
          open
            .segments()[1]
            .split(t - 1)[0]
            .length();
    near([first], [((i + 1) * open.length()) / 10], 1e-12);
  });
  const square = new Spline(
    [
      [0, 0],
      [2, 0],
      [2, 2],
      [0, 2],
    ],
    { degree: 1, closed: true },
  );
  assert.deepEqual([square.length(), square.area(), square.reverse().area()], [8, 4, -4]);
  near([square.timeAtLength(5)], [2.5]);
  const space = new Spline([...SPACE, [5, 0, 0], [6, 1, 1], [7, 0, 2]]);
  agree(
    space.length(),
    space.segments().reduce((sum, curve) => sum + curve.length(), 0),
  );
  refused(() => space.area(), TypeError, /^area: expected a 2D spline, got a 3D one$/);
});

test("timeAtLength and equidistantTimes: refusals", () => {
  for (const target of [new Curve(CUBIC), new Spline(SEVEN)]) {
    for (const s of [NaN, Infinity])
      refused(() => target.timeAtLength(s), RangeError, /^s: expected a finite number, got /);
    for (const s of [undefined, "1", null])
      refused(() => target.timeAtLength(untyped(s)), TypeError, /^s: expected a number, got /);
    refused(() => target.timeAtLength(1, 0), RangeError, /^tolerance: expected a number above 0, got 0$/);
    refused(() => target.timeAtLength(1, 1e-17), RangeError, /^tolerance: expected at least /);
    for (const n of [0, -1, 1.5, NaN])
      refused(
        () => target.equidistantTimes(n),
        RangeError,
        /^segments: expected a whole number from 1 to 4294967295, got /,
      );
    refused(() => target.equidistantTimes(untyped("8")), TypeError, /^segments: expected a whole number, got /);
    refused(
      () => target.equidistantTimes(2 ** 31),
      RangeError,
      /^segments: expected at most \d+, this needs 2147483648$/,
    );
  }
});

/** (t, t², t³) */
const TWISTED = [
  [0, 0, 0],
  [1 / 3, 0, 0],
  [2 / 3, 1 / 3, 0],
  [1, 1, 1],
];

test("torsion", () => {
  const curve = new Curve(TWISTED);
  for (const t of [0, 0.3, 1]) near([curve.torsion(t)], [3 / (1 + 9 * t ** 2 + 9 * t ** 4)]);
  assert.equal(new Curve(CUBIC).torsion(0.3), 0);
  assert.equal(new Curve(CUBIC.map(([x, y]) => [x, y, 3])).torsion(0.3), 0);
  refused(() => curve.torsion(NaN), RangeError, /^t: expected a finite number, got NaN$/);
  refused(() => new Curve(CUBIC).torsion(untyped("1")), TypeError, /^t: expected a number, got "1"$/);
});

test("frames: orthonormal, without twist, as many as asked for", () => {
  const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const at = (array, i) => [...array.slice(3 * i, 3 * i + 3)];
  const curve = new Curve(TWISTED);
  for (const target of [curve, new Spline(TWISTED), new Spline([...TWISTED, [2, 1, 4], [2, 0, 3], [1, 0, 3]])]) {
    for (const where of [8, target.equidistantTimes(10), [0.1, 0.5, 0.2]]) {
      const frames = target.frames(where);
      const ts =
        typeof where === "number"
          ? Array.from({ length: 8 * (target instanceof Spline ? target.segmentCount : 1) + 1 }, (_, i) => i / 8)
          : where;
      Object.values(frames).forEach(owned);
      near(frames.points, target.evalAt(ts));
      ts.forEach((_, i) => {
        const [u, v, w] = [frames.tangents, frames.normals, frames.binormals].map((array) => at(array, i));
        near([dot(u, u), dot(v, v), dot(w, w), dot(u, v), dot(v, w), dot(w, u)], [1, 1, 1, 0, 0, 0]);
        near([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], w);
      });
    }
  }
  // However many steps: the same last frame.
  near(at(curve.frames(1).normals, 1), at(curve.frames(1000).normals, 1000), 1e-9);
  near(at(curve.frames(1).normals, 0), [0, 1, 0]);
  // Upright in a plane: up stays up, over the cusp too.
  const cusp = new Curve([
    [0, 0, 5],
    [1, 1, 5],
    [0, 1, 5],
    [1, 0, 5],
  ]);
  const { normals } = cusp.frames(7, { normal: { x: 3, y: 0, z: 1 } });
  const first = at(normals, 0);
  const up = cusp.frames(7, { normal: [0, 0, 2] });
  for (let i = 0; i <= 7; i++) {
    near(at(up.normals, i), [0, 0, 1], 1e-9);
    near([normals[3 * i + 2]], [first[2]], 1e-9);
  }
});

test("frames: refusals", () => {
  refused(() => new Curve(CUBIC).frames(4), TypeError, /^frames: expected a 3D curve, got a 2D one$/);
  refused(() => new Spline(SEVEN).frames(4), TypeError, /^frames: expected a 3D spline, got a 2D one$/);
  const curve = new Curve(TWISTED);
  for (const n of [0, 1.5, NaN])
    refused(() => curve.frames(n), RangeError, /^segments: expected a whole number from 1 to 4294967295, got /);
  refused(() => curve.frames(2 ** 31), RangeError, /^segments: expected at most \d+, this needs 2147483648$/);
  refused(() => curve.frames(untyped("4")), TypeError, /^where: expected an array of numbers, got "4"$/);
  refused(() => curve.frames([0, NaN]), RangeError, /^where\[1\]: expected a finite number, got NaN$/);
  refused(() => curve.frames(4, { normal: [0, 1] }), RangeError, /^normal: expected 3 coordinates, got 2$/);
  refused(
    () => curve.frames(4, { normal: [0, 1, Infinity] }),
    RangeError,
    /^normal\[2\]: expected a finite number, got Infinity$/,
  );
});
