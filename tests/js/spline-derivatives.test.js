// Derivatives, tangents, normals, curvature and torsion of splines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { coordinates, near, pointsOf, refused, SEVEN } from "./reference.js";

const CORNER = pointsOf("0,0 2,0 2,2");
/** A cubic with the control points of x = t, y = t², then the line to (4, 1). */
const PARABOLA_AND_LINE = Spline.fromCurves([new Curve([0, 0, 0.5, 0, 1, 1]).elevate(), new Curve([1, 1, 4, 1])]);

test("derivativeAt: closed forms on each segment, zero above the degree, the point for k = 0", () => {
  for (const t of [-0.5, 0, 0.25, 0.75]) {
    near(PARABOLA_AND_LINE.derivativeAt(t), [1, 2 * t]);
    near(PARABOLA_AND_LINE.derivativeAt(t, 0), [t, t * t]);
    near(PARABOLA_AND_LINE.derivativeAt(t, 2), [0, 2]);
  }
  near(PARABOLA_AND_LINE.derivativeAt(1.5), [3, 0]);
  assert.deepEqual(PARABOLA_AND_LINE.derivativeAt(1.5, 2), { x: 0, y: 0 });
});

test("derivativeAt: at a joint the segment that starts there counts, outside the first and the last segment", () => {
  const spline = new Spline(CORNER, { degree: 1 });
  assert.deepEqual(
    [-3, 0, 0.999, 1, 2, 7].map((t) => coordinates(spline.derivativeAt(t))),
    pointsOf("2,0 2,0 2,0 0,2 0,2 0,2"),
  );
  const closed = new Spline(CORNER, { degree: 1, closed: true });
  assert.deepEqual(coordinates(closed.derivativeAt(2)), [-2, -2]);
  assert.deepEqual(coordinates(closed.derivativeAt(3)), [-2, -2]);
  assert.deepEqual(coordinates(closed.derivativeAt(0)), [2, 0]);
  assert.deepEqual(closed.eval(3), { x: 0, y: 0 });
});

test("tangent and normal: unit vectors of a corner, the limit at a handle of length 0, zero on a point", () => {
  const spline = new Spline(CORNER, { degree: 1 });
  assert.deepEqual(
    [spline.tangent(0.5), spline.normal(0.5)],
    [
      { x: 1, y: 0 },
      { x: 0, y: 1 },
    ],
  );
  assert.deepEqual(
    [spline.tangent(1), spline.normal(1)],
    [
      { x: 0, y: 1 },
      { x: -1, y: 0 },
    ],
  );
  const flat = new Spline([0, 0, 0, 0, 3, 4, 3, 4, 3, 4, 3, 4, 3, 4]);
  near(flat.tangent(0), [0.6, 0.8]);
  near(flat.tangent(1), [0, 0], 0);
});

test("curvature: 2 at the vertex of y = t², zero on a line, the other sign when reversed", () => {
  near([PARABOLA_AND_LINE.curvature(0), PARABOLA_AND_LINE.curvature(1.5)], [2, 0]);
  const t = 0.5;
  near([PARABOLA_AND_LINE.curvature(t)], [2 / (1 + 4 * t * t) ** 1.5]);
  near([PARABOLA_AND_LINE.reverse().curvature(1.5)], [-2 / (1 + 4 * t * t) ** 1.5]);
});

test("torsion and the principal normal: the twisted cubic (t, t², t³) as the second segment", () => {
  const twisted = new Curve([
    [0, 0, 0],
    [1 / 3, 0, 0],
    [2 / 3, 1 / 3, 0],
    [1, 1, 1],
  ]);
  const line = new Curve(pointsOf("-1,0,0 0,0,0"));
  const spline = Spline.fromCurves([line, twisted]);
  for (const t of [0, 0.25, 0.5]) {
    near([spline.torsion(1 + t)], [12 / (4 + 36 * t * t + 36 * t ** 4)]);
  }
  near(spline.normal(1), [0, 1, 0]);
  assert.deepEqual([spline.torsion(0.5), spline.normal(0.5)], [0, { x: 0, y: 0, z: 0 }]);
  assert.equal(new Spline(SEVEN).torsion(0.5), 0);
});

test("a t that is not a finite number is refused", () => {
  const spline = new Spline(SEVEN);
  for (const method of ["eval", "derivativeAt", "tangent", "normal", "curvature", "torsion", "split"]) {
    refused(() => spline[method](Number.NaN), RangeError, /^t: /);
    refused(() => spline[method]("1"), TypeError, /^t: /);
  }
  refused(() => spline.derivativeAt(0.5, -1), RangeError, /^k: /);
  refused(() => spline.derivativeAt(0.5, 1.5), RangeError, /^k: /);
});
