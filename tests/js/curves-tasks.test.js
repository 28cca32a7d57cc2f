// The tasks of the chapter on curves: not done at the start, done when it is done, and their own answers count.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve } from "casteljau";
import { applet, load, testTasks } from "./task-cases.js";
import { pointsOf } from "./reference.js";

const ARCH = pointsOf("60,400 160,40 480,40 600,400");
const HILL = pointsOf("70,300 160,40 400,60 610,430");
/** The places of the site's figure, and the orders that it offers. */
const PLACES = pointsOf("16,62 30,14 80,24 68,68");
const ORDERS = [0, 1, 2, 3]
  .flatMap((a) => [0, 1, 2, 3].flatMap((b) => [0, 1, 2, 3].flatMap((c) => [0, 1, 2, 3].map((d) => [a, b, c, d]))))
  .filter((order) => new Set(order).size === 4);
const SEVEN = pointsOf("70,330 90,120 250,110 330,200 430,300 560,380 600,160");

/** Each task: its start, what one may try in vain, and what does it. The answer that it reveals must count too. */
const TASKS = {
  "half-height": {
    start: () => ({ t: 0.5 }),
    vain: [(e) => (e.t = 0.69), (e) => (e.t = -0.71)],
    right: (e) => (e.t = 0.71),
  },
  "half-pixel": {
    start: () => applet({ points: ARCH, segments: "4" }),
    vain: [(e) => (e.segments = "23"), (e) => (e.segments = "25")],
    right: (e) => (e.segments = "24"),
  },
  "top-180": {
    start: () =>
      applet({
        points: pointsOf("80,420 335,200 590,420"),
      }),
    vain: [
      (e) => (e.points = pointsOf("80,420 335,240 590,420")),
      (e) => (e.points = pointsOf("80,420 335,60 590,300")),
    ],
    right: (e) => (e.points = pointsOf("80,420 200,61 590,420")),
  },
  "equal-weights": {
    start: () => applet({ points: ARCH }),
    vain: [(e) => (e.t = 0.67), (e) => (e.t = 0.78), (e) => (e.t = 0)],
    right: (e) => (e.t = 0.75),
  },
  "straight-matrix": {
    start: () => applet({ points: ARCH }),
    vain: [
      (e) => Object.assign(e, { basis: "matrix", matrix: [...Curve.basisMatrix("bezier")].join(" ") }),
      (e) => (e.matrix = "0 0 0 0 -1 0 0 1 0 0 0 0 1 0 0 0"),
    ],
    right: (e) => (e.matrix = "0 0 0 0 0 0 0 0 -1 0 0 1 1 0 0 0"),
  },
  "level-tangent": {
    start: () => applet({ points: HILL, t: 0.75 }),
    vain: [(e) => (e.t = 0.5), (e) => (e.t = 1)],
    right: (e) => (e.t = Math.round(100 * new Curve(e.points).extrema().y[0]) / 100),
  },
  "order-loop": {
    start: () => ({ chosen: 0, curve: (k) => new Curve(ORDERS[k].map((place) => PLACES[place])) }),
    vain: [(e) => (e.chosen = 2), (e) => (e.chosen = 23)],
    right: (e) => (e.chosen = ORDERS.findIndex((order) => order.join("") === "1302")),
  },
  "make-s": {
    start: () => applet({ points: ARCH }),
    vain: [
      (e) => (e.points = pointsOf("60,400 300,60 600,400")),
      (e) => (e.points = pointsOf("60,300 540,60 180,60 600,300")),
    ],
    right: (e) => (e.points = pointsOf("60,400 600,400 60,60 600,60")),
  },
  "match-shape": {
    start: () => applet({ points: ARCH }),
    vain: [(e) => (e.points = pointsOf("110,370 30,60 520,30 560,330"))],
    right: (e) => (e.points = pointsOf("111,369 32,42 519,29 560,331")),
  },
  "inflection-amid": {
    start: () =>
      applet({
        points: pointsOf("80,380 420,440 160,20 590,300"),
      }),
    vain: [(e) => (e.points = ARCH)],
    right: (e) => (e.points = pointsOf("60,400 600,400 60,60 600,60")),
  },
  "cut-at-top": {
    start: () => applet({ points: HILL }),
    vain: [(e) => e.insert(0.5)],
    right: (e) => {
      e.points = HILL;
      e.insert(new Curve(HILL).extrema().y[0] + 0.003);
    },
  },
  "time-ratio": {
    start: () => applet({ points: SEVEN }),
    vain: [
      (e) => (e.points = SEVEN.with(4, [410, 290])), // C1 at equal durations
      (e) => (e.points = SEVEN.with(4, [370, 245])), // half as long instead of twice
      (e) => (e.points = SEVEN.with(4, [490, 385])), // 5 px away
      (e) => (e.points = SEVEN.slice(0, 4)),
      (e) => (e.points = SEVEN.with(2, [330, 200]).with(4, [330, 200])),
    ],
    right: (e) => (e.points = SEVEN.with(4, [492, 383])),
  },
  "aligned-only": {
    start: () => applet({ points: SEVEN }),
    vain: [
      (e) => (e.points = SEVEN.with(4, [410, 290])),
      (e) => (e.points = SEVEN.with(4, [426, 308])),
      (e) => (e.points = SEVEN.with(4, [290, 155])),
      (e) => (e.points = SEVEN.slice(0, 4)),
    ],
    right: (e) => (e.points = SEVEN.with(4, [490, 382])),
  },
  "raise-degree": {
    start: () =>
      applet({
        points: pointsOf("80,390 335,30 335,30 590,390"),
      }),
    vain: [(e) => (e.points = pointsOf("80,390 207,210 463,210 590,390"))],
    right: (e) => (e.points = pointsOf("80,390 250,150 420,150 590,390")),
  },
  "touch-with-spline": {
    start: () =>
      applet({
        points: pointsOf("60,380 170,110 300,330 420,90 610,300"),
        basis: "b-spline",
        whole: true,
      }),
    vain: [(e) => (e.points = e.points.with(2, [330, 330])), (e) => (e.basis = "natural")],
    right: (e) => Object.assign(e, { basis: "b-spline", points: e.points.with(2, [296, 101]) }),
  },
  overshoot: {
    start: () => ({ value: "cubic-bezier(0.25, 0.1, 0.25, 1)" }),
    vain: [(e) => (e.value = "cubic-bezier(0.3, 3, 0.6, 1)"), (e) => (e.value = "cubic-bezier(.3, 1.2, .6, 1)")],
    right: (e) => (e.value = "cubic-bezier(.34, 1.6, .64, 1)"),
  },
};

