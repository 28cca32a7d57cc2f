// Strokes, dashes, offsets of regions and rounded corners, against distances and closed forms.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Path } from "../../js/index.js";
import { untyped } from "./reference.js";

const WAVE = Path.fromSVG("M0 0C1 3 2 -3 3 0S5 2 5 0");
const CUSP = Path.fromSVG("M0 0C3 2 -1 2 2 0");
const SQUARE = Path.rect([0, 0], 4, 4);

/** Points of a grid around a path. */
function grid(path, margin) {
  const { min, max } = path.bounds();
  const points = [];
  for (let i = 0; i <= 24; i++)
    for (let k = 0; k <= 24; k++) {
      const at = (from, to, part) => from - margin + (to - from + 2 * margin) * part;
      points.push([at(min.x, max.x, i / 24 + 0.001), at(min.y, max.y, k / 24 + 0.002)]);
    }
  return points;
}

for (const [name, path] of /** @type {[string, Path][]} */ ([
  ["a wave", WAVE],
  ["a cusp", CUSP],
  ["a square", SQUARE],
]))
  for (const width of [0.1, 1, 3])
    test(`a stroke with round joins and caps is what is nearer than half its width: ${name}, ${width}`, () => {
      const options = /** @type {const} */ ({ join: "round", cap: "round" });
      const stroke = path.stroke(width, { ...options, tolerance: 1e-4 });
      for (const point of grid(path, width)) {
        const distance = path.nearest(point)?.distance ?? Infinity;
        if (Math.abs(distance - width / 2) < 2e-4) continue;
        assert.equal(stroke.windingNumber(point), distance < width / 2 ? 1 : 0, `${point}`);
        assert.equal(path.strokeContains(point, width, options), distance < width / 2, `${point}`);
      }
    });

test("caps and joins: areas in closed form", () => {
  const line = Path.polygon([0, 0, 10, 0], { closed: false });
  const area = (path, width, options) => Number(path.stroke(width, options).area().toFixed(12));
  assert.equal(area(line, 2), 20);
  assert.equal(area(line, 2, { cap: "square" }), 24);
  assert.ok(Math.abs(area(line, 2, { cap: "round", tolerance: 1e-6 }) - 20 - Math.PI) < 1e-5);
  assert.equal(area(SQUARE, 2), 36 - 4);
  assert.equal(area(SQUARE, 2, { join: "bevel" }), 36 - 4 - 2);
  assert.equal(area(SQUARE, 2, { miterLimit: 1 }), 36 - 4 - 2);
  assert.equal(line.stroke(0).subpaths.length, 0);
});

test("dashes: their lengths, and the dash across the start of a closed subpath", () => {
  assert.equal(Path.polygon([0, 0, 10, 0], { closed: false }).dash([4, 2]).toSVG(), "M0,0 L4,0 M6,0 L10,0");
  const dashes = WAVE.dash([0.5, 0.25], 0.1).subpaths.map((piece) => piece.length());
  dashes.slice(1, -1).forEach((length) => assert.ok(Math.abs(length - 0.5) < 1e-9));
  const around = SQUARE.dash([2, 2], 1).subpaths;
  assert.equal(around.length, 4);
  around.forEach((piece) => assert.ok(Math.abs(piece.length() - 2) < 1e-12));
  const stroked = SQUARE.stroke(0.2, { dash: [2, 2], dashOffset: 1 });
  assert.ok(stroked.equals(SQUARE.dash([2, 2], 1).stroke(0.2), 1e-12));
});

test("offset: grown and shrunk squares, whatever their orientation", () => {
  for (const square of [SQUARE, SQUARE.reverse()]) {
    assert.equal(square.offset(1).area(), 36);
    assert.equal(square.offset(-1).area(), 4);
    assert.equal(square.offset(-3).subpaths.length, 0);
    assert.ok(Math.abs(square.offset(1, { join: "round", tolerance: 1e-6 }).area() - 32 - Math.PI) < 1e-4);
  }
});

test("wrong arguments", () => {
  const path = untyped(WAVE);
  assert.throws(() => path.stroke(-1), { name: "RangeError", message: /^width: expected/ });
  assert.throws(() => path.stroke("1"), { name: "TypeError", message: /^width: expected/ });
  assert.throws(() => path.stroke(1, { joins: "round" }), { name: "TypeError", message: /^joins: .*join/ });
  assert.throws(() => path.stroke(1, { cap: "flat" }), { message: /^cap: expected/ });
  assert.throws(() => path.stroke(1, { miterLimit: 0 }), { name: "RangeError", message: /^miterLimit: expected/ });
  assert.throws(() => path.stroke(1, { tolerance: 0 }), { name: "RangeError", message: /^tolerance: expected/ });
  assert.throws(() => path.dash([1, -1]), { name: "RangeError", message: /-1/ });
  assert.throws(() => path.dash([0, 0]), { name: "RangeError" });
  assert.throws(() => path.dash(3), { name: "TypeError", message: /^pattern: expected an array/ });
  assert.throws(() => path.dash([NaN]), { name: "RangeError", message: /^pattern\[0\]: / });
  assert.throws(() => path.offset(Infinity), { name: "RangeError", message: /^distance: / });
  assert.throws(() => path.roundCorners(-1), { name: "RangeError", message: /^radius: .*-1$/ });
  assert.throws(() => path.roundCorners(NaN), { name: "RangeError", message: /^radius: / });
  assert.throws(() => path.roundCorners(untyped("1")), { name: "TypeError", message: /^radius: / });
  assert.throws(() => path.strokeContains([0, 0], 1, { simple: false }), { name: "TypeError", message: /^simple: / });
});

test("rounded corners: the closed form of a square, a slot, and what stays", () => {
  const rounded = SQUARE.roundCorners(0.5);
  assert.ok(Math.abs(rounded.area() - (16 - (4 - Math.PI) * 0.25)) < 1e-8);
  assert.ok(Math.abs(rounded.length() - (16 - (8 - 2 * Math.PI) * 0.5)) < 1e-7);
  // Both ends become half circles.
  assert.ok(Math.abs(Path.rect([0, 0], 4, 2).roundCorners(9).area() - (4 + Math.PI)) < 1e-7);
  assert.ok(SQUARE.roundCorners(0).equals(SQUARE));
  assert.ok(CUSP.roundCorners(1).equals(CUSP));
});
