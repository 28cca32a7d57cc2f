// A computation for each erratum about curves: a sentence with the numbers, and whether they prove the correction.
import { Curve, Path, Spline } from "casteljau";
import { Patch } from "casteljau/surfaces";
import { roundingErrors } from "./rounding.js";
import { listed, rounded } from "./format.js";

/** @typedef {{ words: string, holds: boolean }} Proof */
/** @typedef {[number, number]} Point */

/** @param {number} count */
const steps = (count) => Array.from({ length: count + 1 }, (_, i) => i / count);
/** @param {{ x: number, y: number }} p @param {{ x: number, y: number }} q */
const distance = (p, q) => Math.hypot(p.x - q.x, p.y - q.y);

/** The first curve of the applet. @type {Point[]} */
const ARCH = [
  [70, 330],
  [90, 80],
  [280, 60],
  [335, 240],
];

/** The continuity at the joint of two cubics with these seven points. @param {Point[]} points */
const jointOf = (points) => new Spline(points).continuity(1);
/** A joint at (100, 0) with P2 = (60, 0). @param {Point} p4 */
const alignedJoint = (p4) => jointOf([[0, 0], [0, 80], [60, 0], [100, 0], p4, [220, 90], [260, 0]]);

/** The second derivatives on both sides of a joint with b2 as given. @param {number} degree @param {Point} offset added to b2 */
function c2Jump(degree, offset) {
  const a = Array.from({ length: degree + 1 }, (_, i) => [40 * i, 30 * ((i * i) % 5)]);
  const [a2, a1, a0] = a.slice(-3);
  const b = Array.from({ length: degree + 1 }, (_, i) => [40 * (degree + i), 20 * i]);
  b[0] = a0;
  b[1] = [0, 1].map((k) => 2 * a0[k] - a1[k]);
  b[2] = [0, 1].map((k) => a2[k] - 4 * a1[k] + 4 * a0[k] + offset[k]);
  const second = (/** @type {number[][]} */ p, /** @type {number} */ t) =>
    new Curve(/** @type {Point[]} */ (p)).derivative().derivativeAt(t);
  return distance(second(a, 1), second(b, 0));
}

/** The corrected listing. @param {Point[]} p @param {number} t @returns {Point[][]} */
function splitBezier(p, t) {
  const between = (/** @type {Point} */ a, /** @type {Point} */ b) =>
    /** @type {Point} */ (a.map((x, k) => (1 - t) * x + t * b[k]));
  const [p12, p23, p34] = [between(p[0], p[1]), between(p[1], p[2]), between(p[2], p[3])];
  const [p1223, p2334] = [between(p12, p23), between(p23, p34)];
  const point = between(p1223, p2334);
  return [
    [p[0], p12, p1223, point],
    [point, p2334, p34, p[3]],
  ];
}

