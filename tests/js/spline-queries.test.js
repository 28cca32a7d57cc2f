// Extrema of splines, parameters at which a coordinate has a value, hulls.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Spline } from "casteljau";
import { pairs, pointsOf, SEVEN } from "./reference.js";

/** Lines between points. */
const polyline = (points, closed = false) => new Spline(pointsOf(points), { degree: 1, closed });
const K = (4 / 3) * (Math.SQRT2 - 1);
/** A circle of four cubics that starts at (1, 0); its extrema are its joints. */
const CIRCLE = new Spline([1, 0, 1, K, K, 1, 0, 1, -K, 1, -1, K, -1, 0, -1, -K, -K, -1, 0, -1, K, -1, 1, -K], {
  closed: true,
});

/** Splines with the parameters of their extrema in x and in y. @type {[string, Spline, number[], number[]][]} */
const EXTREMA = [
  ["joints, not the ends of an open spline", polyline("0,0 1,2 2,-1 3,-2 2,5"), [3], [1, 3]],
  ["the inside of segments", new Spline([0, 0, 1, 2, 2, 0, 3, 2, 4, 0], { degree: 2 }), [], [0.5, 1, 1.5]],
  ["a circle at its joints, the start as 0", CIRCLE, [0, 2], [1, 3]],
  ["an open circle without its ends", CIRCLE.subsegment(0, 4), [2], [1, 3]],
  ["both joints of a constant part between a rise and a fall", polyline("0,0 1,1 2,1 3,0"), [], [1, 2]],
  ["none between two rises", polyline("0,0 1,1 2,1 3,2"), [], []],
  ["a constant coordinate", polyline("0,0 1,0 2,0", true), [0, 2], []],
  ["a constant part with the start", polyline("1,0 2,0 2,3 0,3 0,0", true), [1, 2, 3, 4], [0, 1, 2, 3, 4]],
];
for (const [name, spline, x, y] of EXTREMA)
  test(`extrema: ${name}`, () =>
    assert.deepEqual(spline.extrema(), { x: Float64Array.from(x), y: Float64Array.from(y) }));

test("extrema: z in space", () => {
  const spline = new Spline([0, 0, 0, 1, 0, 5, 2, 0, 1], { degree: 1, dimension: 3 });
  assert.deepEqual(Object.keys(spline.extrema()), ["x", "y", "z"]);
  assert.deepEqual(spline.extrema().z, Float64Array.of(1));
});

test("timesAtCoordinate: each time once, joints too, the start of a closed spline as 0, both ends of a constant segment", () => {
  const zigzag = polyline("0,0 1,2 2,0 3,4");
  /** @type {[Spline, any, number[]][]} */
  const cases = [
    [zigzag, { y: 1 }, [0.5, 1.5, 2.25]],
    [zigzag, { y: 2 }, [1, 2.5]],
    [zigzag, { y: 0 }, [0, 2]],
    [zigzag, { x: 2.5 }, [2.5]],
    [zigzag, { y: 9 }, []],
    [CIRCLE, { x: 1 }, [0]],
    [CIRCLE, { y: 0 }, [0, 2]],
    [polyline("0,0 1,1 2,1 3,0"), { y: 1 }, [1, 2]],
  ];
  for (const [spline, where, ts] of cases) assert.deepEqual([...spline.timesAtCoordinate(where)], ts);
});

test("hull: the corners counter-clockwise, of more points than a curve can have", () => {
  const square = [];
  for (let i = 49; i >= 0; i--) square.push([25, 25], [50, i], [50 - i, 50], [0, 50 - i], [i, 0]);
  const hull = pairs(new Spline(square, { degree: 1 }).hull());
  const smallest = hull.findIndex(([x, y]) => x === 0 && y === 0);
  assert.deepEqual([...hull.slice(smallest), ...hull.slice(0, smallest)], pointsOf("0,0 50,0 50,50 0,50"));
  assert.ok(new Spline(SEVEN).hull().length >= 6);
});
