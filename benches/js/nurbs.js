// NURBS curves in space, compared with verb-nurbs and three.js.
import { NurbsCurve } from "casteljau/nurbs";
import { Vector3, Vector4 } from "three";
import { NURBSCurve } from "three/addons/curves/NURBSCurve.js";
import { distanceToSegment } from "./distance.js";
import { assertSame } from "./harness.js";
import { parameters, random } from "./inputs.js";
import { verb } from "./verb.js";

const CALLS = 1000;
const CURVES = 64;
const DEGREE = 3;
const COUNT = 7;
const KNOTS = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4];
const END = 4;
/** Coordinates are up to 200. */
const SIZE = 200;
const WEIGHTS = { min: 1 / 4, max: 4 };
/** All sides compute in f64. */
const ROUNDING = 1e-11;
/** The relative error of verb, which uses 19 nodes for each piece and does not estimate its error. */
const THEIR_LENGTH_ERROR = 1e-3;
/** verb ends Newton's method when the direction is perpendicular to 5e-4. */
const THEIR_NEAREST_ERROR = 1e-3;
/** In at least this part of the calls verb finds the nearest point; in the others it finds a point that is farther away. */
const MIN_FOUND = 0.9;
const TOLERANCE = 0.25;
/**
 * verb compares the square of twice the area of a triangle with this. Of 0.3, 0.1, 0.03, … it is the largest with which all curves are
 * within the tolerance.
 */
const THEIR_TOLERANCE = 0.03;
/** The number of points at which distances from polylines are measured. */
const SAMPLES = 500;

const next = random(13);
const inputs = Array.from({ length: CURVES }, () => ({
  points: Array.from({ length: COUNT }, () => [SIZE * next(), SIZE * next(), SIZE * next()]),
  weights: Array.from({ length: COUNT }, () => WEIGHTS.min * (WEIGHTS.max / WEIGHTS.min) ** next()),
}));
const theirs = inputs.map(({ points, weights }) =>
  verb.geom.NurbsCurve.byKnotsControlPointsWeights(DEGREE, KNOTS, points, weights),
);
const three = inputs.map(
  ({ points, weights }) =>
    new NURBSCurve(
      DEGREE,
      KNOTS,
      points.map(([x, y, z], i) => new Vector4(x, y, z, weights[i])),
    ),
);
const ours = inputs.map((input) => new NurbsCurve({ degree: DEGREE, knots: KNOTS, ...input }));
const ts = parameters(CALLS).map((t) => END * t);
const queries = Array.from({ length: CALLS }, () => [SIZE * next(), SIZE * next(), SIZE * next()]);

const coordinates = (/** @type {{ x: number, y: number, z?: number }} */ { x, y, z = 0 }) => [x, y, z];

const evalCheck = () =>
  ts.forEach((t, i) => {
    const point = coordinates(ours[i & 63].eval(t));
    assertSame("point of verb", theirs[i & 63].point(t), point, ROUNDING);
    assertSame("point of three", three[i & 63].getPoint(t / END).toArray(), point, ROUNDING);
  });

const derivativesCheck = () =>
  ts.forEach((t, i) => {
    const [, first, second] = theirs[i & 63].derivatives(t, 2);
    const size = Math.hypot(...first) + Math.hypot(...second);
    assertSame("first derivative", first, coordinates(ours[i & 63].derivativeAt(t)), ROUNDING * size);
    assertSame("second derivative", second, coordinates(ours[i & 63].derivativeAt(t, 2)), ROUNDING * size);
  });

const lengthCheck = () =>
  ours.forEach((curve, k) => {
    const length = curve.length();
    assertSame("length", [theirs[k].length()], [length], THEIR_LENGTH_ERROR * length);
    const [left, right] = curve.split(0.3 * END);
    assertSame("length of both parts", [left.length() + right.length()], [length], 1e-12 * length);
  });

