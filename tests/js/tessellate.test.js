// Meshes without cracks and topology through the package's door: options, shapes, reuse, refusals. Figures as in
// tests/watertight, of the teapot's listing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Mesh, Patch, Surface } from "casteljau";

const teapot = Surface.teapot();
/** @type {any} any arguments, also wrong ones */
const tessellate = (/** @type {any} */ options) => teapot.tessellate(options);
const square = new Patch(
  [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [1, 1, 1],
  ],
  { degreeU: 1, degreeV: 1 },
);

/** Edges of one triangle only, places compared by their numbers. */
function boundary({ positions, indices }) {
  const edges = new Map();
  const place = (i) => positions.subarray(3 * i, 3 * i + 3).join();
  for (let k = 0; k < indices.length; k += 3) {
    const corners = [0, 1, 2].map((i) => place(indices[k + i]));
    for (let i = 0; i < 3; i++) {
      const key = [corners[i], corners[(i + 1) % 3]].sort().join("|");
      edges.set(key, (edges.get(key) ?? 0) + 1);
    }
  }
  const counts = [...edges.values()];
  assert.ok(counts.every((count) => count <= 2));
  return counts.filter((count) => count === 1).length;
}

test("counts of even segments", () => {
  const welded = tessellate({ segments: 16, weld: "position" });
  assert.ok(welded instanceof Mesh);
  assert.equal(welded.positions.length, 3 * 8257);
  assert.equal(welded.normals.length, 3 * 8257);
  assert.equal(welded.indices.length, 3 * 16256);
  assert.equal(boundary(welded), 256);
  assert.equal(tessellate({ segments: 16, weld: "none" }).positions.length, 3 * 9248);
  assert.ok(tessellate({ segments: 45, weld: "position" }).indices instanceof Uint16Array);
  assert.ok(tessellate({ segments: 46, weld: "position" }).indices instanceof Uint32Array);
  const { u, v } = { u: 5, v: 2 };
  // Sides that meet with 5 and with 2 segments have the samples of both: more vertices than 32·6·3, and no crack.
  const mixed = tessellate({ segments: { u, v }, weld: "none" });
  assert.ok(mixed.positions.length / 3 >= 32 * (u + 1) * (v + 1));
  assert.deepEqual([...new Set(mixed.patchIds)], [...Array(32).keys()]);
});

test("uvs and patch numbers belong to patches of their own", () => {
  for (const weld of ["position", "normal", undefined]) {
    const mesh = tessellate({ tolerance: 0.02, weld });
    assert.equal(mesh.uvs, null);
    assert.equal(mesh.patchIds, null);
    assert.equal(mesh.patchRanges.length, 32);
    assert.ok(mesh.patchRanges.every(({ vertices }) => vertices === 0));
    const ends = mesh.patchRanges.map(({ firstIndex, indices }) => firstIndex + indices);
    assert.equal(ends[31], mesh.indices.length);
  }
  const mesh = tessellate({ tolerance: 0.02, weld: "none" });
  const count = mesh.positions.length / 3;
  assert.equal(mesh.uvs?.length, 2 * count);
  assert.equal(mesh.patchIds?.length, count);
  for (let i = 0; i < count; i += 7) {
    const p = teapot.patch(mesh.patchIds[i]).eval(mesh.uvs[2 * i], mesh.uvs[2 * i + 1]);
    const apart = Math.hypot(
      p.x - mesh.positions[3 * i],
      p.y - mesh.positions[3 * i + 1],
      /** @type {number} */ (p.z) - mesh.positions[3 * i + 2],
    );
    assert.ok(apart < 4e-7, `vertex ${i} is ${apart} from its patch`);
  }
});

test("positions are the same however vertices are shared", () => {
  const [own, normal, position] = ["none", "normal", "position"].map((weld) => tessellate({ tolerance: 0.01, weld }));
  const corners = ({ positions, indices }) => [...indices].flatMap((i) => [...positions.subarray(3 * i, 3 * i + 3)]);
  assert.deepEqual(corners(normal), corners(own));
  assert.deepEqual(corners(position), corners(own));
  assert.ok(position.positions.length < own.positions.length && normal.positions.length < own.positions.length);
});

