// Queries of patches and surfaces: closed forms, and golden values.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Curve, Patch, Surface } from "casteljau";

/** The square [0, 3] × [0, 3] at z = 2: control points on a lattice. */
const plane = new Patch(Array.from({ length: 16 }, (_, i) => [i % 4, Math.floor(i / 4), 2]));

/** z = (u − ½)² + (v − ½)² over the unit square. */
const bowl = new Patch(
  Array.from({ length: 9 }, (_, i) => [
    (i % 3) / 2,
    Math.floor(i / 3) / 2,
    (i % 3 === 1 ? -0.25 : 0.25) + (Math.floor(i / 3) === 1 ? -0.25 : 0.25),
  ]),
  { degreeU: 2, degreeV: 2 },
);

const cube = new Surface(
  {
    vertices: Array.from({ length: 8 }, (_, k) => [k & 1, (k >> 1) & 1, k >> 2]),
    patches: [
      [0, 2, 1, 3],
      [4, 5, 6, 7],
      [0, 1, 4, 5],
      [2, 6, 3, 7],
      [0, 4, 2, 6],
      [1, 3, 5, 7],
    ],
  },
  { degreeU: 1, degreeV: 1 },
);

const empty = new Surface({ vertices: [], patches: [] });

/** @param {{ x: number, y: number, z?: number }} a @param {number[]} b */
const near = (a, b, most = 1e-14) =>
  assert.ok(
    Math.hypot(a.x - b[0], a.y - b[1], (a.z ?? 0) - b[2]) <= most,
    `${JSON.stringify(a)} ≠ ${JSON.stringify(b)}`,
  );

/** @param {number} a @param {number} b */
const close = (a, b, most = 1e-14) => assert.ok(Math.abs(a - b) <= most * Math.max(1, Math.abs(b)), `${a} ≠ ${b}`);

test("curvature of a paraboloid at its vertex and of a plane", () => {
  const { gaussian, mean, k1, k2 } = bowl.curvature(0.5, 0.5);
  for (const [got, expected] of [
    [gaussian, 4],
    [mean, 2],
    [k1, 2],
    [k2, 2],
  ])
    close(got, expected, 1e-12);
  assert.deepEqual(Object.values(plane.curvature(0.3, 0.9)).map(Math.abs), [0, 0, 0, 0]);
});

test("a box is that of the surface, not of its control points", () => {
  const { min, max } = bowl.bounds();
  near(min, [0, 0, 0]);
  near(max, [1, 1, 0.5]);
  const teapot = Surface.teapot().bounds();
  close(teapot?.max.x ?? NaN, 3.434075125471107, 1e-15);
  assert.equal(empty.bounds(), null);
});

test("area, flatness and volume", () => {
  close(plane.area(), 9);
  assert.equal(plane.flatness(), 0);
  close(bowl.flatness(), 0.5); // a quarter for the bulge in u and one for that in v
  close(cube.area(), 6);
  close(cube.volume() ?? NaN, 1);
  assert.equal(Surface.teapot().volume(), null);
  assert.equal(empty.area(), 0);
  assert.equal(empty.volume(), null);
});

test("the teacup's area", () => {
  const { vertices, patches } = JSON.parse(readFileSync(new URL("../data/teacup.json", import.meta.url), "utf8"));
  close(new Surface({ vertices, patches }).area(), 9.981697616, 1e-9);
  close(Surface.teacup().area(), 9.981697616, 1e-9);
  close(Surface.teaspoon().area(), 0.342881444, 2e-9);
});

test("the nearest point, inside, on sides and at corners", () => {
  const inside = plane.nearest([0.75, 1.5, 7]);
  near(inside.point, [0.75, 1.5, 2]);
  assert.deepEqual(
    [inside.u, inside.v, inside.distance].map((x) => +x.toFixed(12)),
    [0.25, 0.5, 5],
  );
  near(plane.nearest({ x: -4, y: 1, z: 5 }).point, [0, 1, 2]);
  near(plane.nearest([9, 9, 9]).point, [3, 3, 2]);
  const onCube = cube.nearest([0.5, 0.25, 3]);
  assert.equal(onCube?.patch, 1);
  near(onCube?.point ?? { x: NaN, y: 0 }, [0.5, 0.25, 1]);
  assert.equal(empty.nearest([0, 0, 0]), null);
  assert.deepEqual(Object.keys(inside), ["u", "v", "point", "distance"]);
});

