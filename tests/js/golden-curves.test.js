// Curves compared with golden values: closed forms (tests/data/curve-facts.json), and other libraries (only in ../shared/data).
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { Curve, Path, Spline, easing } from "casteljau";
import { pairs } from "./reference.js";

const read = async (path) => JSON.parse(await readFile(new URL(path, import.meta.url), "utf8"));
const facts = await read("../data/curve-facts.json");
const shared = await read("../../../shared/data/curve-facts.json").catch(() => null);
const others = shared?.filter(({ truth }) => truth === "library");

const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);
const point = (/** @type {number[]} */ [x, y]) => ({ x, y });

/** Numbers, or nested lists of them, within the fact's tolerance. */
function near(got, expected, tol, what = "") {
  if (got && typeof got === "object" && "x" in got)
    near([got.x, got.y, got.z].slice(0, expected.length), expected, tol, what);
  else if (Array.isArray(expected)) {
    assert.equal(got.length, expected.length, `${what}: got ${JSON.stringify(got)}`);
    expected.forEach((part, k) => near(got[k], part, tol, `${what}[${k}]`));
  } else assert.ok(Math.abs(got - expected) <= tol, `${what}: got ${got}, expected ${expected} ± ${tol}`);
}

/** Meetings: an overlap, or points with kinds. */
function meetings({ input, expect, tol }) {
  const found = new Curve(input.a).intersections(new Curve(input.b));
  if (expect.overlap) return assert.ok(JSON.stringify(found).includes('"kind":"overlap"'));
  if (expect.count === undefined) return; // the note tells what is acceptable
  assert.equal(found.length, expect.count, JSON.stringify(found));
  // Equal t may be in either order.
  const order = (list) => list.toSorted((a, b) => (Math.abs(a.t - b.t) > 1e-6 ? a.t - b.t : a.u - b.u));
  const wanted = order(expect.t.map((t, k) => ({ t, u: expect.s[k], tangent: expect.tangent?.[k] })));
  order(found).forEach(({ t, u, kind }, k) => {
    near([t, u], [wanted[k].t, wanted[k].u], tol);
    if (expect.tangent) assert.equal(kind, wanted[k].tangent ? "tangent" : "cross", `at ${t}`);
  });
}

function offset({ input, expect, tol }) {
  const curve = new Curve(input.points);
  const spline = curve.offset(input.distance, expect.ends ? undefined : { tolerance: tol / 10 });
  const points = pairs(spline.sample(64)).map(point);
  assert.ok(points.every(({ x, y }) => Number.isFinite(x) && Number.isFinite(y)));
  if (expect.ends) {
    near([points[0], points.at(-1)], expect.ends, tol, "ends");
    const straight = points.every(({ y }) => Math.abs(y - expect.ends[0][1]) <= tol);
    assert.ok(straight, "straight");
    return;
  }
  // Past a cusp of the offset a point may be nearer to another part of the curve, never farther.
  const d = Math.abs(input.distance);
  for (const p of points) assert.ok(curve.nearest(p).distance <= d + tol);
}

/** The facts about arcs are exact to nine digits. */
const ARC_TOLERANCE = 1e-10;

function svg({ input, expect, tol }) {
  if (expect.error) return assert.throws(() => Path.fromSVG(input.d), RangeError);
  const path = Path.fromSVG(input.d, { tolerance: ARC_TOLERANCE });
  const curves = path.subpaths.flatMap((spline) => spline.segments());
  if (expect.segments) {
    const points = curves.map((curve) => pairs(curve.controlPoints()));
    const expected = expect.segments.map(([, points]) => points);
    near(points, expected, tol, "segments");
  }
  if (expect.segment_count) assert.equal(curves.length, expect.segment_count);
  if (expect.reversed) assert.deepEqual(path.reverse().toSVG(), Path.fromSVG(expect.reversed).toSVG());
  if (expect.arc) {
    const center = point(expect.arc.center);
    for (const p of path.subpaths.flatMap((spline) => pairs(spline.sample(32)).map(point))) {
      near(distance(p, center), expect.arc.radius, 1e-9 * expect.arc.radius, "radius");
    }
  }
}