/** @type {Record<string, () => Proof>} */
export const curveProofs = {
  "four-points"() {
    const [two, three] = [ARCH.slice(0, 2), ARCH.slice(0, 3)].map((points) => new Curve(points));
    return {
      words: `The curve of (70, 330) and (90, 80) has degree ${two.degree} and the length of the segment, ${rounded(two.length(), 1)}. With (280, 60) as a third point the degree is ${three.degree}.`,
      holds: two.degree === 1 && three.degree === 2 && Math.abs(two.length() - Math.hypot(20, 250)) < 1e-9,
    };
  },

  parabola() {
    const curve = new Curve([
      [0, 0],
      [0.5, 0],
      [1, 1],
    ]);
    const errors = steps(100).map((t) => distance(curve.eval(t), { x: t, y: t * t }));
    return {
      words: `The points (0, 0), (½, 0), (1, 1) give (t, t²) with an error of at most ${Math.max(...errors).toExponential(0)} at 101 values of t.`,
      holds: Math.max(...errors) < 1e-15,
    };
  },

  numbering() {
    const t = 0.2;
    const k = [(1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t ** 2, t ** 3];
    const b = Curve.bernstein(3, t);
    return {
      words: `At t = 0.2, k₁ … k₄ are ${listed(k)} and B₀ … B₃ are ${listed(b)}: k₁ is B₀, and not B₁.`,
      holds: k.every((weight, i) => Math.abs(weight - b[i]) < 1e-15),
    };
  },

  "n-zero"() {
    const [zero, one] = [Curve.bernstein(0, 0.3), Curve.bernstein(1, 0.3)];
    return {
      words: `At t = 0.3 degree 0 has the weights ${listed(zero)}, degree 1 has ${listed(one)}.`,
      holds: zero.length === 1 && zero[0] === 1 && one.length === 2 && Math.abs(one[0] - 0.7) < 1e-15,
    };
  },

  bicubic() {
    const patch = new Patch(Array.from({ length: 16 }, (_, i) => [i % 4, Math.floor(i / 4), 0]));
    const curve = new Curve(ARCH);
    return {
      words: `Four points: a curve of degree ${curve.degree} in its only parameter. Sixteen points: a surface of degrees ${patch.degreeU} and ${patch.degreeV}.`,
      holds: curve.degree === 3 && patch.degreeU === 3 && patch.degreeV === 3,
    };
  },

  stable() {
    const { bernsteinSum, deCasteljau, powers } = roundingErrors();
    return {
      words: `500 random cubics in single precision, root mean square errors in units in the last place: ${rounded(bernsteinSum, 2)} for the lesson's first listing, ${rounded(deCasteljau, 2)} for its de Casteljau listing, ${rounded(powers, 2)} for powers of t.`,
      holds: Math.abs(bernsteinSum / deCasteljau - 1) < 0.1 && powers > 2 * bernsteinSum,
    };
  },

  circumscribed() {
    const curve = new Curve(ARCH);
    const corners = curve.hull();
    const hull = new Path([new Spline([...corners, corners[0], corners[1]], { degree: 1, dimension: 2 })]);
    const inside = steps(100)
      .slice(1, -1)
      .filter((t) => hull.contains(curve.eval(t))).length;
    return {
      words: `Of 99 points between the ends of the applet's first curve, ${inside} lie inside the hull.`,
      holds: inside === 99,
    };
  },

  aligned() {
    const [uneven, back] = [alignedJoint([200, 0]), alignedJoint([50, 0])];
    const described = (/** @type {typeof uneven} */ c) => `${c.g1 ? "G1" : "not G1"} and ${c.c1 ? "C1" : "not C1"}`;
    return {
      words: `P2 = (60, 0), P3 = (100, 0). With P4 = (200, 0) the joint is ${described(uneven)}; with P4 = (50, 0), on the same line, it is ${described(back)}: the curve turns back by ${rounded((back.angle * 180) / Math.PI, 0)}°.`,
      holds: uneven.g1 && !uneven.c1 && !back.g1 && !back.c1,
    };
  },

  c0() {
    const joint = alignedJoint([140, 0]);
    return {
      words: `P2 = (60, 0), P3 = (100, 0), P4 = (140, 0): the curves are tangent, and C0 is ${joint.c0}.`,
      holds: joint.c0 && joint.g1 && joint.c1,
    };
  },

  c2() {
    const degrees = [2, 3, 4, 5];
    const jumps = degrees.map((degree) => c2Jump(degree, [0, 0]));
    const missed = degrees.map((degree) => c2Jump(degree, [1, 0]));
    const [a1, a2, a3] = [
      [40, 90],
      [80, 90],
      [120, 60],
    ];
    const b1 = [0, 1].map((k) => 2 * a3[k] - a2[k]);
    const b2 = [0, 1].map((k) => a1[k] - 4 * a2[k] + 4 * a3[k]);
    const area = (b1[0] - a3[0]) * (b2[1] - a3[1]) - (b1[1] - a3[1]) * (b2[0] - a3[0]);
    return {
      words: `Degrees 2, 3, 4 and 5: the formula leaves a jump of ${rounded(Math.max(...jumps))} in the second derivative, and b2 one pixel aside one of at least ${rounded(Math.min(...missed))}. A cubic that ends with (40, 90), (80, 90), (120, 60) needs (${listed(b1)}) and (${listed(b2)}), which are not on one line with (120, 60).`,
      holds: Math.max(...jumps) < 1e-9 && Math.min(...missed) >= 1 && area !== 0,
    };
  },

  divide() {
    const curve = new Curve(ARCH);
    const cut = 0.3;
    const [left, right] = curve.split(cut);
    const errors = steps(100).flatMap((t) => [
      distance(left.eval(t), curve.eval(cut * t)),
      distance(right.eval(t), curve.eval(cut + (1 - cut) * t)),
    ]);
    return {
      words: `The applet's first curve split at t = 0.3: both parts are cubics, and at 101 values of t they differ from B(0.3 t) and B(0.3 + 0.7 t) by at most ${Math.max(...errors).toExponential(0)} px.`,
      holds: left.degree === 3 && right.degree === 3 && Math.max(...errors) < 1e-12,
    };
  },

  p1224() {
    const t = 0.3;
    const between = (/** @type {Point} */ a, /** @type {Point} */ b) => a.map((x, k) => (1 - t) * x + t * b[k]);
    const [p12, p23] = [between(ARCH[0], ARCH[1]), between(ARCH[1], ARCH[2])];
    const p1223 = between(/** @type {Point} */ (p12), /** @type {Point} */ (p23));
    const third = [...new Curve(ARCH).split(t)[0].controlPoints().slice(4, 6)];
    return {
      words: `At t = 0.3, P12 and P23 give P1223 = (${listed(p1223)}), and the third point of the first sub-curve is (${listed(third)}).`,
      holds: third.every((x, k) => Math.abs(x - p1223[k]) < 1e-12),
    };
  },

  "split-listing"() {
    const t = 0.3;
    const corrected = splitBezier(ARCH, t);
    const halves = new Curve(ARCH).split(t).map((half) => [...half.controlPoints()]);
    const error = Math.max(...corrected.flatMap((half, i) => half.flat().map((x, k) => Math.abs(x - halves[i][k]))));
    return {
      words: `The corrected listing at t = 0.3 gives the control points of curve.split(0.3), to 12 decimals; its last point is P[3] = (${corrected[1][3].join(", ")}).`,
      holds: error < 1e-12 && corrected[1][3] === ARCH[3],
    };
  },

  "spline-through"() {
    const spline = Spline.fromBSpline(ARCH);
    const distances = ARCH.map((point) => spline.nearest(point).distance);
    return {
      words: `The uniform cubic B-spline of the applet's first four points passes them at distances of ${listed(distances, 0)} px.`,
      holds: Math.min(...distances) > 10,
    };
  },

  superset() {
    const first = Spline.fromBSpline(ARCH).segments()[0];
    const [start, tangent] = [first.eval(0), first.tangent(0)];
    const side = { x: ARCH[1][0] - ARCH[0][0], y: ARCH[1][1] - ARCH[0][1] };
    const angle = Math.acos((tangent.x * side.x + tangent.y * side.y) / Math.hypot(side.x, side.y));
    return {
      words: `The uniform B-spline of the applet's first four points starts at (${listed([start.x, start.y], 1)}) instead of (70, 330), and its tangent there is ${rounded((angle * 180) / Math.PI, 0)}° off the direction from P0 to P1.`,
      holds: distance(start, { x: 70, y: 330 }) > 10 && angle > 0.1,
    };
  },

  concave() {
    const inflections = (/** @type {Point[]} */ points) => new Curve(points).inflections().length;
    const area = (/** @type {Point[]} */ [a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    /** @type {Point[]} */
    const quadratic = [
      [0, 0],
      [50, 90],
      [100, 0],
    ];
    const backwards = [...quadratic].reverse();
    const cubic = inflections([
      [0, 0],
      [50, 100],
      [50, -100],
      [100, 0],
    ]);
    return {
      words: `The quadratic (0, 0), (50, 90), (100, 0) has ${inflections(quadratic)} inflections; it turns right, and left when it is run backwards. The cubic (0, 0), (50, 100), (50, −100), (100, 0) has ${cubic}.`,
      holds: inflections(quadratic) === 0 && cubic === 1 && area(quadratic) < 0 && area(backwards) > 0,
    };
  },
};
