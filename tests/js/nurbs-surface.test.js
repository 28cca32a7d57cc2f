// Rational patches and NURBS surfaces as JavaScript sees them: closed forms, knots, forms of arguments, JSON, meshes.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import * as complete from "casteljau";
import {
  Curve,
  Mesh,
  NurbsCurve,
  NurbsSurface,
  RationalCurve,
  RationalPatch,
  RationalSurface,
  Spline,
} from "casteljau/nurbs";
import { near, owned, recorder, refusedAll, untyped } from "./reference.js";

const HALF = Math.SQRT1_2;
const ROWS = [
  [
    [1, 0, 0],
    [1, 1, 0],
    [0, 1, 0],
  ],
  [
    [1, 0, 2],
    [1, 1, 2],
    [0, 1, 2],
  ],
];
const WEIGHTS = [1, HALF, 1, 1, HALF, 1];
const quarter = new RationalPatch(ROWS, WEIGHTS);
const sphere = NurbsSurface.sphere([0, 0, 0], 2);
const torus = NurbsSurface.torus([0, 0, 0], 3, 1);
const cylinder = NurbsSurface.cylinder([1, 2, 3], 2, 5, { axis: [1, 0, 0] });
const cone = NurbsSurface.cone([0, 0, 0], 1, 2);
const plane = NurbsSurface.plane([1, 1, 1], [2, 0, 0], [0, 3, 0]);
const SHAPES = { sphere, torus, cylinder, cone, plane };
const PLACES = Array.from({ length: 49 }, (_, k) => [(k % 7) / 6, Math.floor(k / 7) / 6]);
const length = ({ x, y, z }) => Math.hypot(x, y, z);
const NOWHERE = { x: NaN, y: NaN, z: NaN };
const numbers = ({ x, y, z }) => [x, y, z];

test("rational patches: a quarter of a cylinder", () => {
  assert.deepEqual([quarter.degreeU, quarter.degreeV, ...quarter.weights()], [2, 1, ...WEIGHTS]);
  assert.deepEqual([...quarter.controlPoints()], ROWS.flat(2));
  for (const [u, v] of PLACES) {
    const p = quarter.eval(u, v);
    near([Math.hypot(p.x, p.y), p.z], [1, 2 * v], 1e-15);
    near(quarter.normal(u, v), { x: p.x, y: p.y, z: 0 }, 1e-15);
    const { gaussian, mean, k1, k2 } = quarter.curvature(u, v);
    near([gaussian, mean, k1, k2], [0, -0.5, 0, -1], 1e-13);
    near(quarter.partials(u, v).v, { x: 0, y: 0, z: 2 }, 1e-15);
  }
  assert.deepEqual(quarter.eval(1, 1), { x: 0, y: 1, z: 2 });
  const arc = quarter.isocurveAtV(0.5);
  assert.ok(arc instanceof RationalCurve && arc.degree === 2);
  near(arc.length(), Math.PI / 2, 1e-14);
  assert.deepEqual(quarter.isocurveAtU(0).eval(0.5), { x: 1, y: 0, z: 1 });
  assert.deepEqual(quarter.bounds(), { min: { x: 0, y: 0, z: 0 }, max: { x: 1, y: 1, z: 2 } });
});

test("rational patches: parts, degrees and maps", () => {
  for (const { parts, at } of [
    { parts: quarter.splitU(0.3), at: [0.15, 0.5] },
    { parts: quarter.splitV(0.3), at: [0.5, 0.15] },
  ]) {
    near(numbers(parts[0].eval(0.5, 0.5)), numbers(quarter.eval(at[0], at[1])), 1e-15);
    assert.ok(parts[1] instanceof RationalPatch);
  }
  const high = quarter.elevate();
  assert.deepEqual([high.degreeU, high.degreeV], [3, 2]);
  near(numbers(high.eval(0.3, 0.6)), numbers(quarter.eval(0.3, 0.6)), 1e-15);
  near(numbers(quarter.transform("translate(1 2)").eval(0, 0)), [2, 2, 0]);
  // A projective map with the weight 2 + x.
  const image = quarter.transform([1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2]);
  const p = quarter.eval(0.3, 0.6);
  near(
    numbers(image.eval(0.3, 0.6)),
    numbers(p).map((x) => x / (2 + p.x)),
    1e-15,
  );
  const plain = new complete.Patch(ROWS, { degreeU: 2, degreeV: 1 });
  assert.deepEqual([...RationalPatch.from(plain).weights()], [1, 1, 1, 1, 1, 1]);
  assert.ok(RationalPatch.from(quarter).equals(quarter) && !quarter.equals(RationalPatch.from(plain)));
  assert.ok(
    quarter.equals(
      new RationalPatch(
        ROWS.flat(2),
        WEIGHTS.map((w) => 4 * w),
        { degreeU: 2, degreeV: 1 },
      ),
    ),
  );
});

