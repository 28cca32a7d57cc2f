// Isocurves, wireframes and flat pieces.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Mesh, Surface } from "casteljau";
import { near, pointsOf } from "./reference.js";

const teapot = Surface.teapot();
const empty = new Surface({ vertices: [], patches: [] });
const point = new Surface({ vertices: [[1, 2, 3]], patches: [new Array(16).fill(0)] });
const corners = { vertices: pointsOf("0,0,1 3,0,1 0,2,1 3,2,1"), patches: [[0, 1, 2, 3]] };
const square = new Surface(corners, { degreeU: 1, degreeV: 1 });

test("isocurves are curves in space, by default of 4 lines", () => {
  const curves = teapot.isocurves();
  assert.ok(curves.every((curve) => curve instanceof Curve && curve.degree === 3 && curve.dimension === 3));
  assert.deepEqual(curves.length, teapot.isocurves({ lines: 4 }).length);
  assert.deepEqual(empty.isocurves(), []);
});

test("tubes are triangles, ribbons along straight sides rectangles", () => {
  const tubes = teapot.wireframe({ lines: 2, radius: 0.02, sides: 6 });
  assert.ok(tubes instanceof Mesh && tubes.indices instanceof Uint16Array);
  assert.deepEqual([tubes.uvs, tubes.patchIds, tubes.quads], [null, null, undefined]);
  // Closed bodies: V − E + F is 2 for each, and 2E = 3F.
  const [vertices, faces] = [tubes.positions.length / 3, tubes.indices.length / 3];
  assert.equal(vertices - faces / 2, 2 * teapot.isocurves({ lines: 2 }).length);
  assert.ok(teapot.wireframe({ lines: 12, radius: 0.002 }).indices instanceof Uint32Array);
  const ribbons = square.wireframe({ lines: 1, width: 0.5 });
  assert.equal(ribbons.indices.length, 4 * 6);
  near(ribbons.positions.slice(0, 12), [-0.25, 0, 1, 0.25, 0, 1, -0.25, 2, 1, 0.25, 2, 1]);
  near(ribbons.normals, new Array(16).fill([0, 0, 1]).flat());
  assert.deepEqual(ribbons.patchRanges, [{ firstVertex: 0, vertices: 16, firstIndex: 0, indices: 24 }]);
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
  const at = (u, v) => Object.values(teapot.patch(patch).eval(u, v));
  near(corners, [at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)].flat(), 1e-14);
  assert.equal(square.subdivide(1e-9).length, 1);
  assert.deepEqual([...square.subdivide(1)[0].corners], [0, 0, 1, 3, 0, 1, 3, 2, 1, 0, 2, 1]);
  assert.deepEqual(empty.subdivide(1), []);
});

test("a grid after a wireframe has its own layout", () => {
  const grid = () => teapot.grid({ segments: 3 });
  const first = grid();
  teapot.wireframe({ width: 0.1 });
  assert.deepEqual(grid(), first);
});
