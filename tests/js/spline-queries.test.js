// Derivatives, tangents, normals, curvature and torsion of splines; their extrema, and parameters at which a coordinate has a value.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { coordinates, near, pointsOf, SEVEN, TWISTED } from "./reference.js";

/** Lines between points. */
const polyline = (points, closed = false) => new Spline(pointsOf(points), { degree: 1, closed });
const CORNER = polyline("0,0 2,0 2,2");
/** A cubic with the control points of x = t, y = t², then the line to (4, 1). */
const PARABOLA_AND_LINE = Spline.fromCurves([new Curve([0, 0, 0.5, 0, 1, 1]).elevate(), new Curve([1, 1, 4, 1])]);
const K = (4 / 3) * (Math.SQRT2 - 1);
/** A circle of four cubics that starts at (1, 0); its extrema are its joints. */
const CIRCLE = new Spline([1, 0, 1, K, K, 1, 0, 1, -K, 1, -1, K, -1, 0, -1, -K, -K, -1, 0, -1, K, -1, 1, -K], {
  closed: true,
});

test("derivativeAt and curvature: closed forms on each segment, zero above the degree, the point for k = 0", () => {
  for (const t of [-0.5, 0, 0.25, 0.75]) {
    near(PARABOLA_AND_LINE.derivativeAt(t), [1, 2 * t]);
    near(PARABOLA_AND_LINE.derivativeAt(t, 0), [t, t * t]);
    near(PARABOLA_AND_LINE.derivativeAt(t, 2), [0, 2]);
    const curvature = 2 / (1 + 4 * t * t) ** 1.5;
    near([PARABOLA_AND_LINE.curvature(t), PARABOLA_AND_LINE.reverse().curvature(2 - t)], [curvature, -curvature]);
  }
  near([...coordinates(PARABOLA_AND_LINE.derivativeAt(1.5)), PARABOLA_AND_LINE.curvature(1.5)], [3, 0, 0]);
  assert.deepEqual(PARABOLA_AND_LINE.derivativeAt(1.5, 2), { x: 0, y: 0 });
});

test("derivativeAt: at a joint the segment that starts there counts, outside the first and the last segment", () => {
  const at = (spline, ts) => ts.map((t) => coordinates(spline.derivativeAt(t)));
  assert.deepEqual(at(CORNER, [-3, 0, 0.999, 1, 2, 7]), pointsOf("2,0 2,0 2,0 0,2 0,2 0,2"));
  const closed = polyline("0,0 2,0 2,2", true);
  assert.deepEqual(at(closed, [2, 3, 0]), pointsOf("-2,-2 -2,-2 2,0"));
  assert.deepEqual(closed.eval(3), { x: 0, y: 0 });
});

test("tangent and normal: unit vectors of a corner, the limit at a handle of length 0, zero on a point", () => {
  const directions = [0.5, 1].flatMap((t) => [CORNER.tangent(t), CORNER.normal(t)]).map(coordinates);
  assert.deepEqual(directions, pointsOf("1,0 0,1 0,1 -1,0"));
  const flat = new Spline([0, 0, 0, 0, 3, 4, 3, 4, 3, 4, 3, 4, 3, 4]);
  near(flat.tangent(0), [0.6, 0.8]);
  near(flat.tangent(1), [0, 0], 0);
});

test("torsion and the principal normal: the twisted cubic (t, t², t³) as the second segment", () => {
  const spline = Spline.fromCurves([new Curve(pointsOf("-1,0,0 0,0,0")), new Curve(TWISTED)]);
  for (const t of [0, 0.25, 0.5]) near(spline.torsion(1 + t), 12 / (4 + 36 * t * t + 36 * t ** 4));
  near(spline.normal(1), [0, 1, 0]);
  assert.deepEqual([spline.torsion(0.5), spline.normal(0.5)], [0, { x: 0, y: 0, z: 0 }]);
  assert.equal(new Spline(SEVEN).torsion(0.5), 0);
});

/** Splines with the parameters of their extrema in x and in y. @type {[string, Spline, number[], number[]][]} */
const EXTREMA = [
  ["joints, not the ends of an open spline", polyline("0,0 1,2 2,-1 3,-2 2,5"), [3], [1, 3]],
  ["the inside of segments", new Spline([0, 0, 1, 2, 2, 0, 3, 2, 4, 0], { degree: 2 }), [], [0.5, 1, 1.5]],
  ["a circle at its joints, the start as 0", CIRCLE, [0, 2], [1, 3]],
  ["an open circle without its ends", CIRCLE.subsegment(0, 4), [2], [1, 3]],
  ["both joints of a constant part between a rise and a fall", polyline("0,0 1,1 2,1 3,0"), [], [1, 2]],
  ["none between two rises", polyline("0,0 1,1 2,1 3,2"), [], []],
  ["a constant coordinate", polyline("0,0 1,0 2,0", true), [0, 2], []],
  ["a constant part with the start", polyline("1,0 2,0 2,3 0,3 0,0", true), [1, 2, 3, 4], [0, 1, 2, 3, 4]],
];
for (const [name, spline, x, y] of EXTREMA)
  test(`extrema: ${name}`, () =>
    assert.deepEqual(spline.extrema(), { x: Float64Array.from(x), y: Float64Array.from(y) }));

test("extrema: z in space", () => {
  const spline = new Spline([0, 0, 0, 1, 0, 5, 2, 0, 1], { degree: 1, dimension: 3 });
  assert.deepEqual(Object.keys(spline.extrema()), ["x", "y", "z"]);
  assert.deepEqual(spline.extrema().z, Float64Array.of(1));
});

test("timesAtCoordinate: each time once, joints too, the start of a closed spline as 0, both ends of a constant segment", () => {
  const zigzag = polyline("0,0 1,2 2,0 3,4");
  /** @type {[Spline, any, number[]][]} */
  const cases = [
    [zigzag, { y: 1 }, [0.5, 1.5, 2.25]],
    [zigzag, { y: 2 }, [1, 2.5]],
    [zigzag, { y: 0 }, [0, 2]],
    [zigzag, { x: 2.5 }, [2.5]],
    [zigzag, { y: 9 }, []],
    [CIRCLE, { x: 1 }, [0]],
    [CIRCLE, { y: 0 }, [0, 2]],
    [polyline("0,0 1,1 2,1 3,0"), { y: 1 }, [1, 2]],
  ];
  for (const [spline, where, ts] of cases) assert.deepEqual([...spline.timesAtCoordinate(where)], ts);
});