test("NURBS surfaces: points, normals and curvatures of shapes", () => {
  for (const [u, v] of PLACES) {
    const p = sphere.eval(u, v);
    near(length(p), 2, 1e-15);
    near(
      numbers(sphere.normal(u, v)),
      numbers(p).map((x) => x / 2),
      1e-14,
    );
    near([sphere.curvature(u, v).gaussian, sphere.curvature(u, v).mean], [0.25, -0.5], 1e-11);
    const q = torus.eval(u, v);
    near(Math.hypot(Math.hypot(q.x, q.y) - 3, q.z), 1, 1e-14);
    const r = cylinder.eval(u, v);
    near([Math.hypot(r.y - 2, r.z - 3), r.x - 1], [2, 5 * v], 1e-14);
    const s = cone.eval(u, v);
    near([Math.hypot(s.x, s.y), s.z], [1 - v, 2 * v], 1e-14);
    near(plane.eval(u, v), { x: 1 + 2 * u, y: 1 + 3 * v, z: 1 }, 1e-15);
  }
  assert.deepEqual([sphere.normal(0.3, 1), sphere.normal(0.3, 0).z], [{ x: 0, y: 0, z: 1 }, -1]);
  assert.deepEqual(sphere.domain, { u: [0, 1], v: [0, 1] });
  assert.deepEqual(
    [sphere, torus, plane].map((each) => each.patches().length),
    [8, 16, 1],
  );
  near(Object.values(sphere.bounds()).flatMap(numbers), [-2, -2, -2, 2, 2, 2], 1e-14);
});

test("NURBS surfaces: derivatives are by u and v", () => {
  const h = 1e-6;
  const [u, v] = [0.3, 0.4];
  const { u: du, v: dv } = torus.partials(u, v);
  const by = (a, b) => numbers(a).map((x, k) => (x - numbers(b)[k]) / (2 * h));
  near(numbers(du), by(torus.eval(u + h, v), torus.eval(u - h, v)), 1e-7);
  near(numbers(dv), by(torus.eval(u, v + h), torus.eval(u, v - h)), 1e-7);
});

test("NURBS surfaces: knots, degrees, parts and isocurves", () => {
  const finer = torus.insertKnotU(0.3).insertKnotV(0.6, 2);
  const higher = torus.elevateU().elevateV(2);
  assert.deepEqual([higher.degreeU, higher.degreeV, finer.patches().length], [3, 4, 25]);
  for (const [u, v] of PLACES) for (const each of [finer, higher]) near(each.eval(u, v), torus.eval(u, v), 1e-13);
  const [left, right] = torus.splitU(0.3);
  assert.deepEqual(
    [left.domain.u, right.domain.u],
    [
      [0, 0.3],
      [0.3, 1],
    ],
  );
  near(left.eval(0.2, 0.7), torus.eval(0.2, 0.7), 1e-14);
  const [, upper] = torus.splitV(0.3);
  near(upper.eval(0.2, 0.7), torus.eval(0.2, 0.7), 1e-14);
  const tube = torus.isocurveAtU(0.3);
  assert.ok(tube instanceof NurbsCurve && tube.dimension === 3);
  near([tube.length(), torus.isocurveAtV(0).length()], [2 * Math.PI, 8 * Math.PI], 1e-13);
  near(numbers(torus.reverse().eval(0.3, 0.4)), numbers(torus.eval(0.7, 0.4)), 1e-14);
  near(
    numbers(torus.reverse().normal(0.3, 0.4)),
    numbers(torus.normal(0.7, 0.4)).map((x) => -x),
    1e-14,
  );
  near(numbers(torus.transform("scale(2)").eval(0, 0)), [8, 0, 0]);
});

