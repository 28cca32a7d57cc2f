// The tasks of the chapter on curves: not done at the start, done when it is done, and their own answers count.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { Curve, Path } from "casteljau";
import { fitOf, samplesOf } from "../../www/figures/lib/fitting.js";
import { discAt } from "../../www/figures/lib/taper.js";
import { applet, load, testTasks } from "./task-cases.js";
import { pointsOf } from "./reference.js";

const ARCH = pointsOf("60,400 160,40 480,40 600,400");
const HILL = pointsOf("70,300 160,40 400,60 610,430");
/** The places of the site's figure, and the orders that it offers. */
const PLACES = pointsOf("8,64 37,16 76,28 92,51");
const ORDERS = Array.from({ length: 256 }, (_, k) => [k >> 6, (k >> 4) & 3, (k >> 2) & 3, k & 3]).filter(
  (order) => new Set(order).size === 4,
);
const FIVE = pointsOf("10,72 30,18 56,64 84,14 118,58");
const LINE = pointsOf("30,42 50,42 70,42 90,42");
const SEVEN = pointsOf("70,330 90,120 250,110 330,200 430,300 560,380 600,160");
const points = (text) => ({ points: pointsOf(text) });
/** The chain of two cubics with its point after the joint moved. */
const after = (x, y) => ({ points: SEVEN.with(4, [x, y]) });
const S = points("60,400 600,400 60,60 600,60");
const TOP = new Curve(HILL).extrema().y[0];
const chosen = () => ({
  chosen: 0,
  places: PLACES,
  curve(k) {
    return new Curve(ORDERS[k].map((place) => this.places[place]));
  },
});
const inBasis = (matrix) => ({ basis: "matrix", matrix });
const spline = { ...points("60,380 170,110 300,330 420,90 610,300"), basis: "b-spline", whole: true };
const bezier = (handles) => ({ value: `cubic-bezier(${handles})` });

