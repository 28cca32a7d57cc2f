// Patches, surfaces and meshes as JavaScript sees them: types of arrays, meshes that are filled again. Their numbers are those of Rust
// (parity.test.js).
import assert from "node:assert/strict";
import { test } from "node:test";
import { Mesh, Patch, Surface } from "casteljau";
import { recorder } from "./reference.js";

/** The plane z = 2 over [0, 3] × [0, 3]: control points on a lattice. */
const plane = new Patch(Array.from({ length: 16 }, (_, i) => [i % 4, Math.floor(i / 4), 2]));

test("the teapot has the counts of its listing", () => {
  const mesh = Surface.teapot().grid({ segments: 16, quads: true });
  const counts = [mesh.positions.length, mesh.indices.length, mesh.quads?.length];
  assert.deepEqual(counts, [3 * 9248, 3 * 32 * 2 * 16 * 16, 4 * 32 * 16 * 16]);
  assert.ok(mesh.indices instanceof Uint16Array);
  assert.ok(Surface.teapot().grid({ segments: 46 }).indices instanceof Uint32Array);
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
  for (const shape of [Surface.teapot(), plane]) {
    const size = shape === plane ? 3 : 3.525;
    const [exact, stepped] = ["bernstein", "forward-difference"].map((method) =>
      shape.grid({ segments: 20, method: /** @type {any} */ (method) }),
    );
    const apart = exact.positions.map((x, i) => Math.abs(x - stepped.positions[i]));
    assert.ok(Math.max(...apart) <= size * 2 ** -22);
    assert.deepEqual(stepped.indices, exact.indices);
    assert.deepEqual(exact, shape.grid({ segments: 20 }));
  }
});

test("deCasteljau of a patch: rows, then a curve, then the point", () => {
  const { rows, column, point } = plane.deCasteljau(0.25, 0.75);
  const counts = [...rows, column].map((levels) => levels.map((level) => level.length / 3));
  assert.deepEqual(counts, new Array(5).fill([4, 3, 2, 1]));
  assert.deepEqual(point, plane.eval(0.25, 0.75));
});

test("queries of nothing", () => {
  const empty = new Surface({ vertices: [], patches: [] });
  assert.deepEqual([empty.area(), empty.volume(), empty.bounds(), empty.nearest([0, 0, 0])], [0, null, null, null]);
  assert.deepEqual(empty.intersectRay([0, 0, 0], [0, 0, 1]), []);
  assert.equal(Surface.teapot().volume(), null); // open
});

test("nets as rows of points", () => {
  const flat = Array.from({ length: 6 }, (_, k) => [k % 3, k, k * k]);
  const rows = [flat.slice(0, 3), flat.slice(3)];
  const degrees = { degreeU: 2, degreeV: 1 };
  assert.ok(new Patch(rows, degrees).equals(new Patch(flat, degrees)));
  const objects = rows.map((row) => row.map(([x, y, z]) => ({ x, y, z })));
  assert.ok(new Patch(objects, degrees).equals(new Patch(flat, degrees)));
  assert.ok(new Patch(rows).equals(new Patch(flat, degrees)));
  assert.deepEqual([new Patch(objects).degreeU, new Patch(objects).degreeV], [2, 1]);
});

test("one call draws the whole network", () => {
  const target = recorder();
  const square = new Surface({ vertices: plane.controlPoints(), patches: [[...Array(16).keys()]] });
  square.trace(target, { matrix: [10, 0, 0, 10, 100, 0], lines: 1 });
  assert.deepEqual([target.calls[0], target.calls.length], [["moveTo", 100, 0], 8]);
});
