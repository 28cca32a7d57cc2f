// The rules of the small applet without a page: the joint, random points, the edge of the picture, refusals, texts.
import assert from "node:assert/strict";
import { test } from "node:test";
import { pointPair } from "#js/editor/plane.js";
import { withJoint, withLayers, withPoints, withShown, withT } from "#js/applet/changes.js";
import { continuityAtP3, description, jointLabel, place } from "#js/applet/words.js";
import { appended, randomized, withPointAt } from "#js/editor/commands.js";
import { bezierFigure, figureOf } from "#js/editor/figure.js";
import { clamped } from "#js/editor/plane.js";
import { roomiestAmong } from "#js/editor/random.js";
import { allPointsToggled, firstState } from "#js/editor/state.js";

const first = firstState();
const pointsOf = (/** @type {{ points: readonly (readonly number[])[] }} */ { points }) =>
  points.map((point) => [...point]);
/** The first state with some points moved, without a joint mode. */
const moved = (/** @type {[number, [number, number]][]} */ ...moves) =>
  moves.reduce((state, [index, to]) => withPointAt(state, index, to), first);
/** The first state with other points, given as text. */
const from = (/** @type {string} */ text) =>
  withPoints(
    first,
    text.split(" ").map((pair) => pair.split(",").map(Number)),
  );

/** What P2, P3, P4 are to each other: the sine of the angle between P2P3 and P3P4, its cosine, the two lengths. */
function joint(/** @type {number[][]} */ [, , p2, p3, p4]) {
  const [[ax, ay], [bx, by]] = [
    [p3[0] - p2[0], p3[1] - p2[1]],
    [p4[0] - p3[0], p4[1] - p3[1]],
  ];
  const [before, after] = [Math.hypot(ax, ay), Math.hypot(bx, by)];
  return { sine: (ax * by - ay * bx) / before / after, cosine: (ax * bx + ay * by) / before / after, before, after };
}
const near = (a, b, words = "") => assert.ok(Math.abs(a - b) < 1e-9, `${words} ${a} and ${b}`);
const aligned = (/** @type {number[][]} */ points) => {
  const { sine, cosine } = joint(points);
  assert.ok(Math.abs(sine) < 1e-9 && cosine > 0, `aligned: ${sine}, ${cosine}`);
};

test("G1 keeps the lengths of both tangents when P3 moves, and that of the other when a handle moves", () => {
  const held = withJoint(first, "g1");
  const lengths = joint(pointsOf(held));
  const anchored = joint(pointsOf(withPointAt(held, 3, [345, 260])));
  near(anchored.before, lengths.before);
  near(anchored.after, lengths.after);
  near(joint(pointsOf(withPointAt(held, 2, [275, 130]))).after, lengths.after);
});

test("a joint mode moves the partner of a handle and nothing beyond it", () => {
  for (const mode of ["g1", "c1"]) {
    const held = withJoint(first, mode);
    const before = pointsOf(held);
    for (const index of [2, 3, 4]) {
      const after = pointsOf(withPointAt(held, index, [before[index][0] + 30, before[index][1] - 40]));
      aligned(after);
      if (mode === "c1") near(joint(after).before, joint(after).after);
      for (const far of index === 3 ? [0, 1, 5, 6] : [0, 1, 3, 5, 6])
        assert.deepEqual(after[far], before[far], `${mode}: P${far} stays`);
    }
  }
});

test("free: each point moves alone", () => {
  const before = pointsOf(first);
  for (const [index, [x, y]] of before.entries())
    assert.deepEqual(pointsOf(moved([index, [x + 15, y + 20]])), before.with(index, [x + 15, y + 20]));
});

test("a joint mode aligns a broken joint by moving P4 alone; G1 keeps its distance from P3", () => {
  const broken = moved([3, [375, 180]]);
  for (const mode of ["g1", "c1"]) {
    const [before, after] = [pointsOf(broken), pointsOf(withJoint(broken, mode))];
    assert.deepEqual(after.with(4, before[4]), before);
    aligned(after);
    near(joint(after).after, mode === "g1" ? joint(before).after : joint(before).before);
  }
});

test("random points are inside the box, differ from those before, keep the joint, and depend on the seed only", () => {
  for (const mode of ["free", "g1", "c1"]) {
    const state = withJoint(first, mode);
    for (let seed = 0; seed < 60; seed++) {
      const points = pointsOf(randomized(state, seed));
      assert.deepEqual(pointsOf(randomized(state, seed)), points);
      assert.ok(points.every(([x, y], i) => x >= 0 && x <= 670 && y >= 0 && y <= 480 && x !== pointsOf(state)[i][0]));
      if (mode !== "free") aligned(points);
      if (mode === "c1") near(joint(points).before, joint(points).after);
    }
  }
  assert.notDeepEqual(pointsOf(randomized(first, 7)), pointsOf(randomized(first, 8)));
});

test("the joint mode holds at a hidden joint and at a joint that is added later", () => {
  const few = allPointsToggled(withJoint(first, "c1"));
  const hidden = withPointAt(few, 2, [215, 135]);
  assert.deepEqual([hidden.shown, allPointsToggled(hidden).shown], [4, 7]);
  aligned(pointsOf(hidden));
  let longer = appended(hidden, [300, 60]);
  assert.equal(longer.shown, 10);
  for (let k = 0; k < 2; k++) {
    const last = pointsOf(longer).slice(3);
    aligned(last);
    near(joint(last).before, joint(last).after);
    longer = withPointAt(longer, 5, [560, 410]);
  }
});

