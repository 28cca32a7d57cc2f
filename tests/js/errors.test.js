// Bad input: the class of the error, a message that names the argument, what was expected and what came; and after
// each of them the package works on.
import assert from "node:assert/strict";
import { after, afterEach, test } from "node:test";
import * as casteljau from "casteljau";
import { CUBIC, pointsOf, refused, refusedAll, SEVEN, SPACE } from "./reference.js";

/** The classes without their types, because many arguments are wrong on purpose. @type {any} */
const { Curve, Spline } = casteljau;
const cubic = new Curve(CUBIC);
const seven = new Spline(SEVEN);

const works = () => {
  assert.deepEqual(new Curve(CUBIC).eval(0.5), { x: 4, y: 6 });
  assert.deepEqual(cubic.eval(0.5), { x: 4, y: 6 });
  assert.deepEqual(seven.eval(1), { x: 2, y: 0 });
  assert.deepEqual([...new Curve(SPACE).sample(1)], [...SPACE[0], ...SPACE[3]]);
};
afterEach(works);
after(works);

/** An array whose buffer was given away. */
function detached(length = 8) {
  const array = new Float64Array(length).fill(1);
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
}

/** @type {unknown[]} */
const NOT_NUMBERS = [undefined, null, "1", "", true, {}, [], [0.5], 1n, Symbol("t"), () => 1, new Date(0)];
NOT_NUMBERS.push({ valueOf: () => 1 });
const NOT_FINITE = [NaN, Infinity, -Infinity];

test("points: wrong counts", () => {
  for (const points of [[], [[0, 0]], new Float64Array(0), [0, 0], new Array(66).fill([1, 2]), detached()])
    refused(() => new Curve(points), RangeError, /^points: expected 2 to 65 control points .*got \d+$/);
  refusedAll(RangeError, [
    [() => new Curve([1, 2, 3]), /^points: expected a multiple of 2 .*got 3$/],
    [() => new Curve([1, 2, 3, 4], { dimension: 3 }), /^points: expected a multiple of 3 .*got 4$/],
    [() => Curve.fromBasis("hermite", CUBIC.slice(1)), /^points: expected 4 points, got 3$/],
    [() => Curve.fromBasis("hermite", []), /^points: expected 4 points, got 0$/],
  ]);
  const spline = (count, options) => () => new Spline(new Array(count).fill([0, 0]), options);
  for (const count of [0, 1, 2, 3, 5, 6, 8])
    refused(
      spline(count),
      RangeError,
      /^points: expected a multiple of 3, and one more, .*got \d(; \d points fit degree [12 or]+)?$/,
    );
  for (const count of [0, 1, 2, 4, 7])
    refused(
      spline(count, { closed: true }),
      RangeError,
      /^points: expected a multiple of 3 .*got \d(; \d points fit degree [12 or]+)?$/,
    );
});

test("points: a million of them", () => {
  for (const points of [new Array(1e6).fill([0, 0]), new Float64Array(2e6), new Array(2e6).fill(0)]) {
    refused(() => new Curve(points), RangeError, /^points: .*got 1000000$/);
    refused(() => Curve.fromBasis("bezier", points), RangeError, /^points: .*got 1000000$/);
  }
  assert.equal(new Spline(new Float64Array(2e6 + 2), { degree: 64 }).segmentCount, 15_625);
});