test("NURBS surfaces: ruled, extruded, revolved and lofted", () => {
  const arc = NurbsCurve.arc([0, 0, 0], 1, 0, Math.PI / 2);
  const wall = NurbsSurface.extrude(arc, [0, 0, 2]);
  near(numbers(wall.eval(0.3, 0.5)), [...numbers(arc.eval(0.3)).slice(0, 2), 1], 1e-15);
  const line = new Curve([0, 0, 5, 1, 0, 5], { dimension: 3 });
  near(numbers(NurbsSurface.ruled(arc, line).eval(0.3, 1)), [0.3, 0, 5], 1e-15);
  // A profile of the plane turns around the y-axis.
  const half = NurbsCurve.arc([0, 0], 1, -Math.PI / 2, Math.PI / 2);
  const ball = NurbsSurface.revolve(half, { axis: [0, 1, 0] });
  for (const [u, v] of PLACES) near(length(ball.eval(u, v)), 1, 1e-15);
  const [from, to] = half.domain;
  assert.deepEqual(ball.domain.v, [from, to]);
  const side = new Spline([1, 0, 2, 1, 2, 2, 1, 3], { degree: 3 });
  const vase = NurbsSurface.revolve(side, { axis: [0, 1, 0], angle: -Math.PI / 2 });
  near(
    numbers(vase.eval(1, 0.5)),
    numbers(vase.eval(0, 0.5)).map((_, k, p) => [p[2], p[1], p[0]][k]),
    1e-14,
  );
  const circles = [0, 1, 2].map((z) => NurbsCurve.arc([0, 0, z], 1 + z, 0, 2 * Math.PI));
  const horn = NurbsSurface.loft(circles);
  assert.equal(horn.degreeV, 2);
  for (const v of [0, 1]) near(Math.hypot(...numbers(horn.eval(0.3, v)).slice(0, 2)), 1 + 2 * v, 1e-14);
  assert.equal(NurbsSurface.loft(circles, { degree: 1 }).degreeV, 1);
});

test("NURBS surfaces: the constructor, JSON and equality", () => {
  const { degreeU, degreeV, points, weights, knotsU, knotsV } = sphere.toJSON();
  const rows = Array.from({ length: 5 }, (_, j) => points.slice(9 * j, 9 * j + 9));
  const again = new NurbsSurface({ degreeU, degreeV, points: rows, weights, knotsU, knotsV });
  assert.ok(again.equals(sphere) && !again.equals(torus) && again.equals(NurbsSurface.sphere([0, 0, 1e-9], 2), 2e-9));
  for (const each of Object.values(SHAPES)) {
    assert.ok(NurbsSurface.fromJSON(JSON.parse(JSON.stringify(each))).equals(each));
    const surface = each.toSurface();
    const read = RationalSurface.fromJSON(JSON.parse(JSON.stringify(surface)));
    assert.deepEqual(read.toJSON(), surface.toJSON());
  }
  assert.ok(RationalPatch.fromJSON(JSON.parse(JSON.stringify(quarter))).equals(quarter));
  const plain = new NurbsSurface({
    degreeU: 1,
    degreeV: 1,
    points: [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0],
    knotsU: [0, 0, 1, 1],
    knotsV: [0, 0, 2, 2],
  });
  assert.deepEqual([...plain.weights(), ...plain.jointsU(), ...plain.jointsV()], [1, 1, 1, 1, 0, 1, 0, 2]);
  owned(sphere.controlPoints());
  owned(sphere.weights());
  owned(sphere.knotsU());
});

