// Weights in <bezier-applet>: attributes and JSON, the rational curves and their layers, the code, and what changes a weight.
import assert from "node:assert/strict";
import { test } from "node:test";
import { AppletController } from "#js/elements/applet/controller.js";
import { BezierApplet } from "#js/elements/applet/element.js";
import * as rational from "#js/elements/applet/rational.js";
import { appended, inserted, randomized, removed, withPointAt } from "#js/editor/commands.js";
import { codeOf } from "#js/editor/code.js";
import { description } from "#js/editor/descriptions.js";
import { figureOf } from "#js/editor/figure.js";
import { withText } from "#js/editor/import.js";
import { jsonOf, stateOf } from "#js/editor/schema.js";
import { weightPoints } from "#js/editor/weights.js";
import { svgFigure } from "#js/layers/svg.js";
import { RationalCurve } from "#js/nurbs.js";
import { elementOf } from "./element-node.js";
import { near } from "./reference.js";

/** A quarter of the circle of radius 200 about (300, 300). */
const QUARTER = {
  points: [
    [100, 300],
    [100, 100],
    [300, 100],
  ],
  degree: 2,
  weights: [1, Math.SQRT1_2, 1],
};
const radius = ({ x, y }) => Math.hypot(x - 300, y - 300);
const figure = (state) => figureOf(state, RationalCurve);
const CHAIN = {
  points: [
    [0, 0],
    [100, 50],
    [200, 0],
    [300, 80],
    [400, 0],
  ],
  degree: 2,
  weights: [1, 2, 3, 4, 5],
};

test("attributes: as many weights as points, above 0 and up to 1000; removed, the curve has no weights", () => {
  const applet = elementOf(BezierApplet, { points: "0,0 10,20 30,0", degree: "2", weights: "1, 0.7 1" });
  assert.deepEqual([applet.weights, applet.model.problems], [[1, 0.7, 1], []]);
  for (const [given, message] of [
    ["1 2", "weights: expected 3 numbers, got 2"],
    ["1 0 1", "weights[1]: expected a number from 0.001 to 1000, got 0"],
    ["1 1 -2", "weights[2]: expected a number from 0.001 to 1000, got -2"],
    ["1 x 1", 'weights[1]: expected a number from 0.001 to 1000, got "x"'],
  ]) {
    applet.setAttribute("weights", given);
    assert.deepEqual([applet.weights, applet.model.problems], [[1, 0.7, 1], [message]]);
  }
  applet.removeAttribute("weights");
  assert.deepEqual([applet.weights, applet.model.problems, applet.state.weights], [[], [], undefined]);
  applet.weights = [1, 5, 1];
  assert.deepEqual([applet.weights, applet.getAttribute("weights")], [[1, 5, 1], "1 5 1"]);
  applet.edit({ weights: [] });
  applet.model.attributes.hostUpdated();
  assert.equal(applet.getAttribute("weights"), null);
});

test("the state's JSON has the weights, also for a basis that does not use them", () => {
  for (const basis of ["bezier", "hermite"]) {
    const json = { ...QUARTER, basis };
    assert.deepEqual(jsonOf(stateOf(jsonOf(stateOf(json)))).weights, QUARTER.weights);
  }
  const { rational: curves, pieces } = figure(stateOf({ ...QUARTER, degree: 3, basis: "hermite" }));
  assert.deepEqual([curves.length, pieces.length], [0, 0]);
  assert.throws(() => stateOf({ ...QUARTER, weights: [1] }), /^RangeError: weights: expected 3 numbers, got 1/);
});

test("the figure's curves are rational; before their class is loaded there are none", () => {
  const state = stateOf(QUARTER);
  const { rational: curves, pieces, spline, kinds } = figure(state);
  assert.deepEqual([curves.length, pieces.length, spline, kinds], [1, 0, null, ["on", "off", "on"]]);
  for (const t of [0, 0.3, 1]) near([radius(curves[0].curve.eval(t))], [200], 1e-12);
  assert.deepEqual([figureOf(state).rational, figureOf(state).kinds], [[], kinds]);
  assert.deepEqual(
    figure(stateOf(CHAIN)).rational.map(({ curve }) => [...curve.weights()]),
    [
      [1, 2, 3],
      [3, 4, 5],
    ],
  );
});