test("f64 on demand", () => {
  const precise = tessellate({ segments: 8, weld: "position", precision: "f64" });
  const plain = tessellate({ segments: 8, weld: "position" });
  assert.ok(precise.positions instanceof Float64Array && precise.normals instanceof Float64Array);
  assert.ok(plain.positions instanceof Float32Array && plain.normals instanceof Float32Array);
  assert.deepEqual(new Float32Array(precise.positions), plain.positions);
  assert.deepEqual(precise.indices, plain.indices);
  assert.ok(precise.positions.some((x, i) => x !== plain.positions[i]));
  const least = 2 ** -21;
  assert.throws(() => square.tessellate({ tolerance: least * 0.9 }), RangeError);
  assert.ok(square.tessellate({ tolerance: least * 0.9, precision: "f64" }).indices.length > 0);
});

test("a patch alone", () => {
  const mesh = square.tessellate({ tolerance: 0.01 });
  // A bilinear patch bends by its twist 1 only: h · k · 2 / 8 within 0.01, so 25 cells at least.
  assert.ok(mesh.indices.length / 3 >= 2 * 25);
  assert.equal(square.tessellate({ segments: 3, weld: "none" }).uvs?.length, 2 * 16);
});

test("by pixels: what is nearer is finer", () => {
  const looking = (/** @type {number} */ distance) => {
    // From (0, −distance, 1.5) along +y: X = x, Y = z − 1.5, W = y + distance.
    const viewProjection = [1, 0, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0, 0, -1.5, 0, distance];
    return tessellate({ pixels: 1, viewProjection, viewport: [800, 800] }).indices.length;
  };
  assert.ok(looking(5) > 1.5 * looking(20));
  assert.ok(looking(20) > 1.5 * looking(200));
});

test("an earlier mesh is filled again", () => {
  const mesh = tessellate({ tolerance: 0.005, weld: "none" });
  const { positions, normals, uvs, patchIds, indices } = mesh;
  assert.equal(tessellate({ tolerance: 0.005, weld: "none", into: mesh }), mesh);
  assert.ok(mesh.positions === positions && mesh.normals === normals && mesh.uvs === uvs);
  assert.ok(mesh.patchIds === patchIds && mesh.indices === indices);
  // Fewer numbers: the same memory.
  tessellate({ tolerance: 0.05, weld: "none", into: mesh });
  assert.deepEqual({ ...mesh }, { ...tessellate({ tolerance: 0.05, weld: "none" }) });
  assert.ok(mesh.positions.buffer === positions.buffer && mesh.indices.buffer === indices.buffer);
});

test("an earlier mesh of any kind will do", () => {
  const kinds = [
    [{ segments: 3 }, { weld: "none" }],
    [{ segments: 9 }, { precision: "f64" }],
    [{ tolerance: 0.1 }, { weld: "position" }],
    [{ segments: 46 }, { weld: "none" }],
    [{ segments: 2 }, { weld: "none", precision: "f64" }],
    [{ tolerance: 0.01 }, undefined],
    [{ segments: 1 }, { weld: "normal" }],
    [{ segments: 5 }, { weld: "none" }],
  ];
  const mesh = teapot.grid({ segments: 4, quads: true });
  for (const [fineness, options] of kinds) {
    const other = tessellate({ ...fineness, ...options, into: mesh });
    assert.equal(other, mesh);
    assert.deepEqual({ ...mesh }, { ...tessellate({ ...fineness, ...options }) });
  }
  const empty = new Surface({ vertices: [], patches: [] }).tessellate({ segments: 2, into: mesh });
  assert.equal(empty.positions.length + empty.indices.length + empty.patchRanges.length, 0);
  const again = teapot.grid({ segments: 4, quads: true, into: mesh });
  assert.deepEqual({ ...again }, { ...teapot.grid({ segments: 4, quads: true }) });
});

