// Boolean operations, strokes, dashes, offsets of regions and rounded corners of paths: one check of each function by winding numbers,
// distances or closed forms. The geometry is tested in Rust (tests/path_boolean, tests/stroke).
import assert from "node:assert/strict";
import { test } from "node:test";
import { Path } from "#js/index.js";
import { near, pointsOf, refusedAll, untyped } from "./reference.js";

const circle = (x, y, radius) => Path.circle([x, y], radius, { tolerance: 3e-4 * radius });
const STAR = Path.fromSVG("M0 -1L.59 .81L-.95 -.31H.95L-.59 .81Z");
const RING = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
const SQUARE = Path.rect([0, 0], 4, 4);
const WAVE = Path.fromSVG("M0 0C1 3 2 -3 3 0S5 2 5 0");
const CUSP = Path.fromSVG("M0 0C3 2 -1 2 2 0");
const line = (...points) => Path.polygon(points, { closed: false });
/** @type {[string, Path, Path][]} */
const PAIRS = [
  ["two circles", circle(0, 0, 1), circle(1, 0, 1)],
  ["a star and a circle", STAR, circle(0.1, 0, 0.6)],
  ["disjoint", circle(-2, 0, 0.5), circle(2, 0, 0.5)],
];
/** @type {["union" | "intersect" | "subtract" | "exclude", (a: boolean, b: boolean) => boolean][]} */
const OPERATIONS = [
  ["union", (a, b) => a || b],
  ["intersect", (a, b) => a && b],
  ["subtract", (a, b) => a && !b],
  ["exclude", (a, b) => a !== b],
];

/** Points of a grid that are farther than 0.01 from all outlines. */
function samples(...paths) {
  const points = Array.from({ length: 29 * 29 }, (_, n) => {
    const [i, k] = [Math.floor(n / 29), n % 29];
    return [-2.77 + 0.2 * i + 0.0071 * k, -1.31 + 0.0917 * k];
  });
  return points.filter((point) => paths.every((path) => path.nearest(point).distance > 0.01));
}

for (const [name, a, b] of PAIRS)
  test(`points inside of results, and their areas: ${name}`, () => {
    for (const fillRule of /** @type {const} */ (["nonzero", "evenodd"]))
      for (const [operation, expected] of OPERATIONS) {
        const result = a[operation](b, { fillRule });
        for (const point of samples(a, b)) {
          const inside = expected(a.contains(point, { fillRule }), b.contains(point, { fillRule }));
          assert.equal(result.windingNumber(point), inside ? 1 : 0, `${operation} ${fillRule} at ${point}`);
        }
      }
    const [union, intersection, difference, exclusion] = OPERATIONS.map(([operation]) => a[operation](b).area());
    const [first, second] = [a, b].map((path) => path.removeOverlaps().area());
    near([union + intersection, exclusion, difference], [first + second, union - intersection, first - intersection]);
  });

test("combine: any number of paths", () => {
  assert.equal(Path.combine([], "union").subpaths.length, 0);
  const three = [circle(0, 0, 1), circle(0.5, 0, 1), circle(0.25, 0.4, 1)];
  const [all, odd] = /** @type {const} */ (["intersect", "exclude"]).map((each) => Path.combine(three, each));
  for (const point of samples(...three)) {
    const count = three.filter((path) => path.contains(point)).length;
    assert.deepEqual([all.contains(point), odd.contains(point)], [count === 3, count % 2 === 1]);
  }
});

test("the fill rule decides what a path that crosses itself contains", () => {
  const parts = [STAR.removeOverlaps(), STAR.removeOverlaps({ fillRule: "evenodd" })].map((path) => path.subpathCount);
  assert.deepEqual(parts, [1, 5]);
  const twice = Path.fromSVG("M0 0H1V1H0Z M0 0H1V1H0Z");
  const areas = [twice.area(), twice.area({ fillRule: "nonzero" }), twice.area({ fillRule: "evenodd" })];
  assert.deepEqual(areas, [2, 1, 0]);
  near([twice.reverse().moments({ fillRule: "nonzero" }).x], [0.5]);
});

test("every operation takes the fill rule", () => {
  const twice = Path.fromSVG("M0 0H3V3H0Z M1 1H2V2H1Z"); // the square in the middle has the winding number 2
  const far = Path.rect([5, 5], 1, 1);
  for (const fillRule of /** @type {const} */ (["nonzero", "evenodd"])) {
    const area = fillRule === "nonzero" ? 9 : 8;
    const regions = [twice.union(far, { fillRule }), twice.exclude(far, { fillRule })].map((path) => path.area() - 1);
    regions.push(twice.subtract(far, { fillRule }).area(), twice.intersect(SQUARE, { fillRule }).area());
    regions.push(Path.combine([twice], "union", { fillRule }).area());
    const inside = Path.faces([twice], { fillRule }).filter((face) => face.inside[0]);
    for (const parts of [inside.map(({ path }) => path), twice.divide(line(-1, 0.5, 4, 0.5), { fillRule })])
      regions.push(parts.reduce((sum, part) => sum + part.area(), 0));
    regions.push(line(-1, 1.5, 4, 1.5).clip(twice, { fillRule }).length() + 6);
    near(regions, new Array(8).fill(area));
  }
});

