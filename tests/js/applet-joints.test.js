// What <bezier-applet> does with its points, without a page: joints that are held, bases and degrees, points that are removed.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as commands from "#js/editor/commands.js";
import { FIELDS } from "#js/editor/schema.js";
import { continuityOf, figureOf } from "#js/editor/figure.js";
import { jointsOf } from "#js/editor/joints.js";
import { BASES, firstState, withPoints } from "#js/editor/state.js";
import { near, pointsOf } from "./reference.js";

const stateWith = (points, changes = {}) => ({ ...withPoints(firstState(), points), ...changes });
const flat = (curve) => [...curve.controlPoints()];

const THREE = pointsOf("60,300 100,100 200,100 250,250 300,380 380,400 430,240 470,100 560,120 610,300");
test("automatic handles follow their neighbours", () => {
  const state = commands.withJoints(stateWith(THREE), ["auto"]);
  const moved = commands.withPointAt(state, 6, [state.points[6][0], state.points[6][1] - 60]);
  assert.notDeepEqual(moved.points[2], state.points[2], "the handles of P3 depend on P6");
  assert.deepEqual(moved.points[3], state.points[3]);
  assert.ok(continuityOf(figureOf(moved)).every(({ g1 }) => g1));
});

test("a move makes one spline: the figure and the next move use that of the last one", () => {
  const state = stateWith(THREE, { joints: ["g1"] });
  assert.equal(figureOf(state).spline, commands.chainOf(state)?.spline);
  const moved = commands.withPointAt(state, 4, [390, 380]);
  assert.equal(figureOf(moved).spline, commands.chainOf(moved)?.spline);
  assert.notEqual(figureOf(moved).spline, figureOf(state).spline);
  for (const degree of [1, 2, 9]) {
    const other = figureOf({ ...moved, degree });
    assert.deepEqual(
      other.pieces.map(({ curve }) => curve.degree),
      Array(Math.floor(9 / degree)).fill(degree),
    );
    assert.deepEqual([...other.pieces[0].curve.controlPoints().slice(0, 2)], moved.points[0]);
  }
  const few = { ...moved, shown: 7 };
  assert.deepEqual([figureOf(few).pieces.length, commands.chainOf(few)?.spline.segmentCount], [2, 3]);
  assert.deepEqual([figureOf(few).pieces.length, commands.modesOf(few)], [2, ["g1"]]);
});

test("one joint can be held and another be free", () => {
  const state = commands.withJoint(stateWith(THREE), 2, "c1");
  assert.deepEqual(state.joints, ["free", "c1"]);
  const before = continuityOf(figureOf(state)).map(({ c1 }) => c1);
  assert.deepEqual(before, [false, true]);
  const moved = commands.withPointAt(state, 4, [320, 450]);
  const after = continuityOf(figureOf(moved)).map(({ g1, c1 }) => g1 && c1);
  assert.deepEqual(after, [false, true]);
});

/** P2, P3 and P4, and what is true at P3: the verdict, the angle, the ratio of the tangents' lengths. @type {any[][]} */
const JOINTS = [
  ["100,200 200,200 300,200", "C1", "0°", "1 : 1"],
  ["100,200 200,200 250,200", "G1", "0°", "1 : 0.5"],
  ["100,200 200,200 200,300", "C0", "90°", "1 : 1"],
  ["200,200 200,200 200,300", "C0", null, "no length on one side"],
];

test("what is true at a joint: continuity, angle, ratio of the tangents", () => {
  for (const [points, verdict, angle, ratio] of JOINTS) {
    const [joint] = jointsOf(figureOf(stateWith(pointsOf(`0,200 50,200 ${points} 350,300 400,400`))));
    assert.deepEqual([joint.verdict, joint.ratio, joint.at], [verdict, ratio, "P3"]);
    if (angle) assert.equal(joint.angle, angle);
  }
});

const SIX = pointsOf("100,300 150,100 300,100 350,300 450,420 550,300");
/** What each basis makes of six points: the number of pieces, and where the first begins. */
const PIECES = {
  bezier: [1, [100, 300]],
  hermite: [1, [100, 300]],
  "b-spline": [3, [(100 + 4 * 150 + 300) / 6, (300 + 4 * 100 + 100) / 6]],
  "catmull-rom": [3, [150, 100]],
  natural: [5, [100, 300]],
  centripetal: [5, [100, 300]],
  matrix: [1, [100, 300]],
};

test("every basis on the same points: pieces, their start, and the matrix that gives their points", () => {
  assert.deepEqual(Object.keys(PIECES).sort(), [...BASES].sort());
  for (const [basis, [count, start]] of Object.entries(PIECES)) {
    const { pieces, matrix } = figureOf(stateWith(SIX, { basis }));
    assert.equal(pieces.length, count, basis);
    near(flat(pieces[0].curve).slice(0, 2), start, 1e-12, basis);
    if (!matrix) continue;
    // [t³ t² t 1] · M · P at t = ½ is the point of the Bézier form there.
    const weights = [0, 1, 2, 3].map((i) => matrix[i] / 8 + matrix[4 + i] / 4 + matrix[8 + i] / 2 + matrix[12 + i]);
    const point = [0, 1].map((axis) => weights.reduce((sum, weight, i) => sum + weight * SIX[i][axis], 0));
    near(pieces[0].curve.eval(0.5), point, 1e-12, basis);
  }
});

