// What the layers of <bezier-applet> find, against closed forms and definitions.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve } from "#js/index.js";
import { figureOf } from "#js/editor/figure.js";
import { nameAt, namesOf } from "#js/layers/names.js";
import { deviation, treeOf } from "#js/layers/halving.js";
import { envelopeLines } from "#js/layers/envelope.js";
import { combOf, pointsAndDirections } from "#js/layers/directions.js";
import { weightsAt } from "#js/layers/weights.js";
import { BASES } from "#js/editor/state.js";
import { derived, stateWith } from "./layers-page.js";
import { near, pointsOf } from "./reference.js";

/** y = x² for x from −1 to 1. */
const PARABOLA = new Curve([-1, 1, 0, -1, 1, 1]);

/** The curve's middle part turns back on itself and comes to a point at t = ½. */
const CUSP = new Curve([100, 400, 560, 100, 100, 100, 560, 400]);

test("the weights of every basis put the point where the curve is", () => {
  for (const basis of BASES)
    for (const degree of basis === "bezier" || basis === "b-spline" ? [1, 2, 3, 5] : [3])
      for (const t of [-0.4, 0, 0.3, 1, 1.5]) {
        const state = stateWith({ basis, degree, t, segment: 0 });
        const figure = figureOf(state);
        const { flat, values } = weightsAt(figure, state);
        const sum = (of) => [...values].reduce((all, value, i) => all + value * of(i), 0);
        const { x, y } = figure.pieces[0].curve.eval(t);
        const sums = [sum(() => 1), sum((i) => flat[2 * i]), sum((i) => flat[2 * i + 1])];
        near(sums, [1, x, y], 1e-12, `${basis} of degree ${degree} at ${t}`);
      }
});

test("the weights of a cubic at ½ are 1, 3, 3, 1 eighths; those of a uniform B-spline at 0 are 1, 4, 1, 0 sixths", () => {
  assert.deepEqual([...derived("weights", { t: 0.5 }).data.values], [0.125, 0.375, 0.375, 0.125]);
  const { values } = derived("weights", { basis: "b-spline", t: 0 }).data;
  near(values, [1 / 6, 4 / 6, 1 / 6, 0], 1e-15);
  const five = derived("weights", { basis: "b-spline", degree: 2, t: 0 }).data.values;
  near(five, [1 / 2, 1 / 2, 0], 1e-15);
});

test("the comb's teeth are the curvature, to the outer side: 2 at the parabola's vertex, below it", () => {
  const { teeth, sharpest } = combOf([PARABOLA], 4, 0.1, 10);
  near(sharpest, 2, 1e-12);
  near(teeth[0].subarray(8, 12), [0, 0, 0, -0.2]);
  near(teeth[0].subarray(12, 16), [0.5, 0.25, 0.55, 0.2]); // slope 1, curvature 1/√2
});

test("at a cusp the teeth have an end", () => {
  const { teeth, sharpest } = combOf([CUSP], 48, 4000, 87);
  assert.equal(sharpest, Infinity);
  for (let i = 0; i < teeth[0].length; i += 4) {
    const [x, y, tipX, tipY] = teeth[0].subarray(i, i + 4);
    assert.ok(Math.hypot(tipX - x, tipY - y) <= 87.000001);
  }
});

test("every string touches the curve: the point at t divides it as t does, and it has the tangent's direction", () => {
  const curve = new Curve([70, 330, 110, 90, 235, 120, 325, 230, 400, 20]);
  const strings = envelopeLines(curve, 16);
  for (let k = 0; k <= 16; k++) {
    const [ax, ay, bx, by] = strings.subarray(4 * k, 4 * k + 4);
    const t = k / 16;
    const at = curve.eval(t);
    const slope = curve.derivativeAt(t);
    near(at, [ax + t * (bx - ax), ay + t * (by - ay)]);
    const length = Math.hypot(bx - ax, by - ay) * Math.hypot(slope.x, slope.y);
    near((bx - ax) * slope.y - (by - ay) * slope.x, 0, 1e-6 * length);
  }
});

test("points and unit tangents, also where the derivative vanishes", () => {
  const [x, y, tx, ty] = pointsAndDirections(CUSP, [0.5]);
  assert.deepEqual([x, y], [330, 175]);
  near(Math.hypot(tx, ty), 1, 1e-12);
  const flat = pointsAndDirections(PARABOLA, [0.75]); // x = ½, slope 1
  near(flat.slice(2, 4), [Math.SQRT1_2, Math.SQRT1_2]);
  assert.deepEqual([...pointsAndDirections(new Curve([5, 5, 5, 5, 5, 5]), [0.5])], [5, 5, 0, 0]);
});

