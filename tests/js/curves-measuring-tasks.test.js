// The tasks of the chapter on curves about derivatives, lengths, boxes, distances, intersections, offsets, circles and faces.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Curve } from "casteljau";
import { NurbsCurve, RationalCurve } from "casteljau/nurbs";
import { arcOf, maxRadialError, standardHandle } from "../../www/figures/lib/circle.js";
import { rationalBasis } from "../../www/figures/lib/rational.js";
import { feet } from "../../www/figures/lib/nearest.js";
import { checkPrediction, load, testTasks } from "./task-cases.js";
import { pointsOf } from "./reference.js";

/** The control points of the site's figures, and what the tasks see of these. */
const UNEVEN = pointsOf("12,66 12,52 36,8 118,28");
const BEND = pointsOf("14,62 43,57 84,40 67,23");
const curveOf = (points, t) => ({
  t,
  points,
  get curve() {
    return new Curve(this.points);
  },
});
/** The centres of three shapes. */
const CENTERS = pointsOf("45,32 74,32 60,57");
const ARCH = pointsOf("80,400 250,20 420,20 590,400");
const LEVEL = pointsOf("90,400 150,90 460,90 590,400");
/** A symmetric arch around x = 50. */
const BOW = new Curve([0, 100, 20, 0, 80, 0, 100, 100]);
/** y = T(x) for x from −1 to 1, where T is the Chebyshev polynomial 4x³ − 3x. */
const WAVE = [-1, 5, -5, 1].map((y, i) => [(2 * i) / 3 - 1, y]);
/** What the task sees of the site's figure: the wave, and a curve of these coordinates. */
const cubics = (xs, ys) => ({
  points: [...WAVE, ...xs.map((x, i) => [x, ys[i]])],
  get found() {
    return new Curve(this.points.slice(0, 4)).intersections(new Curve(this.points.slice(4)));
  },
});
const faces = (...keys) => keys.map((key) => ({ inside: [...key].map((each) => each === "1") }));

/** The radius of curvature in the middle of ARCH: (x′)² / y″ with B′(½) = (¾ (x3 + x2 − x1 − x0), 0). */
const RADIUS = (0.75 * (590 + 420 - 250 - 80)) ** 2 / (3 * (400 - 20 - 20 + 400));
const [BELOW, ABOVE] = [Math.floor(RADIUS), Math.ceil(RADIUS)];
const offset = (distance, points = ARCH) => ({ offset: String(distance), points });

/** What the tasks see of the site's figures of a conic and of a NURBS curve. */
const conic = (weight, /** @type {[number, number]} */ p1 = [67, 12]) => ({
  /** @type {[number, number][]} */
  points: [[29, 50], p1, [105, 50]],
  weight,
  get middle() {
    const [p0, p1, p2] = this.points;
    const { x, y } = RationalCurve.conic(p0, p1, p2, this.weight).eval(0.5);
    return [x, y];
  },
});
const onCircle = (t) => ({
  t,
  get point() {
    return [(1 - this.t ** 2) / (1 + this.t ** 2), (2 * this.t) / (1 + this.t ** 2)];
  },
});
/** @type {[number, number][]} */
const FIVE = [
  [14, 64],
  [24, 24],
  [67, 16],
  [110, 24],
  [120, 64],
];
const nurbs = () => ({
  points: FIVE,
  weight: 1,
  first: 0.35,
  second: 0.65,
  get curve() {
    const knots = [0, 0, 0, this.first, this.second, 1, 1, 1];
    return new NurbsCurve({ degree: 2, points: this.points, weights: [1, 1, this.weight, 1, 1], knots });
  },
});

