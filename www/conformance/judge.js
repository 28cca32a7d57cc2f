// Whether an answer is the one that a fact states.

/** @typedef {import("./facts.js").Fact} Fact */
/** @typedef {"right" | "close" | "wrong" | "not offered"} Grade */

/**
 * An answer that is not within the tolerance of its fact, but has all numbers that the fact states to so much (relative if they are greater than 1), is
 * close.
 */
export const CLOSE = 1e-3;

/** Samples of a curve to which distances are measured. */
const SAMPLES = 4000;
/** Parameters closer than this may be in either order. */
const SAME_PARAMETER = 1e-6;

/**
 * How far an answer is from what a fact states: of all numbers the greatest difference, and the greatest relative to numbers above 1. Infinite where
 * the form differs.
 *
 * @param {any} got
 * @param {any} expected
 * @returns {{ absolute: number, relative: number }}
 */
function difference(got, expected) {
  if (typeof expected === "number") {
    const absolute = typeof got === "number" && Number.isFinite(got) ? Math.abs(got - expected) : Infinity;
    return { absolute, relative: absolute / Math.max(1, Math.abs(expected)) };
  }
  if (typeof expected !== "object") return got === expected ? NONE : APART;
  const keys = Object.keys(expected);
  if (typeof got !== "object" || got === null || (Array.isArray(expected) && got.length !== expected.length))
    return APART;
  return worst(keys.map((key) => difference(got[key], expected[key])));
}

const NONE = { absolute: 0, relative: 0 };
const APART = { absolute: Infinity, relative: Infinity };

/** @param {{ absolute: number, relative: number }[]} all */
const worst = (all) => ({
  absolute: Math.max(0, ...all.map(({ absolute }) => absolute)),
  relative: Math.max(0, ...all.map(({ relative }) => relative)),
});

/** The excess of a distance over what is allowed. @param {number} distance @param {number} allowed */
const above = (distance, allowed) => difference(Math.max(0, distance - allowed), 0);

/** @param {number[][]} points de Casteljau's algorithm @param {number} t @returns {number[]} */
function pointAt(points, t) {
  if (points.length === 1) return points[0];
  return pointAt(
    points.slice(1).map((to, i) => to.map((x, axis) => (1 - t) * points[i][axis] + t * x)),
    t,
  );
}

/** @param {number[][]} points of a Bézier curve */
const sampled = (points) => Array.from({ length: SAMPLES + 1 }, (_, i) => pointAt(points, i / SAMPLES));

/** @param {number[]} p @param {number[][]} polyline */
function distanceTo(p, polyline) {
  let best = Infinity;
  for (let k = 1; k < polyline.length; k++) {
    const [[ax, ay], [bx, by]] = [polyline[k - 1], polyline[k]];
    const [dx, dy] = [bx - ax, by - ay];
    const s = Math.min(1, Math.max(0, ((p[0] - ax) * dx + (p[1] - ay) * dy) / (dx * dx + dy * dy || 1)));
    best = Math.min(best, Math.hypot(p[0] - ax - s * dx, p[1] - ay - s * dy));
  }
  return best;
}

/** @param {any} got @param {Fact} fact */
function meetings(got, { expect }) {
  if (expect.overlap || got.overlap) return got.overlap === expect.overlap ? NONE : APART;
  // A contact closer than rounding may be counted or not: its note says so.
  if (expect.count === undefined) return got.t.length <= 1 ? NONE : APART;
  if (!got.s)
    return difference(
      [...got.t].sort((a, b) => a - b),
      expect.t,
    ); // only parameters of the first curve
  const order = (/** @type {number[]} */ t, /** @type {number[]} */ s) =>
    t
      .map((value, k) => [value, s[k]])
      .sort((a, b) => (Math.abs(a[0] - b[0]) > SAME_PARAMETER ? a[0] - b[0] : a[1] - b[1]));
  return difference(order(got.t, got.s), order(expect.t, expect.s));
}

/** @param {any} got @param {Fact} fact */
function nearest(got, { expect }) {
  const ts = [expect.t, ...(expect.also_t ?? [])];
  const t = ts.reduce((best, each) => (Math.abs(each - got.t) < Math.abs(best - got.t) ? each : best));
  return difference({ t: got.t, distance: got.distance }, { t, distance: expect.distance });
}