test("the error of an even polyline: on y = x² the sagitta h²/4 over √(1 + slope²) of the flattest chord", () => {
  for (const n of [2, 4, 10]) {
    const h = 2 / n; // the width of a step in x; the chord from 0 to h has the slope h
    const wanted = h ** 2 / 4 / Math.hypot(1, h);
    const even = Float64Array.from({ length: n + 1 }, (_, k) => k / n);
    near(deviation(PARABOLA, even), wanted, 1e-4 * wanted, `${n} steps`);
  }
  const { data, words } = derived("segments", { points: pointsOf("0,0 100,200 200,0"), degree: 2, segments: 2 });
  near(data.error, 25 / Math.SQRT2, 0.0005); // 25 above the middle of a chord of slope 1
  assert.match(words, /2 segments/);
});

test("the error is that of the whole: no dense sample is farther, one is as far", () => {
  const curve = new Curve([70, 330, 600, 90, -200, 120, 325, 230]);
  const ts = [0, 0.2, 0.45, 0.8, 1];
  let farthest = 0;
  for (let k = 0; k + 1 < ts.length; k++) {
    const chord = new Curve([Object.values(curve.eval(ts[k])), Object.values(curve.eval(ts[k + 1]))]);
    for (let i = 1; i < 1000; i++)
      farthest = Math.max(farthest, chord.nearest(curve.eval(ts[k] + (i / 1000) * (ts[k + 1] - ts[k]))).distance);
  }
  near(deviation(curve, ts), farthest, 0.005);
});

test("recursive halving stops where D1 − D2 < tolerance, says how many lines there are and how far off they are", () => {
  const state = stateWith({ layers: ["tree"], tolerance: 0.5 });
  const figure = figureOf(state);
  const leavesOf = (curve) => {
    const p = curve.controlPoints();
    let polygon = 0;
    for (let i = 2; i < p.length; i += 2) polygon += Math.hypot(p[i] - p[i - 2], p[i + 1] - p[i - 1]);
    if (polygon - Math.hypot(p.at(-2) - p[0], p.at(-1) - p[1]) < 0.5) return [curve];
    return curve.halve().flatMap(leavesOf);
  };
  const leaves = figure.pieces.flatMap(({ curve }) => leavesOf(curve));
  const { segments, error } = treeOf(figure, state);
  assert.equal(segments, leaves.length);
  const chord = (curve) => new Curve([...curve.controlPoints().subarray(0, 2), ...curve.controlPoints().subarray(-2)]);
  const wanted = Math.max(...leaves.map((leaf) => leaf.hausdorff(chord(leaf))));
  near(error, wanted, 0.005 * Math.min(1, wanted));
});

test("a tolerance that would take too long is raised, and the raised one is reported", () => {
  const { data, words } = derived("tree", { tolerance: 1e-9 });
  assert.ok(data.segments < 500, `${data.segments} segments`);
  assert.ok(data.tolerance > 1e-4);
  assert.match(words, new RegExp(`< ${Number(data.tolerance.toPrecision(3))}:`));
});

const TIMES = ({ ts }) => ts.flat();
const flat = (curve) => [...curve.controlPoints()];
/** A layer, points with what else differs from the first state, numbers of its data, what they are, and its words. @type {any[][]} */
const FOUND = [
  [
    "extrema",
    { points: "100,400 200,200 300,400", degree: 2 },
    ({ ts, strokes }) => [...ts.flat(), ...strokes],
    [0.5, 200, 300, 1, 0],
    "Extrema at t = 0.500",
  ],
  [
    "bounds",
    { points: "100,400 200,200 300,400", degree: 2 },
    ({ boxes }) => boxes.flatMap(({ min, max }) => [min.x, min.y, max.x, max.y]),
    [100, 300, 300, 400],
  ],
  ["inflections", { points: "100,100 300,100 100,300 300,300" }, TIMES, [0.5], "Inflections at t = 0.500 (serpentine)"],
  ["inflections", { points: "100,300 150,100 250,100 300,300" }, TIMES, [], "Inflections: none inside (arch)"],
  [
    "nearest",
    { points: "0,0 100,0 100,100", degree: 1, pointer: [130, 25] },
    ({ found }) => [found.point.x, found.point.y],
    [100, 25],
    "Nearest point: t = 0.250 on piece 2, 30 px away",
  ],
  ["offset", { points: "0,50 100,50", degree: 1, offset: 30 }, ({ curves }) => curves.flatMap(flat), [0, 80, 100, 80]],
  [
    "ticks",
    { points: "0,0 100,0 100,300", degree: 1, ticks: 4 },
    ({ across }) => across.filter((_, i) => i % 4 < 2),
    [0, 0, 100, 0, 100, 100, 100, 200, 100, 300],
    "Length 400 px, a tick every 100 px",
  ],
  [
    "extrapolation",
    { points: "0,0 100,0", degree: 1 },
    (curves) => curves.flatMap(flat),
    [-50, 0, 0, 0, 100, 0, 150, 0],
  ],
];