test("weights follow their points: appended ones have 1, removed ones leave, paths have none", () => {
  const state = stateOf(CHAIN);
  assert.deepEqual(appended(state, [9, 9]).weights, [1, 2, 3, 4, 5, 1]);
  assert.deepEqual(removed(state, 1).weights, [1, 3, 4, 5]);
  assert.deepEqual(randomized(state, 1).weights, CHAIN.weights);
  assert.deepEqual(withText(state, "M0 0C1 2 3 4 5 6").weights, []);
  assert.deepEqual(withText(state, "1,2 3,4 5,6").weights, [1, 2, 3]);
  assert.deepEqual(withPointAt(state, 2, [7, 7]).points[2], [7, 7]);
});

test("cut at t, a rational curve keeps its shape, its ends and the other weights", () => {
  const state = { ...stateOf(CHAIN), segment: 1 };
  const cut = inserted(state, 0.25);
  assert.deepEqual([cut.points.length, cut.weights.length, cut.shown, cut.joints], [7, 7, 7, state.joints]);
  assert.deepEqual([cut.weights.slice(0, 3), cut.weights[6]], [[1, 2, 3], 5]);
  assert.deepEqual([cut.points.slice(0, 3), cut.points[6]], [CHAIN.points.slice(0, 3), CHAIN.points[4]]);
  const [, whole] = figure(state).rational;
  const [, first, second] = figure(cut).rational;
  for (const t of [0, 0.3, 1]) {
    const places = [first.curve.eval(t), second.curve.eval(t)].flatMap(({ x, y }) => [x, y]);
    near(
      places,
      [whole.curve.eval(t / 4), whole.curve.eval(0.25 + 0.75 * t)].flatMap(({ x, y }) => [x, y]),
      1e-10,
    );
  }
  assert.equal(inserted(stateOf({ ...CHAIN, degree: "n" }), 0.5).degree, 4);
  assert.throws(
    () => inserted(stateOf({ ...CHAIN, degree: 6 })),
    /^RangeError: insert: expected a curve, got too few points/,
  );
});

test("the handle of a weight is Farin's point, and dragging it along its leg changes this weight alone", () => {
  const state = stateOf(CHAIN);
  const [first, second] = weightPoints(figure(state));
  near(first, [(0 * 1 + 100 * 2) / 3, (0 * 1 + 50 * 2) / 3], 1e-12);
  near(second, [(100 * 2 + 200 * 3) / 5, (50 * 2 + 0 * 3) / 5], 1e-12);
  assert.equal(weightPoints(figure(state)).length, 4);
  const half = rational.withWeightPointAt(state, 1, [50, 25]);
  assert.deepEqual(half.weights, [1, 1, 3, 4, 5]);
  assert.deepEqual(rational.withWeightPointAt(state, 1, [50 + 7, 25 - 14]).weights, half.weights, "beside the leg");
  assert.equal(rational.withWeightPointAt(state, 1, [999, 500]).weights[1], 1000);
  assert.equal(rational.withWeightPointAt(state, 1, [-9, -9]).weights[1], 0.001);
  near([rational.withWeightPointAt(state, 2, [175, 12.5]).weights[2]], [2 * 3], 1e-12);
  const noLeg = withPointAt(state, 1, [0, 0]);
  assert.equal(rational.withWeightPointAt(noLeg, 1, [50, 25]), noLeg);
  assert.equal(rational.steppedWeight(rational.steppedWeight(state, 2, 10), 2, -10).weights[2], 3);
  assert.ok(rational.steppedWeight(state, 2, 1).weights[2] > 3);
});