test("points: values of the wrong kind", () => {
  const view = new DataView(new ArrayBuffer(32));
  const likeArray = { length: 2, 0: [0, 0], 1: [1, 1] };
  for (const points of [undefined, null, 5, "0,0 1,1", {}, likeArray, view, new Map(), 1n, Symbol("p"), () => CUBIC])
    for (const make of [(p) => new Curve(p), (p) => new Spline(p), (p) => Curve.fromBasis("bezier", p)])
      refused(() => make(points), TypeError, /^points: expected an array of points, got /);
  for (const point of [undefined, null, "x", 1n, true, Symbol("p")]) {
    refused(() => new Curve([[0, 0], point, [1, 1]]), TypeError, /^points\[1\]: expected a point .*got /);
    refused(() => new Curve([point, [0, 0], [1, 1]]), TypeError, /^points\[0\]: expected a point .*got /);
  }
  refusedAll(TypeError, [
    [() => new Curve([[0, 0], 5, [1, 1]]), /^points\[1\]: expected a point .*got 5$/],
    [() => cubic.nearest(80, 90), /^p: expected a point .*got 80; did you mean \[x, y\]\?$/],
    [() => new Curve(BigInt64Array.of(1n, 2n, 3n, 4n)), /^points\[0\]: expected a number, got 1n$/],
  ]);
  for (const bad of NOT_NUMBERS)
    refusedAll(TypeError, [
      [() => new Curve([CUBIC[0], [1, bad]]), /^points\[1\]\[1\]: expected a number, got /],
      [() => new Curve([CUBIC[0], { x: bad, y: 0 }]), /^points\[1\]\.x: expected a number, got /],
      [() => new Curve([0, 0, bad, 1]), /^points\[2\]: expected a number, got /],
    ]);
});

test("points: holes in arrays", () => {
  const holes = pointsOf("0,0 1,1 2,2 3,3");
  delete holes[2];
  refused(() => new Curve(holes), TypeError, /^points\[2\]: expected a point .*got undefined$/);
  const flat = [0, 0, 1, 1];
  delete flat[3];
  refused(() => new Curve(flat), TypeError, /^points\[3\]: expected a number, got undefined$/);
  refused(() => new Curve(new Array(4)), TypeError, /^points\[0\]: expected a point .*got undefined$/);
  const curves = [cubic, cubic, cubic];
  delete curves[1];
  refused(() => Spline.fromCurves(curves), TypeError, /^curves\[1\]: expected a Curve, got undefined$/);
  // biome-ignore lint/suspicious/noSparseArray: a hole is the input under test
  refused(() => cubic.evalAt([0, , 1]), TypeError, /^ts\[1\]: expected a number, got undefined$/);
});

test("points: NaN and infinities", () => {
  for (const bad of NOT_FINITE)
    refusedAll(RangeError, [
      [() => new Curve([CUBIC[0], [bad, 1]]), /^points\[1\]\[0\]: expected a finite number, got -?(NaN|Infinity)$/],
      [() => new Curve([CUBIC[0], { x: 0, y: bad }]), /^points\[1\]\.y: /],
      [() => new Spline(Float64Array.of(0, 0, bad, 1), { degree: 1 }), /^points\[2\]: /],
      [() => new Curve([SPACE[0], [1, 1, bad]]), /^points\[1\]\[2\]: /],
      [() => Curve.fromBasis("hermite", [...CUBIC.slice(1), [bad, 0]]), /^points\[3\]\[0\]: /],
    ]);
});

test("points: dimensions that do not fit", () => {
  refusedAll(RangeError, [
    [() => new Curve([CUBIC[0], SPACE[1]]), /^points\[1\]: expected 2 coordinates, got 3$/],
    [() => new Curve([SPACE[0], CUBIC[1]]), /^points\[1\]: expected 3 coordinates, got 2$/],
    [() => new Curve([[0], [1]]), /^points\[0\]: expected 2 or 3 coordinates, got 1$/],
    [() => new Curve(CUBIC, { dimension: 3 }), /^points\[0\]: expected 3 coordinates, got 2$/],
  ]);
  refused(() => new Curve([{ x: 0, y: 0 }, CUBIC[1]], { dimension: 3 }), TypeError, /^points\[0\]\.z: /);
  for (const dimension of [0, 1, 4, 2.5, NaN])
    refused(() => new Curve(CUBIC, { dimension }), RangeError, /^dimension: expected 2 or 3, got /);
  for (const dimension of ["2", null, 2n, {}])
    refused(() => new Curve(CUBIC, { dimension }), TypeError, /^dimension: expected 2 or 3, got /);
  for (const options of [5, "closed", true, 3n]) {
    refused(() => new Curve(CUBIC, options), TypeError, /^options: expected an object, got /);
    refused(() => new Spline(SEVEN, options), TypeError, /^options: expected an object, got /);
  }
});