const KINDS = {
  eval: ({ input, expect, tol }) => near(new Curve(input.points).eval(input.t), expect, tol),
  derivative: ({ input, expect, tol }) => near(new Curve(input.points).derivativeAt(input.t, input.order), expect, tol),
  tangent: ({ input, expect, tol }) => near(new Curve(input.points).tangent(input.t), expect, tol),
  curvature: ({ input, expect, tol }) => near(new Curve(input.points).curvature(input.t), expect, tol),
  bbox({ input, expect, tol }) {
    const { min, max } = new Curve(input.points).bounds();
    near([min, max], [expect.min, expect.max], tol);
  },
  extrema({ input, expect, tol }) {
    const { x, y } = new Curve(input.points).extrema();
    const found = [x, y].map((ts) => Array.from(ts));
    near(found, [expect.x, expect.y], tol, "extrema");
  },
  inflection: ({ input, expect, tol }) => near(new Curve(input.points).inflections(), expect, tol, "inflections"),
  classify: ({ input, expect }) => assert.equal(new Curve(input.points).classify(), expect.class),
  selfintersect({ input, expect, tol }) {
    const found = new Curve(input.points).selfIntersections();
    assert.equal(found.length, expect.count, JSON.stringify(found));
    if (expect.count) near([found[0].t, found[0].u], expect.t, tol, "t");
  },
  split({ input, expect, tol }) {
    const halves = new Curve(input.points).split(input.t).map((half) => pairs(half.controlPoints()));
    near(halves, [expect.left, expect.right], tol);
  },
  subsegment: ({ input, expect, tol }) =>
    near(pairs(new Curve(input.points).subsegment(input.t0, input.t1).controlPoints()), expect, tol),
  elevate: ({ input, expect, tol }) => near(pairs(new Curve(input.points).elevate().controlPoints()), expect, tol),
  reduce({ input, expect, tol }) {
    const { curve, error } = new Curve(input.points).reduce();
    near(pairs(curve.controlPoints()), expect.points, tol);
    near(error, expect.error, tol);
  },
  length: ({ input, expect, tol }) => near(new Curve(input.points).length(), expect, tol),
  inverse_length({ input, expect, tol }) {
    const curve = new Curve(input.points);
    near(curve.timeAtLength(input.s === "length" ? curve.length() : input.s), expect, tol);
  },
  nearest({ input, expect, tol }) {
    const found = new Curve(input.points).nearest(input.query);
    near(found.distance, expect.distance, tol, "distance");
    const ts = [expect.t, ...(expect.also_t ?? [])];
    const isExpected = ts.some((t) => Math.abs(found.t - t) <= tol);
    assert.ok(isExpected, `t: got ${found.t}, expected one of ${ts}`);
  },
  intersect: meetings,
  line_intersect: meetings,
  min_distance({ input, expect, tol }) {
    const { distance, t, u } = new Curve(input.a).distanceTo(new Curve(input.b));
    near([distance, t, u], [expect.distance, expect.t, expect.s], tol);
  },
  area({ input, expect, tol }) {
    if (!input.svg) return near(new Curve(input.points).area(), expect, tol);
    const path = Path.fromSVG(input.svg);
    near(Math.abs(path.area()), expect.abs_area, tol);
    near(path.length(), expect.perimeter, tol);
  },
  contains: ({ input, expect }) =>
    input.queries.forEach((p, k) => assert.equal(Path.fromSVG(input.svg).contains(p), expect[k], `${p}`)),
  easing: ({ input, expect, tol }) =>
    near(easing(.../** @type {[number, number, number, number]} */ (input.bezier))(input.x), expect, tol),
  circle({ input, expect, tol }) {
    const { k } = input;
    const quarter = new Curve([1, 0, 1, k, k, 1, 0, 1]);
    const errors = pairs(quarter.sample(10_000)).map(([x, y]) => Math.hypot(x, y) - 1);
    near([Math.min(...errors), Math.max(...errors)], [expect.min_radial_error, expect.max_radial_error], tol);
  },
  convert({ input, expect, tol }) {
    if (input.catmull_rom)
      return near(pairs(Curve.fromBasis("catmull-rom", input.catmull_rom).controlPoints()), expect, tol);
    const monomials = new Curve(input.points).toBasis([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    const axes = [0, 1].map((axis) => monomials.filter((_, i) => i % 2 === axis).reverse());
    near(axes, [expect.x, expect.y], tol);
  },
  bspline({ input, expect, tol }) {
    const { points, degree, knots, u } = input;
    const spline = Spline.fromBSpline(points, { degree, knots });
    near(spline.eval(u - knots[degree]), expect, tol); // knots one apart: a segment for each
  },
  continuity({ input, expect }) {
    const { c0, g1, c1, c2 } = Spline.fromCurves([new Curve(input.a), new Curve(input.b)]).continuity(1);
    assert.deepEqual([c0, g1, c1, c2], [expect.C0, expect.G1, expect.C1, expect.C2]);
  },
  offset,
  flatten({ input, expect }) {
    const { points } = new Curve(input.points).flatten(input.tolerance);
    assert.ok(points.length / 2 - 1 <= 1.5 * expect.greedy_min_segments + 4);
  },
  svgpath: svg,
  solve_t({ input, expect, tol }) {
    const { points, ...value } = input;
    near(new Curve(points).timesAtCoordinate(value), expect, tol, "ts");
  },
};

/** Nothing in the interface can express them: rational weights, polynomials, the centroid by length. */
const WITHOUT = ["eval_rational", "roots", "length_centroid"];

for (const fact of [...facts, ...(others ?? [])]) {
  if (WITHOUT.includes(fact.kind)) continue;
  test(`${fact.id}: ${fact.source}`, () => {
    const check = KINDS[fact.kind];
    assert.ok(check, `no check for facts of the kind ${fact.kind}`);
    check(fact);
  });
}
test("the golden values are complete", () => assert.equal(facts.length, 116));
const absent = !others && "../shared/data/curve-facts.json is absent";
test("the golden values of other libraries are complete", { skip: absent }, () => assert.equal(others.length, 5));
