// <bezier-applet> as an object, without a page: properties and attributes, methods, events, undo, actions and what is announced.
import assert from "node:assert/strict";
import { test } from "node:test";
import { AppletController } from "#js/elements/applet/controller.js";
import { BezierApplet } from "#js/elements/applet/element.js";
import { elementOf } from "./element-node.js";
import * as commands from "#js/editor/commands.js";
import { FIELDS } from "#js/editor/schema.js";
import { attributeName } from "#js/elements/attribute-text.js";
import { figureOf } from "#js/editor/figure.js";
import { withText } from "#js/editor/import.js";
import { jointsOf } from "#js/editor/joints.js";
import { turnedBy15 } from "#js/editor/snapping.js";
import { BASES, firstState, MODES, withPoints } from "#js/editor/state.js";
import { description, jointWords } from "#js/editor/descriptions.js";

/** An element with these attributes, and the events that it has fired. */
function element(attributes = {}) {
  const applet = elementOf(BezierApplet, attributes);
  const events = [];
  for (const type of ["input", "change"]) applet.addEventListener(type, () => events.push(type));
  return { applet, events };
}
/** Points as text, and the reverse. */
const text = (points) => FIELDS.points.write({ ...firstState(), points });
const read = (/** @type {string} */ given) => text(withPoints(firstState(), FIELDS.points.parse(given)).points);
const FIRST = text(firstState().points);
const CUBIC = "0,0 100,100 200,0 300,300";

/** What an action throws, as text. */
function thrown(act) {
  try {
    act();
    return "nothing";
  } catch (/** @type {any} */ error) {
    return `${error.name}: ${error.message}`;
  }
}

/** What properties and methods refuse, by the class of the error. @type {Record<string, ((applet: any) => unknown)[]>} */
const REFUSED = {
  TypeError: [
    (a) => (a.points = 3),
    (a) => (a.points = [[1, 2], "x"]),
    (a) => (a.t = [0.5]),
    (a) => (a.joints = 1),
    (a) => (a.state = null),
    (a) => (a.state = { points: 1 }),
    (a) => a.insertJoint("x"),
    (a) => a.appendPoint([1]),
  ],
  RangeError: [
    (a) => (a.points = [[1, 2]]),
    (a) => (a.points = [[1, NaN], Array(2).fill(3)]),
    (a) => (a.t = 7),
    (a) => (a.t = NaN),
    (a) => (a.joints = ["x"]),
    (a) => (a.state = { points: FIELDS.points.parse(CUBIC), basis: "x" }),
    (a) => a.insertJoint(2),
    (a) => a.removePoint(99),
    (a) => a.removePoint(1.5),
    (a) => a.appendPoint([NaN, 1]),
    (a) => a.randomize(0.5),
    (a) => a.split(3),
    (a) => a.edit({ index: 99, point: [1, 1] }),
    (a) => a.edit({ t: 9 }),
  ],
};

test("properties and methods refuse with the right error, and nothing changes", () => {
  const { applet, events } = element();
  const before = JSON.stringify(applet);
  for (const [name, actions] of Object.entries(REFUSED))
    for (const act of actions) {
      assert.match(
        thrown(() => act(applet)),
        new RegExp(`^${name}: .*expected .*got `),
        String(act),
      );
      assert.equal(JSON.stringify(applet), before, String(act));
    }
  applet.undo();
  assert.deepEqual([JSON.stringify(applet), events], [before, []], "there is nothing to undo");
});

/** For each attribute a text that cannot be used; applet-joints.test.js has more of them. */
const UNUSABLE = {
  points: "1,2 3,NaN",
  visiblePoints: "99",
  joints: "g1 x",
  basis: "__proto__",
  degree: "2.5",
  weights: "1 2",
  matrix: "1 2 3",
  t: "",
  show: "hasOwnProperty",
  labels: "Q",
  tolerance: "-3",
  segments: "1e9",
  offset: "x",
  ticks: "0",
  view: "0 0 1e-400 1",
  segment: "-1",
};

