// Queries of patches and surfaces by closed forms and golden values: one check of each function; tests/queries in Rust has the rest.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Curve, Patch, Surface } from "casteljau";
import { near, pointsOf } from "./reference.js";

/** The square [0, 3] × [0, 3] at z = 2: control points on a lattice. */
const plane = new Patch(Array.from({ length: 16 }, (_, i) => [i % 4, Math.floor(i / 4), 2]));
/** z = (u − ½)² + (v − ½)² over the unit square. */
const bowl = new Patch(pointsOf("0,0,0.5 0.5,0,0 1,0,0.5 0,0.5,0 0.5,0.5,-0.5 1,0.5,0 0,1,0.5 0.5,1,0 1,1,0.5"), {
  degreeU: 2,
  degreeV: 2,
});
const cube = new Surface(
  {
    vertices: Array.from({ length: 8 }, (_, k) => [k & 1, (k >> 1) & 1, k >> 2]),
    patches: pointsOf("0,2,1,3 4,5,6,7 0,1,4,5 2,6,3,7 0,4,2,6 1,3,5,7"),
  },
  { degreeU: 1, degreeV: 1 },
);
const empty = new Surface({ vertices: [], patches: [] });
const teapot = Surface.teapot();

test("curvature of a paraboloid at its vertex and of a plane", () => {
  const { gaussian, mean, k1, k2 } = bowl.curvature(0.5, 0.5);
  near([gaussian, mean, k1, k2], [4, 2, 2, 2]);
  assert.deepEqual(Object.values(plane.curvature(0.3, 0.9)).map(Math.abs), [0, 0, 0, 0]);
});

test("bounds, area, flatness and volume", () => {
  const { min, max } = bowl.bounds();
  near([min, max].flatMap(Object.values), [0, 0, 0, 1, 1, 0.5]);
  near([teapot.bounds()?.max.x], [3.434075125471107], 1e-15);
  near([plane.area(), plane.flatness(), cube.area(), cube.volume()], [9, 0, 6, 1], 1e-14);
  near([bowl.flatness()], [0.5]); // a quarter for the bulge in u and one for that in v
  assert.deepEqual([teapot.volume(), empty.area(), empty.volume(), empty.bounds()], [null, 0, null, null]);
  const { vertices, patches } = JSON.parse(readFileSync(new URL("../data/teacup.json", import.meta.url), "utf8"));
  const areas = [new Surface({ vertices, patches }), Surface.teacup(), Surface.teaspoon()].map((each) => each.area());
  near(areas, [9.981697616, 9.981697616, 0.342881444], 2e-9);
});

test("the nearest point, inside, on sides and at corners", () => {
  const inside = plane.nearest([0.75, 1.5, 7]);
  assert.deepEqual(Object.keys(inside), ["u", "v", "point", "distance"]);
  near([inside.u, inside.v, ...Object.values(inside.point), inside.distance], [0.25, 0.5, 0.75, 1.5, 2, 5]);
  near(plane.nearest({ x: -4, y: 1, z: 5 }).point, [0, 1, 2]);
  near(plane.nearest([9, 9, 9]).point, [3, 3, 2]);
  const onCube = cube.nearest([0.5, 0.25, 3]);
  near([onCube?.patch, ...Object.values(onCube?.point ?? {})], [1, 0.5, 0.25, 1]);
  assert.equal(empty.nearest([0, 0, 0]), null);
});

test("all hits of a ray, by distance", () => {
  const hits = bowl.intersectRay([-1, 0.5, 0.04], [5, 0, 0]);
  const found = hits.flatMap(({ point, distance }) => [...Object.values(point), distance]);
  near(found, [0.3, 0.5, 0.04, 1.3, 0.7, 0.5, 0.04, 1.7]);
  assert.deepEqual(bowl.intersectRay([-1, 0.5, -1], [1, 0, 0]), []);
  const through = cube.intersectRay([0.5, 0.5, 9], [0, 0, -0.1]).map(({ patch, distance }) => [patch, distance]);
  assert.deepEqual(through, pointsOf("1,8 0,9"));
  // Along a diagonal of the cube: corners, each of three faces, count once.
  assert.equal(cube.intersectRay([-1, -1, -1], [1, 1, 1]).length, 2);
  assert.deepEqual(empty.intersectRay([0, 0, 0], [0, 0, 1]), []);
});

test("deCasteljau of a patch: rows, then a curve, then the point", () => {
  const { rows, column, point } = bowl.deCasteljau(0.25, 0.75);
  const counts = [...rows, column].map((levels) => levels.map((level) => level.length / 3));
  assert.deepEqual(counts, new Array(4).fill([3, 2, 1]));
  const last = rows.flatMap((levels) => [...levels[2]]);
  assert.deepEqual(last, [...column[0]]);
  near(point, [0.25, 0.75, 0.125]);
  near(bowl.eval(0.25, 0.75), [0.25, 0.75, 0.125]);
});

test("elevation keeps the patch", () => {
  const high = bowl.elevate();
  assert.deepEqual([high.degreeU, high.degreeV], [3, 3]);
  near(high.eval(0.2, 0.7), [0.2, 0.7, 0.13]);
});

test("a patch from another basis goes through the curves of that basis", () => {
  const net = Array.from({ length: 16 }, (_, i) => [i % 4, Math.floor(i / 4), (i * 7) % 5]);
  for (const basis of /** @type {const} */ (["bezier", "b-spline", "catmull-rom", "hermite"])) {
    const patch = Patch.fromBasis(basis, net);
    const ends = [0, 1, 2, 3].map((j) => Curve.fromBasis(basis, net.slice(4 * j, 4 * j + 4)).eval(0.3));
    near(patch.eval(0.3, 0.6), Object.values(Curve.fromBasis(basis, ends).eval(0.6)));
    assert.ok(Patch.fromBasis(Curve.basisMatrix(basis), new Float64Array(net.flat())).equals(patch));
  }
});
