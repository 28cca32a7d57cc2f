// Boolean operations of paths, against winding numbers of the inputs at sample points.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Path } from "../../js/index.js";
import { untyped } from "./reference.js";

const circle = (x, y, radius) => Path.circle([x, y], radius, { tolerance: 3e-4 * radius });
const STAR = Path.fromSVG("M0 -1L.59 .81L-.95 -.31H.95L-.59 .81Z");
/** @type {[string, Path, Path][]} */
const PAIRS = [
  ["two circles", circle(0, 0, 1), circle(1, 0, 1)],
  ["a circle in another one", circle(0, 0, 1), circle(0.2, 0.1, 0.3)],
  ["circles that touch", circle(0, 0, 1), circle(2, 0, 1)],
  ["squares that share a part of an edge", Path.rect([-1, -1], 1, 1), Path.rect([0, -0.5], 0.7, 1)],
  ["a star and a circle", STAR, circle(0.1, 0, 0.6)],
  ["disjoint", circle(-2, 0, 0.5), circle(2, 0, 0.5)],
  ["the same", circle(0, 0, 1), circle(0, 0, 1)],
];

/** @type {["union" | "intersect" | "subtract" | "exclude", (a: boolean, b: boolean) => boolean][]} */
const OPERATIONS = [
  ["union", (a, b) => a || b],
  ["intersect", (a, b) => a && b],
  ["subtract", (a, b) => a && !b],
  ["exclude", (a, b) => a !== b],
];

/** Points of a grid that are farther than 0.01 from both outlines. */
function samples(...paths) {
  const points = [];
  for (let i = 0; i < 29; i++)
    for (let k = 0; k < 29; k++) points.push([-2.77 + 0.2 * i + 0.0071 * k, -1.31 + 0.0917 * k]);
  return points.filter((point) => paths.every((path) => path.nearest(point).distance > 0.01));
}

for (const [name, a, b] of PAIRS)
  test(`points inside of results: ${name}`, () => {
    for (const fillRule of /** @type {const} */ (["nonzero", "evenodd"]))
      for (const [operation, expected] of OPERATIONS) {
        const result = a[operation](b, { fillRule });
        for (const point of samples(a, b)) {
          const winding = result.windingNumber(point);
          const inside = expected(a.contains(point, { fillRule }), b.contains(point, { fillRule }));
          assert.equal(winding, inside ? 1 : 0, `${operation} ${fillRule} at ${point}`);
        }
      }
  });

for (const [name, a, b] of PAIRS)
  test(`areas add up: ${name}`, () => {
    const area = (path) => path.removeOverlaps().area();
    const [union, intersection, difference, exclusion] = OPERATIONS.map(([operation]) => a[operation](b).area());
    const near = (value, expected) => assert.ok(Math.abs(value - expected) < 1e-12, `${value}, not ${expected}`);
    near(union + intersection, area(a) + area(b));
    near(exclusion, union - intersection);
    near(difference, area(a) - intersection);
  });

test("segments that nothing touches are kept bit for bit", () => {
  const [a, b] = [circle(0, 0, 1), circle(1, 0, 1)];
  const kept = a.union(b).subpaths[0].segments();
  const left = a.subpaths[0].segments().filter((segment) => segment.bounds().max.x < 0.4);
  assert.equal(left.length, 2);
  for (const segment of left) assert.ok(kept.some((other) => other.equals(segment)));
});

test("combine: any number of paths", () => {
  assert.equal(Path.combine([], "union").subpaths.length, 0);
  const three = [circle(0, 0, 1), circle(0.5, 0, 1), circle(0.25, 0.4, 1)];
  const all = Path.combine(three, "intersect");
  for (const point of samples(...three))
    assert.equal(
      all.contains(point),
      three.every((path) => path.contains(point)),
    );
  const odd = Path.combine(three, "exclude");
  for (const point of samples(...three))
    assert.equal(
      odd.contains(point),
      three.reduce((inside, path) => inside !== path.contains(point), false),
    );
});

test("the fill rule decides what a path that crosses itself contains", () => {
  assert.equal(STAR.removeOverlaps().subpaths.length, 1);
  assert.equal(STAR.removeOverlaps({ fillRule: "evenodd" }).subpaths.length, 5);
});

test("faces: the parts of two circles, and the hole of a ring", () => {
  const [a, b] = [circle(0, 0, 1), circle(1, 0, 1)];
  const faces = Path.faces([a, b]);
  assert.equal(faces.length, 3);
  for (const point of samples(a, b)) {
    const here = faces.filter(({ path }) => path.contains(point));
    const inside = [a.contains(point), b.contains(point)];
    assert.equal(here.length, inside.includes(true) ? 1 : 0);
    if (here.length) assert.deepEqual(here[0].inside, inside);
  }
  const ring = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
  assert.deepEqual(
    Path.faces([ring])
      .map(({ inside }) => inside[0])
      .sort(),
    [false, true],
  );
  assert.deepEqual(Path.faces([]), []);
});

test("divide: a square along a line", () => {
  const square = Path.rect([0, 0], 2, 2);
  const parts = square.divide(Path.polygon([-1, 0.5, 3, 0.5], { closed: false }));
  assert.deepEqual(parts.map((part) => part.area()).sort(), [1, 3]);
  assert.equal(square.divide(Path.polygon([-1, 0.5, 1, 0.5], { closed: false })).length, 1);
});

test("clip: the parts of a line inside a ring", () => {
  const line = Path.polygon([-1, 2, 5, 2], { closed: false });
  const inside = line.clip(Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z"));
  const ends = inside.subpaths.map((piece) => [...piece.controlPoints()]);
  assert.deepEqual(ends, [
    [0, 2, 1, 2],
    [3, 2, 4, 2],
  ]);
});

test("area and moments of the filled region", () => {
  const twice = Path.fromSVG("M0 0H1V1H0Z M0 0H1V1H0Z");
  assert.equal(twice.area(), 2);
  assert.equal(twice.area({ fillRule: "nonzero" }), 1);
  assert.equal(twice.area({ fillRule: "evenodd" }), 0);
  assert.ok(Math.abs(twice.reverse().moments({ fillRule: "nonzero" }).x - 0.5) < 1e-15);
  assert.throws(() => untyped(twice).area({ rule: "nonzero" }), { name: "TypeError", message: /fillRule/ });
});

test("wrong arguments", () => {
  const a = untyped(circle(0, 0, 1));
  assert.throws(() => a.union(), { name: "TypeError", message: /^other: expected a Path, got undefined/ });
  assert.throws(() => a.union("M0 0"), { name: "TypeError", message: /^other: expected a Path/ });
  assert.throws(() => a.union(a, { rule: "evenodd" }), { name: "TypeError", message: /^rule: .*fillRule/ });
  assert.throws(() => a.union(a, { fillRule: "odd" }), { message: /^fillRule: expected/ });
  assert.throws(() => untyped(Path).combine(a, "union"), { name: "TypeError", message: /^paths: expected an array/ });
  assert.throws(() => untyped(Path).combine([a, 1], "union"), { message: /^paths\[1\]: expected a Path, got 1/ });
  assert.throws(() => untyped(Path).combine([a], "subtract"), { message: /^operation: expected/ });
});