test("degrees", () => {
  for (const degree of [0, -1, 65, 1.5, NaN, Infinity])
    refused(() => new Spline(SEVEN, { degree }), RangeError, /^degree: expected a whole number from 1 to 64, got /);
  for (const degree of [-1, 65, 0.5, NaN])
    refused(() => Curve.bernstein(degree, 0.5), RangeError, /^degree: expected a whole number from 0 to 64, got /);
  for (const bad of ["3", null, 3n]) {
    refused(() => new Spline(SEVEN, { degree: bad }), TypeError, /^degree: /);
    refused(() => Curve.bernstein(bad, 0.5), TypeError, /^degree: /);
  }
  const high = new Curve(new Array(65).fill([0, 0]));
  refused(() => high.elevate(), RangeError, /^degree: expected a degree below 64, got 64$/);
});

test("parameters", () => {
  const calls = ["eval", "derivativeAt", "tangent", "normal", "curvature", "split", "deCasteljau"].flatMap((name) =>
    [cubic, new Curve(SPACE), new Curve(CUBIC.slice(1))].map((curve) => (t) => curve[name](t)),
  );
  const names = ["eval", "derivativeAt", "tangent", "normal", "curvature", "torsion", "split", "insert"];
  calls.push(...names.map((name) => (t) => seven[name](t)), (t) => Curve.bernstein(3, t));
  for (const call of calls) {
    for (const bad of NOT_NUMBERS) refused(() => call(bad), TypeError, /^t: expected a number, got /);
    for (const bad of NOT_FINITE) refused(() => call(bad), RangeError, /^t: expected a finite number, got /);
  }
  refused(() => cubic.subsegment("0", 1), TypeError, /^t0: /);
  refused(() => cubic.subsegment(0, NaN), RangeError, /^t1: /);
  for (const call of [(ts) => cubic.evalAt(ts), (ts) => seven.evalAt(ts)]) {
    for (const bad of [undefined, null, 0.5, "0.5", {}])
      refused(() => call(bad), TypeError, /^ts: expected an array of numbers, got /);
    refused(() => call([0, "1"]), TypeError, /^ts\[1\]: /);
    refused(() => call([0, NaN]), RangeError, /^ts\[1\]: /);
    refused(() => call(BigInt64Array.of(0n)), TypeError, /^ts\[0\]: /);
    assert.deepEqual(call(detached()), new Float64Array(0));
  }
  for (const k of [-1, 0.5, NaN])
    refused(() => cubic.derivativeAt(0.5, k), RangeError, /^k: expected a whole number from 0/);
  refused(() => cubic.derivativeAt(0.5, "1"), TypeError, /^k: /);
  for (const t of [-0.1, 2.1])
    refused(() => seven.insert(t), RangeError, /^t: expected 0 to the number of segments, got /);
});

test("segments", () => {
  for (const [name, shape] of Object.entries({ segments: cubic, segmentsPerCurve: seven })) {
    const call = (n) => shape.sample(n);
    for (const bad of [0, -1, 1.5, NaN, Infinity, 2 ** 32])
      refused(() => call(bad), RangeError, new RegExp(`^${name}: expected a whole number from 1.*got `));
    for (const bad of NOT_NUMBERS) refused(() => call(bad), TypeError, new RegExp(`^${name}: `));
    // The limit of 1 GiB.
    refused(() => call(2 ** 26), RangeError, /^segments: expected at most \d+, this needs \d+$/);
  }
});

test("into", () => {
  const calls = [
    (into) => cubic.sample(3, { into }),
    (into) => cubic.evalAt([0, 1], { into }),
    (into) => seven.sample(1, { into }),
    (into) => seven.evalAt([0, 1], { into }),
  ];
  for (const call of calls) {
    refused(() => call(new Float64Array(3)), RangeError, /^into: expected at least \d numbers, got 3$/);
    refused(() => call(detached()), RangeError, /^into: expected at least \d numbers, got 0$/);
    for (const bad of [null, [], new Float32Array(99), new ArrayBuffer(99), "into", 5])
      refused(() => call(bad), TypeError, /^into: expected a Float64Array, got /);
  }
  const into = new Float64Array(3).fill(5);
  assert.throws(() => cubic.sample(9, { into }));
  assert.deepEqual([...into], [5, 5, 5]);
});