function nearestCheck() {
  let found = 0;
  queries.forEach((q, i) => {
    const [x, y, z] = theirs[i & 63].closestPoint(q);
    const [their, our] = [Math.hypot(x - q[0], y - q[1], z - q[2]), ours[i & 63].nearest(q).distance];
    if (!(our <= their + ROUNDING)) throw new Error(`nearest: ${our}, verb ${their}`);
    if (their - our < THEIR_NEAREST_ERROR) found++;
  });
  if (!(found >= MIN_FOUND * CALLS)) throw new Error(`nearest: verb agrees in ${found} of ${CALLS} calls`);
}

/**
 * The largest distance of samples of a curve from a polyline.
 *
 * @param {NurbsCurve} curve
 * @param {number[][]} vertices
 */
function largestDistance(curve, vertices) {
  let largest = 0;
  for (let i = 0; i <= SAMPLES; i++) {
    const point = coordinates(curve.eval((END * i) / SAMPLES));
    const distances = vertices.slice(1).map((vertex, k) => distanceToSegment(point, vertices[k], vertex));
    largest = Math.max(largest, Math.min(...distances));
  }
  return largest;
}

/** @param {Float64Array} flat */
const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => [...flat.subarray(3 * i, 3 * i + 3)]);

/** verb divides where `Math.random` says; here it has the same numbers in each run. */
function flattenCheck() {
  const chance = Math.random;
  Math.random = random(14);
  try {
    ours.forEach((curve, k) => {
      const [their, our] = [theirs[k].tessellate(THEIR_TOLERANCE), triples(curve.flatten(TOLERANCE).points)].map(
        (vertices) => largestDistance(curve, vertices),
      );
      if (!(their <= TOLERANCE && our <= TOLERANCE)) throw new Error(`flatten: the distance ${our}, verb ${their}`);
    });
  } finally {
    Math.random = chance;
  }
}

/** @param {(index: number) => number} call */
const summed = (call) => () => {
  let sum = 0;
  for (let i = 0; i < CALLS; i++) sum += call(i);
  return sum;
};

let current = 0;
function nextCurve() {
  current = (current + 1) & 63;
  return current;
}

const target = new Vector3();
const evaluated = {
  work: "NURBS curve, eval(t)",
  items: CALLS,
  check: evalCheck,
  ours: summed((i) => ours[i & 63].eval(ts[i]).x),
};

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    ...evaluated,
    id: "nurbs-eval-verb",
    peer: "verb-nurbs point",
    theirs: summed((i) => theirs[i & 63].point(ts[i])[0]),
  },
  {
    ...evaluated,
    id: "nurbs-eval-three",
    peer: "three NURBSCurve",
    theirs: summed((i) => three[i & 63].getPoint(ts[i] / END, target).x),
  },
  {
    id: "nurbs-derivative-verb",
    work: "NURBS curve, first derivative",
    peer: "verb-nurbs derivatives",
    items: CALLS,
    check: derivativesCheck,
    theirs: summed((i) => theirs[i & 63].derivatives(ts[i], 1)[1][0]),
    ours: summed((i) => ours[i & 63].derivativeAt(ts[i]).x),
  },
  {
    id: "nurbs-length-verb",
    work: "NURBS curve, length, ours to 1e-12",
    peer: "verb-nurbs length",
    items: 1,
    check: lengthCheck,
    theirs: () => theirs[nextCurve()].length(),
    ours: () => ours[nextCurve()].length(),
  },
  {
    id: "nurbs-nearest-verb",
    work: "NURBS curve, nearest point",
    peer: "verb-nurbs closestPoint",
    items: CALLS,
    check: nearestCheck,
    theirs: summed((i) => theirs[i & 63].closestPoint(queries[i])[0]),
    ours: summed((i) => ours[i & 63].nearest(queries[i]).point.x),
  },
  {
    id: "nurbs-flatten-verb",
    work: "NURBS curve, flatten, tolerance 0.25",
    peer: "verb-nurbs tessellate",
    items: 1,
    check: flattenCheck,
    theirs: () => theirs[nextCurve()].tessellate(THEIR_TOLERANCE).length,
    ours: () => ours[nextCurve()].flatten(TOLERANCE).points.length,
  },
];
