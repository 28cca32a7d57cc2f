import assert from "node:assert/strict";
import { test } from "node:test";
import { BoxTree } from "#js/geometry/box-tree.js";
import { generator } from "#js/editor/random.js";

const COUNT = 10_000;
const random = generator(1);

/** @param {(k: number) => number[]} center of a square of side 1 */
const squares = (center) =>
  Float64Array.from({ length: COUNT }, (_, k) => k).reduce(
    (boxes, k) => {
      const [x, y] = center(k);
      boxes.set([x, y, x + 1, y + 1], 4 * k);
      return boxes;
    },
    new Float64Array(4 * COUNT),
  );

const LISTS = {
  "in random order": squares(() => [1000 * random(), 1000 * random()]),
  "and one of them far away": squares((k) => (k === 0 ? [1e12, 1e12] : [1000 * random(), 1000 * random()])),
  "half of them in a crowd": squares((k) => (k % 2 ? [1000 * random(), 1000 * random()] : [random(), random()])),
  "in a row": squares((k) => [(2 * (k * 797)) % COUNT, 0]),
  "in a column": squares((k) => [0, (2 * (k * 797)) % COUNT]),
};

for (const [name, boxes] of Object.entries(LISTS)) {
  const tree = BoxTree.ofPlane(boxes);
  const at = (/** @type {number} */ k) => boxes.subarray(4 * k, 4 * k + 4);
  /** Points near squares and points anywhere. */
  const points = Array.from({ length: 40 }, (_, k) => {
    const [x, y] = at(Math.floor(COUNT * random()));
    return k % 2 ? [x + 2 * random(), y + 2 * random()] : [1000 * random(), 1000 * random()];
  });

  test(`squares ${name}: those around a point, and the nearest one`, () => {
    for (const [x, y] of points) {
      const distances = Array.from({ length: COUNT }, (_, k) => {
        const [minX, minY, maxX, maxY] = at(k);
        return Math.hypot(Math.max(minX - x, x - maxX, 0), Math.max(minY - y, y - maxY, 0));
      });
      /** @type {number[]} */
      const around = [];
      tree.around(x, y, (k) => around.push(k));
      const expected = distances.flatMap((distance, k) => (distance === 0 ? [k] : []));
      assert.deepEqual(
        around.sort((a, b) => a - b),
        expected,
      );
      let nearest = Infinity;
      tree.nearest(Float64Array.of(x, y), Infinity, (k) => {
        nearest = Math.min(nearest, distances[k]);
        return nearest;
      });
      assert.equal(nearest, Math.min(...distances));
    }
  });

  test(`squares ${name}: few boxes are compared`, () => {
    let compared = 0;
    for (const [x, y] of points)
      tree.descend((list, i) => {
        compared++;
        return list[i] <= x && x <= list[i + 2] && list[i + 1] <= y && y <= list[i + 3];
      });
    assert.ok(compared / points.length < (name.includes("crowd") ? 2000 : 200), `${compared / points.length}`);
  });
}

test("a tree without items finds nothing", () => {
  const tree = BoxTree.ofPlane(new Float64Array(0));
  tree.around(0, 0, () => assert.fail());
  tree.nearest(Float64Array.of(0, 0), Infinity, () => assert.fail());
});
