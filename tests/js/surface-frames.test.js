// What <bezier-surface> computes in a frame while the reader drags: no more than once what has not changed, and no new mesh while
// the camera moves.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Surface } from "casteljau";
import { boundingSphereOf, HOME, moved, cameraMatricesOf } from "#js/elements/surface/camera.js";
import { figureOf } from "#js/elements/surface/figure.js";
import { Geometry } from "#js/elements/surface/geometry.js";
import { settingsOf } from "#js/elements/surface/settings.js";

const surface = Surface.teapot();
const [WIDTH, HEIGHT] = [600, 400];
const scene = (attributes) => ({
  surface,
  settings: settingsOf(/** @type {any} */ (attributes)),
  sphere: boundingSphereOf(surface.vertices, "z"),
  picked: null,
});
const matrices = (zoom) =>
  cameraMatricesOf(moved(HOME, { zoom }), boundingSphereOf(surface.vertices, "z"), WIDTH, HEIGHT);

test("a mesh by pixels stays while the camera moves, and follows when it rests", () => {
  const geometry = new Geometry();
  const shown = scene({ pixels: 1 });
  geometry.seen(matrices(1), true); // the first view counts in any case
  const coarse = geometry.mesh(shown).indices.length;
  const version = geometry.version();
  geometry.seen(matrices(3), true);
  geometry.mesh(shown);
  assert.equal(geometry.version(), version);
  assert.equal(geometry.outdated, true);
  geometry.seen(matrices(3), false);
  assert.ok(geometry.mesh(shown).indices.length > coarse);
  assert.ok(geometry.version() > version);
  assert.equal(geometry.outdated, false);
});

test("the nearest point is computed once for a point, however often the figure is read", () => {
  const shown = scene({ probe: "3 0 3" });
  const first = figureOf(shown, null).nearest;
  assert.equal(figureOf(shown, null).nearest, first);
  const { distance } = surface.nearest([3, 0, 3]) ?? {};
  assert.equal(first?.distance, distance);
  const cup = Surface.teacup();
  assert.notEqual(figureOf({ ...shown, surface: cup }, null).nearest?.distance, distance);
});
