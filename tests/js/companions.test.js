// The pure parts of the companions: reading and writing numbers, weights, what a figure amounts to, timing functions.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, easing, Spline } from "#js/index.js";
import { RationalCurve } from "#js/nurbs.js";
import { quoted, readNumber, readPoints, shown, shownFraction } from "#js/ui/numbers.js";
import { ownMatrix, standaloneCurve } from "#js/elements/companions/own.js";
import { ownPoints, pointsText } from "#js/elements/companions/points.js";
import { plotOf, tAt, xOf, yOf } from "#js/elements/companions/plot.js";
import { inPoints, subjectOf } from "#js/elements/companions/subject.js";
import { heightsOf, placeAt, presetOf, PRESETS, readTiming, timingText } from "#js/elements/companions/timing.js";
import { binomial, matrixOf, throughMatrix, weightsAt } from "#js/elements/companions/weights.js";
import { near, pointsOf } from "./reference.js";

/** @typedef {import("#js/elements/companions/subject.js").Subject} Subject */

const POINTS = pointsOf("70,330 110,90 235,120 325,230");
const TS = [-0.4, 0, 0.1, 0.5, 0.9, 1, 1.3];

/** A basis from the text of its name and degree. @param {string} text @returns {any} */
function named(text) {
  const [basis, degree] = text.split(" ");
  return { basis, degree: Number(degree), matrix: null };
}

test("numbers are read as people write them, and nothing else is one", () => {
  const good = { 12: 12, "-3.5": -3.5, "−3": -3, " 7 ": 7, ".5": 0.5, "5.": 5, "1e3": 1000, "+2E−2": 0.02 };
  for (const [text, value] of Object.entries(good)) assert.equal(readNumber(text), value, text);
  for (const bad of ["", " ", "NaN", "Infinity", "1e999", "-1e999", "0x10", "1,5", "12px", "--1", "1 2", "e5", "."])
    assert.ok(Number.isNaN(readNumber(bad)), bad);
});

test("points are read from attributes and from tables; what is wrong is named with its line", () => {
  const two = pointsOf("1,2 3,4.5");
  const texts = ["1,2 3,4.5", "1 2 3 4.5", "1,2\n3,4.5", "1\t2\r\n3\t4.5\r\n", "1;2\n\n3;4.5\n", " 1, 2\n 3 , 4.5"];
  for (const text of texts) assert.deepEqual(readPoints(text), two, JSON.stringify(text));
  assert.throws(() => readPoints("1,2\n3"), /^RangeError: line 2: expected pairs of numbers x,y, got “3”/);
  assert.throws(() => readPoints("1,2\nx,4"), /^RangeError: line 2: expected a number, got “x”/);
  assert.throws(() => readPoints("1,2 3,1e999"), /^RangeError: expected a number, got “1e999”/);
  assert.deepEqual(readPoints(pointsText(POINTS)), POINTS);
});

test("numbers are shown short, with a real minus, never as −0", () => {
  const texts = [0, -0, 1 / 3, -2.5, 1e-9, 12345678, -0.0004].map((x) => shown(x));
  assert.deepEqual(texts, ["0", "0", "0.333", "−2.5", "1.0e−9", "1.23e+7", "0"]);
  assert.deepEqual([1 / 6, -2 / 3, 4, -0.5, 0.1, -0].map(shownFraction), ["1/6", "−2/3", "4", "−1/2", "0.1", "0"]);
  assert.equal(quoted(""), "nothing");
  assert.ok(quoted("x".repeat(1e6)).length < 40);
});

test("matrices and recursions give the weights that the core has", () => {
  for (const degree of [1, 2, 3, 7]) {
    const matrix = /** @type {number[]} */ (matrixOf("bezier", degree, null));
    for (const t of TS) near(throughMatrix(matrix, t), Curve.bernstein(degree, t), 1e-9);
  }
  assert.equal(binomial(30, 15), 155117520);
  // Each weight of a B-spline is what its curve does with a point at 1 and the others at 0.
  for (const degree of [1, 2, 3, 5]) {
    for (let i = 0; i <= degree; i++) {
      const points = Array.from({ length: degree + 1 }, (_, k) => [k === i ? 1 : 0, 0]);
      const spline = Spline.fromBSpline(points, { degree });
      for (const t of [0, 0.25, 0.8, 1])
        near(weightsAt({ basis: "b-spline", degree, matrix: null }, t)[i], spline.eval(t).x);
    }
  }
});

test("point weights sum to 1, at any t and in every basis", () => {
  for (const t of TS) {
    for (const each of ["bezier 64", "b-spline 3", "b-spline 9", "catmull-rom 3"]) {
      const { degree, ...basis } = named(each);
      const sum = weightsAt({ degree, ...basis }, t).reduce((a, b) => a + b, 0);
      if (degree < 20 || (t >= 0 && t <= 1)) near(sum, 1, 1e-9);
    }
    const [first, last] = weightsAt({ basis: "hermite", degree: 3, matrix: null }, t);
    near(first + last, 1);
  }
});