test("a warning about a bad attribute stays until the attribute is removed, and the last good value is kept", () => {
  assert.deepEqual(Object.keys(UNUSABLE).sort(), Object.keys(FIELDS).sort());
  const { applet } = element({ points: "10,20 30,200 300,40 400,300", t: "0.25", show: "hull" });
  for (const [name, unusable] of Object.entries(UNUSABLE)) {
    const attribute = attributeName(name);
    const [good, given] = [JSON.stringify(applet), applet.getAttribute(attribute)];
    applet.setAttribute(attribute, unusable);
    assert.equal(JSON.stringify(applet), good, name);
    assert.equal(applet.model.problems.length, 1, name);
    assert.match(applet.model.problems[0], new RegExp(`^(\\w+ of )?${name}(\\[\\d+\\])?: expected`));
    if (given === null) applet.removeAttribute(attribute);
    else applet.setAttribute(attribute, given);
    assert.deepEqual([JSON.stringify(applet), applet.model.problems], [good, []], name);
  }
});

test("attributes are read in any order, reflect, and go back to the defaults when they are taken away", () => {
  const { applet } = element({
    "visible-points": "4",
    joints: "c1",
    t: "0.2",
    show: "hull",
    points: "0,0 10,100 20,100 100,0 200,-90 300,10 310,20",
  });
  const { points, figure, visiblePoints, t, show } = applet;
  assert.deepEqual([visiblePoints, t, points.length, figure.points.length, show], [4, 0.2, 7, 4, "hull"]);
  assert.equal(text(points), "0,0 10,100 20,100 100,0 180,-100 300,10 310,20", "held from the start");
  for (const name of ["points", "visible-points", "t", "show", "joints"]) applet.removeAttribute(name);
  assert.deepEqual([text(applet.points), applet.visiblePoints, applet.t, applet.show], [FIRST, null, 0.5, "polygon"]);
  applet.model.attributes.hostUpdated();
  assert.equal(applet.attributes.length, 0, "what is as at first is not written");
  Object.assign(applet, { show: "comb tree", t: 0.25, points: CUBIC, joints: ["c2"], view: "10 20 67 48" });
  applet.model.attributes.hostUpdated();
  const names = ["show", "t", "points", "joints", "view"];
  assert.deepEqual(
    names.map((name) => applet.getAttribute(name)),
    ["comb tree", "0.25", CUBIC, "c2", "10 20 67 48"],
  );
  assert.ok(applet.figure.tree.segments > 2);
});

test("the state goes through JSON and back to the last bit", () => {
  const [{ applet: a }, { applet: b }] = [element(), element()];
  a.randomize(3);
  Object.assign(a, { joints: ["c2"], t: 0.3, show: "hull comb", labels: "b0", tolerance: 3, view: "10 20 67 48" });
  b.state = JSON.parse(JSON.stringify(a));
  for (const each of [a, b]) each.model.attributes.hostUpdated();
  assert.deepEqual([b.state, b.figure], [a.state, a.figure]);
  const attributes = (each) => Object.keys(FIELDS).map((name) => [name, each.getAttribute(attributeName(name))]);
  assert.deepEqual(attributes(b), attributes(a));
});

test("what the page writes fires nothing, and each step can be undone", () => {
  const { applet, events } = element();
  applet.points = FIELDS.points.parse(CUBIC);
  applet.t = 0.25;
  applet.insertJoint(0.5);
  applet.randomize(7);
  const random = text(applet.points);
  applet.randomize(7);
  assert.equal(text(applet.points), random, "equal seeds, equal points");
  applet.undo();
  applet.undo();
  assert.equal(applet.points.length, 7);
  applet.undo();
  applet.undo();
  assert.equal(text(applet.points), CUBIC, "properties that are set before the user does something are no steps");
  applet.redo();
  assert.equal(applet.points.length, 7);
  assert.deepEqual(events, []);
  applet.edit({ t: 0.5 }); // as the user does
  applet.points = FIELDS.points.parse(FIRST);
  applet.undo();
  assert.equal(applet.points.length, 7);
});

test("companions edit as the user does: input, one change, one undo step", () => {
  const { applet, events } = element();
  for (const t of [0.1, 0.2, 0.3]) applet.edit({ t }, false);
  assert.deepEqual(events.splice(0), ["input", "input", "input"]);
  applet.edit({ t: 0.4 }, true);
  assert.deepEqual(events.splice(0), ["input", "change"]);
  assert.equal(applet.figure.t, 0.4);
  applet.edit({ index: 0, point: [1, 2] });
  assert.deepEqual(applet.points[0], [1, 2]);
  applet.undo();
  applet.undo();
  assert.deepEqual([applet.t, text(applet.points)], [0.5, FIRST]);
  applet.readonly = true;
  applet.edit({ index: 0, point: [1, 2] });
  applet.edit({ t: 0.9 });
  assert.deepEqual([applet.t, text(applet.points)], [0.9, FIRST], "read only: t alone moves");
});