test("all hits of a ray, by distance", () => {
  const [first, second, ...others] = bowl.intersectRay([-1, 0.5, 0.04], [5, 0, 0]);
  assert.equal(others.length, 0);
  near(first.point, [0.3, 0.5, 0.04]);
  near(second.point, [0.7, 0.5, 0.04]);
  close(first.distance, 1.3);
  assert.equal(bowl.intersectRay([-1, 0.5, 0], [1, 0, 0]).length, 1);
  assert.deepEqual(bowl.intersectRay([-1, 0.5, -1], [1, 0, 0]), []);
  const through = cube.intersectRay([0.5, 0.5, 9], [0, 0, -0.1]);
  assert.deepEqual(
    through.map(({ patch, distance }) => [patch, distance]),
    [
      [1, 8],
      [0, 9],
    ],
  );
  // Along a diagonal of the cube: corners, each of three faces, count once.
  assert.equal(cube.intersectRay([-1, -1, -1], [1, 1, 1]).length, 2);
  assert.equal(Surface.teapot().intersectRay([0, 0, 9], [0, 0, -1]).length, 2);
  assert.deepEqual(empty.intersectRay([0, 0, 0], [0, 0, 1]), []);
});

test("deCasteljau of a patch: rows, then a curve, then the point", () => {
  const { rows, column, point } = bowl.deCasteljau(0.25, 0.75);
  assert.deepEqual(
    rows.map((levels) => levels.map((level) => level.length / 3)),
    [
      [3, 2, 1],
      [3, 2, 1],
      [3, 2, 1],
    ],
  );
  assert.deepEqual(
    column.map((level) => level.length / 3),
    [3, 2, 1],
  );
  assert.deepEqual(
    rows.flatMap((levels) => [...levels[2]]),
    [...column[0]],
  );
  near(point, [0.25, 0.75, 0.125]);
  near(bowl.eval(0.25, 0.75), [0.25, 0.75, 0.125]);
});

test("elevation keeps the patch", () => {
  const high = bowl.elevate();
  assert.deepEqual([high.degreeU, high.degreeV], [3, 3]);
  near(high.eval(0.2, 0.7), [0.2, 0.7, 0.13]);
  assert.throws(
    () => new Patch(new Float64Array(3 * 65 * 2), { degreeU: 64, degreeV: 1 }).elevate(),
    /RangeError: degree: expected a degree below 64, got 64/,
  );
});

test("a patch from another basis goes through the curves of that basis", () => {
  const net = Array.from({ length: 16 }, (_, i) => [i % 4, Math.floor(i / 4), (i * 7) % 5]);
  for (const basis of /** @type {const} */ (["bezier", "b-spline", "catmull-rom", "hermite"])) {
    const patch = Patch.fromBasis(basis, net);
    const ends = [0, 1, 2, 3].map((j) => Curve.fromBasis(basis, net.slice(4 * j, 4 * j + 4)).eval(0.3));
    const { x, y, z = 0 } = Curve.fromBasis(basis, ends).eval(0.6);
    near(patch.eval(0.3, 0.6), [x, y, z]);
    assert.ok(Patch.fromBasis(Curve.basisMatrix(basis), new Float64Array(net.flat())).equals(patch));
  }
});

const refusals = /** @type {[string, () => unknown, any, RegExp][]} */ ([
  [
    "a direction of length 0",
    () => plane.intersectRay([0, 0, 0], [0, 0, 0]),
    RangeError,
    /^direction: expected a vector of a length above 0, got 0$/,
  ],
  [
    "an origin with a NaN",
    () => cube.intersectRay([0, NaN, 0], [0, 0, 1]),
    RangeError,
    /^origin\[1\]: expected a finite number, got NaN$/,
  ],
  [
    "a direction of the plane",
    () => plane.intersectRay([0, 0, 0], [0, 1]),
    RangeError,
    /^direction: expected 3 coordinates, got 2$/,
  ],
  ["a point without z", () => plane.nearest({ x: 0, y: 1 }), TypeError, /^point\.z: expected a number, got undefined$/],
  ["no point", () => cube.nearest(/** @type {any} */ (7)), TypeError, /^point: expected a point/],
  [
    "an infinite point",
    () => cube.nearest([0, 0, Infinity]),
    RangeError,
    /^point\[2\]: expected a finite number, got Infinity$/,
  ],
  [
    "a parameter that is no number",
    () => plane.curvature(/** @type {any} */ ("0"), 0),
    TypeError,
    /^u: expected a number, got "0"$/,
  ],
  ["deCasteljau at NaN", () => plane.deCasteljau(0, NaN), RangeError, /^v: expected a finite number, got NaN$/],
  [
    "an unknown basis",
    () => Patch.fromBasis(/** @type {any} */ ("spline"), plane.controlPoints()),
    RangeError,
    /^basis: expected one of "bezier"/,
  ],
  [
    "a basis of nine numbers",
    () => Patch.fromBasis(new Float64Array(9), plane.controlPoints()),
    RangeError,
    /^basis: expected 16 numbers \(4×4\), got 9$/,
  ],
  [
    "nine points",
    () => Patch.fromBasis("b-spline", bowl.controlPoints()),
    RangeError,
    /^net: expected 16 control points in rows of 4 along u \(degrees 3 × 3\), got 9$/,
  ],
]);

for (const [name, act, type, message] of refusals) {
  test(`refused: ${name}`, () => {
    assert.throws(act, (/** @type {any} */ error) => error instanceof type && message.test(error.message));
    near(plane.eval(0, 0), [0, 0, 2]);
  });
}