testTasks([
  ["half-height", { t: 0.5 }, [{ t: 0.69 }, { t: -0.71 }, { t: 0.25 }], { t: 0.71 }],
  [
    "half-pixel",
    { points: ARCH, segments: "4" },
    [
      { segments: "23" },
      { segments: "25" },
      { points: pointsOf("60,400 240,400 420,400 600,400"), segments: "1" }, // a straight line
    ],
    { points: ARCH, segments: "24" },
  ],
  [
    "top-180",
    points("80,430 335,250 590,430"),
    [
      points("80,430 335,160 590,430"), // 270 px
      points("80,430 335,790 590,430"), // below the line
      points("80,360 335,0 590,360"), // the ends have moved
    ],
    points("80,430 200,71 590,430"),
  ],
  ["equal-weights", { points: ARCH }, [{ t: 0.67 }, { t: 0.78 }, { t: 0 }], { t: 0.75 }],
  [
    "straight-matrix",
    { points: ARCH },
    [
      inBasis([...Curve.basisMatrix("bezier")]),
      { ...inBasis([...Curve.basisMatrix("bezier")]), points: pointsOf("60,400 240,400 420,400 600,400") }, // a line for these points only
      inBasis([0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0]), // not at constant speed
      inBasis([0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1]), // from P3 to P0
    ],
    inBasis([0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1, 1, 0, 0, 0]),
  ],
  [
    "level-tangent",
    { points: HILL, t: 0.75 },
    [{ t: 0.5 }, { t: 1 }, { t: Math.round(100 * TOP) / 100 + 0.03 }],
    { t: Math.round(100 * TOP) / 100 },
  ],
  [
    "order-loop",
    chosen,
    [
      { chosen: 2 },
      { chosen: 23 },
      { chosen: ORDERS.findIndex((each) => `${each}` === "0,2,1,3") }, // the legs cross, the curve does not
      { chosen: ORDERS.findIndex((each) => `${each}` === "1,3,0,2"), places: PLACES.with(0, [37, 60]) },
    ],
    { chosen: ORDERS.findIndex((each) => `${each}` === "1,3,0,2") },
  ],
  [
    "make-s",
    { points: ARCH },
    [
      points("60,400 300,60 600,400"), // a quadratic
      points("60,300 540,60 180,60 600,300"), // two inflections
      points("60,400 240,400 420,400 600,400"), // a straight line
    ],
    S,
  ],
  [
    "make-cusp",
    points("190,400 590,80 90,80 490,400"),
    [
      points("190,400 440,200 240,200 490,400"), // the loop is gone, without a cusp
      points("190,400 190,400 490,100 490,400"), // the speed is zero at an end
      points("190,400 700,400 0,400 490,400"), // a line that turns back
      points("190,400 490,100 190,100 500,400"), // an end has moved
    ],
    points("190,400 480,110 200,105 490,400"),
  ],
  [
    "match-shape",
    { points: ARCH },
    [
      points("110,370 30,60 520,30 560,330"),
      points("110,370 520,30 30,40 560,330"), // P1 and P2 exchanged
      points("110,370 -130,-620 440,-570 560,330"), // velocities instead of a third of them
    ],
    points("111,369 32,42 519,29 560,331"),
  ],
  [
    "inflection-amid",
    points("80,380 420,440 160,20 590,300"),
    [
      { points: ARCH },
      points("0,0 100,25 0,100 100,0"), // a second inflection at 0.8
      points("60,400 600,400 200,60 600,60"), // beside the middle
    ],
    S,
  ],
  [
    "cut-at-top",
    { points: HILL },
    [
      (e) => e.insertJoint(0.5),
      (e) => {
        e.insertJoint(0.5);
        e.points = e.points.with(2, [e.points[2][0], e.points[3][1]]).with(4, [e.points[4][0], e.points[3][1]]); // handles made level
      },
      (e) => Object.assign(e, { points: HILL.with(1, [160, 60]) }),
      (e) => {
        e.insertJoint(TOP - 0.05);
        e.insertJoint(0.9);
      },
    ],
    (e) => {
      e.insertJoint(TOP + 0.003);
      e.insertJoint(0.8);
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
    [
      points("80,390 207,210 463,210 590,390"), // half of the way
      points("80,390 335,30 335,30 590,390"), // all the way
      points("80,390 250,150 420,150 590,300"),
    ],
    points("80,390 250,150 420,150 590,390"),
  ],
  [
    "no-loop",
    () => ({ points: FIVE, family: "natural", tension: 0.5 }),
    [
      { family: "centripetal" }, // no points are close together
      { points: FIVE.with(2, [36, 17]), family: "catmull-rom" },
      { family: "natural" }, // a loop, too
      { family: "b-spline" },
      { family: "cardinal", tension: 0 }, // the same as Catmull–Rom
      { family: "cardinal", tension: 1 }, // corners
      { points: FIVE.with(1, [110, 30]), family: "centripetal" }, // the lines between the points cross, and every spline
    ],
    { points: FIVE.with(1, [52, 62]), family: "centripetal" },
  ],
  [
    "touch-with-spline",
    spline,
    [
      { points: spline.points.with(2, [330, 330]) },
      { basis: "natural" },
      { basis: "b-spline", points: spline.points.with(1, [300, 330]).with(3, [300, 330]) }, // three points in one place
      { points: spline.points.with(2, [170, 110]) }, // two
    ],
    { points: spline.points.with(2, [296, 101]) },
  ],
  [
    "fit-noise",
    () => ({
      noise: 1.5,
      exponent: 3,
      get fit() {
        return fitOf(samplesOf(this.noise), 2 ** this.exponent);
      },
    }),
    [
      { exponent: -2 }, // follows the noise
      { exponent: 0.5 }, // just below it
      { exponent: 2 }, // too coarse
      { exponent: 0, noise: 0 }, // another question
    ],
    { exponent: 0.75, noise: 1.5 },
  ],
  [
    "thirty-degrees",
    () => ({ points: LINE, first: 4, last: 16 }),
    [
      { last: 4 + 60 * Math.tan(Math.PI / 6) }, // the angle of the points on the normals
      { last: 36 },
      { first: 0, last: 60 }, // one disc covers the others
      { first: 4, last: 34, points: LINE.with(3, [90, 80]) }, // a bent line
    ],
    { points: LINE, first: 34, last: 4 },
  ],
  [
    "overshoot",
    bezier("0.25, 0.1, 0.25, 1"),
    [bezier("0.3, 3, 0.6, 1"), bezier(".3, 1.2, .6, 1"), bezier("0.25, 0.1, 0.25, 1.15")],
    bezier(".34, 1.6, .64, 1"),
  ],
]);

test("a spline through P2 counts wherever it passes: with all points on one line at any distances", async () => {
  const { check } = await load("touch-with-spline");
  const straight = applet({ ...spline, points: pointsOf("0,0 100,0 140,0 300,0 400,0") });
  assert.match(check(straight.figure).words, /^The distance from P2 to the spline is 0\.00 px\.$/);
  assert.equal(check(straight.figure).done, true);
});

test("task enough-pieces", async () => {
  const { check, reveal, POINTS: points } = await load("enough-pieces");
  const tree = (segments, error) => check({ points, tree: { segments, error } }).done;
  assert.deepEqual([tree(16, 1.64), tree(32, 0.41), tree(48, 0.3), tree(49, 0.3)], [false, true, true, false]);
  assert.equal(check({ points, tree: null }).done, false);
  const straight = points.map(([x], i) => [x + i, 300]);
  const { done, restore } = check({ points: straight, tree: { segments: 1, error: 0 } });
  assert.equal(done, false);
  const moved = { points: straight };
  restore(moved);
  assert.equal(moved.points, points);
  const element = { tolerance: "8" };
  reveal(element);
  const pieces = leaves(new Curve([60, 300, 60, 20, 620, 20, 600, 300]).subdivide(Number(element.tolerance)));
  const error = Math.max(...pieces.map(({ curve }) => curve.hausdorff(new Curve([curve.eval(0), curve.eval(1)]))));
  assert.equal(tree(pieces.length, error), true);
});

test("every task of the chapter that is checked has a test", async () => {
  const sections = new URL("../../www/curves/sections/", import.meta.url);
  const text = readdirSync(sections)
    .map((name) => readFileSync(new URL(name, sections), "utf8"))
    .join("\n");
  const used = Array.from(text.matchAll(/^::: task ([\w-]+)/gm), ([, name]) => name);
  const tests = ["curves-tasks", "curves-measuring-tasks"]
    .map((name) => readFileSync(new URL(`${name}.test.js`, import.meta.url), "utf8"))
    .join("\n");
  assert.ok(used.length >= 29, `${used.length}`);
  for (const name of used) {
    const { check, predict, answer } = await load(name);
    assert.ok(check || predict || answer, name);
    if (check) assert.match(tests, new RegExp(`^ *\\[?"${name}",|"task ${name}"`, "m"), name);
  }
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

test("the sides of a stroke of varying width touch its discs where the formula says", () => {
  const points = /** @type {[number, number][]} */ (pointsOf("30,42 45,30 75,30 90,42"));
  const path = Path.from(new Curve(points));
  const width = {
    stops: /** @type {[number, number][]} */ ([
      [0, 8],
      [1, 32],
    ]),
  };
  const outline = path.stroke(width, { cap: "round", tolerance: 1e-6 });
  for (const t of [0.2, 0.5, 0.8]) {
    const { contacts, center, radius } = discAt(points, [4, 16], t);
    assert.equal(contacts.length, 2);
    for (const contact of contacts) {
      assert.ok(Number(outline.nearest(contact)?.distance) < 1e-5, `t = ${t}`);
      assert.ok(Math.abs(Math.hypot(contact[0] - center[0], contact[1] - center[1]) - radius) < 1e-12);
    }
  }
  assert.deepEqual(discAt(points, [0, 100], 0.5).contacts, []);
});

const leaves = (node) => (node.halves ? node.halves.flatMap(leaves) : [node]);
