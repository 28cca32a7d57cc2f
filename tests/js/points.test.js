// The forms that points and matrices may have, and value semantics: nothing is shared with the caller.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as casteljau from "casteljau";
import { CUBIC, near, owned, pairs, SEVEN, SPACE } from "./reference.js";

const { Curve, Spline } = casteljau;

/** @typedef {import("#js/geometry/check.js").PointsLike} PointsLike */

/** Has the fields of a DOMPoint. */
const domPoint = (x, y, z, w = 1) => ({ x, y, z, w });

const objects = CUBIC.map(([x, y]) => ({ x, y }));
/** @type {Record<string, PointsLike>} */
const forms2D = {
  arrays: CUBIC,
  "typed arrays": CUBIC.map((p) => Float32Array.from(p)),
  objects,
  "a mixture": [CUBIC[0], objects[1], Float64Array.from(CUBIC[2]), objects[3]],
  "DOMPoints, whose z does not count": CUBIC.map(([x, y]) => domPoint(x, y, 9)),
  "a flat array": CUBIC.flat(),
  "a Float64Array": Float64Array.from(CUBIC.flat()),
  "a Float32Array": Float32Array.from(CUBIC.flat()),
  "an Int32Array": Int32Array.from(CUBIC.flat()),
  "a Uint8Array in the middle of a buffer": new Uint8Array([9, 9, ...CUBIC.flat(), 9]).subarray(2, 10),
};
/** @type {Record<string, PointsLike>} */
const forms3D = { arrays: SPACE, objects: SPACE.map(([x, y, z]) => ({ x, y, z })) };

/** Curves and splines of these points have these control points. */
function made(points, dimension, expected, options) {
  const shapes = [new Curve(points, options), new Spline(points, options), Curve.fromBasis("bezier", points, options)];
  for (const shape of shapes)
    assert.deepEqual([shape.dimension, pairs(shape.controlPoints(), dimension)], [dimension, expected]);
}
for (const [name, points] of Object.entries(forms2D))
  test(`plane: ${name}`, () => [undefined, { dimension: 2 }].forEach((options) => made(points, 2, CUBIC, options)));
for (const [name, points] of Object.entries(forms3D)) test(`space: ${name}`, () => made(points, 3, SPACE, undefined));

test("dimension decides wherever it is given", () => {
  const flat = SPACE.flat();
  assert.equal(new Curve(flat).degree, 5);
  for (const points of [flat, Float64Array.from(flat), SPACE.map(([x, y, z]) => domPoint(x, y, z))])
    made(points, 3, SPACE, { dimension: 3 });
  const inPlane = new Curve(forms3D.objects, { dimension: 2 });
  const expected = SPACE.map(([x, y]) => [x, y]);
  assert.deepEqual(pairs(inPlane.controlPoints()), expected);
  assert.equal(Curve.fromJSON({ points: flat, dimension: 3 }).dimension, 3);
});

test("matrices: 6 numbers, 16 numbers, a DOMMatrix", () => {
  const six = [1, 2, 3, 4, 5, 6];
  const sixteen = [1, 2, 0, 0, 3, 4, 0, 0, 0, 0, 1, 0, 5, 6, 0, 1];
  const dom = { toFloat64Array: () => Float64Array.from(sixteen) };
  const expected = CUBIC.map(([x, y]) => [x + 3 * y + 5, 2 * x + 4 * y + 6]);
  for (const matrix of [six, Float64Array.from(six), sixteen, Float32Array.from(sixteen), dom]) {
    assert.deepEqual(pairs(new Curve(CUBIC).transform(matrix).controlPoints()), expected);
    assert.deepEqual(pairs(new Spline(CUBIC).transform(matrix).controlPoints()), expected);
    const space = pairs(new Curve(SPACE).transform(matrix).controlPoints(), 3);
    const mapped = SPACE.map(([x, y, z]) => [x + 3 * y + 5, 2 * x + 4 * y + 6, z]);
    assert.deepEqual(space, mapped);
  }
  // A quarter turn about x, then one along z.
  const turn = [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 1, 1];
  const turned = SPACE.flatMap(([x, y, z]) => [x, -z, y + 1]);
  near(new Curve(SPACE).transform(turn).controlPoints(), turned, 0);
});