test("faces: the parts of two circles, and the hole of a ring", () => {
  const [a, b] = [circle(0, 0, 1), circle(1, 0, 1)];
  const faces = Path.faces([a, b]);
  assert.equal(faces.length, 3);
  for (const point of samples(a, b)) {
    const here = faces.filter(({ path }) => path.contains(point)).map(({ inside }) => inside);
    const inside = [a.contains(point), b.contains(point)];
    assert.deepEqual(here, inside.includes(true) ? [inside] : []);
  }
  const inRing = Path.faces([RING]).map(({ inside }) => inside[0]);
  assert.deepEqual(inRing.sort(), [false, true]);
  assert.deepEqual(Path.faces([]), []);
});

test("divide and clip along lines", () => {
  const square = Path.rect([0, 0], 2, 2);
  const areas = square.divide(line(-1, 0.5, 3, 0.5)).map((part) => part.area());
  assert.deepEqual(areas.sort(), [1, 3]);
  assert.equal(square.divide(line(-1, 0.5, 1, 0.5)).length, 1);
  assert.equal(line(-1, 2, 5, 2).clip(RING).toSVG(), "M0,2 L1,2 M3,2 L4,2");
});

test("a stroke with round joins and caps is what is nearer than half its width", () => {
  for (const path of [WAVE, CUSP, SQUARE])
    for (const width of [0.1, 1]) {
      const options = /** @type {const} */ ({ join: "round", cap: "round" });
      const stroke = path.stroke(width, { ...options, tolerance: 1e-4 });
      for (const point of samples()) {
        const { distance } = /** @type {any} */ (path.nearest(point));
        if (Math.abs(distance - width / 2) < 2e-4) continue;
        assert.equal(stroke.windingNumber(point), distance < width / 2 ? 1 : 0, `${point}`);
        assert.equal(path.strokeContains(point, width, options), distance < width / 2, `${point}`);
      }
    }
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

test("caps and joins of strokes: areas in closed form", () => {
  const straight = line(0, 0, 10, 0);
  /** @type {[Path, any, number][]} */
  const cases = [
    [straight, undefined, 20],
    [straight, { cap: "square" }, 24],
    [straight, { cap: "round", tolerance: 1e-6 }, 20 + Math.PI],
    [SQUARE, undefined, 36 - 4],
    [SQUARE, { join: "bevel" }, 36 - 4 - 2],
    [SQUARE, { miterLimit: 1 }, 36 - 4 - 2],
  ];
  for (const [path, options, area] of cases)
    near([path.stroke(2, options).area()], [area], options?.tolerance ?? 1e-12);
  assert.equal(straight.stroke(0).subpathCount, 0);
});

test("dashes: their lengths, and the dash across the start of a closed subpath", () => {
  assert.equal(line(0, 0, 10, 0).dash([4, 2]).toSVG(), "M0,0 L4,0 M6,0 L10,0");
  const dashes = WAVE.dash([0.5, 0.25], 0.1).subpaths.map((piece) => piece.length());
  near(dashes.slice(1, -1), new Array(dashes.length - 2).fill(0.5), 1e-9);
  const around = SQUARE.dash([2, 2], 1).subpaths.map((piece) => piece.length());
  near(around, [2, 2, 2, 2]);
  const stroked = SQUARE.stroke(0.2, { dash: [2, 2], dashOffset: 1 });
  assert.ok(stroked.equals(SQUARE.dash([2, 2], 1).stroke(0.2), 1e-12));
});

test("offset and roundCorners: areas in closed form", () => {
  for (const square of [SQUARE, SQUARE.reverse()]) {
    const areas = [1, -1, -3].map((distance) => square.offset(distance).area());
    assert.deepEqual(areas, [36, 4, 0]);
    near([square.offset(1, { join: "round", tolerance: 1e-6 }).area()], [32 + Math.PI], 1e-5);
  }
  const rounded = SQUARE.roundCorners(0.5);
  near([rounded.area(), rounded.length()], [16 - (4 - Math.PI) * 0.25, 16 - (8 - 2 * Math.PI) * 0.5], 1e-8);
  const corners = [{ subpath: 0, t: 1 }];
  assert.ok(Math.abs(SQUARE.roundCorners(0.5, { corners }).area() - (SQUARE.area() - 0.25 * (1 - Math.PI / 4))) < 1e-9);
  const count = (path) => path.subpaths[0].segmentCount;
  const coarse = SQUARE.roundCorners(0.5, { tolerance: 0.01 });
  assert.ok(count(coarse) === 8 && count(rounded) > 8, `${count(coarse)}`);
  assert.ok(SQUARE.roundCorners(0).equals(SQUARE) && CUSP.roundCorners(1).equals(CUSP));
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
