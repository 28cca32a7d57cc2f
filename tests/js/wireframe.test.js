// Isocurves, wireframes and flat pieces.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Mesh, Surface } from "casteljau";
import { refused, untyped } from "./reference.js";

const teapot = Surface.teapot();
const empty = new Surface({ vertices: [], patches: [] });
const point = new Surface({ vertices: [[1, 2, 3]], patches: [new Array(16).fill(0)] });
const square = new Surface(
  {
    vertices: [
      [0, 0, 1],
      [3, 0, 1],
      [0, 2, 1],
      [3, 2, 1],
    ],
    patches: [[0, 1, 2, 3]],
  },
  { degreeU: 1, degreeV: 1 },
);

test("isocurves: each line once", () => {
  for (const lines of [1, 2, 5]) {
    const curves = teapot.isocurves({ lines });
    // 52 sides are shared by two patches, 8 are a point.
    assert.equal(curves.length, 32 * 2 * (lines + 1) - 52 - 8);
    assert.ok(curves.every((curve) => curve instanceof Curve && curve.degree === 3 && curve.dimension === 3));
  }
  assert.equal(teapot.isocurves().length, teapot.isocurves({ lines: 4 }).length);
  const [left, right, near, far] = square.isocurves({ lines: 1 }).map((curve) => [...curve.controlPoints()]);
  assert.deepEqual(
    [left, right, near, far],
    [
      [0, 0, 1, 0, 2, 1],
      [3, 0, 1, 3, 2, 1],
      [0, 0, 1, 3, 0, 1],
      [0, 2, 1, 3, 2, 1],
    ],
  );
  assert.deepEqual(empty.isocurves(), []);
});

test("isocurves are the patches'", () => {
  const curves = new Surface({
    vertices: teapot.patch(13).controlPoints(),
    patches: [[...Array(16).keys()]],
  }).isocurves({ lines: 3 });
  curves.slice(0, 4).forEach((curve, k) =>
    assert.deepEqual(
      curve.controlPoints(),
      teapot
        .patch(13)
        .isocurveAtU(k / 3)
        .controlPoints(),
    ),
  );
  curves.slice(4).forEach((curve, k) =>
    assert.deepEqual(
      curve.controlPoints(),
      teapot
        .patch(13)
        .isocurveAtV(k / 3)
        .controlPoints(),
    ),
  );
});

/** How often each edge has a face, by its direction. */
function edges(mesh) {
  const counts = new Map();
  for (let i = 0; i < mesh.indices.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const edge = `${mesh.indices[i + k]} ${mesh.indices[i + ((k + 1) % 3)]}`;
      counts.set(edge, (counts.get(edge) ?? 0) + 1);
    }
  }
  return counts;
}

test("tubes are closed bodies", () => {
  const mesh = teapot.wireframe({ lines: 2, radius: 0.02, sides: 6 });
  assert.ok(mesh instanceof Mesh && mesh.indices instanceof Uint16Array);
  assert.deepEqual([mesh.uvs, mesh.patchIds, mesh.quads], [null, null, undefined]);
  const counts = edges(mesh);
  for (const [edge, count] of counts) {
    assert.equal(count, 1);
    assert.equal(counts.get(edge.split(" ").reverse().join(" ")), 1);
  }
  const curves = teapot.isocurves({ lines: 2 }).length;
  assert.equal(mesh.positions.length / 3 - counts.size / 2 + mesh.indices.length / 3, 2 * curves);
  assert.ok(teapot.wireframe({ lines: 12, radius: 0.002 }).indices instanceof Uint32Array);
});

test("a ribbon along a straight side is a rectangle", () => {
  const mesh = square.wireframe({ lines: 1, width: 0.5 });
  assert.equal(mesh.indices.length, 4 * 6);
  assert.deepEqual(
    [...mesh.positions.slice(0, 12)].map((x) => x + 0),
    [-0.25, 0, 1, 0.25, 0, 1, -0.25, 2, 1, 0.25, 2, 1],
  );
  for (let i = 0; i < mesh.normals.length; i += 3)
    assert.deepEqual(
      [...mesh.normals.slice(i, i + 3)].map((x) => x + 0),
      [0, 0, 1],
    );
  assert.deepEqual(mesh.patchRanges, [{ firstVertex: 0, vertices: 16, firstIndex: 0, indices: 24 }]);
});