test("extrema, boxes, inflections, nearest points, offsets, ticks and what lies beyond the ends, by closed forms", () => {
  for (const [layer, { points, ...changes }, numbersOf, numbers, told] of FOUND) {
    const { data, words } = derived(layer, { points: pointsOf(points), ...changes });
    near(numbersOf(data), numbers, 1e-12, layer);
    if (told) assert.equal(words, told);
  }
  assert.equal(
    derived("nearest", { points: pointsOf("0,0 100,0 100,100"), degree: 1 }).data,
    null,
    "without a pointer",
  );
});

test("beside the exact box there is that of the control points", () => {
  const { pointBoxes } = derived("bounds", { points: pointsOf("90,400 150,90 460,80 590,410") }).data;
  assert.deepEqual(pointBoxes, [[90, 80, 590, 410]]);
});

test("the hull of a B-spline is that of its own points, of other bases that of the Bézier form", () => {
  const points = pointsOf("0,0 0,300 300,300 300,0");
  assert.equal(derived("hull", { points, basis: "b-spline" }).data[0].length, 8);
  assert.deepEqual(new Set(derived("hull", { points, basis: "b-spline" }).data[0]), new Set([0, 300]));
  const form = derived("hull", { points, basis: "catmull-rom" });
  assert.deepEqual([...form.data[0]], [...form.figure.pieces[0].curve.hull()]);
});

test("names on the construction, as the texts write them", () => {
  assert.equal(nameAt("P0", 1, 0, false), "P01");
  assert.equal(nameAt("P1", 1, 0, false), "P12");
  assert.equal(nameAt("P1", 2, 0, false), "P1223");
  assert.equal(nameAt("P1", 2, 1, false), "P2334");
  assert.equal(nameAt("P1", 3, 0, true), "B(t)");
  assert.equal(nameAt("b0", 1, 0, false), "b₀¹");
  assert.equal(nameAt("b0", 3, 10, true), "b₁₀³");
  assert.equal(nameAt("p0", 2, 0, false), "p01-12");
  assert.equal(nameAt("p0", 3, 0, true), "B(t)");
  assert.equal(nameAt("P0", 1, 9, false), "P9,10");
});

test("with the halves their points are called q and r, and the one at t both", () => {
  const state = stateWith({ layers: ["halves", "names"], labels: "p0", t: 0.25 });
  const figure = figureOf(state);
  const names = namesOf(figure, state);
  const texts = names.map(({ text }) => text);
  assert.deepEqual(texts, ["q0", "q1", "q2", "q3", "r0", "r1", "r2", "r3"]);
  const { x, y } = figure.pieces[0].curve.eval(0.25);
  for (const { at } of names.slice(3, 5)) assert.deepEqual(Array.from(at), [x, y]);
  assert.deepEqual(namesOf(figure, { ...state, labels: "none" }), []);
});

test("the names of both points at the cut stand on the side of their half", () => {
  const state = stateWith({ layers: ["halves", "names"], labels: "p0", t: 0.5 });
  const names = namesOf(figureOf(state), state);
  const named = (text) => /** @type {(typeof names)[number]} */ (names.find((name) => name.text === text));
  for (const [cut, neighbour] of Object.entries({ q3: "q2", r0: "r1" })) {
    const { at, away } = named(cut);
    const [dx, dy] = [named(neighbour).at[0] - at[0], named(neighbour).at[1] - at[1]];
    assert.ok(away[0] * dx + away[1] * dy > 0, `${cut} is on the side of ${neighbour}`);
  }
});
