// Freehand strokes through the package; their geometry is tested in tests/stroke/ink.rs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { InkStroke, Path } from "casteljau";
import { getStroke } from "perfect-freehand";
import { discsOf, distanceFromDiscs, freehandDiscs, outlinePoints } from "../../www/ink/compare.js";
import { hand } from "../../www/ink/samples.js";

/** @param {import("casteljau").InkOptions} options @param {number[][]} points */
function inkOf(options, points) {
  const ink = new InkStroke(options);
  for (const [x, y, pressure] of points) ink.append(x, y, { pressure });
  return ink;
}

test("ink: several strokes at a time are independent, and their outline is the stroke of their widths", () => {
  const [a, b] = [new InkStroke({ size: 8 }), new InkStroke({ size: 8 })];
  const points = hand(60, 4);
  for (const [x, y] of points) {
    a.append(x, y);
    b.append(y, x);
  }
  const flipped = b.outline().transform([0, 1, 1, 0, 0, 0]);
  assert.ok(Math.abs(flipped.area() + a.outline().area()) < 1e-6 * a.outline().area());
  const path = Path.from(/** @type {import("casteljau").Spline} */ (a.spline()));
  const same = path.stroke(a.widths(), { cap: "round", join: "round", tolerance: 0.2 });
  assert.ok(same.equals(a.outline()));
});

test("ink: the changes cover the outline", () => {
  const ink = new InkStroke({ size: 10, taper: { start: 20, end: 30 } });
  /** @type {import("casteljau").Spline[]} */
  const contours = [];
  let open = new Path([]);
  for (const [x, y] of hand(400, 7)) {
    const changes = ink.append(x, y).changes();
    contours.push(...changes.settled.subpaths);
    open = changes.open;
  }
  assert.ok(contours.length > 5 && open.subpaths.length === 1);
  const all = new Path([...contours, ...open.subpaths]).removeOverlaps();
  const outline = ink.outline();
  const limit = 0.25 * outline.length();
  assert.ok(outline.exclude(all).moments().area < limit, `${outline.exclude(all).moments().area}`);
});

test("ink: options and samples of the wrong type", () => {
  assert.throws(() => new InkStroke(/** @type {any} */ ({})), /^TypeError: size: expected a number, got undefined$/);
  assert.throws(
    () => new InkStroke(/** @type {any} */ ({ size: 8, taper: 3 })),
    /^TypeError: taper: expected an object, got 3$/,
  );
  assert.throws(() => new InkStroke(/** @type {any} */ ({ size: 8, width: 3 })), /width/);
  const ink = new InkStroke({ size: 8 });
  assert.throws(() => ink.append(/** @type {any} */ ("1"), 2), /^TypeError: x: expected a number, got "1"$/);
  assert.throws(
    () => ink.append(1, 2, { time: Infinity }),
    /^RangeError: time: expected a finite number, got Infinity$/,
  );
  assert.equal(ink.spline(), null);
});

test("ink: at most a fifth of perfect-freehand's points, at a smaller error", () => {
  let [segments, corners] = [0, 0];
  for (const [count, seed] of [
    [300, 1],
    [500, 2],
    [800, 3],
  ])
    for (const size of [6, 12, 24]) {
      const points = hand(count, seed);
      const options = { size, thinning: 0.5, streamline: 0.5, smoothing: 0.5 };
      const polygon = getStroke(points, options);
      const theirs = distanceFromDiscs(outlinePoints(polygon), freehandDiscs(points, options));
      const ink = inkOf({ ...options, tolerance: theirs }, points);
      const outline = ink.outline();
      const ours = distanceFromDiscs(outlinePoints(outline), discsOf(ink));
      assert.ok(ours <= theirs, `${count} ${size}: ${ours} ${theirs}`);
      segments += outline.subpaths.reduce((sum, { segmentCount }) => sum + segmentCount, 0);
      corners += polygon.length;
    }
  assert.ok(segments <= corners / 5, `${segments} ${corners}`);
});