test("Hermite: the tangents are P1 − P0 and P3 − P2, and a cut leaves the curve", () => {
  const state = stateWith(pointsOf("100,300 200,100 400,200 500,300"), { basis: "hermite" });
  const figure = figureOf(state);
  near(flat(figure.pieces[0].curve), [100, 300, 100 + 100 / 3, 300 - 200 / 3, 500 - 100 / 3, 300 - 100 / 3, 500, 300]);
  const cut = commands.inserted(state, 0.4);
  assert.equal(cut.points.length, 7);
  near([figureOf(cut).spline?.length()], [figure.spline?.length()], 1e-8);
});

test("other degrees: points that do not fill a curve wait; of degree n there is one curve", () => {
  const of = (degree) => {
    const { pieces, degree: got, kinds } = figureOf({ ...firstState(), degree });
    return [pieces.length, got, kinds.join(" ")];
  };
  assert.deepEqual(of(1), [6, 1, "on on on on on on on"]);
  assert.deepEqual(of(2), [3, 2, "on off on off on off on"]);
  assert.deepEqual(of(5), [1, 5, "on off off off off on wait"]);
  assert.deepEqual(of("n"), [1, 6, "on off off off off off on"]);
  const longer = commands.appended({ ...firstState(), degree: "n" }, [300, 300]);
  assert.deepEqual([figureOf(longer).degree, longer.points.length], [7, 8]);
  const quadratics = commands.withJoints({ ...firstState(), degree: 2 }, ["c1"]);
  assert.ok(continuityOf(figureOf(commands.withPointAt(quadratics, 1, [120, 70]))).every(({ c1 }) => c1));
});

test("without an end goes its segment; without a handle, it lies on the chord; bare, the point alone", () => {
  const state = stateWith(THREE);
  const shorter = commands.removed(state, 9);
  assert.deepEqual(shorter.points, THREE.slice(0, 7));
  near(commands.removed(shorter, 1).points[1], [60 + 190 / 3, 300 - 50 / 3]);
  const bare = commands.removed(shorter, 1, true);
  assert.deepEqual(bare.points, THREE.slice(0, 7).toSpliced(1, 1));
  assert.deepEqual(figureOf(bare).kinds, ["on", "off", "off", "on", "wait", "wait"]);
});

test("what cannot be removed or cut is refused", () => {
  const state = stateWith(THREE.slice(0, 4));
  assert.throws(() => commands.removed(state, 0), /^RangeError: remove: expected .* only segment/);
  const spline = { ...state, basis: /** @type {const} */ ("b-spline") };
  assert.throws(() => commands.inserted(spline), /^RangeError: insert: expected the basis bezier or hermite/);
});

/** Attributes that cannot be used. */
const UNUSABLE = {
  points: ["", "1", "1,2", "a,b c,d", "1,2 3,NaN", "1,2 3,Infinity", "1e9,0 0,0", "<script>", "1 2 3"],
  visiblePoints: ["1", "99", "4.5", "x"],
  joints: ["g7", "g1 x"],
  basis: ["", "Bezier", "constructor", "__proto__"],
  degree: ["0", "65", "2.5", "x", ""],
  weights: ["1 2 3", "x", "1 1 1 0 1 1 1", "1 1 1 1 1 1 1e4"],
  matrix: ["1 2 3", "", "a b c d e f g h i j k l m n o p"],
  t: ["2", "-1", "x", "", "NaN"],
  show: ["polygon x", "hasOwnProperty"],
  labels: ["Q"],
  tolerance: ["0", "-3", "x"],
  segments: ["0", "1.5", "1e9"],
  offset: ["1e9", "x"],
  ticks: ["0", "x"],
  view: ["1 2 3", "0 0 0 0", "0 0 -1 5", "a b c d", "0 0 1e-400 1"],
  segment: ["-1", "x"],
};

/** What reading an attribute throws, as text. */
function refusal(name, text) {
  try {
    FIELDS[name].put(firstState(), FIELDS[name].parse(text));
    return "nothing";
  } catch (/** @type {any} */ error) {
    return `${error.name}: ${error.message}`;
  }
}

test("every attribute: a text that cannot be used is refused by name", () => {
  assert.deepEqual(Object.keys(UNUSABLE).sort(), Object.keys(FIELDS).sort());
  for (const [name, texts] of Object.entries(UNUSABLE)) {
    const message = new RegExp(`^(Range|Type)Error: (\\w+ of )?${name}(\\[\\d+\\])?: expected .*got`);
    for (const text of texts) assert.match(refusal(name, text), message, `${name}="${text}"`);
  }
});

test("a megabyte as points is refused in a short message", () => {
  for (const text of ["x".repeat(2 ** 20), "1,2 ".repeat(2 ** 18)]) {
    const words = refusal("points", text);
    assert.match(words.slice(0, 200), /^RangeError: points: expected/);
    assert.ok(words.length < 200, `${words.length} characters`);
  }
});
