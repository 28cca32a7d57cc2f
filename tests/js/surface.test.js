// Patch, Surface and Mesh through the package's door; the figures are those of the listing and of closed forms.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Mesh, Patch, Surface } from "casteljau";

/** The plane z = 2 over [0, 3] × [0, 3]: control points on a lattice. */
const plane = new Patch(Array.from({ length: 16 }, (_, i) => [i % 4, Math.floor(i / 4), 2]));
const near = (a, b) =>
  assert.ok(Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z) < 1e-14, `${JSON.stringify(a)} ≠ ${JSON.stringify(b)}`);

test("a patch over a lattice is the plane itself", () => {
  near(plane.eval(0.25, 0.5), { x: 0.75, y: 1.5, z: 2 });
  near(plane.normal(0.3, 0.9), { x: 0, y: 0, z: 1 });
  const { u, v, uu, uv, vv } = plane.partials(0.4, 0.7);
  near(u, { x: 3, y: 0, z: 0 });
  near(v, { x: 0, y: 3, z: 0 });
  for (const second of [uu, uv, vv]) near(second, { x: 0, y: 0, z: 0 });
  near(plane.isocurveAtU(0.5).eval(0.25), { x: 1.5, y: 0.75, z: 2 });
  near(plane.isocurveAtV(0.5).eval(0.25), { x: 0.75, y: 1.5, z: 2 });
});

test("the pieces of a patch lie where they were cut", () => {
  const [first, , , last] = plane.split(0.5, 0.25);
  near(first.eval(1, 1), { x: 1.5, y: 0.75, z: 2 });
  near(last.eval(1, 1), { x: 3, y: 3, z: 2 });
  near(plane.transform([1, 0, 0, 1, 5, 0]).eval(0, 0), { x: 5, y: 0, z: 2 });
  assert.equal(plane.movePoint(5, [9, 9, 9]).controlPoints()[15], 9);
  assert.ok(Patch.fromJSON(JSON.parse(JSON.stringify(plane))).equals(plane));
});

test("the teapot has the counts of its listing", () => {
  const mesh = Surface.teapot().grid({ segments: 16, quads: true });
  assert.equal(mesh.positions.length, 3 * 9248);
  assert.equal(mesh.indices.length, 3 * 32 * 2 * 16 * 16);
  assert.equal(mesh.quads?.length, 4 * 32 * 16 * 16);
  assert.ok(mesh.indices instanceof Uint16Array);
  assert.ok(Surface.teapot().grid({ segments: 46 }).indices instanceof Uint32Array);
  const height = (/** @type {any} */ options) => Math.max(...Surface.teapot(options).grid({ segments: 1 }).positions);
  assert.ok(height({ lid: false, up: "y" }) > 3);
});

test("parts, height and axis of the teapot", () => {
  assert.equal(Surface.teapot({ lid: false, bottom: false }).patchCount, 20);
  const top = (/** @type {any} */ options, /** @type {number} */ axis) =>
    Surface.teapot(options).vertices.reduce((most, x, i) => (i % 3 === axis ? Math.max(most, x) : most), 0);
  assert.ok(Math.abs(top({}, 2) - 3.15) < 1e-12);
  assert.ok(Math.abs(top({ height: "original", up: "y" }, 1) - 4.2) < 1e-12);
});

test("an earlier mesh is reused and returned", () => {
  const mesh = plane.grid({ segments: 4 });
  const { positions } = mesh;
  assert.equal(plane.grid({ segments: { u: 4, v: 4 }, into: mesh }), mesh);
  assert.equal(mesh.positions, positions);
  assert.equal(plane.grid({ segments: 2, into: mesh }).positions.length, 27);
  assert.ok(mesh instanceof Mesh);
});

