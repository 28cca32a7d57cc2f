// Drawings of the size that people have: every icon of bootstrap-icons, and the countries of the world.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { Path } from "casteljau";
import { feature, merge } from "topojson-client";

const require = createRequire(import.meta.url);

/** @param {string} file */
const packageFile = (file) => new URL(file, `file://${require.resolve("bootstrap-icons/package.json")}`);

/** @param {number[][]} points @param {number[][]} line */
function distanceFromLine(points, line) {
  let farthest = 0;
  for (const [x, y] of points) {
    let nearest = Infinity;
    for (let k = 1; k < line.length; k++) {
      const [[x0, y0], [x1, y1]] = [line[k - 1], line[k]];
      const [dx, dy] = [x1 - x0, y1 - y0];
      const part = Math.max(0, Math.min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy || 1)));
      nearest = Math.min(nearest, Math.hypot(x - x0 - part * dx, y - y0 - part * dy));
    }
    farthest = Math.max(farthest, nearest);
  }
  return farthest;
}

/** @param {{ points: Float64Array }} line */
const pointsOf = ({ points }) =>
  Array.from({ length: points.length / 2 }, (_, k) => [points[2 * k], points[2 * k + 1]]);

/** @param {Path} path */
const segmentsOf = (path) => path.subpaths.reduce((sum, { segmentCount }) => sum + segmentCount, 0);

/** Of the icons, every sixth one is drawn; all of them with CASTELJAU_DEEP=1. */
const EVERY = process.env.CASTELJAU_DEEP ? 1 : 6;

test("bootstrap-icons: the stroke and the offset of every path, with the areas that they must have", () => {
  const folder = packageFile("icons/");
  let [count, segments] = [0, 0];
  for (const file of readdirSync(folder).filter((_, k) => k % EVERY === 0)) {
    for (const [, d] of readFileSync(new URL(file, folder), "utf8").matchAll(/<path[^>]*? d="([^"]*)"/g)) {
      const path = Path.fromSVG(d);
      count++;
      const own = path.area({ fillRule: "nonzero" });
      const joints = path.subpaths.reduce((sum, spline) => sum + spline.segmentCount, 0);
      segments += joints;
      const [stroke, grown, shrunk] = [path.stroke(0.5), path.offset(0.2), path.offset(-0.2)];
      const [line, large, small] = [stroke, grown, shrunk].map((region) => region.area());
      // A stroke covers at most the outline's length times the width and the miters; growing adds half of a stroke
      // of twice the distance, shrinking removes the other half.
      assert.ok(line > 0 && line <= 0.5 * path.length() + 0.25 * joints + 1, file);
      assert.ok(large > own && small < own && small >= 0, file);
      for (const region of [stroke, grown, shrunk]) {
        assert.ok(Math.abs(region.area({ fillRule: "evenodd" }) - region.area()) <= 1e-6, file);
      }
    }
  }
  assert.ok(EVERY * count > 3_000 && EVERY * segments < 120_000, `${count} paths of ${segments} segments`);
});

test("bootstrap-icons simplified: within the tolerance both ways, with fewer segments", () => {
  const folder = packageFile("icons/");
  const kinds = [{}, { extrema: true }, { precision: 2 }, { effort: /** @type {const} */ ("best") }];
  const counts = kinds.map(() => 0);
  let before = 0;
  for (const file of readdirSync(folder).filter((_, k) => k % (5 * EVERY) === 0)) {
    for (const [, d] of readFileSync(new URL(file, folder), "utf8").matchAll(/<path[^>]*? d="([^"]*)"/g)) {
      const path = Path.fromSVG(d);
      before += segmentsOf(path);
      for (const tolerance of [0.016, 0.08]) {
        const lines = path.flatten(0.01 * tolerance).map(pointsOf);
        for (const [k, options] of kinds.entries()) {
          const simple = path.simplify(tolerance, options);
          counts[k] += segmentsOf(simple);
          for (const [index, line] of simple
            .flatten(0.01 * tolerance)
            .map(pointsOf)
            .entries()) {
            const apart = Math.max(distanceFromLine(lines[index], line), distanceFromLine(line, lines[index]));
            assert.ok(apart <= 1.02 * tolerance, `${file}, subpath ${index}: ${apart} with ${JSON.stringify(options)}`);
          }
        }
      }
    }
  }
  const parts = counts.map((count) => count / (2 * before));
  assert.ok(parts[0] < 0.9 && parts[2] < 0.95 && parts[3] <= parts[0], `${parts} of ${before} segments`);
});

/** @typedef {{ type: string, coordinates: number[][][][] | number[][][] }} Geometry */

/** @param {Geometry} geometry @returns {number[][][][]} */
const polygons = (geometry) =>
  /** @type {number[][][][]} */ (geometry.type === "Polygon" ? [geometry.coordinates] : geometry.coordinates);

/** Whether a ring runs along or across the meridian of 180°, where the flat map is cut. @param {number[][]} ring */
const isCut = (ring) => ring.some(([x], k) => k > 0 && Math.abs(x - ring[k - 1][0]) > 180);

/** The path of a country. @param {Geometry} geometry */
function country(geometry) {
  const rings = polygons(geometry).flat();
  return Path.from(rings.map((ring) => Path.polygon(ring.slice(0, -1)).subpaths[0]));
}

/** Twice the area of a ring by the shoelace formula. @param {number[][]} ring */
const doubleArea = (ring) => ring.slice(1).reduce((sum, [x, y], k) => sum + ring[k][0] * y - x * ring[k][1], 0);

for (const resolution of ["110m", "50m", "10m"]) {
  test(`world-atlas, ${resolution}: the union of the countries is what topojson-client merges`, () => {
    const world = JSON.parse(readFileSync(require.resolve(`world-atlas/countries-${resolution}.json`), "utf8"));
    const all = world.objects.countries.geometries;
    const whole = all.filter((geometry) => !polygons(feature(world, geometry).geometry).flat().some(isCut));
    assert.ok(whole.length > 0.9 * all.length);
    const union = Path.combine(
      whole.map((geometry) => country(feature(world, geometry).geometry)),
      "union",
    );
    const merged = merge(world, whole).coordinates.flat();
    const area = Math.abs(merged.reduce((sum, ring) => sum + doubleArea(ring), 0)) / 2;
    assert.ok(Math.abs(union.area() - area) <= 1e-6 * area, `${union.area()} instead of ${area}`);
    // Rings that touch themselves are divided by the union.
    const rings = union.subpaths.length;
    assert.ok(rings >= merged.length && rings <= 1.02 * merged.length + 2, `${rings} rings, ${merged.length} merged`);
  });
}