test("the caller's arrays may change afterwards", () => {
  const flat = Float64Array.from(CUBIC.flat());
  const nested = CUBIC.map((p) => [...p]);
  const values = [flat, nested].flatMap((points) => [new Curve(points), new Spline(points)]);
  values.push(Curve.fromBasis("bezier", flat));
  flat.fill(99);
  nested.forEach((p) => p.fill(99));
  for (const value of values) assert.deepEqual(pairs(value.controlPoints()), CUBIC);
});

test("what comes out may change without harm", () => {
  const curve = new Curve(CUBIC);
  const spline = new Spline(SEVEN);
  for (const value of [curve, spline]) {
    const before = [...value.controlPoints()];
    value.controlPoints().fill(7);
    value.toJSON().points[0][0] = 7;
    Object.assign(value.eval(0), { x: 7 });
    Object.assign(value.bounds().min, { x: 7 });
    assert.deepEqual([...value.controlPoints()], before);
  }
  spline.degrees[0] = 7;
  spline.toJSON().degrees[0] = 7;
  assert.deepEqual(spline.degrees, [3, 3]);
  Curve.basisMatrix("hermite").fill(0);
  assert.equal(Curve.basisMatrix("hermite")[0], 2);
  spline.segments()[0].controlPoints().fill(0);
  assert.deepEqual(pairs(spline.segments()[0].controlPoints()), SEVEN.slice(0, 4));
});

test("classes carry their names through the bundle", () => {
  for (const [name, value] of Object.entries(casteljau)) {
    if (/^[A-Z]/.test(name)) assert.equal(value.name, name);
  }
});

test("properties cannot be assigned", () => {
  const curve = new Curve(CUBIC);
  const spline = new Spline(SEVEN);
  for (const name of ["degree", "dimension"]) assert.throws(() => Object.assign(curve, { [name]: 1 }), TypeError);
  for (const name of ["closed", "degrees", "segmentCount"])
    assert.throws(() => Object.assign(spline, { [name]: 1 }), TypeError);
});

test("into is filled from its start and returned; what lies behind stays", () => {
  const curve = new Curve(CUBIC);
  const spline = new Spline(SEVEN);
  /** @type {[(into?: Float64Array) => Float64Array, number][]} */
  const calls = [
    [(into) => curve.sample(3, { into }), 8],
    [(into) => curve.evalAt([0, 1], { into }), 4],
    [(into) => spline.sample(2, { into }), 10],
    [(into) => spline.evalAt([0, 1, 2], { into }), 6],
  ];
  for (const [call, length] of calls) {
    const expected = [...call(undefined)];
    assert.equal(expected.length, length);
    const into = new Float64Array(length + 2).fill(-1);
    assert.equal(call(into), into);
    assert.deepEqual([...into], [...expected, -1, -1]);
    // A part of the caller's own buffer.
    const whole = new Float64Array(length + 4).fill(-2);
    const part = whole.subarray(3);
    assert.equal(call(part), part);
    assert.deepEqual([...whole], [-2, -2, -2, ...expected, -2]);
  }
});

test("results are arrays of their own, of exactly their length", () => {
  const curve = new Curve(CUBIC);
  const spline = new Spline(SEVEN);
  const { points, ts } = curve.flatten(0.01);
  const results = [
    curve.controlPoints(),
    curve.sample(9),
    curve.evalAt([0.5]),
    curve.hull(),
    curve.toBasis("hermite"),
    points,
    ts,
    Curve.bernstein(3, 0.5),
    Curve.basisMatrix("bezier"),
    ...curve.deCasteljau(0.5),
    spline.controlPoints(),
    spline.sample(9),
  ];
  results.forEach(owned);
  assert.equal(new Set(results.map((result) => result.buffer)).size, results.length);
});

test("huge and tiny coordinates", () => {
  for (const scale of [1e149, 1e-300]) {
    const curve = new Curve(CUBIC.map((p) => p.map((x) => x * scale)));
    near([curve.eval(0.5).x / scale, curve.eval(0.5).y / scale], [4, 6]);
    near(curve.tangent(0), [0, 1]);
    near([curve.bounds().max.y / scale], [6]);
    assert.ok(curve.flatten(scale / 100).ts.length > 10);
    assert.ok(curve.split(0.3)[0].controlPoints().every(Number.isFinite));
  }
});
