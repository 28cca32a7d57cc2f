// Curves, compared with bezier-js.
import { Bezier } from "bezier-js";
import { Curve } from "casteljau";
import { assertSame } from "./harness.js";
import { cubics, parameters } from "./inputs.js";

/** Coordinates are up to 200; both sides compute in f64. */
const TOLERANCE = 1e-11;
const POINTS = 1000;

const inputs = cubics(64);
const theirs = inputs.map((numbers) => new Bezier(numbers));
const ours = inputs.map((numbers) => new Curve(numbers));
const ts = parameters(POINTS);
const reused = new Float64Array(2 * POINTS);
const into = { into: reused };

/** @param {{ x: number, y: number }[]} points */
const flat = (points) => points.flatMap(({ x, y }) => [x, y]);

/**
 * bezier-js caches its last table. It is deleted here, so that the table is computed each time and the tables of other
 * curves do not burden the garbage collector.
 *
 * @param {any} curve
 * @returns {{ x: number, y: number }[]}
 */
function lut(curve) {
  const table = curve.getLUT(POINTS - 1);
  curve._lut = [];
  return table;
}

/** The index of the next curve: each call uses another curve, so that caching the last result does not help. */
let current = 0;
function next() {
  current = (current + 1) & 63;
  return current;
}

const sampleCheck = () =>
  ours.forEach((curve, k) => {
    const table = flat(lut(theirs[k]));
    assertSame("fresh sample", table, curve.sample(POINTS - 1), TOLERANCE);
    assertSame("reused sample", table, curve.sample(POINTS - 1, into), TOLERANCE);
  });

const sampled = {
  peer: "bezier-js getLUT",
  items: 1,
  check: sampleCheck,
  theirs: () => lut(theirs[next()])[POINTS >> 1].x,
};

function evalCheck() {
  for (let i = 0; i < POINTS; i++) {
    assertSame("eval", flat([theirs[i & 63].get(ts[i])]), flat([ours[i & 63].eval(ts[i])]), TOLERANCE);
  }
}

function theirPoints() {
  let sum = 0;
  for (let i = 0; i < POINTS; i++) {
    const point = theirs[i & 63].get(ts[i]);
    sum += point.x + point.y;
  }
  return sum;
}

function ourPoints() {
  let sum = 0;
  for (let i = 0; i < POINTS; i++) {
    const point = ours[i & 63].eval(ts[i]);
    sum += point.x + point.y;
  }
  return sum;
}

function splitCheck() {
  for (let i = 0; i < POINTS; i++) {
    const { left, right } = theirs[i & 63].split(ts[i]);
    const [before, after] = ours[i & 63].split(ts[i]);
    assertSame("split, before", flat(left.points), before.controlPoints(), TOLERANCE);
    assertSame("split, after", flat(right.points), after.controlPoints(), TOLERANCE);
  }
}

function theirPieces() {
  let sum = 0;
  for (let i = 0; i < POINTS; i++) {
    const { left, right } = theirs[i & 63].split(ts[i]);
    sum += left.order + right.order;
  }
  return sum;
}

function ourPieces() {
  let sum = 0;
  for (let i = 0; i < POINTS; i++) {
    const [before, after] = ours[i & 63].split(ts[i]);
    sum += before.degree + after.degree;
  }
  return sum;
}

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    ...sampled,
    id: "sample-reused",
    work: "1,000 points of a cubic, into a reused array",
    ours: () => ours[next()].sample(POINTS - 1, into)[POINTS],
  },
  {
    ...sampled,
    id: "sample-fresh",
    work: "1,000 points of a cubic, fresh array",
    ours: () => ours[next()].sample(POINTS - 1)[POINTS],
  },
  {
    id: "eval",
    work: "eval(t), one point",
    peer: "bezier-js get",
    items: POINTS,
    check: evalCheck,
    theirs: theirPoints,
    ours: ourPoints,
  },
  {
    id: "split",
    work: "split(t)",
    peer: "bezier-js split",
    items: POINTS,
    check: splitCheck,
    theirs: theirPieces,
    ours: ourPieces,
  },
];