test("wireframes into an earlier mesh, and of nothing", () => {
  const mesh = square.wireframe({ lines: 2, width: 0.5 });
  const { positions } = mesh;
  assert.equal(square.wireframe({ lines: 2, width: 0.25, into: mesh }), mesh);
  assert.equal(mesh.positions, positions);
  for (const surface of [empty, point]) {
    assert.equal(surface.wireframe({ radius: 0.1 }).positions.length, 0);
    assert.equal(surface.wireframe({ width: 0.1 }).indices.length, 0);
  }
  assert.equal(teapot.grid({ segments: 4, into: teapot.wireframe({ width: 0.01 }) }).uvs?.length, 2 * 32 * 25);
});

test("flat pieces cover the patches", () => {
  const pieces = teapot.subdivide(0.02);
  const areas = new Float64Array(32);
  for (const { patch, u0, u1, v0, v1, corners } of pieces) {
    areas[patch] += (u1 - u0) * (v1 - v0);
    assert.ok(corners instanceof Float64Array && corners.length === 12);
  }
  assert.ok(areas.every((area) => area === 1));
  const { patch, u0, u1, v0, v1, corners } = pieces[pieces.length >> 1];
  const expected = [
    [u0, v0],
    [u1, v0],
    [u1, v1],
    [u0, v1],
  ].flatMap(([u, v]) => Object.values(teapot.patch(patch).eval(u, v)));
  assert.ok(expected.every((x, k) => Math.abs(x - corners[k]) < 1e-14));
  assert.equal(square.subdivide(1e-9).length, 1);
  assert.deepEqual([...square.subdivide(1)[0].corners], [0, 0, 1, 3, 0, 1, 3, 2, 1, 0, 2, 1]);
  assert.deepEqual(empty.subdivide(1), []);
});

test("refused", () => {
  const wire = (options) => () => teapot.wireframe(options);
  for (const lines of [0, -1, 1.5, NaN]) {
    refused(() => teapot.isocurves({ lines }), RangeError, /^lines: expected a whole number from 1 .*got /);
    refused(wire({ lines, width: 1 }), RangeError, /^lines: expected a whole number from 1 .*got /);
  }
  refused(
    wire(undefined),
    TypeError,
    /^options: expected either radius \(tubes\) or width \(ribbons\), got none of them$/,
  );
  refused(wire({ radius: 1, width: 1 }), TypeError, /^options: expected either .*got both$/);
  refused(wire(5), TypeError, /^options: expected an object, got 5$/);
  for (const bad of [0, -1]) {
    refused(wire({ radius: bad }), RangeError, /^radius: expected a number above 0, got /);
    refused(wire({ width: bad }), RangeError, /^width: expected a number above 0, got /);
  }
  refused(wire({ radius: NaN }), RangeError, /^radius: expected a finite number, got NaN$/);
  refused(wire({ width: "1" }), TypeError, /^width: expected a number, got "1"$/);
  for (const sides of [2, 0, 3.5, Infinity])
    refused(wire({ radius: 1, sides }), RangeError, /^sides: expected a whole number from 3 .*got /);
  refused(
    wire({ radius: 1e-9 }),
    RangeError,
    /^radius: expected at least \S+ \(f32 shows nothing smaller here\), got 1e-9$/,
  );
  refused(wire({ width: 1e39 }), RangeError, /^vertices: expected coordinates that f32 can hold, got 1e\+39$/);
  refused(wire({ lines: 1e6, width: 0.1 }), RangeError, /^vertices: expected at most \d+, this needs \d+$/);
  refused(
    wire({ radius: 0.1, sides: 2 ** 32 - 1 }),
    RangeError,
    /^vertices: expected at most \d+, this needs 4294967295$/,
  );
  refused(wire({ radius: 0.1, into: {} }), TypeError, /^into: expected a Mesh, got /);
  for (const bad of [0, -1])
    refused(() => teapot.subdivide(bad), RangeError, /^tolerance: expected a number above 0, got /);
  refused(() => teapot.subdivide(untyped(undefined)), TypeError, /^tolerance: expected a number, got undefined$/);
  refused(() => teapot.subdivide(1e-20), RangeError, /^tolerance: expected at least \S+ .*got 1e-20$/);
  refused(() => teapot.subdivide(1e-9), RangeError, /^leaves: expected at most 264192, this needs 264193$/);
  assert.equal(teapot.patchCount, 32);
});

test("a grid after a wireframe has its own layout", () => {
  const grid = () => teapot.grid({ segments: 3 });
  const first = grid();
  teapot.wireframe({ width: 0.1 });
  assert.deepEqual(grid(), first);
});
