// What a point of a cubic in space costs: operations as counted by arithmetic that counts, time as measured here and now.
import { html } from "lit";
import { Curve } from "casteljau";
import { counting } from "./lib/evaluators.js";
import { Figure } from "./lib/figure.js";
import { decimal } from "./lib/numbers.js";

/** @typedef {import("./lib/evaluators.js").Arithmetic} Arithmetic */
/** @typedef {readonly [number, number, number]} Point */
/** @typedef {(o: Arithmetic, points: readonly Point[], t: number) => readonly number[]} Way */

const scale = (/** @type {Arithmetic} */ o, /** @type {readonly number[]} */ p, /** @type {number} */ k) =>
  p.map((x) => o.mul(x, k));
const plus = (/** @type {Arithmetic} */ o, /** @type {readonly number[]} */ p, /** @type {readonly number[]} */ q) =>
  p.map((x, i) => o.add(x, q[i]));
const sum = (/** @type {Arithmetic} */ o, /** @type {readonly (readonly number[])[]} */ points) =>
  points.reduce((a, b) => plus(o, a, b));

/** As lessons write it: 1 − t and its powers anew in every weight. @type {Way} */
const writtenOut = (o, points, t) => {
  const s = () => o.sub(1, t);
  const k = [
    o.mul(o.mul(s(), s()), s()),
    o.mul(o.mul(o.mul(3, s()), s()), t),
    o.mul(o.mul(o.mul(3, s()), t), t),
    o.mul(o.mul(t, t), t),
  ];
  return sum(
    o,
    points.map((p, i) => scale(o, p, k[i])),
  );
};

/** 1 − t and its square computed once. @type {Way} */
const shared = (o, points, t) => {
  const s = o.sub(1, t);
  const [ss, tt] = [o.mul(s, s), o.mul(t, t)];
  const k = [o.mul(ss, s), o.mul(o.mul(3, ss), t), o.mul(o.mul(3, s), tt), o.mul(tt, t)];
  return sum(
    o,
    points.map((p, i) => scale(o, p, k[i])),
  );
};

/** Six divisions of a line, 1 − t anew in each. @type {Way} */
const casteljauWritten = (o, points, t) => {
  let row = points.map((p) => [...p]);
  while (row.length > 1) row = row.slice(1).map((q, i) => plus(o, scale(o, row[i], o.sub(1, t)), scale(o, q, t)));
  return row[0];
};

/** The same as a + t (b − a): one multiplication less a coordinate. @type {Way} */
const casteljauLerp = (o, points, t) => {
  let row = points.map((p) => [...p]);
  while (row.length > 1)
    row = row.slice(1).map((q, i) =>
      plus(
        o,
        row[i],
        scale(
          o,
          q.map((x, k) => o.sub(x, row[i][k])),
          t,
        ),
      ),
    );
  return row[0];
};

/** Of coefficients that are at hand. @type {Way} */
const horner = (o, [a, b, c, d], t) => plus(o, scale(o, plus(o, scale(o, plus(o, scale(o, d, t), c), t), b), t), a);

