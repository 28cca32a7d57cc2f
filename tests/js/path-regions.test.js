// Options and results of operations on regions that only JavaScript has: profiles of widths, some corners, arcs as text. Their numbers
// are those of Rust (parity.test.js).
import assert from "node:assert/strict";
import { test } from "node:test";
import { Path } from "#js/index.js";
import { near, pointsOf, refusedAll, untyped } from "./reference.js";

const SQUARE = Path.rect([0, 0], 4, 4);
const WAVE = Path.fromSVG("M0 0C1 3 2 -3 3 0S5 2 5 0");
const line = (...points) => Path.polygon(points, { closed: false });

test("combine: any number of paths; faces: none", () => {
  assert.equal(Path.combine([], "union").subpaths.length, 0);
  assert.deepEqual(Path.faces([]), []);
});

test("widths along a stroke: a cone, positions by length and by t", () => {
  const line = Path.polygon([0, 0, 10, 0], { closed: false });
  const cone = {
    stops: [
      [0, 2],
      [1, 6],
    ],
  };
  const round = { cap: /** @type {const} */ ("round"), tolerance: 1e-9 };
  // The hull of two discs of radius 1 and 3.
  const angle = Math.acos(-0.2);
  const area = 4 * Math.sqrt(96) + Math.PI - angle + 9 * angle;
  near([line.stroke(cone, round).area()], [area], 1e-7);
  assert.ok(line.strokeContains([10, 2.9], cone, { cap: "round" }));
  assert.ok(!line.strokeContains([5, 2.2], cone, { cap: "round" }));
  // Positions by t: half of the parameters are on the first line, a tenth of the length.
  const bent = Path.polygon([0, 0, 1, 0, 10, 0], { closed: false });
  const late = [
    [0, 1],
    [0.5, 1],
    [1, 4],
  ];
  for (const at of /** @type {const} */ (["length", "t"])) {
    const outline = bent.stroke({ stops: late, at, interpolation: "smooth" });
    assert.ok((outline.bounds()?.max.y ?? 0) > 1.9);
  }
  const wide = (/** @type {"length" | "t"} */ at) => bent.strokeContains([4, 0.6], { stops: late, at });
  assert.deepEqual([wide("t"), wide("length")], [true, false]);
});

test("strokes with different widths on both sides", () => {
  const straight = line(0, 0, 10, 0);
  const sides = { left: 3, right: 1 };
  near([straight.stroke(sides).area(), straight.stroke(sides, { cap: "square" }).area()], [40, 56]);
  const bounds = straight.stroke(sides).bounds();
  assert.deepEqual([bounds?.min.y, bounds?.max.y], [-1, 3]);
  assert.deepEqual(
    [2.9, 3.1, -0.9, -1.1].map((y) => straight.strokeContains([5, y], sides)),
    [true, false, true, false],
  );
  assert.ok(straight.strokeContains([11, 1], sides, { cap: "round" }));
  assert.ok(WAVE.stroke({ left: 0.2, right: 0.2 }).equals(WAVE.stroke(0.4)));
  assert.equal(WAVE.stroke({ left: 0, right: 0 }).subpathCount, 0);
});

test("default values of options: nonzero, mitered offsets", () => {
  const star = Path.fromSVG("M0 -1L.59 .81L-.95 -.31H.95L-.59 .81Z");
  const counts = [{}, { fillRule: "nonzero" }, { fillRule: "evenodd" }].map((/** @type {any} */ options) =>
    [star.removeOverlaps(options), star.union(new Path([]), options)].map(({ subpathCount }) => subpathCount),
  );
  assert.deepEqual(counts, [
    [1, 1],
    [1, 1],
    [5, 5],
  ]);
  assert.ok(SQUARE.offset(1).equals(SQUARE.offset(1, { join: "miter" })) && SQUARE.offset(1).area() === 36);
});

test("options of strokes: the default join and cap, the limit of miters, dashes", () => {
  const areas = [{}, { join: "miter", cap: "butt" }, { join: "bevel" }, { miterLimit: 1 }].map(
    (/** @type {any} */ options) => SQUARE.stroke(2, options).area(),
  );
  near(areas, [32, 32, 30, 30]);
  assert.equal(line(0, 0, 10, 0).stroke(0).subpathCount, 0);
  const stroked = SQUARE.stroke(0.2, { dash: [2, 2], dashOffset: 1 });
  assert.ok(stroked.equals(SQUARE.dash([2, 2], 1).stroke(0.2), 1e-12));
});