test("NURBS surfaces: what is refused", () => {
  const points = ROWS.flat();
  const good = { degreeU: 2, degreeV: 1, points, knotsU: [0, 0, 0, 1, 1, 1], knotsV: [0, 0, 1, 1] };
  refusedAll(RangeError, [
    [
      () => new NurbsSurface({ ...good, knotsU: [0, 0, 1, 1] }),
      /^knotsU: expected at least .* = 6 knots \(rhino3dm.*got 4$/,
    ],
    [() => new NurbsSurface({ ...good, points: points.slice(1) }), /^points: expected 3 × 2 control points .*got 5$/],
    [
      () => new NurbsSurface({ ...good, points: ROWS.slice(1) }),
      /^points: expected 3 × 2 control points .*got 1 rows$/,
    ],
    [() => new NurbsSurface({ ...good, knotsU: [0, 0, 0, 1, 1, 0] }), /^knotsU\[5\]: expected /],
    [() => new NurbsSurface({ ...good, weights: [1, 1, 1, 1, 1, 0] }), /^weights\[5\]: expected a number above 0/],
    [() => new NurbsSurface({ ...good, weights: [1] }), /^weights: expected 6 numbers/],
    [() => NurbsSurface.sphere([0, 0, 0], -1), /^radius: expected a number from 0, got -1$/],
    [() => NurbsSurface.sphere([0, 0, 0], 1, { axis: [0, 0, 0] }), /^axis: expected a vector that is not 0/],
    [() => NurbsSurface.torus([0, 0, 0], 1, 1), /^majorRadius: expected a number above the minor radius, got 1$/],
    [() => sphere.elevateU(63), /^times: expected a whole number from 0 to 62, got 63$/],
    [() => sphere.splitU(1), /^u: expected a number inside of the domain, 0 to 1, got 1$/],
    [() => sphere.insertKnotV(2), /^v: expected .*got 2$/],
    [() => sphere.isocurveAtU(-1), /^u: expected .*got -1$/],
    [
      () => new NurbsSurface({ ...good, weights: [1, 3, 1, 1, 3, 1], knotsU: [0, 0, 0, 2, 2, 2] }).eval(18, 0),
      /^u, v: expected parameters at which the denominator is above 0, got 18, 0$/,
    ],
    [
      () => new RationalPatch(ROWS, [1, 3, 1, 1, 3, 1]).eval(9, 0),
      /^u, v: expected parameters at which the denominator is above 0, got 9, 0$/,
    ],
    [
      () => NurbsSurface.loft([NurbsCurve.circle([0, 0], 1)]),
      /^curves: expected at least 2 curves \(degree 1\), got 1$/,
    ],
    [() => NurbsSurface.revolve(new Curve([-1, 0, 1, 1]), { axis: [0, 1, 0] }), /meets the axis: expected an end/],
  ]);
  refusedAll(TypeError, [
    [() => sphere.equals(untyped(torus.patches()[0])), /^other: expected a NurbsSurface, got a RationalPatch$/],
    [
      () => NurbsSurface.extrude(untyped(7), [0, 0, 1]),
      /^curve: expected a Curve, a RationalCurve, a NurbsCurve or a Spline, got 7$/,
    ],
    [() => NurbsSurface.loft(untyped(7)), /^curves: expected an array, got 7$/],
  ]);
});

/** How often each edge of a mesh is passed in either direction. */
function edgesOf({ indices }) {
  const edges = new Map();
  for (let k = 0; k < indices.length; k += 3) {
    for (let i = 0; i < 3; i++) {
      const [a, b] = [indices[k + i], indices[k + ((i + 1) % 3)]];
      edges.set(`${a} ${b}`, (edges.get(`${a} ${b}`) ?? 0) + 1);
    }
  }
  return edges;
}

test("surfaces with weights: meshes by tolerance are closed and near", () => {
  const far = {
    sphere: (/** @type {number[]} */ [x, y, z]) => Math.abs(Math.hypot(x, y, z) - 2),
    torus: (/** @type {number[]} */ [x, y, z]) => Math.abs(Math.hypot(Math.hypot(x, y) - 3, z) - 1),
  };
  for (const [name, distance] of Object.entries(far)) {
    const surface = SHAPES[name].toSurface();
    assert.ok(surface instanceof RationalSurface);
    assert.deepEqual([surface.topology().open, surface.topology().components.length], [[], 1]);
    for (const tolerance of [0.1, 0.01, 0.001]) {
      const mesh = surface.tessellate({ tolerance, weld: "position", precision: "f64" });
      assert.ok(mesh instanceof Mesh);
      const edges = edgesOf(mesh);
      for (const [edge, count] of edges) {
        assert.equal(count, 1);
        assert.ok(edges.has(edge.split(" ").reverse().join(" ")), `${name}: an edge without a neighbour`);
      }
      const { positions, indices } = mesh;
      const at = (k) => [...positions.subarray(3 * k, 3 * k + 3)];
      for (let k = 0; k < indices.length; k += 3) {
        const corners = [0, 1, 2].map((i) => at(indices[k + i]));
        const middle = [0, 1, 2].map((axis) => (corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3);
        assert.ok(distance(middle) <= tolerance, `${name}, ${tolerance}`);
        assert.ok(corners.every((p) => distance(p) < 1e-14));
      }
    }
  }
});

test("surfaces with weights: solids of revolution", () => {
  const side = new Curve([2, 0, 1, 3], { dimension: 2 });
  const options = { origin: [0, 0, 0], axis: [0, 1, 0] };
  const moment = (4 + 2 + 1) / 2; // ½ ∫ r² dz
  for (const angle of [2 * Math.PI, 1, -4]) {
    const frustum = RationalSurface.solidOfRevolution(side, { ...options, angle });
    assert.ok(frustum instanceof RationalSurface);
    assert.deepEqual([frustum.topology().open, frustum.topology().nonManifold], [[], []]);
    near(frustum.volume(), moment * Math.abs(angle), 1e-9);
    const edges = edgesOf(frustum.tessellate({ tolerance: 0.01, weld: "position", precision: "f64" }));
    for (const edge of edges.keys()) assert.ok(edges.has(edge.split(" ").reverse().join(" ")));
  }
  const ring = NurbsCurve.arc([2, 0], 0.5, 0, 2 * Math.PI);
  near(RationalSurface.solidOfRevolution(ring, { ...options, angle: 1 }).volume(), Math.PI / 2, 1e-9);
  assert.equal(RationalSurface.solidOfRevolution(side, options).patchCount, 12);
  const wave = new Spline([1, 0, 2, 2, 1, 1, 1, 3], { degree: 1 });
  refusedAll(RangeError, [
    [
      () => RationalSurface.solidOfRevolution(wave, { ...options, angle: 1 }),
      /^t where the profile turns back along the axis: expected no such place for less than a full turn, got 1$/,
    ],
    [() => RationalSurface.solidOfRevolution(side, { angle: 7 }), /^angle: expected at most a full turn, 2π, got 7$/],
  ]);
});

test("surfaces with weights: vertices, patches and weights", () => {
  const surface = sphere.toSurface();
  assert.equal(surface.patchCount, 8);
  assert.deepEqual(surface.topology().collapsed.length, 8);
  assert.ok(surface.patch(3).equals(sphere.patches()[3]));
  assert.deepEqual(surface.weights()[0], sphere.patches()[0].weights());
  assert.deepEqual(RationalSurface.fromPatches(sphere.patches()).toJSON(), surface.toJSON());
  const { vertices, patches } = surface;
  const same = new RationalSurface({ vertices, patches, weights: surface.weights() }, { degreeU: 2, degreeV: 2 });
  assert.deepEqual(same.toJSON(), surface.toJSON());
  const teapot = RationalSurface.from(complete.Surface.teapot());
  assert.deepEqual(
    teapot.tessellate({ segments: 2 }).indices,
    complete.Surface.teapot().tessellate({ segments: 2 }).indices,
  );
  const moved = surface.movePoint(0, [0, 0, -3]).transform("translate(1 0)");
  assert.deepEqual([...moved.vertices.subarray(0, 3)], [1, 0, -3]);
  // Other weights along an edge are another line.
  const other = new RationalPatch(ROWS, [1, 0.9, 1, 1, 0.9, 1]);
  assert.equal(
    RationalSurface.fromPatches([quarter, other.transform([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 2, 1])]).topology()
      .open.length,
    8,
  );
  // The same edge with other parameters is multiplied by 2⁻ⁱ.
  const degrees = { degreeU: 1, degreeV: 1 };
  const net = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];
  const square = new RationalPatch(net, [1, 1, 1, 1], degrees);
  const beside = new RationalPatch(net, [3, 3, 6, 12], degrees).transform("translate(1 0)");
  const along = RationalSurface.fromPatches([square, beside]);
  assert.deepEqual([...along.weights()[1]], [3, 3, 3, 6]);
  assert.equal(along.topology().shared.length, 1);
  refusedAll(RangeError, [
    [
      () => new RationalSurface({ vertices, patches, weights: [[1]] }, { degreeU: 2, degreeV: 2 }),
      /^weights: expected 8 lists/,
    ],
    [
      () => RationalSurface.fromPatches([new RationalPatch(ROWS, [1, 1e7, 1, 1, 1, 1])]).tessellate({ tolerance: 0.1 }),
      /largest weight .*2\^20.*got 10000000$/,
    ],
  ]);
});

test("surfaces with weights: grids, isocurves and wireframes", () => {
  const surface = sphere.toSurface();
  const grid = surface.grid({ segments: { u: 3, v: 2 }, quads: true });
  assert.deepEqual([grid.positions.length, grid.quads?.length, grid.uvs?.length], [8 * 3 * 12, 8 * 4 * 6, 8 * 2 * 12]);
  for (let k = 0; k < grid.positions.length; k += 3) {
    const [x, y, z] = grid.positions.subarray(k, k + 3);
    assert.ok(Math.abs(Math.hypot(x, y, z) - 2) <= 1e-6);
    near([...grid.normals.subarray(k, k + 3)], [x / 2, y / 2, z / 2], 1e-6);
  }
  assert.equal(surface.grid({ segments: 2, into: grid }), grid);
  const curves = surface.isocurves({ lines: 1 });
  // Four meridians from pole to pole and the equator, in eight and four parts.
  assert.equal(curves.length, 12);
  for (const curve of curves) near(curve.length(), Math.PI, 1e-13);
  const tubes = surface.wireframe({ lines: 1, radius: 0.1 });
  for (let k = 0; k < tubes.positions.length; k += 3) {
    const size = Math.hypot(...tubes.positions.subarray(k, k + 3));
    assert.ok(size > 1.89 && size < 2.11, `${size}`);
  }
  const target = recorder();
  surface.trace(untyped(target), { matrix: [10, 0, 0, 10, 0, 0], lines: 1 });
  assert.ok(target.calls.length > 12);
});

test("surfaces with weights: measures, nearest points and rays", () => {
  const [ball, ring, side] = [sphere, torus, cylinder].map((each) => each.toSurface());
  near([ball.area(), ball.volume() ?? NaN], [16 * Math.PI, (32 * Math.PI) / 3], 1e-8);
  near([ring.area(), ring.volume() ?? NaN], [12 * Math.PI ** 2, 6 * Math.PI ** 2], 1e-8);
  near(side.area(), 20 * Math.PI, 1e-8);
  assert.equal(side.volume(), null);
  near(Object.values(ring.bounds() ?? {}).flatMap(numbers), [-4, -4, -1, 4, 4, 1], 1e-14);
  const found = ball.nearest([3, 4, 0]);
  near([found?.distance ?? NaN, ...numbers(found?.point ?? NOWHERE)], [3, 1.2, 1.6, 0], 1e-8);
  const hits = ring.intersectRay([-9, 0, 0], [2, 0, 0]);
  near(
    hits.map(({ distance }) => distance),
    [5, 7, 11, 13],
    1e-12,
  );
  const { patch, u, v, point } = hits[0];
  near(numbers(ring.patch(patch).eval(u, v)), numbers(point), 1e-12);
  const empty = new RationalSurface({ vertices: [], patches: [] });
  assert.deepEqual([empty.bounds(), empty.area(), empty.nearest([0, 0, 0])], [null, 0, null]);
});

// tests/surface/text.rs reads the same table.
for (const { name, text, error, indices, weights, written } of JSON.parse(
  readFileSync(new URL("../texts/weighted-surfaces.json", import.meta.url), "utf8"),
)) {
  test(`surfaces with weights, text: ${name}`, () => {
    assert.throws(() => complete.Surface.parse(text), RangeError);
    if (error) return assert.throws(() => RationalSurface.parse(text), new RangeError(error));
    const surface = RationalSurface.parse(text);
    const listed = (nets) => nets.flatMap((net) => [...net]);
    assert.deepEqual(listed(surface.weights()), weights);
    assert.deepEqual(listed(surface.patches), indices);
    assert.equal(surface.toText(), written ?? text);
  });
}

test("surfaces with weights: text", () => {
  const square = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.5];
  const data = { vertices: square, patches: [[0, 1, 2, 3]], weights: [[1, 1, 2, 0.5]] };
  const surface = new RationalSurface(data, { degreeU: 1, degreeV: 1 });
  const text = surface.toText();
  assert.ok(text.endsWith("1 1\n0 1\n2 3\nw 1 1\nw 2 0.5\n"));
  for (const each of [surface, sphere.toSurface(), RationalSurface.from(complete.Surface.teapot())])
    assert.deepEqual(RationalSurface.parse(each.toText()).toJSON(), each.toJSON());
  const teapot = complete.Surface.teapot().toText();
  assert.equal(RationalSurface.parse(teapot).toText(), teapot);
});
