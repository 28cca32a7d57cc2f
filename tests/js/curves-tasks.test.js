// The tasks of the chapter on curves: not done at the start, done when it is done, and their own answers count.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve } from "casteljau";
import { load, testTasks } from "./task-cases.js";
import { pointsOf } from "./reference.js";

const ARCH = pointsOf("60,400 160,40 480,40 600,400");
const HILL = pointsOf("70,300 160,40 400,60 610,430");
/** The places of the site's figure, and the orders that it offers. */
const PLACES = pointsOf("8,64 37,16 76,28 92,51");
const ORDERS = Array.from({ length: 256 }, (_, k) => [k >> 6, (k >> 4) & 3, (k >> 2) & 3, k & 3]).filter(
  (order) => new Set(order).size === 4,
);
const SEVEN = pointsOf("70,330 90,120 250,110 330,200 430,300 560,380 600,160");
const points = (text) => ({ points: pointsOf(text) });
/** The chain of two cubics with its point after the joint moved. */
const after = (x, y) => ({ points: SEVEN.with(4, [x, y]) });
const S = points("60,400 600,400 60,60 600,60");
const TOP = new Curve(HILL).extrema().y[0];
const chosen = { chosen: 0, curve: (k) => new Curve(ORDERS[k].map((place) => PLACES[place])) };
const inBasis = (matrix) => ({ basis: "matrix", matrix });
const spline = { ...points("60,380 170,110 300,330 420,90 610,300"), basis: "b-spline", whole: true };
const bezier = (handles) => ({ value: `cubic-bezier(${handles})` });

testTasks([
  ["half-height", { t: 0.5 }, [{ t: 0.69 }, { t: -0.71 }], { t: 0.71 }],
  ["half-pixel", { points: ARCH, segments: "4" }, [{ segments: "23" }, { segments: "25" }], { segments: "24" }],
  [
    "top-180",
    points("80,420 335,200 590,420"),
    [points("80,420 335,240 590,420"), points("80,420 335,60 590,300")],
    points("80,420 200,61 590,420"),
  ],
  ["equal-weights", { points: ARCH }, [{ t: 0.67 }, { t: 0.78 }, { t: 0 }], { t: 0.75 }],
  [
    "straight-matrix",
    { points: ARCH },
    [inBasis([...Curve.basisMatrix("bezier")]), inBasis([0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0])],
    inBasis([0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1, 1, 0, 0, 0]),
  ],
  ["level-tangent", { points: HILL, t: 0.75 }, [{ t: 0.5 }, { t: 1 }], { t: Math.round(100 * TOP) / 100 }],
  [
    "order-loop",
    chosen,
    [{ chosen: 2 }, { chosen: 23 }],
    { chosen: ORDERS.findIndex((each) => `${each}` === "1,3,0,2") },
  ],
  ["make-s", { points: ARCH }, [points("60,400 300,60 600,400"), points("60,300 540,60 180,60 600,300")], S],
  ["match-shape", { points: ARCH }, [points("110,370 30,60 520,30 560,330")], points("111,369 32,42 519,29 560,331")],
  ["inflection-amid", points("80,380 420,440 160,20 590,300"), [{ points: ARCH }], S],
  [
    "cut-at-top",
    { points: HILL },
    [(e) => e.insertJoint(0.5)],
    (e) => {
      e.points = HILL;
      e.insertJoint(TOP + 0.003);
    },
  ],
  [
    "time-ratio",
    { points: SEVEN },
    [
      after(410, 290), // C1 at equal durations
      after(370, 245), // half as long instead of twice
      after(490, 385), // 5 px away
      { points: SEVEN.slice(0, 4) },
      { points: SEVEN.with(2, [330, 200]).with(4, [330, 200]) },
    ],
    after(492, 383),
  ],
  [
    "aligned-only",
    { points: SEVEN },
    [after(410, 290), after(426, 308), after(290, 155), { points: SEVEN.slice(0, 4) }],
    after(490, 382),
  ],
  [
    "raise-degree",
    points("80,390 335,30 335,30 590,390"),
    [points("80,390 207,210 463,210 590,390")],
    points("80,390 250,150 420,150 590,390"),
  ],
  [
    "touch-with-spline",
    spline,
    [{ points: spline.points.with(2, [330, 330]) }, { basis: "natural" }],
    { basis: "b-spline", points: spline.points.with(2, [296, 101]) },
  ],
  [
    "overshoot",
    bezier("0.25, 0.1, 0.25, 1"),
    [bezier("0.3, 3, 0.6, 1"), bezier(".3, 1.2, .6, 1")],
    bezier(".34, 1.6, .64, 1"),
  ],
]);

test("task enough-pieces", async () => {
  const { check, reveal, POINTS: points } = await load("enough-pieces");
  const tree = (segments, error) => check({ points, tree: { segments, error } }).done;
  assert.deepEqual([tree(16, 1.64), tree(32, 0.41), tree(48, 0.3), tree(49, 0.3)], [false, true, true, false]);
  assert.equal(check({ points, tree: null }).done, false);
  assert.equal(check({ points: points.with(1, [60, 60]), tree: { segments: 32, error: 0.41 } }).done, false);
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