test("two meshes do not share memory", () => {
  const one = tessellate({ segments: 2 });
  const copy = one.positions.slice();
  tessellate({ segments: 3 });
  assert.deepEqual(one.positions, copy);
});

test("topology of the teapot", () => {
  const { shared, nonManifold, open, collapsed, components } = teapot.topology();
  assert.deepEqual([shared.length, nonManifold.length, open.length, collapsed.length], [52, 0, 16, 8]);
  assert.deepEqual(
    components.map((patches) => patches.length),
    [16, 4, 4, 8],
  );
  const sides = [...shared.flat(), ...open, ...collapsed].map(({ patch, edge }) => `${patch} ${edge}`);
  assert.equal(new Set(sides).size, 128);
  assert.ok(shared.every((pair) => pair.length === 2 && pair[0].reversed === false));
  assert.ok(
    shared
      .flat()
      .every(({ edge, reversed }) => ["u0", "u1", "v0", "v1"].includes(edge) && typeof reversed === "boolean"),
  );
});

test("three patches on one side, one of them backwards", () => {
  const vertices = [
    [0, 0, 0],
    [0, 1, 0],
    [1, 0, 0],
    [1, 1, 0],
    [-1, 0, 1],
    [-1, 1, 1],
    [0, 0, 2],
    [0, 1, 2],
  ];
  const fins = new Surface(
    {
      vertices,
      patches: [
        [0, 1, 2, 3],
        [0, 1, 4, 5],
        [1, 0, 7, 6],
      ],
    },
    { degreeU: 1, degreeV: 1 },
  );
  const { shared, nonManifold, open, components } = fins.topology();
  assert.deepEqual(nonManifold, [
    [
      { patch: 0, edge: "v0", reversed: false },
      { patch: 1, edge: "v0", reversed: false },
      { patch: 2, edge: "v0", reversed: true },
    ],
  ]);
  assert.deepEqual([shared.length, open.length, components], [0, 9, [[0, 1, 2]]]);
  assert.equal(fins.tessellate({ segments: 4, weld: "position" }).positions.length / 3, 5 + 3 * 20);
});

test("what was joined stays joined, and nothing else becomes so", () => {
  const before = teapot.topology();
  const { vertices } = teapot;
  const point = (/** @type {number} */ k) => [...vertices.subarray(3 * k, 3 * k + 3)];
  for (const [index, to] of [
    [0, [9, 9, 9]],
    [5, point(6)],
    [100, point(0)],
  ]) {
    const moved = teapot.movePoint(/** @type {number} */ (index), /** @type {any} */ (to));
    assert.deepEqual(moved.topology(), before);
    const back = moved.movePoint(/** @type {number} */ (index), point(/** @type {number} */ (index)));
    assert.deepEqual(back.topology(), before);
    assert.deepEqual(back.tessellate({ segments: 2 }), teapot.tessellate({ segments: 2 }));
    assert.deepEqual(moved.transform([1, 0, 0, 1, 5, 0]).topology(), before);
  }
  assert.equal(boundary(teapot.movePoint(5, point(6)).tessellate({ segments: 4, weld: "position" })), 64);
});

const view = { pixels: 1, viewProjection: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], viewport: [640, 480] };