testTasks(TASKS);

test("task enough-pieces", async () => {
  const { check, reveal } = await load("enough-pieces");
  const tree = (segments, error) => check({ tree: { segments, error } }).done;
  assert.deepEqual([tree(16, 1.64), tree(32, 0.41), tree(48, 0.3), tree(49, 0.3)], [false, true, true, false]);
  assert.equal(check({ tree: null }).done, false);
  const element = { tolerance: "8" };
  reveal(element);
  const pieces = leaves(new Curve([60, 300, 60, 20, 620, 20, 600, 300]).subdivide(Number(element.tolerance)));
  const error = Math.max(...pieces.map(({ curve }) => curve.hausdorff(new Curve([curve.eval(0), curve.eval(1)]))));
  assert.equal(tree(pieces.length, error), true);
});

test("the predicted answers hold: shapes whose first and last leg cross, equal weights, the radius at the top", async () => {
  /** @type {(a: number[], b: number[], p: number[]) => number} */
  const side = ([ax, ay], [bx, by], [x, y]) => Math.sign((bx - ax) * (y - ay) - (by - ay) * (x - ax));
  const cross = (/** @type {number[][]} */ [a, b, c, d]) =>
    side(a, b, c) !== side(a, b, d) && side(c, d, a) !== side(c, d, b);
  const shapes = ORDERS.map((order) => order.map((place) => PLACES[place]));
  assert.equal(shapes.filter(cross).length / 2, 4);
  const loops = shapes.filter((points) => new Curve(points).selfIntersections().length > 0);
  assert.equal(loops.length / 2, 2);
  assert.ok(loops.every(cross));
  const answer = async (name) => (await load(name)).predict.options[(await load(name)).predict.answer];
  assert.equal(await answer("order-loop"), "four");
  assert.equal(await answer("equal-weights"), "at t = ¾");
  const weights = Curve.bernstein(3, 3 / 4);
  assert.equal(weights[2], weights[3]);
  const { POINTS } = await load("offset-cusp");
  const arch = new Curve(POINTS);
  const [velocity, second] = [arch.derivativeAt(0.5), arch.derivative().derivativeAt(0.5)];
  assert.deepEqual([velocity.x, velocity.y, second.x, second.y], [510, 0, 0, 2280]);
  assert.ok(Math.abs(510 ** 2 / 2280 - 114) < 0.1);
  assert.equal(await answer("offset-cusp"), "about 115 px");
});

const leaves = (node) => (node.halves ? node.halves.flatMap(leaves) : [node]);