test("what was done in between leaves no traces in an earlier mesh", () => {
  const surface = Surface.teapot();
  const fresh = surface.grid({ segments: 5, quads: true });
  const into = surface.grid({ segments: 5, quads: true });
  const between = [
    () => {
      into.positions.fill(7);
      into.normals.fill(7);
    },
    () => (into.indices = into.indices.slice().reverse()),
    () => (into.uvs = new Float32Array(/** @type {any} */ (into.uvs).length)),
    () => surface.grid({ segments: 5 }),
    () => surface.grid({ segments: { u: 1, v: 17 }, quads: true, into }),
    () => surface.grid({ segments: { u: 17, v: 1 }, quads: true, into }),
    () => plane.grid({ segments: 5, quads: true, into }),
    () => surface.tessellate({ segments: 5, weld: "none", into }),
    () => surface.tessellate({ tolerance: 0.1, into: new Mesh({ ...into }) }),
    () => surface.tessellate({ segments: 5, weld: "none" }),
    () => surface.grid({ segments: { u: 4, v: 6 }, quads: true }),
    () => plane.grid({ segments: 5, quads: true }),
    () => assert.throws(() => surface.grid({ segments: 1e6 }), RangeError),
    () => surface.grid({ segments: 5, quads: true, method: "forward-difference" }),
  ];
  for (const act of between) {
    act();
    assert.deepEqual({ ...surface.grid({ segments: 5, quads: true, into }) }, { ...fresh });
  }
});

test("an earlier grid of the same counts keeps its layout, and what was changed there", () => {
  const into = plane.grid({ segments: 3 });
  const { indices, uvs } = into;
  /** @type {any} */ (uvs)[0] = 7;
  plane.movePoint(5, [0, 0, 9]).grid({ segments: 3, into });
  assert.ok(into.indices === indices && into.uvs === uvs && uvs?.[0] === 7);
  assert.deepEqual(into.positions, plane.movePoint(5, [0, 0, 9]).grid({ segments: 3 }).positions);
  plane.grid({ segments: { u: 3, v: 3 }, into: plane.grid({ segments: 2, into }) });
  assert.equal(into.uvs?.[0], 0);
});

test("forward differences come to the same, to the last bit or so", () => {
  for (const [shape, size] of /** @type {[Surface | Patch, number][]} */ ([
    [Surface.teapot(), 3.525],
    [plane, 3],
  ])) {
    const [exact, stepped] = ["bernstein", "forward-difference"].map((method) =>
      shape.grid({ segments: 20, method: /** @type {any} */ (method) }),
    );
    const apart = exact.positions.map((x, i) => Math.abs(x - stepped.positions[i]));
    assert.ok(Math.max(...apart) <= size * 2 ** -22);
    assert.deepEqual(stepped.indices, exact.indices);
    assert.deepEqual(exact, shape.grid({ segments: 20 }));
  }
});

test("one call draws the whole network", () => {
  const steps = [];
  const names = ["moveTo", "lineTo", "quadraticCurveTo", "bezierCurveTo", "closePath"];
  const target = Object.fromEntries(names.map((name) => [name, (...p) => steps.push([name, ...p])]));
  const square = new Surface({ vertices: plane.controlPoints(), patches: [[...Array(16).keys()]] });
  square.trace(/** @type {any} */ (target), { matrix: [10, 0, 0, 10, 100, 0], lines: 1 });
  assert.deepEqual(steps[0], ["moveTo", 100, 0]);
  assert.equal(steps.length, 8);
});

const refusals = /** @type {[string, () => unknown, any, RegExp][]} */ ([
  ["0 segments", () => plane.grid({ segments: 0 }), RangeError, /segments: expected a whole number from 1.*got 0/],
  [
    "a million segments",
    () => plane.grid({ segments: 1e6 }),
    RangeError,
    /segments: expected at most \d+, this needs 1000000/,
  ],
  [
    "no segments",
    () => plane.grid(/** @type {any} */ ({})),
    TypeError,
    /segments: expected a whole number, got undefined/,
  ],
  [
    "another method",
    () => plane.grid({ segments: 2, method: /** @type {any} */ ("horner") }),
    RangeError,
    /method: expected one of "bernstein", "forward-difference", got "horner"/,
  ],
  ["fifteen points", () => new Patch(new Float64Array(45)), RangeError, /net: expected 16 control points.*got 15/],
  [
    "an index past the end",
    () => new Surface({ vertices: [[0, 0, 0]], patches: [new Array(16).fill(1)] }),
    RangeError,
    /patches\[0\]\[0\]/,
  ],
  ["a NaN", () => new Patch(new Float64Array(48).fill(NaN)), RangeError, /net\[0\]: expected a finite number, got NaN/],
  [
    "a patch that is not there",
    () => Surface.teapot().patch(32),
    RangeError,
    /patch: expected a whole number from 0 to 31, got 32/,
  ],
]);

for (const [name, act, type, message] of refusals) {
  test(`refused: ${name}`, () => {
    assert.throws(act, (/** @type {any} */ error) => error instanceof type && message.test(error.message));
    near(plane.eval(0, 0), { x: 0, y: 0, z: 2 });
  });
}