/** @returns {any} a figure of the applet, as far as the companions read it */
const figure = (basis, curve, more = {}) => ({
  ...{ basis, points: POINTS, names: ["P0", "P1", "P2", "P3"], matrix: null, t: 0.3, segment: 0 },
  pieces: [{ curve, indices: [0, 1, 2, 3] }],
  ...more,
});
/** Weights times points. */
const blended = (/** @type {any} */ { points, ...subject }) => {
  const weights = weightsAt(subject, subject.t);
  return [0, 1].map((axis) => points.reduce((sum, p, i) => sum + weights[i] * p[axis], 0));
};

test("weights times points is the point of the curve, whatever the basis", () => {
  const [a, b, c, d] = POINTS;
  const vectors = [a, d, [b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]];
  const own = [1, 2, 3, 4, 0.5, -1, 0, 2, 0, 1, 1, 0, 1, 0, 0, 0];
  const curve = new Curve([0, 0, 1, 5, 2, 5, 9, 0]);
  const figures = [
    figure("bezier", new Curve(POINTS)),
    figure("hermite", Curve.fromBasis("hermite", vectors)),
    figure("b-spline", Curve.fromBasis("b-spline", POINTS)),
    figure("catmull-rom", Curve.fromBasis("catmull-rom", POINTS)),
    figure("matrix", Curve.fromBasis(own, POINTS), { matrix: own }),
    figure("natural", curve, { pieces: [{ curve, indices: [0, 1] }] }),
  ];
  for (const each of figures) near(blended(subjectOf(each)), each.pieces[0].curve.eval(0.3));
  const hermite = /** @type {Subject} */ (subjectOf(figures[1]));
  assert.deepEqual(hermite.names, ["P0", "P3", "P1−P0", "P3−P2"]);
  const same = inPoints(hermite, /** @type {number[]} */ (matrixOf("hermite", 3, null)));
  assert.deepEqual(same.names, ["P0", "P1", "P2", "P3"]);
  near(blended(same), blended(hermite));
});

test("points with weights: rational basis functions, for the piece that is looked at; none before its class is loaded", () => {
  const weights = [1, 0.4, 2, 1, 0.5, 0.25, 3];
  const points = [...POINTS, ...pointsOf("400,300 480,90 560,200")];
  const groups = [
    [0, 1, 2, 3],
    [3, 4, 5, 6],
  ];
  const rational = groups.map((indices) => ({ indices }));
  for (const segment of [0, 1]) {
    const own = figure("bezier", null, { points, names: [], weights, pieces: [], rational, segment });
    const subject = /** @type {Subject} */ (subjectOf(own));
    assert.deepEqual(
      subject.weights,
      groups[segment].map((i) => weights[i]),
    );
    const curve = new RationalCurve(
      groups[segment].map((i) => points[i]),
      subject.weights,
    );
    near(blended(subject), curve.eval(0.3));
    near(
      weightsAt(subject, 0.7).reduce((a, b) => a + b),
      1,
    );
    assert.equal(subjectOf({ ...own, rational: [] }), null);
  }
});

test("the piece that is looked at counts; no piece is no subject; names may be missing", () => {
  const [first, second] = [new Curve(POINTS), new Curve([...POINTS].reverse())];
  const pieces = [
    { curve: first, indices: [0, 1, 2, 3] },
    { curve: second, indices: [3, 2, 1, 0] },
  ];
  const two = figure("bezier", first, { names: [], segment: 1, pieces });
  assert.deepEqual([subjectOf(two)?.points[0], subjectOf(two)?.names[0]], [POINTS[3], "P3"]);
  assert.equal(subjectOf({ ...two, segment: 9 })?.curve, first);
  assert.equal(subjectOf({ ...two, pieces: [] }), null);
  assert.equal(subjectOf(null), null);
});

test("alone: attributes that cannot be used are named, and the defaults stand in", () => {
  const problems = [];
  const check = (name, value, usable, _, fallback) => {
    if (usable) return value;
    problems.push(name);
    return fallback;
  };
  const bad = standaloneCurve({ given: "1,2 3", t: NaN, degree: 99, basis: "nurbs", matrix: "1 2" }, check);
  assert.deepEqual(problems.sort(), ["basis", "degree", "points", "t"]);
  assert.deepEqual([bad.basis, bad.degree, bad.t, bad.points], ["bezier", 3, 0.5, POINTS]);
  const strict = (name, value, usable) => {
    assert.ok(usable, name);
    return value;
  };
  const alone = standaloneCurve(
    { given: "0,0 1,1 2,0", t: 0.5, degree: null, basis: "bezier", matrix: "" },
    strict,
  ).degree;
  assert.equal(alone, 2);
  for (const given of [7, [[1]], pointsOf("1,NaN 2,3"), {}])
    assert.equal(ownPoints(/** @type {any} */ (given), check), ownPoints(null, check));
  assert.equal(ownMatrix("1 ".repeat(15)), null);
  assert.equal(ownMatrix("1, ".repeat(16))?.length, 16);
});

