// Lengths, even steps, areas, torsion and frames through the package's door, by closed forms.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve } from "casteljau";
import { CUBIC, near, refused, SPACE } from "./reference.js";

/** A part of the larger number. */
const agree = (got, expected, part = 1e-12) => assert.ok(Math.abs(got - expected) <= part * Math.abs(expected), `${got} instead of ${expected}`);

test("length: closed forms, at turn-backs and cusps too", () => {
  assert.equal(new Curve([[0, 0], [3, 4]]).length(), 5);
  assert.equal(new Curve([[0, 0, 0], [1, 2, 2]]).length(), 3);
  assert.equal(new Curve([[0.1, 0.1], [0.1, 0.1], [0.1, 0.1], [0.1, 0.1]]).length(), 0);
  agree(new Curve([[0, 0], [0.5, 1], [1, 0]]).length(), Math.sqrt(5) / 2 + Math.asinh(2) / 4, 1e-15);
  agree(new Curve([[1, 3], [2, 5], [-9, -17]]).length(), 22.733357771247864, 1e-15);
  agree(new Curve([[0, 0], [1, 0], [1, 0], [0, 0]]).length(), 1.5);
  // (t², t³) from −1 to 1, in the plane and turned into space.
  const cusp = [[1, -1], [-1 / 3, 1], [-1 / 3, -1], [1, 1]];
  const expected = (2 * (13 * Math.sqrt(13) - 8)) / 27;
  agree(new Curve(cusp).length(), expected);
  agree(new Curve(cusp.map(([x, y]) => [0.6 * x, y, 0.8 * x])).length(), expected);
  for (const size of [1e-300, 1e-9, 1e9, 1e300]) {
    agree(new Curve(cusp.map((p) => p.map((x) => x * size))).length(), expected * size);
  }
});

test("length: additive, and as the polyline's limit", () => {
  for (const points of [CUBIC, SPACE, [[0, 0], [9, 1], [-3, 4], [5, 5], [2, 0], [0, 7]]]) {
    const curve = new Curve(points);
    for (const t of [0.1, 0.5, 0.77]) {
      const [left, right] = curve.split(t);
      agree(left.length() + right.length(), curve.length());
    }
    agree(curve.reverse().length(), curve.length());
    agree(curve.elevate().length(), curve.length());
    const { points: vertices } = curve.flatten(1e-6);
    let sum = 0;
    for (let i = curve.dimension; i < vertices.length; i += curve.dimension) {
      sum += Math.hypot(...[0, 1, 2].slice(0, curve.dimension).map((k) => vertices[i + k] - vertices[i + k - curve.dimension]));
    }
    agree(sum, curve.length(), 1e-5);
    for (const tolerance of [1, 1e-3, 1e-6, 1e-9]) near([curve.length(tolerance)], [curve.length()], tolerance);
  }
});

test("length: refusals", () => {
  for (const curve of [new Curve(CUBIC), new Curve(SPACE)]) {
    for (const tolerance of [0, -1]) refused(() => curve.length(tolerance), RangeError, /^tolerance: expected a number above 0, got /);
    for (const tolerance of [NaN, Infinity]) refused(() => curve.length(tolerance), RangeError, /^tolerance: expected a finite number, got /);
    for (const tolerance of [null, "1", {}]) refused(() => curve.length(tolerance), TypeError, /^tolerance: expected a number, got /);
    refused(() => curve.length(1e-17), RangeError, /^tolerance: expected at least .* \(4 ulps of the largest coordinate\), got 1e-17$/);
  }
});

test("area: swept from the origin", () => {
  near([new Curve([[1, 0], [2 / 3, 1], [1 / 3, 1], [0, 1]]).area()], [0.75], 1e-15);
  assert.equal(new Curve([[2, 0], [0, 3]]).area(), 3);
  assert.equal(new Curve([[0, 3], [2, 0]]).area(), -3);
  refused(() => new Curve(SPACE).area(), TypeError, /^area: expected a 2D curve, got a 3D one$/);
});