test("every layer of rational curves can be drawn, and those that are for polynomials are not offered", () => {
  const names = rational.RATIONAL_LAYERS.flatMap(({ name }) => (name ? [name] : []));
  for (const without of ["tree", "offset", "envelope"]) assert.ok(!names.includes(/** @type {any} */ (without)));
  const svg = (json, show) => {
    const state = stateOf({ ...json, show });
    return svgFigure({ ...state, pointer: [50, 60] }, figure(state), { layers: rational.RATIONAL_LAYERS });
  };
  for (const json of [QUARTER, CHAIN, { ...CHAIN, degree: "n" }, { ...CHAIN, degree: 1 }])
    for (const name of names) assert.doesNotMatch(svg(json, [name]), /NaN|Infinity|undefined/, name);
  assert.match(svg(QUARTER, []), />w1 = 0\.7071</);
  assert.notEqual(svg(QUARTER, ["construction"]), svg({ ...QUARTER, weights: [1, 1, 1] }, ["construction"]));
});

/** What a layer derives. */
const derived = (name, json) => {
  const state = stateOf(json);
  const layer = rational.RATIONAL_LAYERS.find((each) => each.name === name);
  return { data: layer?.derive(figure(state), state), words: (data) => layer?.describe?.(data, state) };
};

test("layers on a quarter of a circle: the construction ends on it, the comb has its radius, ticks its length", () => {
  const json = { ...QUARTER, t: 0.3, ticks: 4 };
  const [levels] = derived("construction", json).data;
  near([radius({ x: levels[2][0], y: levels[2][1] })], [200], 1e-12);
  near([derived("comb", json).data.sharpest], [1 / 200], 1e-12);
  const { across } = derived("ticks", json).data;
  const angles = [0, 1, 2, 3, 4].map((k) => Math.atan2(300 - across[4 * k + 1], 300 - across[4 * k]));
  near(
    angles,
    [0, 1, 2, 3, 4].map((k) => (k * Math.PI) / 8),
    1e-9,
  );
  const { values } = derived("weights", json).data;
  near([values.reduce((sum, each) => sum + each, 0)], [1], 1e-12);
  assert.ok(values[1] < 2 * 0.3 * 0.7, "less than the one without weights");
  const inflections = derived("inflections", json);
  assert.match(inflections.words(inflections.data) ?? "", /none inside \(ellipse\)/);
});

test("the program for a rational curve finds the point that is shown", () => {
  for (const segment of [0, 1]) {
    const state = stateOf({ ...CHAIN, segment, t: 0.25 });
    const code = codeOf(state, figure(state), "js");
    assert.match(code, /^import \{ RationalCurve \} from "casteljau\/nurbs";\n/);
    const { x, y } = new Function("RationalCurve", `${code.replace(/import.*\n/, "")}; return { x, y };`)(
      RationalCurve,
    );
    const shown = figure(state).rational[segment].curve.eval(0.25);
    near([x, y], [shown.x, shown.y], 1e-9);
    assert.match(
      codeOf(state, figure(state), "rust"),
      /RationalCurve::new\(&\[DVec2::new\(0\.0, 0\.0\).*&\[1\.0, 2\.0, 3\.0\]\)/,
    );
    assert.match(codeOf(state, figure(state), "canvas"), /moveTo\(0, 0\).*bezierCurveTo/s);
  }
});

test("weights by `edit` are a step of undo; readonly refuses them; split gives rational halves", () => {
  const applet = elementOf(BezierApplet);
  applet.state = QUARTER;
  applet.model.rational = rational;
  assert.equal(applet.figure.rational.length, 1);
  const [first, second] = applet.split(0.5);
  near([first.length() / second.length()], [1], 1e-9);
  applet.edit({ weights: [1, 2, 1] });
  assert.deepEqual(
    [applet.weights, applet.figure.weights],
    [
      [1, 2, 1],
      [1, 2, 1],
    ],
  );
  applet.undo();
  assert.deepEqual(applet.weights, QUARTER.weights);
  applet.readonly = true;
  applet.edit({ weights: [1, 3, 1] });
  assert.deepEqual(applet.weights, QUARTER.weights);
  assert.equal(new AppletController(applet).weightWords(1), "Weight of P1: 0.7071");
});

test("the description names rational curves", () => {
  const words = (json) => description(stateOf(json), figure(stateOf(json)), [], []);
  assert.match(words(QUARTER), /^1 rational Bézier curve of degree 2\./);
  assert.match(words(CHAIN), /^2 rational Bézier curves of degree 2\./);
});
