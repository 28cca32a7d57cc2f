// Extrema of splines, and parameters at which a coordinate has a value.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Spline } from "casteljau";
import { pointsOf, refused } from "./reference.js";

const polyline = (points, closed = false) => new Spline(points, { degree: 1, closed });
const K = (4 / 3) * (Math.SQRT2 - 1);
/** A circle of four cubics that starts at (1, 0); its extrema are its joints. */
const CIRCLE = new Spline([1, 0, 1, K, K, 1, 0, 1, -K, 1, -1, K, -1, 0, -1, -K, -K, -1, 0, -1, K, -1, 1, -K], {
  closed: true,
});

test("extrema: joints and the inside of segments, not the ends of an open spline", () => {
  const zigzag = polyline(pointsOf("0,0 1,2 2,-1 3,-2 2,5"));
  assert.deepEqual([[...zigzag.extrema().y], [...zigzag.extrema().x]], [[1, 3], [3]]);
  // y = 4t(1 − t) twice: up to 1 and back to 0
  const hills = new Spline([0, 0, 1, 2, 2, 0, 3, 2, 4, 0], { degree: 2 });
  assert.deepEqual([...hills.extrema().y], [0.5, 1, 1.5]);
  assert.deepEqual([...hills.extrema().x], []);
});

test("extrema: of a circle they are at its joints, the start as 0; of an open arc not", () => {
  assert.deepEqual([...CIRCLE.extrema().x], [0, 2]);
  assert.deepEqual([...CIRCLE.extrema().y], [1, 3]);
  const { x, y } = CIRCLE.subsegment(0, 4).extrema();
  assert.deepEqual([...x, ...y], [2, 1, 3]);
});

test("extrema: the joints of a constant part between a rise and a fall, none between two rises", () => {
  const plateau = polyline(pointsOf("0,0 1,1 2,1 3,0"));
  assert.deepEqual([...plateau.extrema().y], [1, 2]);
  const terrace = polyline(pointsOf("0,0 1,1 2,1 3,2"));
  assert.deepEqual([...terrace.extrema().y], []);
  const flat = polyline(pointsOf("0,0 1,0 2,0"), true);
  assert.deepEqual([...flat.extrema().y], []);
  assert.deepEqual([...flat.extrema().x], [0, 2]);
  // a closed trapezium whose constant side contains the start
  const trapezium = polyline(pointsOf("1,0 2,0 2,3 0,3 0,0"), true);
  assert.deepEqual([...trapezium.extrema().y], [0, 1, 2, 3, 4]);
});

test("extrema: z in 3D only", () => {
  const spline = new Spline([0, 0, 0, 1, 0, 5, 2, 0, 1], { degree: 1, dimension: 3 });
  assert.deepEqual([.../** @type {Float64Array} */ (spline.extrema().z)], [1]);
  assert.deepEqual(Object.keys(CIRCLE.extrema()), ["x", "y"]);
});

test("timesAtCoordinate: each time once, joints too, the start of a closed spline as 0", () => {
  const zigzag = polyline(pointsOf("0,0 1,2 2,0 3,4"));
  assert.deepEqual([...zigzag.timesAtCoordinate({ y: 1 })], [0.5, 1.5, 2.25]);
  assert.deepEqual([...zigzag.timesAtCoordinate({ y: 2 })], [1, 2.5]);
  assert.deepEqual([...zigzag.timesAtCoordinate({ y: 0 })], [0, 2]);
  assert.deepEqual([...zigzag.timesAtCoordinate({ x: 2.5 })], [2.5]);
  assert.deepEqual([...zigzag.timesAtCoordinate({ y: 9 })], []);
  assert.deepEqual([...CIRCLE.timesAtCoordinate({ x: 1 })], [0]);
  assert.deepEqual([...CIRCLE.timesAtCoordinate({ y: 0 })], [0, 2]);
});

test("timesAtCoordinate: both ends of a segment on which the coordinate is constant", () => {
  const spline = polyline(pointsOf("0,0 1,1 2,1 3,0"));
  assert.deepEqual([...spline.timesAtCoordinate({ y: 1 })], [1, 2]);
});

test("timesAtCoordinate refuses other coordinates", () => {
  refused(() => CIRCLE.timesAtCoordinate({ z: 1 }), TypeError, /^where: /);
  refused(() => CIRCLE.timesAtCoordinate({ x: 1, y: 1 }), TypeError, /^where: /);
  refused(() => CIRCLE.timesAtCoordinate({ x: Number.NaN }), RangeError, /^x: /);
});