test("a place outside the picture becomes the nearest one inside", () => {
  assert.deepEqual(clamped(first.box, [-330, 730]), [0, 480]);
  assert.deepEqual(clamped(first.box, [100, 730]), [100, 480]);
  assert.deepEqual(clamped({ x: 10, y: 20, width: 5, height: 5 }, [99, 0]), [15, 20]);
});

test("a new point is placed where there is room", () => {
  let state = first;
  for (let k = 0; k < 2; k++) {
    const others = pointsOf(state);
    const [x, y] = roomiestAmong(state.box, state.points);
    const room = Math.min(...others.map(([px, py]) => Math.hypot(x - px, y - py)));
    assert.ok(room > 60, `${room} pixels`);
    state = appended(state, [x, y]);
    assert.deepEqual(pointsOf(state).slice(0, others.length), others);
  }
});

test("the points fit a box of any size; huge, tiny and coincident points are accepted", () => {
  const small = pointsOf(firstState({ width: 300, height: 200 }));
  assert.ok(small.every(([x, y]) => x > 0 && x < 300 && y > 0 && y < 200));
  for (const value of [1e149, 1e-300, 0, -1e12]) {
    const state = withPoints(first, new Array(7).fill([value, value]));
    assert.deepEqual(pointsOf(state)[3], [value, value]);
    assert.doesNotMatch(jointLabel(bezierFigure(state)).text, /NaN/);
  }
});

const seven = pointsOf(first);
/** What is refused, and the message; without a message: that it names the argument and what came. @type {[() => unknown, string?][]} */
const REFUSED = [
  [() => withPoints(first, []), "RangeError: points: expected 4, 7, 10 … points (3n + 1), got 0"],
  [() => withPoints(first, seven.slice(1)), "RangeError: points: expected 4, 7, 10 … points (3n + 1), got 6"],
  [() => withPoints(first, seven.with(2, [NaN, 1])), "RangeError: x of points[2]: expected a finite number, got NaN"],
  [() => withPoints(first, seven.with(2, [1, Infinity]))],
  [() => withPoints(first, "seven"), 'TypeError: points: expected an array of [x, y], got "seven"'],
  [() => withPoints(first, null)],
  [() => withPoints(first, seven.with(2, /** @type {any} */ ([1])))],
  [() => withPoints(first, seven.with(2, /** @type {any} */ (["1", 2])))],
  [() => withPoints(first, new Array(7))],
  ...[5, 10, NaN, "7"].map((mode) => /** @type {[() => unknown]} */ ([() => withShown(first, mode)])),
  ...["G9", 1].map((mode) => /** @type {[() => unknown]} */ ([() => withJoint(first, mode)])),
  ...[2, NaN, "half"].map((t) => /** @type {[() => unknown]} */ ([() => withT(first, t)])),
  ...[{ bones: true }, { hull: 1 }, null, { toString: true }].map(
    (layers) => /** @type {[() => unknown]} */ ([() => withLayers(first, layers)]),
  ),
  ...[[1], [NaN, 0], "x"].map((point) => /** @type {[() => unknown]} */ ([() => pointPair(point, "point")])),
];

test("what cannot be used is refused by name", () => {
  for (const [act, message] of REFUSED) {
    assert.throws(act, (error) => {
      if (message) assert.equal(String(error), message);
      assert.match(String(error), /^(RangeError|TypeError): .+: expected .+, got .+/);
      return true;
    });
  }
});

test("the label of the joint states continuity, angle and lengths", () => {
  for (const [state, verdict, words] of /** @type {[import("#js/editor/state.js").State, string, RegExp][]} */ ([
    [first, "G1", /^P2, P3, P4 aligned: G1 at P3\. C1 when .*; now 142\.\d and 170\.\d\.$/],
    [withJoint(first, "c1"), "C1", /^P2, P3, P4 aligned and \|P2P3\| = \|P3P4\|: G1 and C1 at P3\.$/],
    [from("0,200 50,200 100,200 200,200 200,300 350,300 400,400"), "C0", /^Broken at P3: the tangent turns by 90°/],
    [allPointsToggled(first), "", /^One cubic Bézier curve: P0 to P3, no joint\.$/],
  ])) {
    const label = jointLabel(bezierFigure(state));
    assert.equal(label.verdict, verdict);
    assert.match(label.text, words);
    assert.equal(continuityAtP3(bezierFigure(state))?.g1 ?? null, verdict === "" ? null : verdict !== "C0");
  }
});

test("descriptions and announcements are made of the values", () => {
  const figure = bezierFigure(moved([1, [195, 80]]));
  assert.match(
    description(figure, 0.5),
    /^2 cubic Bézier curves joined end to end through P0 at 70, 330, P3 at .* with P1 at 195, 80, .* t is 0\.50\.$/,
  );
  assert.match(description(bezierFigure(allPointsToggled(first)), 0.5), /^One cubic Bézier curve through P0/);
  assert.equal(place(bezierFigure(moved([3, [12.44, 7.6]])), 3), "P3 at 12.4, 7.6");
});

test("the figure of Bézier curves is that of all bases, but for the matrix", () => {
  for (const state of [first, allPointsToggled(first), moved([3, [12, 7]])]) {
    const [figure, all] = [bezierFigure(state), figureOf(state)];
    assert.deepEqual({ ...figure, matrix: all.matrix }, all);
  }
});