/** Control points of the same curve, of a higher degree if there have to be more. @param {number[][]} points @param {number} count @returns {number[][]} */
function raised(points, count) {
  const n = points.length;
  if (n >= count) return points;
  const inner = points.slice(1).map((to, i) => to.map((x, axis) => ((i + 1) * points[i][axis] + (n - i - 1) * x) / n));
  return raised([points[0], ...inner, points[n - 1]], count);
}

/** Facts whose answers are not compared number by number. @type {Record<string, (got: any, fact: Fact) => { absolute: number, relative: number }>} */
const RULES = {
  nearest,
  "rational nearest": nearest,
  intersect: meetings,
  line_intersect: meetings,
  // A part may have more control points than the curve, if it is the same curve.
  split: (got, { expect }) =>
    difference(got, {
      left: raised(expect.left, got.left.length),
      right: raised(expect.right, got.right.length),
    }),
  subsegment: (got, { expect }) => difference(got, raised(expect, got.length)),
  classify: (got, { expect }) => difference(got, expect.class),
  selfintersect: (got, { expect }) => difference(got, [expect.t]),
  min_distance: (got, { expect }) => difference(got, expect),
  circle: (got, { expect }) => {
    const errors = got.map((/** @type {number[]} */ [x, y]) => Math.hypot(x, y) - 1);
    return difference([Math.max(...errors), Math.min(...errors)], [expect.max_radial_error, expect.min_radial_error]);
  },
  svgpath: (got, { expect: { arc } }) =>
    worst(
      got.map((/** @type {number[]} */ [x, y]) =>
        difference(Math.hypot(x - arc.center[0], y - arc.center[1]) / arc.radius, 1),
      ),
    ),
  offset: (got, { input, expect }) => {
    if (expect.ends) {
      const [[, y]] = expect.ends;
      return worst([
        difference([got[0], got.at(-1)], expect.ends),
        ...got.map((/** @type {number[]} */ p) => difference(p[1], y)),
      ]);
    }
    const curve = sampled(input.points);
    return worst(
      got.map((/** @type {number[]} */ p) =>
        p.every(Number.isFinite) ? above(distanceTo(p, curve), Math.abs(input.distance)) : APART,
      ),
    );
  },
  flatten: (got, { input, expect }) => {
    const curve = sampled(input.points);
    return worst([
      ...curve.map((p) => above(distanceTo(p, got), input.tolerance)),
      ...(expect.must_reach ?? []).map((/** @type {number[]} */ p) =>
        above(
          Math.min(...got.map((/** @type {number[]} */ q) => Math.hypot(p[0] - q[0], p[1] - q[1]))),
          input.tolerance,
        ),
      ),
    ]);
  },
  // The weights of a part are determined up to a common factor.
  "rational split": (got, { expect }) =>
    worst(
      ["left", "right"].map((part) => {
        const factor = expect[part].weights[0] / got[part].weights[0];
        const weights = got[part].weights.map((/** @type {number} */ weight) => weight * factor);
        return difference({ points: got[part].points, weights }, expect[part]);
      }),
    ),
};

/**
 * @param {unknown} got the answer of a library; undefined: it does not claim to have one
 * @param {Fact} fact
 * @returns {{ grade: Grade, off: number }} off: the greatest difference
 */
export function judge(got, fact) {
  if (got === undefined) return { grade: "not offered", off: NaN };
  if (got === null) return { grade: "wrong", off: Infinity };
  const { absolute, relative } = (RULES[fact.kind] ?? ((answer) => difference(answer, fact.expect)))(got, fact);
  if (absolute <= fact.tol) return { grade: "right", off: absolute };
  return { grade: relative <= CLOSE ? "close" : "wrong", off: absolute };
}

/**
 * The answer of a library to a fact, and its grade. An exception is a wrong answer.
 *
 * @param {import("./answers.js").Answers} answers
 * @param {Fact} fact
 * @returns {{ grade: Grade, off: number, got: unknown }}
 */
export function ask(answers, fact) {
  const answer = answers[fact.kind];
  if (!answer) return { grade: "not offered", off: NaN, got: undefined };
  try {
    const got = answer(fact.input, fact);
    return { ...judge(got, fact), got };
  } catch (error) {
    return { grade: "wrong", off: Infinity, got: error instanceof Error ? error.message : String(error) };
  }
}