testTasks([
  [
    "circle-weight",
    () => conic(0.4),
    [
      { weight: 0.5 },
      { weight: 0.74 },
      { weight: 0.5, points: conic(1, [67, 50 - 38 * Math.sqrt(3)]).points }, // a circle, with legs of 60°
      { weight: 0.71, points: conic(1, [67, 50 - 38 * Math.sqrt(3)]).points },
      { weight: 1, points: conic(1, [67, 50]).points }, // a segment
    ],
    { weight: 0.7 },
  ],
  ["weight-two", () => conic(0.4), [{ weight: 1 }, { weight: 2.1 }, { weight: 0.5 }], { weight: 1.96 }],
  ["three-fifths", () => onCircle(0.75), [{ t: 0.59 }, { t: 0.52 }, { t: 0.6 }], { t: 0.5 }],
  [
    "double-knot",
    nurbs,
    [
      { weight: 8 },
      { first: 0.49, second: 0.51 },
      { first: 0.5, second: 0.5, points: FIVE.with(1, FIVE[2]) },
      { first: 0.3, second: 0.6, points: FIVE.map(([x]) => [x, 40]) }, // a line, through P2 with any knots
    ],
    { first: 0.2, second: 0.2, points: FIVE },
  ],
  [
    "sharpest-bend",
    () => curveOf(BEND, 0),
    [{ t: 0.5 }, { t: 0.82 }, { t: 1 }, { t: 0.25, points: pointsOf("14,62 43,5 84,40 67,23") }],
    { t: 0.85 },
  ],
  [
    "half-length",
    () => curveOf(UNEVEN, 0.5),
    [{ t: 0.65 }, { t: 0.71 }, { t: 0 }, { t: 0.5, points: pointsOf("0,0 30,0 60,0 90,0") }],
    { t: 0.68 },
  ],
  [
    "low-box",
    { points: LEVEL },
    [
      { points: LEVEL.with(2, [460, 240]) },
      { points: LEVEL.with(0, [90, 90]) }, // an end has moved
      { points: LEVEL.with(1, [200, 395]).with(2, [400, 405]) }, // too flat
      { points: LEVEL.with(2, [460, 700]).with(3, [590, 410]) }, // low, but the other end has moved
    ],
    { points: LEVEL.with(2, [460, 700]) },
  ],
  ["two-nearest", { curve: BOW, q: [30, 70] }, [{ q: [54, 90] }, { q: [50, -40] }, { q: [30, 90] }], { q: [50.5, 90] }],
  [
    "many-intersections",
    () => cubics([-3, -1, 1, 3], [0, 0, 0, 0]), // a line across the wave
    [
      { points: [...WAVE, ...WAVE] }, // they share everything
      { points: [...WAVE, ...WAVE.map(([x, y]) => [x + 20, y])] },
      { points: [...WAVE, ...WAVE.map(([x, y]) => [x, -y])] }, // three: an S and its mirror image
    ],
    { points: [...WAVE, ...WAVE.map(([x, y]) => [y, x])] },
  ],
  [
    "offset-cusp",
    offset(40),
    [
      offset(-75),
      offset(ABOVE),
      offset(BELOW - 4),
      offset(BELOW, ARCH.with(1, [250, 60])),
      offset(173, pointsOf("80,400 250,150 420,150 590,400")),
    ],
    offset(BELOW),
  ],
  [
    "quarter-circle",
    { arcs: 4, length: 0.52 },
    [{ length: 0.5523 }, { length: 0.5515 }, { arcs: 8, length: 0.2652 }],
    { arcs: 4, length: 0.552 },
  ],
  [
    "odd-faces",
    { chosen: new Set(), centers: CENTERS, faces: faces("100", "010", "001", "110", "101", "011", "111") },
    [
      { chosen: new Set(["100", "010", "001"]) },
      { chosen: new Set(["100", "010", "001", "111", "110"]) },
      {
        chosen: new Set(["100", "010", "001"]),
        centers: CENTERS.with(2, [60, 80]),
        faces: faces("100", "010", "001", "110"),
      }, // C far away
    ],
    {
      chosen: new Set(["111", "001", "010", "100"]),
      faces: faces("100", "010", "001", "110", "101", "011", "111"),
    },
  ],
]);

test("the basis functions of the figure: with points of geomdl, and the sum 1", () => {
  const { curves } = JSON.parse(readFileSync(new URL("../data/nurbs.json", import.meta.url), "utf8"));
  const plane = curves.filter(({ points, degree, knots }) => points[0].length === 2 && knots[0] === knots[degree]);
  assert.ok(plane.length >= 8);
  for (const { id, degree, points, weights, knots, samples } of plane) {
    const ts = samples.map(({ t }) => t);
    const basis = rationalBasis(new NurbsCurve({ degree, points, weights, knots }), ts);
    for (const [k, { t, point }] of samples.entries()) {
      const sum = (/** @type {(i: number) => number} */ factor) =>
        basis.reduce((total, values, i) => total + values[k] * factor(i), 0);
      assert.ok(Math.abs(sum(() => 1) - 1) < 1e-14, `${id}, sum at ${t}`);
      const found = [0, 1].map((axis) => sum((i) => points[i][axis]));
      assert.ok(Math.hypot(found[0] - point[0], found[1] - point[1]) < 1e-13, `${id} at ${t}: ${found}`);
    }
  }
});

test("the feet of perpendiculars: nearest first, ends included", () => {
  const line = new Curve([0, 0, 10, 0]);
  const distances = feet(line, [4, 3]).map(({ distance }) => distance);
  assert.deepEqual(distances, [3]);
  assert.equal(feet(line, [13, 4])[0].t, 1);
  const found = feet(BOW, [45, 90]);
  assert.equal(found.length, 2); // one on each side; the top is the farthest
  assert.ok(found[0].t < 0.5 && found[1].t > 0.5 && found[0].distance < found[1].distance);
});

test("a circle of cubic arcs: known errors, and the middle of each arc on the circle", () => {
  assert.ok(Math.abs(maxRadialError(4, (4 / 3) * (Math.SQRT2 - 1)) - 2.7253e-4) < 1e-7);
  for (const arcs of [2, 3, 4, 8]) {
    const { x, y } = arcOf(arcs, standardHandle(arcs)).eval(0.5);
    assert.ok(Math.abs(Math.hypot(x, y) - 1) < 1e-14, `${arcs} arcs`);
  }
});

test("task safe-powers has one answer", async () => {
  checkPrediction((await load("safe-powers")).predict);
});