test("reset restores what the page has set before the first action of the user", () => {
  const { applet } = element({ points: CUBIC, t: "0.25" });
  applet.reset();
  assert.deepEqual([text(applet.points), applet.t], [CUBIC, 0.25], "before anything has changed, too");
  applet.points = FIELDS.points.parse("100,300 150,100 400,120 500,310");
  applet.edit({ index: 1, point: [149, 100] });
  applet.model.editor.dispatch((state) => commands.appended(state, [600, 30]), { by: "user" });
  assert.equal(applet.points.length, 7);
  applet.reset();
  assert.deepEqual([text(applet.points), applet.t], ["100,300 150,100 400,120 500,310", 0.25]);
  applet.undo();
  assert.equal(applet.points.length, 7);
});

test("split shows the halves and returns them", () => {
  const { applet } = element();
  const [first, second] = applet.split(0.25).map((half) => [...half.controlPoints()]);
  assert.deepEqual([first.slice(0, 2), first.slice(-2)], [[70, 330], second.slice(0, 2)]);
  assert.deepEqual([applet.t, applet.show], [0.25, "polygon halves"]);
});

/** The actions of the user on an element, and what they announce. */
function actions(attributes = {}) {
  const { applet, events } = element(attributes);
  const acting = new AppletController(applet);
  const said = [];
  acting.announcer = /** @type {any} */ ({ say: (words) => said.push(words) });
  return { applet, events, acting, said };
}

test("Enter at a joint goes through its modes, by turns, and nowhere else", () => {
  const { applet, acting, said } = actions({ joints: "free c1", points: `${FIRST} 610,60 500,30 400,40` });
  for (const mode of [...MODES.slice(1), MODES[0]]) {
    assert.ok(acting.cycleJoint(3));
    assert.deepEqual(applet.joints, [mode, "c1"]);
  }
  assert.deepEqual(said.slice(0, 2), ["P3 held: G1", "P3 held: C1"]);
  for (const index of [0, 4, 9]) assert.equal(acting.cycleJoint(index), false, `P${index} is no joint`);
  applet.readonly = true;
  assert.equal(acting.cycleJoint(3), false);
});

test("each action is announced and is one undo step; a refusal is announced and changes nothing", () => {
  for (const [act, words, count] of /** @type {[(acting: any) => unknown, string, number][]} */ ([
    [(acting) => acting.run("append"), "Point added", 10],
    [(acting) => acting.run("insert"), "Split at t", 10],
    [(acting) => acting.run("randomize"), "Points randomized", 7],
    [(acting) => acting.remove(6), "P6 removed", 4],
    [(acting) => acting.remove(1, true), "P1 removed", 6],
    [(acting) => acting.open("1,2 3,4"), "Opened", 2],
    [(acting) => acting.holdJoint(1, "c1"), "P3 held: C1", 7],
  ])) {
    const { applet, events, acting, said } = actions();
    act(acting);
    assert.deepEqual([said.at(-1), applet.points.length, events], [words, count, ["input", "change"]]);
    acting.run("undo");
    assert.equal(text(applet.points), FIRST, words);
    assert.equal(said.at(-1), "Undone");
    acting.run("redo");
    assert.deepEqual([said.at(-1), applet.points.length], ["Done again", count]);
  }
  const { applet, acting, said } = actions({ points: CUBIC });
  acting.remove(0);
  assert.match(applet.model.message, /^remove: .*only segment/);
  applet.setAttribute("basis", "b-spline");
  acting.run("insert");
  assert.match(applet.model.message, /^insert: expected the basis bezier or hermite/);
  assert.deepEqual([text(applet.points), said], [CUBIC, ["", ""]]);
  acting.open("no figure");
  assert.match(applet.model.message, /^This is no figure: points\[0\]: expected numbers, got "no"$/);
});

test("the same refusal is announced again", () => {
  const { acting } = actions({ points: CUBIC });
  acting.announced = ["the message", "At P3: C0"];
  acting.remove(0);
  assert.deepEqual(acting.announced, ["At P3: C0"]);
});

test("in every basis a point is moved, and undone it is back", () => {
  for (const basis of BASES) {
    const { applet } = element({ basis, points: "100,300 150,100 300,100 350,300 450,420 550,300" });
    const before = text(applet.points);
    applet.edit({ index: 2, point: [320, 80] });
    assert.deepEqual(applet.points[2], [320, 80], basis);
    applet.undo();
    assert.equal(text(applet.points), before);
  }
});

