// Counts operations by running the texts' recipes on numbers that keep a tally.

const tally = { "−": 0, "+": 0, "×": 0 };

/** @param {number} a @param {number} b */
const sub = (a, b) => {
  tally["−"]++;
  return a - b;
};
/** @param {number} a @param {number} b */
const add = (a, b) => {
  tally["+"]++;
  return a + b;
};
/** @param {...number} xs */
const mul = (...xs) => {
  tally["×"] += xs.length - 1;
  return xs.reduce((a, b) => a * b);
};

/** Points in space, whatever they are. */
const POINTS = [
  [0, 2, 3],
  [2, 3, 5],
  [6, 7, 9],
  [3, 4, 5],
];
const T = 0.3;

/** @param {number[]} p @param {number} k */
const scaled = (p, k) => p.map((x) => mul(k, x));
/** @param {number[]} p @param {number[]} q */
const plus = (p, q) => p.map((x, i) => add(x, q[i]));

/** The points weighted. @param {number[]} weights */
const blend = (weights) => POINTS.map((p, i) => scaled(p, weights[i])).reduce(plus);

/** Three levels of division. @param {(p: number[], q: number[]) => number[]} divide */
function levels(divide) {
  let points = POINTS;
  while (points.length > 1) points = points.slice(1).map((q, i) => divide(points[i], q));
  return points[0];
}

/** What the texts list, and what one would write. */
export const listings = {
  weights() {
    const t = T;
    return blend([
      mul(sub(1, t), sub(1, t), sub(1, t)),
      mul(3, sub(1, t), sub(1, t), t),
      mul(3, sub(1, t), t, t),
      mul(t, t, t),
    ]);
  },
  casteljau: () => levels((p, q) => plus(scaled(p, sub(1, T)), scaled(q, T))),
  sharedWeights() {
    const [t, s] = [T, sub(1, T)];
    const [tt, ss, both] = [mul(t, t), mul(s, s), mul(3, s, t)];
    return blend([mul(ss, s), mul(both, s), mul(both, t), mul(tt, t)]);
  },
  differences: () => levels((p, q) => p.map((x, i) => add(x, mul(T, sub(q[i], x))))),
  /** The eight points of the halves of one coordinate, from the formulas for t = ½. */
  halvesDirectly() {
    const [a, b, c, d] = POINTS.map(([x]) => x);
    const middle = mul(add(add(a, mul(3, add(b, c))), d), 1 / 8);
    return [
      a,
      mul(add(a, b), 1 / 2),
      mul(add(add(a, mul(2, b)), c), 1 / 4),
      middle,
      middle,
      mul(add(add(d, mul(2, c)), b), 1 / 4),
      mul(add(c, d), 1 / 2),
      d,
    ];
  },
  /** The same from six middles. */
  halvesByMiddles() {
    const [a, b, c, d] = POINTS.map(([x]) => x);
    const middle = (/** @type {number} */ x, /** @type {number} */ y) => mul(add(x, y), 1 / 2);
    const [ab, bc, cd] = [middle(a, b), middle(b, c), middle(c, d)];
    const [abc, bcd] = [middle(ab, bc), middle(bc, cd)];
    const abcd = middle(abc, bcd);
    return [a, ab, abc, abcd, abcd, bcd, cd, d];
  },
};

/**
 * @param {() => unknown} run
 * @returns {string} such as "6−, 9+, 22×"
 */
export function counted(run) {
  for (const sign of /** @type {(keyof typeof tally)[]} */ (Object.keys(tally))) tally[sign] = 0;
  run();
  const counts = Object.entries(tally).filter(([, count]) => count > 0);
  return counts.map(([sign, count]) => `${count}${sign}`).join(", ");
}
