// Intersections of curves, compared with bezier-js and paper.js.
import { Bezier } from "bezier-js";
import { Curve } from "casteljau";
import paper from "paper/dist/paper-core.js";
import { assertSame } from "./harness.js";
import { cubics } from "./inputs.js";

/** paper.js stops clipping at 1e-12 of a parameter, except at small angles. */
const TOLERANCE = 1e-6;
const PAIRS = 64;

/** Two cubics with nine intersections, from the README of FloBezier. */
const NINE = [
  [6.4, 4.8, 15, 5, 1, 4, 10, 4],
  [9.4, 0.4, 9.3, 10.3, 8.1, 0.1, 7.53125, 5.5],
];

/** @param {ArrayLike<number>} p eight numbers */
function paperCurve(p) {
  const at = (/** @type {number} */ i) => new paper.Point(p[2 * i], p[2 * i + 1]);
  return new paper.Curve(at(0), at(1).subtract(at(0)), at(2).subtract(at(3)), at(3));
}

const numbers = cubics(2 * PAIRS);
const ours = numbers.map((p) => new Curve(p));
const theirs = numbers.map(paperCurve);
const nine = NINE.map((p) => new Curve(p));
const nineOfPaper = NINE.map(paperCurve);
const nineOfBezier = NINE.map((p) => new Bezier(p));

/**
 * @param {Curve} a
 * @param {Curve} b
 * @param {any} p
 * @param {any} q
 */
function assertSameTimes(a, b, p, q) {
  const found = p.getIntersections(q).map((/** @type {any} */ location) => location.time);
  assertSame(
    "intersect",
    found.sort((/** @type {number} */ s, /** @type {number} */ t) => s - t),
    a.intersections(b).map(({ t }) => t),
    TOLERANCE,
  );
}

/**
 * bezier-js returns pairs of parameters as text, some twice, with errors of up to half a unit: each is near one of
 * ours.
 */
function nineCheck() {
  const [a, b] = nine;
  assertSameTimes(a, b, nineOfPaper[0], nineOfPaper[1]);
  const intersections = a.intersections(b);
  for (const pair of nineOfBezier[0].intersects(nineOfBezier[1])) {
    const t = Number(String(pair).split("/")[0]);
    const near = Math.min(...intersections.map((each) => Math.abs(each.t - t)));
    assertSame("bezier-js, roughly", [0], [near], 0.1);
  }
}

/** The shared part of both rows with nine intersections. */
const ON_NINE = {
  work: "curve × curve, 9 intersections",
  items: 1,
  check: nineCheck,
  ours: () => nine[0].intersections(nine[1]).length,
};

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    ...ON_NINE,
    id: "intersect-9-bezier-js",
    peer: "bezier-js intersects",
    theirs: () => nineOfBezier[0].intersects(nineOfBezier[1]).length,
  },
  {
    ...ON_NINE,
    id: "intersect-9-paper",
    peer: "paper.js getIntersections",
    theirs: () => nineOfPaper[0].getIntersections(nineOfPaper[1]).length,
  },
  {
    id: "intersect-paper",
    work: "curve × curve, random pairs",
    peer: "paper.js getIntersections",
    items: PAIRS,
    check: () => {
      for (let k = 0; k < 2 * PAIRS; k += 2) assertSameTimes(ours[k], ours[k + 1], theirs[k], theirs[k + 1]);
    },
    theirs: () => {
      let sum = 0;
      for (let k = 0; k < 2 * PAIRS; k += 2) sum += theirs[k].getIntersections(theirs[k + 1]).length;
      return sum;
    },
    ours: () => {
      let sum = 0;
      for (let k = 0; k < 2 * PAIRS; k += 2) sum += ours[k].intersections(ours[k + 1]).length;
      return sum;
    },
  },
];
