// The ray tracer of the chapter on surfaces: it finds what the surface's own query finds, and covers the picture.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Surface } from "casteljau";
import { boundingSphereOf, HOME, rayThrough, cameraMatricesOf } from "#js/elements/surface/camera.js";
import { boxEntry, progressiveBlocks, RayTracer } from "../../www/figures/lib/ray-tracer.js";
import { pointsOf } from "./reference.js";

const [WIDTH, HEIGHT] = [31, 23];
const teapot = Surface.teapot();
const sphere = boundingSphereOf(teapot.vertices, "z");
const matrices = cameraMatricesOf(HOME, sphere, WIDTH, HEIGHT);
const [FRONT, BACK] = pointsOf("0.2,0.4,0.8 0.8,0.4,0.2");
const lighting = { radius: sphere.radius, front: FRONT, back: BACK, hasShadows: true };
function tracerOf(surface, options = {}) {
  const patches = surface.patches.map((_, k) => surface.patch(k));
  return new RayTracer(patches, { matrices, ...lighting, ...options });
}

test("the nearest hit is the first one of the surface's query", () => {
  const tracer = tracerOf(teapot);
  let hits = 0;
  for (let y = 0.5; y < HEIGHT; y++)
    for (let x = 0.5; x < WIDTH; x++) {
      const { origin, direction } = rayThrough(matrices, x, y);
      const [expected] = teapot.intersectRay(origin, direction);
      const hit = tracer.firstHit(origin, direction);
      assert.equal(hit === null, expected === undefined, `at ${x}, ${y}`);
      if (!hit) continue;
      hits++;
      assert.ok(Math.abs(hit.distance - expected.distance) < 1e-9, `at ${x}, ${y}`);
      assert.equal(tracer.colour(x, y)?.length, 3);
    }
  assert.ok(hits > 100 && hits < (WIDTH * HEIGHT) / 2, `${hits} hits`);
});

test("a wall between a point and the light takes the light away", () => {
  // Seen from above, with the light at the upper left: the wall stands to the left of the point that is looked at.
  const floor = "0 0 0\n4 0 0\n0 4 0\n4 4 0\n";
  const wall = "1 0 0\n1 4 0\n1 0 9\n1 4 9\n";
  const [alone, both] = [Surface.parse(`1\n1 1\n${floor}`), Surface.parse(`2\n1 1\n${floor}1 1\n${wall}`)];
  const above = cameraMatricesOf(
    { turn: 0, tilt: 90, zoom: 1, panX: 0, panY: 0 },
    boundingSphereOf(alone.vertices, "z"),
    41,
    41,
  );
  const at = (surface, hasShadows) => tracerOf(surface, { matrices: above, radius: 3, hasShadows }).colour(18.5, 20.5);
  const [lit, shadow] = [at(alone, true), at(both, true)];
  assert.deepEqual(at(both, false), at(alone, false), "without shadows the wall changes nothing there");
  assert.deepEqual(lit, at(alone, false));
  assert.ok(lit && shadow && shadow[2] < 0.75 * lit[2] && shadow[2] > 0, `${shadow} and ${lit}`);
  assert.ok(lit[2] > lit[0], "the front is blue");
});

test("a ray and a box", () => {
  const box = /** @type {[number[], number[]]} */ (pointsOf("0,0,0 1,2,3"));
  assert.equal(boxEntry([-2, 1, 1], [1, 0, 0], ...box), 2);
  assert.equal(boxEntry([-2, 1, 1], [-1, 0, 0], ...box), Infinity);
  assert.equal(boxEntry([0.5, 1, 1], [0, 0, 5], ...box), 0);
  assert.equal(boxEntry([-2, 3, 1], [1, 0, 0], ...box), Infinity);
  assert.equal(boxEntry([-1, 1, 1], [1, 0, 0], [0, 0, 1], [1, 2, 1]), 1, "a box without thickness");
});

test("the blocks of all passes have each pixel once as their first, and each pass covers the picture", () => {
  const blocks = [...progressiveBlocks(WIDTH, HEIGHT)];
  assert.equal(blocks.length, WIDTH * HEIGHT);
  assert.equal(new Set(blocks.map(({ x, y }) => `${x},${y}`)).size, WIDTH * HEIGHT);
  assert.deepEqual([...new Set(blocks.map(({ size }) => size))], [8, 4, 2, 1]);
  const coarse = blocks.filter(({ size }) => size === 8);
  assert.equal(coarse.length, Math.ceil(WIDTH / 8) * Math.ceil(HEIGHT / 8));
});