test("the plot: every line inside, the peaks labelled apart, t back from its place", () => {
  for (const each of ["bezier 1", "bezier 3", "bezier 64", "hermite 3", "catmull-rom 3"]) {
    const { range, lines } = plotOf({ ...named(each), t: 0.5 });
    assert.equal(lines.length, named(each).degree + 1);
    const outside = lines.flatMap(({ points }) => pointsOf(points).flat()).filter((x) => !(x >= 0 && x <= 400));
    assert.deepEqual(outside, [], each);
    const labels = lines.filter(({ labelled }) => labelled).map(({ peak }) => peak);
    labels.forEach((a, i) => labels.slice(i + 1).forEach((b) => assert.ok(Math.hypot(a.x - b.x, a.y - b.y) >= 17)));
    assert.ok(lines[0].labelled && lines.at(-1)?.labelled);
    for (const t of [0, 0.123, 1]) near(tAt(range, xOf(range, t)), t);
  }
  const cubic = plotOf({ ...named("bezier 3"), t: 0.5 });
  near(cubic.lines[1].peak.x, xOf(cubic.range, 1 / 3), 0.01);
  near(cubic.lines[1].peak.y, yOf(cubic.range, 4 / 9), 0.001);
  assert.deepEqual(plotOf({ ...named("bezier 3"), t: 1.2 }).range.x, [0, 1.25]);
});

test("timing functions: read, written, refused", () => {
  assert.deepEqual(readTiming(" Cubic-Bezier( .1 , -2 , 1 , 3e0 ) "), [0.1, -2, 1, 3]);
  assert.deepEqual(readTiming("EASE-in"), PRESETS["ease-in"]);
  for (const handles of Object.values(PRESETS)) {
    assert.deepEqual(readTiming(timingText(handles)), handles);
    assert.equal(easing(...handles)(1), 1);
    assert.ok(presetOf(handles));
  }
  const numbers = ["()", "(1,2,3)", "(1,2,3,4,5)", "(0, NaN, 0, 0)", "(0, 1e999, 0, 0)", "(0,0,0,0"];
  for (const bad of ["", "overshoot", "steps(3)", "<script>", ...numbers.map((text) => `cubic-bezier${text}`)])
    assert.throws(() => readTiming(bad), /expected cubic-bezier/, bad);
  assert.throws(() => readTiming("cubic-bezier(1.1, 0, 0, 0)"), /x1: expected a number from 0 to 1, got 1.1/);
  assert.throws(() => readTiming("cubic-bezier(0, 0, -0.1, 0)"), /x2: expected a number from 0 to 1, got -0.1/);
});

test("places in the easing's picture: x stays within 0 and 1, y within what is shown", () => {
  const heights = heightsOf([0, 2, 1, -1]);
  assert.ok(heights[0] < -1 && heights[1] > 2);
  assert.deepEqual(placeAt(heights, -5, 0), [0, heights[1]]);
  assert.deepEqual(placeAt(heights, 5, 9), [1, heights[0]]);
  assert.deepEqual(placeAt([0, 1], 0.5, 0.25), [0.5, 0.75]);
});

test("a subject of its own: each message is about an attribute that was given", () => {
  const messagesOf = (given) => {
    /** @type {string[]} */
    const messages = [];
    const check = (name, value, usable, expected, fallback) => {
      if (!usable) messages.push(`${name}: expected ${expected}, got ${value}; ${fallback}`);
      return usable ? value : fallback;
    };
    const subject = standaloneCurve(
      { given: null, t: 0.5, degree: null, basis: "bezier", matrix: "", ...given },
      check,
    );
    return { messages, degree: subject.degree };
  };
  const three = "1,2 3,4 5,6";
  for (const basis of ["hermite", "catmull-rom"]) {
    assert.deepEqual(messagesOf({ basis, given: three }), {
      messages: [`points: expected 4 points for ${basis}, got ${three}; 70,330 110,90 235,120 325,230`],
      degree: 3,
    });
    assert.deepEqual(messagesOf({ basis, given: `${three} 7,8 9,10` }), { messages: [], degree: 3 });
  }
  assert.deepEqual(messagesOf({ given: three }), { messages: [], degree: 2 });
  const tooHigh = "degree: expected a whole number from 1 to 2, for 3 points, got 3; 2";
  assert.deepEqual(messagesOf({ given: three, degree: 3 }), { messages: [tooHigh], degree: 2 });
});