test("roundCorners: some corners, and a tolerance", () => {
  const corners = [{ subpath: 0, t: 1 }];
  assert.ok(Math.abs(SQUARE.roundCorners(0.5, { corners }).area() - (SQUARE.area() - 0.25 * (1 - Math.PI / 4))) < 1e-9);
  const count = (path) => path.subpaths[0].segmentCount;
  const [coarse, fine] = [SQUARE.roundCorners(0.5, { tolerance: 0.01 }), SQUARE.roundCorners(0.5)];
  assert.ok(count(coarse) === 8 && count(fine) > 8, `${count(coarse)}`);
});

test("roundCorners: a radius for each corner, as a list and by a function", () => {
  const rect = Path.rect([0, 0], 20, 10);
  const missing = (...radii) => radii.reduce((sum, r) => sum + (1 - Math.PI / 4) * r * r, 0);
  const sameAsRect = Path.rect([0, 0], 20, 10, { radii: [1, 2, 3, 4] });
  for (const radii of [[1, 2, 3, 4], Float64Array.of(1, 2, 3, 4), (_, k) => k + 1, ({ t }) => t + 1]) {
    const rounded = rect.roundCorners(radii);
    near([rounded.area()], [200 - missing(1, 2, 3, 4)], 1e-7);
    assert.ok(Math.abs(sameAsRect.subtract(rounded).area()) + Math.abs(rounded.subtract(sameAsRect).area()) < 1e-3);
  }
  // What a corner leaves does not change the places of the others.
  const both = new Path([...rect.subpaths, ...Path.polygon([40, 0, 50, 0, 50, 10], { closed: false }).subpaths]);
  const seen = [];
  both.roundCorners((corner, k) => {
    seen.push([corner.subpath, corner.t, k]);
    return 0;
  });
  assert.deepEqual(seen, pointsOf("0,0,0 0,1,1 0,2,2 0,3,3 1,1,4"));
  assert.ok(both.roundCorners([0, 0, 0, 0, 0]).equals(both));
  const corners = [
    { subpath: 0, t: 2 },
    { subpath: 0, t: 0 },
  ];
  near([rect.roundCorners([3, 1], { corners }).area()], [200 - missing(3, 1)], 1e-7);
  near([rect.roundCorners(({ t }) => t, { corners }).area()], [200 - missing(2)], 1e-7);
  refusedAll(RangeError, [
    [() => rect.roundCorners([1, 2, 3]), /^radius: expected 4 radii, one for each corner, got 3$/],
    [() => rect.roundCorners([1], { corners }), /^radius: expected 2 radii, one for each corner, got 1$/],
    [() => rect.roundCorners([1, 2, -3, 4]), /^radius\[2\]: expected a finite number, at least 0, got -3$/],
    [() => rect.roundCorners(() => NaN), /^radius\[0\]: expected a finite number, got NaN$/],
  ]);
  const wrong = untyped(rect);
  refusedAll(TypeError, [
    [() => wrong.roundCorners([1, "2", 3, 4]), /^radius\[1\]: expected a number/],
    [() => wrong.roundCorners(() => undefined), /^radius\[0\]: expected a number, got undefined/],
    [() => wrong.roundCorners({ stops: [] }), /^radius: expected a number/],
  ]);
});

test("arcs: half circles, lines, tangents, and the text that they give", () => {
  const [arcs] = Path.circle([3, 4], 2).toArcs(1e-3);
  near([arcs.length, arcs[0].radius, arcs[0].endAngle - arcs[0].startAngle], [2, 2, Math.PI], 1e-4);
  near(Object.values(arcs[0].center ?? {}), [3, 4], 1e-4);
  assert.deepEqual(arcs[0].end, arcs[1].start);
  const [line] = Path.polygon([0, 0, 4, 3], { closed: false }).toArcs(0.1)[0];
  const straight = { center: null, radius: Infinity, startAngle: 0, endAngle: 0 };
  assert.deepEqual(line, { start: { x: 0, y: 0 }, end: { x: 4, y: 3 }, ...straight });
  const rounded = Path.rect([0, 0], 10, 6, { radii: 1 });
  assert.equal(
    rounded.toSVG({ arcs: 0.001, precision: 3 }),
    "M1 0H9A1 1 0 0 1 10 1V5A1 1 0 0 1 9 6H1A1 1 0 0 1 0 5V1A1 1 0 0 1 1 0Z",
  );
  assert.equal(SQUARE.toSVG({ arcs: 0.001 }), "M0,0 L4,0 L4,4 L0,4 Z");
  const approximated = Path.fromSVG(WAVE.toSVG({ arcs: 0.01 }), { tolerance: 1e-6 });
  for (const curve of approximated.subpaths.flatMap((spline) => spline.segments()))
    for (const t of [0, 0.5]) assert.ok((WAVE.nearest(curve.eval(t))?.distance ?? 1) <= 0.01 + 1e-6);
  assert.deepEqual(new Path([]).toArcs(1), []);
});
