// Short computations that settle what a text says of curves. Each returns what it found, in words, and whether that proves the point.
import { Curve, Path, Spline } from "casteljau";
import { counted, listings } from "./operations.js";
import { rounding, SAMPLES } from "./rounding.js";

/** @typedef {{ words: string, holds: boolean }} Found */

/** @param {number} x @param {number} [digits] */
const n = (x, digits = 3) => String(Number(x.toFixed(digits))).replace("-", "−");
/** @param {Iterable<number>} xs @param {number} [digits] */
const list = (xs, digits = 3) => `[${Array.from(xs, (x) => n(x, digits)).join(", ")}]`;
/** @param {Iterable<number>} xs */
const sum = (xs) => [...xs].reduce((a, b) => a + b, 0);
/** @param {number} count */
const steps = (count) => Array.from({ length: count + 1 }, (_, i) => i / count);

/** The first curve of the applet. */
const ARCH = /** @type {[number, number][]} */ ([
  [70, 330],
  [90, 80],
  [280, 60],
  [335, 240],
]);

/** The greatest distance of a curve from the polyline of so many equal steps of t. @param {Curve} curve @param {number} segments */
function polylineError(curve, segments) {
  const points = curve.sample(segments);
  const chord = (/** @type {number} */ k) => new Curve([...points.slice(2 * k, 2 * k + 4)], { dimension: 2 });
  return Math.max(
    ...steps(segments)
      .slice(1)
      .map((t, k) => curve.subsegment(t - 1 / segments, t).hausdorff(chord(k))),
  );
}

/** A polygon's corners with the first again at the end. @param {Float64Array} corners x, y, x, y … */
const closedPolygon = (corners) => new Float64Array([...corners, corners[0], corners[1]]);