test("tolerances", () => {
  for (const call of [(x) => cubic.flatten(x), (x) => cubic.subdivide(x), (x) => seven.flatten(x)]) {
    for (const bad of [0, -0, -1]) refused(() => call(bad), RangeError, /^tolerance: expected a number above 0, got /);
    for (const bad of NOT_FINITE) refused(() => call(bad), RangeError, /^tolerance: expected a finite number, got /);
    for (const bad of NOT_NUMBERS) refused(() => call(bad), TypeError, /^tolerance: expected a number, got /);
    const least = /^tolerance: expected at least \S+ \(4 ulps of the largest coordinate\), got 1e-16$/;
    refused(() => call(1e-16), RangeError, least);
  }
  refused(() => cubic.flatten(4e-15), RangeError, /^vertices: expected at most 16777216, this needs /);
  refused(() => cubic.subdivide(1e-14), RangeError, /^leaves: expected at most 65536, this needs /);
  for (const bad of [-1, NaN, Infinity]) {
    refused(() => cubic.equals(cubic, bad), RangeError, /^tolerance: /);
    refused(() => seven.equals(seven, bad), RangeError, /^tolerance: /);
    refused(() => seven.continuity(1, bad), RangeError, /^tolerance: /);
  }
});

test("bases and matrices", () => {
  for (const call of [(basis) => Curve.fromBasis(basis, CUBIC), (basis) => cubic.toBasis(basis)]) {
    refused(
      () => call("spline"),
      RangeError,
      /^basis: expected one of "bezier", .*got "spline"; did you mean "b-spline"\?$/,
    );
    for (const bad of [undefined, null, 5, {}]) refused(() => call(bad), TypeError, /^basis: /);
    for (const bad of [[], new Array(15).fill(1), new Float64Array(17), detached(16), pointsOf("1,2 3,4")])
      refused(() => call(bad), RangeError, /^basis: expected 16 numbers/);
    refused(() => call(new Array(16).fill(NaN)), RangeError, /^basis\[0\]: /);
    refused(() => call(new Array(16).fill("1")), TypeError, /^basis\[0\]: /);
  }
  refused(() => cubic.toBasis(new Array(16).fill(1)), RangeError, /^basis: expected a matrix with an inverse/);
  refused(() => new Curve([...CUBIC, [1, 1]]).toBasis("hermite"), RangeError, /^points: expected at most 4 .*got 5$/);
  for (const bad of ["hermit", ""]) refused(() => Curve.basisMatrix(bad), RangeError, /^basis: /);
  for (const bad of [undefined, 1, [1]]) refused(() => Curve.basisMatrix(bad), TypeError, /^basis: /);
  for (const shape of [cubic, seven]) {
    for (const bad of [undefined, null, 5, {}]) refused(() => shape.transform(bad), TypeError, /^matrix: /);
    for (const bad of [[], [1, 0, 0, 1, 0], new Array(9).fill(0), detached(6)])
      refused(() => shape.transform(bad), RangeError, /^matrix: expected 6 or 16 numbers, got /);
    refused(() => shape.transform([1, 0, 0, 1, NaN, 0]), RangeError, /^matrix\[4\]: /);
    const perspective = [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    refused(() => shape.transform(perspective), RangeError, /^matrix: expected an affine map .*got 1 0 0 1$/);
  }
});

test("curves of a spline", () => {
  const apart = [new Curve([0, 0, 1, 0]), new Curve([1, 2, 3, 3])];
  for (const bad of [undefined, null, cubic, "x", { 0: cubic, length: 1 }])
    refused(() => Spline.fromCurves(bad), TypeError, /^curves: expected an array of curves, got /);
  refusedAll(TypeError, [
    [() => Spline.fromCurves([cubic, CUBIC]), /^curves\[1\]: expected a Curve, got an array of 4$/],
    [() => Spline.fromCurves([cubic, new Curve(SPACE)]), /^curves\[1\]: expected a 2D curve, got a 3D one$/],
  ]);
  refusedAll(RangeError, [
    [() => Spline.fromCurves([]), /^curves: expected at least 1 curve, got 0$/],
    [() => Spline.fromCurves(apart), /^curves\[1\]: expected to start .*gap of 2$/],
    [() => Spline.fromCurves([cubic], { closed: true }), /^curves\[0\]: expected to start .*gap of 8$/],
  ]);
});

test("indices, joints and modes", () => {
  for (const bad of [-1, 7, 0.5, NaN])
    refused(() => seven.movePoint(bad, [0, 0]), RangeError, /^index: expected a whole number from 0 to 6, got /);
  refused(() => seven.movePoint("1", [0, 0]), TypeError, /^index: /);
  for (const call of [(k) => seven.continuity(k), (k) => seven.setJoint(k, "g1"), (k) => seven.remove(k)]) {
    for (const bad of [-1, 0, 2, 0.5, NaN])
      refused(() => call(bad), RangeError, /^joint: expected a whole number from 1 to 1, got /);
    for (const bad of ["1", null, undefined, 1n]) refused(() => call(bad), TypeError, /^joint: /);
  }
  for (const mode of ["G1", "smooth", ""])
    refusedAll(RangeError, [
      [() => seven.setJoint(1, mode), /^mode: expected one of "free", "g1", "c1", "c2", "g2", "auto", got /],
      [() => seven.movePoint(1, [0, 0], { joints: { 1: mode } }), /^joints\[1\]: expected one of "free", "g1", .*got /],
    ]);
  refused(() => seven.setJoint(1, 2), TypeError, /^mode: /);
  refused(() => seven.movePoint(1, [0, 0], { joints: [null, 1] }), TypeError, /^joints\[[01]\]: /);
  refused(() => seven.movePoint(1, [0, 0], { joints: "g1" }), TypeError, /^joints: expected an object, got "g1"$/);
  for (const [name, call] of Object.entries({ to: (p) => seven.movePoint(1, p), point: (p) => seven.append(p) })) {
    refused(() => call([0, 0, 0]), RangeError, new RegExp(`^${name}: expected 2 coordinates, got 3$`));
    refused(() => call([0, Infinity]), RangeError, new RegExp(`^${name}\\[1\\]: `));
    refused(() => call({ x: 0 }), TypeError, new RegExp(`^${name}\\.y: expected a number, got undefined$`));
    for (const bad of [undefined, null, "0,0", 5])
      refused(() => call(bad), TypeError, new RegExp(`^${name}: expected a point`));
  }
  const closed = new Spline(CUBIC.slice(1), { closed: true });
  refused(() => closed.append([0, 0]), RangeError, /^append: expected an open spline/);
  refused(() => closed.remove(0), RangeError, /^segments: expected at least 2 .*got 1$/);
});

test("others, hulls, JSON", () => {
  for (const bad of [undefined, null, CUBIC, {}, seven])
    refused(() => cubic.equals(bad), TypeError, /^other: expected a Curve, got /);
  refused(() => seven.equals(cubic), TypeError, /^other: expected a Spline, got a Curve$/);
  refused(() => new Curve(SPACE).hull(), TypeError, /^hull: expected a 2D curve, got a 3D one$/);
  for (const bad of [undefined, null, "{}", 5]) {
    refused(() => Curve.fromJSON(bad), TypeError, /^json: /);
    refused(() => Spline.fromJSON(bad), TypeError, /^json: /);
  }
  refused(() => Curve.fromJSON({}), TypeError, /^json: expected an object with points, got an object without keys; /);
  const json = seven.toJSON();
  refused(() => Spline.fromJSON({ ...json, degrees: undefined }), TypeError, /^degrees: /);
  refused(() => Spline.fromJSON({ ...json, degrees: [3] }), RangeError, /^points: expected 4 .*got 7$/);
  refused(() => Spline.fromJSON({ ...json, degrees: [] }), RangeError, /^points: /);
  refused(() => Spline.fromJSON({ ...json, degrees: [3, 65] }), RangeError, /^degrees\[1\]: /);
  refused(() => Spline.fromJSON({ ...json, degrees: [1.5, 4.5] }), RangeError, /^degrees\[0\]: /);
});
