// Affine maps as texts, compared with matrices.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Patch, Path, Spline, Surface } from "casteljau";

const POINTS = [1, 2, 3, 5, 8, 13];
const quadratic = new Curve(POINTS);
const [c, s] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
const CASES = [
  ["none", [1, 0, 0, 1, 0, 0]],
  ["", [1, 0, 0, 1, 0, 0]],
  ["matrix(1 2 3 4 5 6)", [1, 2, 3, 4, 5, 6]],
  ["translate(5)", [1, 0, 0, 1, 5, 0]],
  ["translate(5px, -6px)", [1, 0, 0, 1, 5, -6]],
  ["translateX(1) translateY(2e1)", [1, 0, 0, 1, 1, 20]],
  ["scale(2)", [2, 0, 0, 2, 0, 0]],
  ["scale(2 .5)", [2, 0, 0, 0.5, 0, 0]],
  ["scaleX(200%) scaleY(-1)", [2, 0, 0, -1, 0, 0]],
  ["rotate(30)", [c, s, -s, c, 0, 0]],
  ["rotate(0.25turn)", [0, 1, -1, 0, 0, 0]],
  ["rotate(90 1 2)", [0, 1, -1, 0, 3, 1]],
  ["rotate(100grad)", [0, 1, -1, 0, 0, 0]],
  ["skewX(45)", [1, 0, 1, 1, 0, 0]],
  ["skewY(45deg)", [1, 1, 0, 1, 0, 0]],
  [" translate( 50 , 50 ),rotate(90)\n", [0, 1, -1, 0, 50, 50]],
];

for (const [text, matrix] of /** @type {[string, number[]][]} */ (CASES)) {
  test(`transform(${JSON.stringify(text)})`, () => {
    assert.ok(quadratic.transform(text).equals(quadratic.transform(matrix), 1e-13));
  });
}

test("every class takes a text, and the six members of a DOMMatrix", () => {
  const members = { a: 1, b: 0, c: 0, d: 1, e: 5, f: 6 };
  const flat = Array.from({ length: 16 }, (_, k) => [k % 4, k, k * k]);
  const shapes = [
    quadratic,
    new Spline(POINTS, { degree: 1 }),
    Path.from(quadratic),
    new Patch(flat),
    Surface.teacup(),
  ];
  for (const shape of shapes) {
    const moved = /** @type {any} */ (shape).transform("translate(5 6)");
    assert.deepEqual(moved.toJSON(), /** @type {any} */ (shape).transform(members).toJSON());
    assert.deepEqual(moved.bounds().min.x, /** @type {any} */ (shape).bounds().min.x + 5);
  }
  assert.throws(() => quadratic.transform({ ...members, f: NaN }), {
    message: "matrix.f: expected a finite number, got NaN",
  });
});

test("other texts are refused with their place", () => {
  for (const [text, offset] of /** @type {[string, number][]} */ ([
    ["rotate", 0],
    ["rotate(30 50)", 0],
    ["rotate(30px)", 0],
    ["translate(1deg)", 0],
    ["scale(2px)", 0],
    ["translate(1 2) turn(3)", 15],
    ["rotate(1e)", 0],
    ["matrix(1 2 3)", 0],
    ["perspective(3)", 0],
    ["constructor(1)", 0],
  ])) {
    assert.throws(() => quadratic.transform(text), {
      name: "RangeError",
      message: new RegExp(`^matrix: expected functions such as .* at offset ${offset}, got `),
    });
  }
});