/** @type {Record<string, () => Found>} */
export const curveProofs = {
  magnets() {
    const least = Math.min(...steps(200).flatMap((t) => [...Curve.bernstein(3, t)]));
    const beyond = Curve.bernstein(3, 1.25);
    return {
      words: `The least of the four weights at 201 values of t from 0 to 1 is ${n(least)}. At t = 1.25 they are ${list(beyond)}.`,
      holds: least === 0 && Math.min(...beyond) < 0,
    };
  },

  "four-points"() {
    const line = new Curve([
      [0, 0],
      [3, 4],
    ]);
    return {
      words: `new Curve([[0, 0], [3, 4]]) has degree ${line.degree} and length ${n(line.length())}.`,
      holds: line.degree === 1 && line.length() === 5,
    };
  },

  parabola() {
    const curve = new Curve([
      [0, 0],
      [0.5, 0],
      [1, 1],
    ]);
    const far = Math.max(...steps(100).map((t) => Math.abs(curve.eval(t).x - t) + Math.abs(curve.eval(t).y - t * t)));
    return {
      words: `The points (0, 0), (½, 0), (1, 1) give (t, t²) to within ${far.toExponential(0)} at 101 values of t.`,
      holds: far < 1e-15,
    };
  },

  "equal-steps"() {
    const curve = new Curve(ARCH);
    const pieces = steps(10)
      .slice(1)
      .map((t) => curve.subsegment(t - 0.1, t).length());
    const [shortest, longest] = [Math.min(...pieces), Math.max(...pieces)];
    return {
      words: `Ten equal steps of t on the applet's first curve: the shortest piece is ${n(shortest, 1)} px long, the longest ${n(longest, 1)} px.`,
      holds: longest > 1.5 * shortest,
    };
  },

  "n-zero"() {
    const [zero, one] = [Curve.bernstein(0, 0.3), Curve.bernstein(1, 0.3)];
    return {
      words: `At t = 0.3 degree 0 has the weights ${list(zero)}, degree 1 has ${list(one)}.`,
      holds: zero.length === 1 && zero[0] === 1 && one.length === 2,
    };
  },

  "matrix-rows"() {
    const weights = (/** @type {Float64Array} */ m, /** @type {boolean} */ turned) =>
      [0, 1, 2, 3].map((k) =>
        sum([0.125, 0.25, 0.5, 1].map((power, row) => power * m[turned ? 4 * k + row : 4 * row + k])),
      );
    const [right, wrong] = [false, true].map((turned) => weights(Curve.basisMatrix("b-spline"), turned));
    const bezier = [false, true].map((turned) => list(weights(Curve.basisMatrix("bezier"), turned)));
    return {
      words: `Weights of the B-spline at t = ½ with the matrix as it must be: ${list(right)}, together ${n(sum(right))}. Rows taken for columns: ${list(wrong)}, together ${n(sum(wrong))}.`,
      holds: Math.abs(sum(right) - 1) < 1e-12 && Math.abs(sum(wrong) - 1) > 0.1 && bezier[0] === bezier[1],
    };
  },

  stable() {
    const { bernstein, casteljau, powers } = rounding();
    return {
      words: `Degree 12 in single precision, ${SAMPLES + 1} values of t: the weights are off by at most ${n(bernstein, 1)} units in the last place, de Casteljau by ${n(casteljau, 1)}, the powers of t by ${n(powers, 0)}.`,
      holds: powers > 20 * Math.max(bernstein, casteljau),
    };
  },

  operations() {
    const said = { weights: "6−, 9+, 22×", casteljau: "6−, 18+, 36×" };
    const found = Object.fromEntries(Object.entries(listings).map(([name, run]) => [name, counted(run)]));
    return {
      words: `Counted while they ran, in space: the weights as listed ${found.weights}, de Casteljau as listed ${found.casteljau}; the weights with shared factors ${found.sharedWeights}, de Casteljau as P + t(Q − P) ${found.differences}.`,
      holds: found.weights === said.weights && found.casteljau === said.casteljau,
    };
  },

  "zero-handle"() {
    const tangent = new Curve([
      [0, 0],
      [0, 0],
      [3, 4],
      [6, 0],
    ]).tangent(0);
    return {
      words: `P0 = P1 = (0, 0), P2 = (3, 4): the tangent at the start is (${n(tangent.x)}, ${n(tangent.y)}), the direction of P2.`,
      holds: Math.abs(tangent.x - 0.6) < 1e-12,
    };
  },

  aligned() {
    const [uneven, back] = [
      [200, 0],
      [50, 0],
    ].map((p4) => new Spline([[0, 0], [0, 80], [60, 0], [100, 0], p4, [220, 90], [260, 0]]).continuity(1));
    const told = (/** @type {ReturnType<Spline["continuity"]>} */ c) =>
      `${c.g1 ? "G1" : "not G1"}, ${c.c1 ? "C1" : "not C1"}`;
    return {
      words: `P2 = (60, 0), P3 = (100, 0). With P4 = (200, 0) the joint is ${told(uneven)}; with P4 = (50, 0), on the same line, ${told(back)}: the curve turns back by ${n((back.angle * 180) / Math.PI, 0)}°.`,
      holds: uneven.g1 && !uneven.c1 && !back.g1 && !back.c1,
    };
  },

  c2() {
    const [a1, a2, a3] = [
      [40, 90],
      [80, 90],
      [120, 60],
    ];
    const b1 = [0, 1].map((k) => 2 * a3[k] - a2[k]);
    const b2 = [0, 1].map((k) => a1[k] - 4 * a2[k] + 4 * a3[k]);
    const joint = (/** @type {number[]} */ p5) => new Spline([[0, 0], a1, a2, a3, b1, p5, [300, 0]]).continuity(1);
    return {
      words: `P1 to P3 at (40, 90), (80, 90), (120, 60): only P4 = (${b1}) with P5 = (${b2}) makes the joint C2, and these do not lie on one line with P3. P5 one pixel aside: C2 is ${joint([b2[0] + 1, b2[1]]).c2}.`,
      holds: joint(b2).c2 && !joint([b2[0] + 1, b2[1]]).c2,
    };
  },

  "halves-speed"() {
    const [left, right] = new Curve(ARCH).split(0.25);
    const speed = (/** @type {Curve} */ half, /** @type {number} */ t) =>
      Math.hypot(half.derivativeAt(t).x, half.derivativeAt(t).y);
    const ratio = speed(left, 1) / speed(right, 0);
    return {
      words: `Cut at t = ¼, the first half arrives with ${n(speed(left, 1), 1)} and the second leaves with ${n(speed(right, 0), 1)}: 1 to ${n(1 / ratio)}, as ¼ to ¾.`,
      holds: Math.abs(ratio - 1 / 3) < 1e-12,
    };
  },

  optimise() {
    const [direct, middles] = [counted(listings.halvesDirectly), counted(listings.halvesByMiddles)];
    return {
      words: `Counted while they ran, for one coordinate: as listed ${direct}; six middles ${middles}. Both give the same points.`,
      holds: direct === "9+, 8×" && middles === "6+, 6×",
    };
  },

  "c1-lengths"() {
    const joint = (/** @type {number[]} */ b1) => {
      const a = new Curve([
        [0, 0],
        [30, 60],
        [60, 60],
        [90, 30],
      ]).derivativeAt(1);
      const b = new Curve([[90, 30], b1, [180, -60], [220, 0]]).derivativeAt(0);
      return [a.x - b.x / 2, a.y - b.y / 2]; // the second piece lasts twice as long
    };
    const [middle, right] = [joint([120, 0]), joint([150, -30])];
    return {
      words: `The first piece lasts 1 s, the second 2 s. With the joint in the middle of its neighbours the speed jumps by (${list(middle, 0)}) px/s; at one third, by (${list(right, 0)}).`,
      holds: Math.hypot(...middle) > 1 && Math.hypot(...right) < 1e-9,
    };
  },

  "hull-range"() {
    const [inside, outside] = [0.99, 1.01].map((t) => new Curve(ARCH).eval(t));
    const hull = new Spline(closedPolygon(new Curve(ARCH).hull()), { degree: 1 });
    const contains = (/** @type {{ x: number, y: number }} */ p) => new Path([hull]).contains(p);
    return {
      words: `In the hull at t = 0.99: ${contains(inside)}. At t = 1.01: ${contains(outside)}.`,
      holds: contains(inside) && !contains(outside),
    };
  },

  "not-through"() {
    const points = ARCH;
    const start = Spline.fromBSpline(points).segments()[0].eval(0);
    return {
      words: `The uniform B-spline of four points with P0 = (70, 330) starts at (${n(start.x, 1)}, ${n(start.y, 1)}).`,
      holds: Math.hypot(start.x - 70, start.y - 330) > 10,
    };
  },

  fraction() {
    const curve = new Curve([
      [0, 0],
      [10, 0],
      [100, 0],
    ]);
    const [t, share] = [0.5, curve.subsegment(0, 0.5).length() / curve.length()];
    return {
      words: `The points 0, 10, 100 on a line: at t = ${t} the curve has run ${n(100 * share, 1)} % of its way.`,
      holds: Math.abs(share - 0.3) < 1e-9,
    };
  },

  smoother() {
    const [ten, twenty] = [10, 20].map((count) => polylineError(new Curve(ARCH), count));
    return {
      words: `Ten pieces are off by ${n(ten, 2)} px, twenty by ${n(twenty, 2)} px: twice as many, ${n(ten / twenty, 1)} times as close.`,
      holds: Math.abs(ten / twenty - 4) < 0.5,
    };
  },

  concave() {
    const bends = (/** @type {[number, number][]} */ points) => new Curve(points).inflections().length;
    const [quadratic, cubic] = [
      bends([
        [0, 0],
        [50, 90],
        [100, 0],
      ]),
      bends([
        [0, 0],
        [50, 100],
        [50, -100],
        [100, 0],
      ]),
    ];
    return {
      words: `Places where the bend changes sides: ${quadratic} on a quadratic, ${cubic} on the cubic (0, 0), (50, 100), (50, −100), (100, 0).`,
      holds: quadratic === 0 && cubic === 1,
    };
  },

  "fixed-increment"() {
    const run = (/** @type {(x: number) => number} */ round) => {
      let [t, count] = [0, 0];
      const increment = round(0.1);
      let last = t;
      for (; t <= 1; t = round(t + increment)) {
        last = t;
        count++;
      }
      return { count, last };
    };
    const [double, single] = [run((x) => x), run(Math.fround)];
    return {
      words: `for (t = 0; t <= 1; t += 0.1): ${double.count} points in double precision, the last at t = ${double.last}; ${single.count} in single precision, the last at t = ${n(single.last, 6)}.`,
      holds: double.last !== 1 && single.last !== 1,
    };
  },

  "stop-test"() {
    const [chord, height] = [100, 1.8];
    const curve = new Curve([
      [0, 0],
      [chord / 3, height],
      [(2 * chord) / 3, height],
      [chord, 0],
    ]);
    const excess = 2 * Math.hypot(chord / 3, height) + chord / 3 - chord;
    const distance = curve.hausdorff(
      new Curve([
        [0, 0],
        [chord, 0],
      ]),
    );
    return {
      words: `A chord of 100 px, both handles 1.8 px beside it: D1 − D2 = ${n(excess)}, below a tolerance of 0.1; the curve is ${n(distance, 2)} px away.`,
      holds: excess < 0.1 && distance > 1.3,
    };
  },
};