test("a matrix of one's own begins with the basis before", () => {
  const before = /** @type {any} */ ({ ...firstState(), basis: "b-spline" });
  const { matrix } = commands.withOwnMatrix({ ...before, basis: "matrix" }, before);
  [-1 / 6, 0.5, -0.5, 1 / 6].forEach((x, i) => assert.ok(Math.abs(matrix[i] - x) < 1e-12));
});

test("of degree n a removed point lowers the degree; a cut holds its joint by G1, a healed one is gone", () => {
  const whole = /** @type {any} */ ({ ...firstState(), degree: "n" });
  assert.equal(figureOf(commands.removed(whole, 2)).degree, 5);
  const cut = commands.inserted(firstState(), 0.3);
  assert.deepEqual([cut.joints, commands.removed(cut, 3).joints], [["g1", "free"], ["free"]]);
  const { joints } = commands.inserted({ ...firstState(), segment: 1 }, 0.3);
  assert.deepEqual(joints, ["free", "g1"]);
});

test("with Shift every handle turns about its anchor in steps of 15°", () => {
  const state = firstState();
  for (const [index, anchor] of Object.entries({ 1: 0, 2: 3, 4: 3, 5: 6 })) {
    const [[x, y], [ax, ay]] = [
      turnedBy15(state, Number(index), [193, 131], state.points[index]),
      state.points[anchor],
    ];
    const steps = (Math.atan2(y - ay, x - ax) * 12) / Math.PI;
    assert.ok(Math.abs(steps - Math.round(steps)) < 1e-9, `P${index}`);
  }
});

const inPicture = ([x, y]) => x >= 0 && x <= 670 && y >= 0 && y <= 480;

test("text is taken as points, an SVG path or JSON; what is none of these is refused", () => {
  const taken = (given) => withText(firstState(), given);
  assert.equal(text(taken("10,20 30,40 50,60 70,80").points), "10,20 30,40 50,60 70,80");
  assert.equal(text(taken("[[1,1],[2,2],[3,3],[4,4]]").points), "1,1 2,2 3,3 4,4");
  const path = taken('<svg viewBox="0 0 9 9"><path stroke="red" d="M10 10Q60 10 60 60L10 60Z"/></svg>').points;
  assert.equal(text(path.filter((_, i) => i % 3 === 0)), "10,10 60,60 10,60 10,10");
  assert.ok(taken("M0 0 L2000 0").points.every(inPicture), "made to fit");
  const { t, layers, points } = taken('{"points":[[1,2],[3,4],[5,6],[7,8]],"t":0.125,"show":["comb"]}');
  assert.deepEqual([t, [...layers], points[3]], [0.125, ["comb"], [7, 8]]);
  for (const [given, words] of /** @type {[string, RegExp][]} */ ([
    ["hello world", /points/],
    ["{", /JSON/],
    ["[1, 2]", /points/],
    ["<svg></svg>", /path/],
    ["M0 0 L x", /^.*d: expected a number at offset 7/],
    ["", /points/],
    ['{"points": [[1, null]]}', /points/],
    ["M0 0 ".repeat(2 ** 19), /got 2621440 characters/],
  ])) {
    const message = thrown(() => taken(given));
    assert.match(message, /^RangeError: This is no figure: /);
    assert.match(message, words);
    assert.ok(message.length < 200);
  }
  assert.equal(read("1 2 3 4"), "1,2 3,4");
});

test("the description names points, joints and t; many points are counted", () => {
  const words = (state) => description(state, figureOf(state), jointsOf(figureOf(state)), ["The hull is shown"]);
  const held = commands.withJoints(firstState(), ["c1"]);
  assert.match(
    words(held),
    /^2 Bézier curves of degree 3\. P0 at 70, 330; P1 at 110, 90, off the curve;.* At P3: C1, turns by 0°, tangents 1 : 1, held C1\. t is 0\.50\. The hull is shown/,
  );
  assert.match(words({ ...firstState(), shown: 3 }), /^Too few points for a curve/);
  const many = withPoints(
    firstState(),
    Array.from({ length: 31 }, (_, i) => [10 * i, 0]),
  );
  assert.match(words(many), /P23 at 230, 0, off the curve; and 7 more/);
  const right = withPoints(firstState(), FIELDS.points.parse("0,200 50,200 100,200 200,200 200,300 350,300 400,400"));
  assert.deepEqual(jointsOf(figureOf(right)).map(jointWords), ["turns by 90°, tangents 1 : 1"]);
});
