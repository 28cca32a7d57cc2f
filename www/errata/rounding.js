// The rounding errors of three ways to evaluate a cubic in single precision.

const round = Math.fround;
/** Of single precision near 1. */
const UNIT_IN_LAST_PLACE = 2 ** -23;
const CURVES = 500;
const SAMPLES = 20;

/** @typedef {(p: number[], t: number) => number} Evaluate */

/** The sum of weights and points, as in the lesson's first listing. @type {Evaluate} */
function bernsteinSum(p, t) {
  const s = round(1 - t);
  const weights = [
    round(round(s * s) * s),
    round(round(round(3 * s) * s) * t),
    round(round(round(3 * s) * t) * t),
    round(round(t * t) * t),
  ];
  return p.map((value, i) => round(value * weights[i])).reduce((a, b) => round(a + b));
}

/** As in the lesson's second listing. @type {Evaluate} */
function deCasteljau(p, t) {
  const s = round(1 - t);
  let values = p;
  while (values.length > 1) values = values.slice(1).map((b, i) => round(round(s * values[i]) + round(t * b)));
  return values[0];
}

/** Powers of t by Horner's rule; the coefficients are rounded once. @type {Evaluate} */
function powers([a, b, c, d], t) {
  const coefficients = [d - 3 * c + 3 * b - a, 3 * c - 6 * b + 3 * a, 3 * b - 3 * a, a].map(round);
  return coefficients.reduce((total, coefficient) => round(round(total * t) + coefficient), 0);
}

/** In double precision. @type {Evaluate} */
const reference = ([a, b, c, d], t) =>
  (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t ** 2 * c + t ** 3 * d;

/** Numbers between 0 and 1, the same ones each time. */
function createGenerator() {
  let state = 1;
  return () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647;
  };
}

/** The root mean square of each error, in units in the last place, over random cubics with values from −1 to 1. */
export function roundingErrors() {
  const random = createGenerator();
  const ways = { bernsteinSum, deCasteljau, powers };
  const squares = { bernsteinSum: 0, deCasteljau: 0, powers: 0 };
  for (let curve = 0; curve < CURVES; curve++) {
    const p = Array.from({ length: 4 }, () => round(2 * random() - 1));
    for (let sample = 0; sample < SAMPLES; sample++) {
      const t = round(random());
      for (const name of /** @type {(keyof typeof ways)[]} */ (Object.keys(ways)))
        squares[name] += ((ways[name](p, t) - reference(p, t)) / UNIT_IN_LAST_PLACE) ** 2;
    }
  }
  const mean = (/** @type {number} */ sum) => Math.sqrt(sum / (CURVES * SAMPLES));
  return {
    bernsteinSum: mean(squares.bernsteinSum),
    deCasteljau: mean(squares.deCasteljau),
    powers: mean(squares.powers),
  };
}
