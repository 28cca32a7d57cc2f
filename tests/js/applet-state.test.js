// The state behind <bezier-applet>, without a page: fields, edits, figures, undo.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as commands from "#js/editor/commands.js";
import { FIELDS, jsonOf, stateOf } from "#js/editor/schema.js";
import { figureOf, nameOf } from "#js/editor/figure.js";
import { withText } from "#js/editor/import.js";
import { History } from "#js/editor/history.js";
import { snapped, turnedBy15 } from "#js/editor/snapping.js";
import {
  BASES,
  firstState,
  isHome,
  MAX_POINTS,
  allPointsToggled,
  toPlane,
  withHome,
  withPoints,
  withView,
  zoomed,
} from "#js/editor/state.js";
import { generator } from "#js/editor/random.js";
import { near, pointsOf } from "./reference.js";

/** A chain of so many random cubics, some points waiting. */
function randomState(seed, segments, rest = 0) {
  const points = Array.from({ length: 3 * segments + 1 + rest }, () => [0, 0]);
  return commands.randomized(withPoints(firstState(), points), seed);
}

test("every field: written, parsed and put it is the same, through attributes and through JSON", () => {
  for (let seed = 0; seed < 50; seed++) {
    const random = generator(seed);
    let state = randomState(seed, 1 + (seed % 4), seed % 3);
    state = {
      ...state,
      t: random(),
      basis: BASES[seed % BASES.length],
      matrix: Array.from({ length: 16 }, random),
      degree: seed % 5 ? 1 + (seed % 7) : "n",
      joints: ["c1", "g2"],
      tolerance: 0.1 + random(),
      offset: 100 * random() - 50,
    };
    state = { ...state, layers: new Set(["tree", "comb"]), shown: Math.min(4, state.points.length) };
    state = zoomed(state, 1 + 5 * random(), [100, 100]);
    let read = firstState();
    for (const { put, parse, write } of Object.values(FIELDS))
      if (write(state) !== "") read = put(read, parse(write(state)));
    assert.deepEqual({ ...read, view: null }, { ...state, view: null });
    near(Object.values(read.view), Object.values(state.view));
    assert.deepEqual(jsonOf(stateOf(JSON.parse(JSON.stringify(jsonOf(read))))), jsonOf(read));
  }
});

test("what is as at first is not written", () => {
  assert.deepEqual(Object.keys(jsonOf(firstState())), ["points"]);
  assert.deepEqual(stateOf(jsonOf(firstState())), firstState());
});

test("refusals name the field and what came", () => {
  const refused = (/** @type {object} */ json) => {
    try {
      stateOf(json);
      return "nothing";
    } catch (/** @type {any} */ error) {
      return `${error.name} ${error.message}`;
    }
  };
  const refusals = [
    [{ points: pointsOf("1,2 3,NaN") }, "RangeError y of points[1]: expected a finite number, got NaN"],
    [
      { points: pointsOf("1,2 3,2e6") },
      "RangeError points[1]: expected coordinates from −1000000 to 1000000, got 2000000",
    ],
    [{ points: Array(MAX_POINTS + 1).fill([0, 0]) }, "RangeError points: expected 2 to 500 points, got 501"],
    [{ t: 1.5 }, "RangeError t: expected a number from 0 to 1, got 1.5"],
    [{ t: 1.5, show: ["extrapolation"] }, "nothing"], // there t goes on
    [{ t: 1.6, show: ["extrapolation"] }, "RangeError t: expected a number from -0.5 to 1.5, got 1.6"],
    [{ visiblePoints: 8 }, "RangeError visiblePoints: expected a number from 2 to 7, got 8"],
    [{ matrix: [1] }, "RangeError matrix: expected 16 numbers, got 1"],
    [{ joints: { 0: "g1" } }, "TypeError joints: expected an array, got Object"],
    [[], "TypeError state: expected an object with points, got an array of 0"],
  ];
  for (const [json, words] of /** @type {[object, string][]} */ (refusals)) assert.equal(refused(json), words);
});

test("a cut leaves the curve and healing it gives the points back, in every chain", () => {
  for (let seed = 0; seed < 60; seed++) {
    const [segments, degree] = [1 + (seed % 4), 1 + (seed % 5)];
    const random = generator(seed);
    const count = segments * degree + 1 + (seed % degree);
    const points = Array.from({ length: count }, () => [600 * random(), 400 * random()]);
    const state = { ...withPoints(firstState(), points), degree, segment: seed % segments, t: 0.1 + 0.8 * random() };
    const cut = commands.inserted(state);
    assert.equal(cut.points.length, points.length + degree);
    const whole = figureOf(state).pieces[state.segment].curve;
    const [a, b] = [0, 1].map((k) => figureOf(cut).pieces[state.segment + k].curve);
    for (const t of [0, 0.3, 0.7, 1]) {
      near(a.eval(t), whole.eval(t * state.t));
      near(b.eval(t), whole.eval(state.t + t * (1 - state.t)));
    }
    const healed = commands.removed(cut, (state.segment + 1) * degree);
    near(healed.points.flat(), points.flat(), 1e-6);
  }
});