/** Plain JavaScript of each way, for the clock: what one would write by hand. Points and results are flat. */
const HAND = {
  written(
    /** @type {Float64Array} */ p,
    /** @type {number} */ t,
    /** @type {Float64Array} */ out,
    /** @type {number} */ at,
  ) {
    const a = (1 - t) * (1 - t) * (1 - t),
      b = 3 * (1 - t) * (1 - t) * t,
      c = 3 * (1 - t) * t * t,
      d = t * t * t;
    for (let k = 0; k < 3; k++) out[at + k] = p[k] * a + p[k + 3] * b + p[k + 6] * c + p[k + 9] * d;
  },
  shared(
    /** @type {Float64Array} */ p,
    /** @type {number} */ t,
    /** @type {Float64Array} */ out,
    /** @type {number} */ at,
  ) {
    const s = 1 - t,
      ss = s * s,
      tt = t * t;
    const a = ss * s,
      b = 3 * ss * t,
      c = 3 * s * tt,
      d = tt * t;
    for (let k = 0; k < 3; k++) out[at + k] = p[k] * a + p[k + 3] * b + p[k + 6] * c + p[k + 9] * d;
  },
  casteljau(
    /** @type {Float64Array} */ p,
    /** @type {number} */ t,
    /** @type {Float64Array} */ out,
    /** @type {number} */ at,
  ) {
    for (let k = 0; k < 3; k++) {
      const a = (1 - t) * p[k] + t * p[k + 3],
        b = (1 - t) * p[k + 3] + t * p[k + 6],
        c = (1 - t) * p[k + 6] + t * p[k + 9];
      const d = (1 - t) * a + t * b,
        e = (1 - t) * b + t * c;
      out[at + k] = (1 - t) * d + t * e;
    }
  },
  lerp(
    /** @type {Float64Array} */ p,
    /** @type {number} */ t,
    /** @type {Float64Array} */ out,
    /** @type {number} */ at,
  ) {
    for (let k = 0; k < 3; k++) {
      const a = p[k] + t * (p[k + 3] - p[k]),
        b = p[k + 3] + t * (p[k + 6] - p[k + 3]),
        c = p[k + 6] + t * (p[k + 9] - p[k + 6]);
      const d = a + t * (b - a),
        e = b + t * (c - b);
      out[at + k] = d + t * (e - d);
    }
  },
  horner(
    /** @type {Float64Array} */ c,
    /** @type {number} */ t,
    /** @type {Float64Array} */ out,
    /** @type {number} */ at,
  ) {
    for (let k = 0; k < 3; k++) out[at + k] = ((c[k + 9] * t + c[k + 6]) * t + c[k + 3]) * t + c[k];
  },
};

/** The text's own counts are given where it states them: −, +, ×. */
export const WAYS = [
  { key: "written", name: "Bernstein, written out", way: writtenOut, text: [6, 9, 22] },
  { key: "shared", name: "Bernstein, 1 − t once", way: shared },
  { key: "casteljau", name: "De Casteljau, written out", way: casteljauWritten, text: [6, 18, 36] },
  { key: "lerp", name: "De Casteljau, a + t (b − a)", way: casteljauLerp },
  { key: "horner", name: "Horner, coefficients known", way: horner },
];

const POINTS = /** @type {const} */ ([
  [0, 2, 3],
  [2, 3, 5],
  [6, 7, 9],
  [3, 4, 5],
]);
const SEGMENTS = 1000;
/** So long each way runs, in short turns with the others in between. */
const TURN_MS = 4;
const TURNS = 9;

/**
 * What a way does for one point.
 *
 * @param {Way} way
 * @returns {[number, number, number]} −, +, ×
 */
export function operations(way) {
  const o = counting();
  way(o, POINTS, 0.3);
  return [o.counts.sub, o.counts.add, o.counts.mul];
}

/** Every contestant fills the same array with the points at t = 0 … 1. @returns {Record<string, () => Float64Array>} */
export function contestants() {
  const curve = new Curve(POINTS);
  const flat = curve.controlPoints();
  const rising = [0, 1, 2, 3]
    .map((j) => curve.derivativeAt(0, j))
    .flatMap(({ x, y, z }, j) => [x, y, z].map((value) => value / [1, 1, 2, 6][j]));
  /** @type {Record<keyof typeof HAND, Float64Array>} */
  const given = {
    .../** @type {Record<keyof typeof HAND, Float64Array>} */ (
      Object.fromEntries(Object.keys(HAND).map((key) => [key, flat]))
    ),
    horner: Float64Array.from([...Object.values(curve.eval(0)), ...rising.slice(3)]),
  };
  const out = new Float64Array(3 * (SEGMENTS + 1));
  const byHand = (/** @type {keyof typeof HAND} */ key) => () => {
    for (let i = 0; i <= SEGMENTS; i++) HAND[key](given[key], i / SEGMENTS, out, 3 * i);
    return out;
  };
  const ways = Object.fromEntries(
    /** @type {(keyof typeof HAND)[]} */ (Object.keys(HAND)).map((key) => [key, byHand(key)]),
  );
  return { ...ways, package: () => /** @type {Float64Array} */ (curve.sample(SEGMENTS, { into: out })) };
}