const refusals = /** @type {[string, any, any, RegExp][]} */ ([
  ["nothing", undefined, TypeError, /options: expected .*segments.*tolerance.*pixels/],
  ["null", null, TypeError, /options: expected /],
  ["a number", 8, TypeError, /options: expected an object, got 8/],
  ["no detail", {}, TypeError, /options: expected .*segments.*tolerance.*pixels/],
  ["0 segments", { segments: 0 }, RangeError, /segments: expected a whole number from 1.*got 0/],
  ["half a segment", { segments: 2.5 }, RangeError, /segments.*got 2.5/],
  ["segments in words", { segments: "4" }, TypeError, /segments.*"?4"?/],
  ["segments along u only", { segments: { u: 3 } }, TypeError, /segments\.v.*undefined/],
  ["a million segments", { segments: 1e6 }, RangeError, /segments: expected at most \d+, this needs 1000000/],
  ["tolerance 0", { tolerance: 0 }, RangeError, /tolerance.*got 0/],
  ["a negative tolerance", { tolerance: -1 }, RangeError, /tolerance.*got -1/],
  ["tolerance NaN", { tolerance: NaN }, RangeError, /tolerance.*got NaN/],
  ["an infinite tolerance", { tolerance: Infinity }, RangeError, /tolerance.*got Infinity/],
  ["a tolerance in words", { tolerance: "0.1" }, TypeError, /tolerance.*0\.1/],
  ["a tolerance below f32", { tolerance: 1e-7 }, RangeError, /tolerance: expected at least 0\.0000016\d+ .*got 1e-7/],
  [
    "a tolerance below f64",
    { tolerance: 1e-16, precision: "f64" },
    RangeError,
    /tolerance: expected at least 3\.1\d+e-15 .*got 1e-16/,
  ],
  [
    "too many triangles",
    { tolerance: 1e-12, precision: "f64" },
    RangeError,
    /triangles: expected at most \d+, this needs \d+/,
  ],
  ["0 pixels", { ...view, pixels: 0 }, RangeError, /pixels.*got 0/],
  ["no matrix", { ...view, viewProjection: undefined }, TypeError, /viewProjection/],
  [
    "a matrix in the plane",
    { ...view, viewProjection: [1, 0, 0, 1, 0, 0] },
    RangeError,
    /viewProjection: expected 16 numbers, got 6/,
  ],
  [
    "a matrix with NaN",
    { ...view, viewProjection: view.viewProjection.with(6, NaN) },
    RangeError,
    /viewProjection.*6.*NaN/,
  ],
  ["no viewport", { ...view, viewport: undefined }, TypeError, /viewport.*undefined/],
  ["a viewport of one number", { ...view, viewport: [640] }, RangeError, /viewport: expected 2 numbers, got 1/],
  ["an empty viewport", { ...view, viewport: [640, 0] }, RangeError, /viewport\[1\].*got 0/],
  ["another weld", { segments: 2, weld: "all" }, RangeError, /weld.*"position".*"normal".*"none".*all/],
  ["another precision", { segments: 2, precision: "f16" }, RangeError, /precision.*f32.*f64.*f16/],
  ["into an array", { segments: 2, into: new Float32Array(9) }, TypeError, /into: expected .*Mesh/],
  ["into an object", { segments: 2, into: {} }, TypeError, /into: expected .*Mesh/],
]);

for (const [name, options, type, message] of refusals) {
  test(`refused: ${name}`, () => {
    for (const act of [() => tessellate(options), () => teapot.patch(0).tessellate(options)]) {
      assert.throws(act, (/** @type {Error} */ error) => {
        assert.ok(error instanceof type, `${error.constructor.name}: ${error.message}`);
        assert.match(error.message, message);
        return true;
      });
      if (name.includes("f32") || name.includes("f64") || name.includes("triangles")) break;
    }
    assert.equal(tessellate({ segments: 1, weld: "position" }).positions.length, 3 * 37);
  });
}

test("nothing gives an empty mesh", () => {
  const point = new Surface({ vertices: [[1, 2, 3]], patches: [new Array(16).fill(0)] });
  for (const surface of [new Surface({ vertices: [], patches: [] }), point]) {
    for (const weld of ["position", "normal", "none"]) {
      const mesh = surface.tessellate({ tolerance: 0.1, weld: /** @type {any} */ (weld) });
      assert.equal(mesh.positions.length + mesh.normals.length + mesh.indices.length, 0);
      assert.equal(mesh.uvs?.length ?? 0, 0);
    }
  }
  assert.deepEqual(point.topology().components, [[0]]);
  assert.equal(point.topology().collapsed.length, 4);
});