test("waiting points stay behind the chain, hidden ones are held and stay hidden", () => {
  const state = commands.withJoints(randomState(5, 2, 2), ["c1"]);
  const moved = commands.withPointAt(state, 3, [100, 100]);
  assert.deepEqual(moved.points.slice(7), state.points.slice(7));
  assert.deepEqual(commands.withPointAt(state, 8, [1, 2]).points[8], [1, 2]);
  const few = { ...state, shown: 4 };
  assert.equal(commands.withPointAt(few, 2, [5, 5]).shown, 4);
  assert.deepEqual(commands.modesOf(few), []);
  assert.equal(allPointsToggled(few).shown, 9);
  assert.equal(commands.appended(few, [1, 1]).shown, 10, "a new point is to be seen");
});

test("joints broken by hand are those beside the point", () => {
  const state = commands.withJoints(randomState(1, 4), ["c1"]);
  assert.deepEqual(commands.broken(state, 4).joints, ["free", "c1", "c1"]);
  assert.deepEqual(commands.broken(state, 6).joints, ["c1", "free", "c1"]);
  assert.equal(commands.broken(state, 0), state);
});

test("undo and redo: a gesture is one step, what passes is none, a new step ends what could be done again", () => {
  /** @type {History<any>} */
  const history = new History(["view", "segment"], ["view"]);
  const states = Array.from({ length: 5 }, (_, i) => ({ ...firstState(), t: i / 10 }));
  history.begin(states[0]);
  history.begin(states[1]);
  assert.ok(history.commit(states[2]));
  assert.equal(history.commit(states[2]), false);
  history.begin(states[2]);
  history.commit({ ...states[2], segment: 1, view: { x: 0, y: 0, width: 1, height: 1 } });
  const looking = { ...states[2], view: { x: 5, y: 5, width: 67, height: 48 } };
  const back = history.undo(looking);
  assert.deepEqual([back.t, back.view.x, history.canUndo], [0, 5, false], "where one looks stays");
  assert.equal(history.undo(back), back);
  assert.equal(history.redo(back).t, 0.2);
  history.undo(states[2]);
  history.begin(states[0]);
  history.commit(states[3]);
  assert.equal(history.canRedo, false);
  history.begin(states[3]);
  const before = history.rollback(looking);
  assert.deepEqual([before.t, before.view.x], [states[3].t, 5], "here, too");
  assert.equal(history.commit(states[4]), false);
});

test("enlarging keeps the place it is about, and the proportions", () => {
  const state = zoomed(firstState(), 8, [100, 50]);
  near(toPlane(state, [100, 50]), [100, 50]);
  assert.equal(state.view.width / state.view.height, 670 / 480);
  assert.ok(!isHome(state) && isHome(withHome(state)));
  const fitted = withView(firstState(), { x: 10, y: 10, width: 67, height: 100 });
  assert.ok(Math.abs(fitted.view.width / fitted.view.height - 670 / 480) < 1e-12 && fitted.view.height === 100);
  assert.ok(zoomed(firstState(), 1e30, [0, 0]).view.width > 0);
});

test("places to click into: the mirror image, the line; 15° about the anchor", () => {
  const state = withPoints(firstState(), pointsOf("0,0 50,0 100,100 200,100 300,300 400,0 500,0"));
  assert.deepEqual(snapped(state, 4, [303, 101], 1), [300, 100]);
  assert.deepEqual(snapped(state, 4, [370, 103], 1), [370, 100]);
  assert.deepEqual(snapped(state, 4, [370, 110], 1), [370, 110], "not near enough");
  assert.deepEqual(snapped(state, 4, [370, 110], 3), [370, 100], "it is when the picture is smaller");
  assert.deepEqual(snapped(state, 5, [100, 100], 1), [100, 100]);
  near(turnedBy15(state, 1, [50, 3], [50, 0]), [50, 0]);
  const [x, y] = turnedBy15(state, 4, [300, 195], [300, 300]);
  near([Math.atan2(y - 100, x - 200)], [Math.PI / 4]);
});

test("names: P0, P1, b with its index below", () => {
  const names = { P0: "P12", P1: "P13", b0: "b₁₂", p0: "p12", none: "P12" };
  for (const [labels, name] of Object.entries(names)) assert.equal(nameOf(/** @type {any} */ (labels), 12), name);
});

test("a path of lines, quadratics and arcs becomes cubics that meet", () => {
  const state = withText(firstState(), "M10 10 L100 10 Q200 10 200 100 A50 50 0 0 1 100 200 Z M0 0 L5 5");
  const { spline, pieces } = figureOf(state);
  assert.equal(spline?.segmentCount, pieces.length);
  const joints = [0, 3, 6, state.points.length - 1].flatMap((index) => state.points[index]);
  near(joints, [10, 10, 100, 10, 200, 100, 10, 10]);
  assert.throws(() => withText(firstState(), "nonsense"), /^RangeError: This is no figure: points: expected pairs/);
});

test("no edit makes more points than can be read back", () => {
  const points = Array.from({ length: MAX_POINTS }, (_, i) => [i, i]);
  const full = withPoints(firstState(), points);
  const refusal = { name: "RangeError", message: /^points: expected at most 500, got 50[13]$/ };
  assert.throws(() => commands.appended(full, [1, 2]), refusal);
  assert.throws(() => commands.inserted(full, 0.5), refusal);
  assert.equal(commands.removed(full, 3).points.length, MAX_POINTS - 3);
});