/** Nanoseconds a point. @param {() => unknown} run */
function clock(run) {
  const start = performance.now();
  let [rounds, passed] = [0, 0];
  do {
    run();
    rounds++;
    passed = performance.now() - start;
  } while (passed < TURN_MS);
  return (passed * 1e6) / (rounds * (SEGMENTS + 1));
}

const median = (/** @type {number[]} */ list) => [...list].sort((a, b) => a - b)[list.length >> 1];

/**
 * Times all of them in turns, giving way to the page between turns; the first turn only warms up.
 *
 * @returns {Promise<Record<string, number>>} nanoseconds a point
 */
export async function race() {
  const all = Object.entries(contestants());
  /** @type {Record<string, number[]>} */
  const times = Object.fromEntries(all.map(([key]) => [key, []]));
  for (let turn = 0; turn <= TURNS; turn++) {
    for (const [key, run] of all) {
      const time = clock(run);
      if (turn > 0) times[key].push(time);
    }
    await new Promise((done) => setTimeout(done));
  }
  return Object.fromEntries(Object.entries(times).map(([key, list]) => [key, median(list)]));
}

/** `<fig-costs>` */
export class FigCosts extends Figure {
  static properties = { times: { state: true }, running: { state: true } };

  constructor() {
    super();
    /** @type {Record<string, number> | null} */
    this.times = null;
    this.running = false;
  }

  async measure() {
    if (this.running) return;
    this.running = true;
    this.times = await race();
    this.running = false;
    this.notifyChange();
  }

  /** @param {string} key */
  time(key) {
    if (!this.times) return html`<td>–</td><td>–</td>`;
    const ratio = this.times[key] / this.times.written;
    return html`<td data-time=${this.times[key]}>${decimal(this.times[key], 1)} ns</td><td>${decimal(ratio, 2)} ×</td>`;
  }

  render() {
    const words = (/** @type {number[] | undefined} */ counts) =>
      counts ? `${counts[0]}−, ${counts[1]}+, ${counts[2]}×` : "–";
    return html`
      <div class="frame">
        <div class="table first" tabindex="0" role="region" aria-label="Operations and time">
          <table>
            <caption>One point of a cubic in space</caption>
            <thead><tr><th>Method</th><th>In a <a href="../texts/#lesson-1">web lesson</a></th><th>Counted here</th><th>Time per point</th><th>relative to the first</th></tr></thead>
            <tbody>
              ${WAYS.map(
                ({ key, name, way, text }) => html`
                <tr data-way=${key}><th scope="row">${name}</th><td class="counts">${words(text)}</td><td class="counts">${words(operations(way))}</td>${this.time(key)}</tr>`,
              )}
              <tr data-way="package"><th scope="row">This package, <code>sample</code> (wasm)</th><td>–</td><td>–</td>${this.time("package")}</tr>
            </tbody>
          </table>
        </div>
        <div class="controls">
          <button ?disabled=${this.running} @click=${this.measure}>${this.running ? "Measuring …" : "Measure in this browser"}</button>
          <span role="status">${this.times && !this.running ? `Median of ${TURNS} turns, ${SEGMENTS + 1} points each time.` : ""}</span>
        </div>
        <p class="facts">
          The operations are counted while the method runs. The number of operations alone does not give the time: compilers compute repeated terms only once,
          and processors do several operations at the same time.
        </p>
      </div>
    `;
  }
}

customElements.define("fig-costs", FigCosts);
