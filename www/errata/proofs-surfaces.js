// A computation for each erratum about surfaces: a sentence with the numbers, and whether they prove the correction.
import { Curve } from "casteljau";
import { Patch, Surface } from "casteljau/surfaces";
import { listed, rounded } from "./format.js";

/** @typedef {import("./proofs-curves.js").Proof} Proof */
/** @typedef {{ x: number, y: number, z: number }} Vector */

/** @param {Vector} v */
const described = ({ x, y, z }) => `(${listed([x, y, z], 2)})`;
/** @param {Vector} a @param {Vector} b @returns {Vector} */
const cross = (a, b) => ({ x: a.y * b.z - a.z * b.y, y: a.z * b.x - a.x * b.z, z: a.x * b.y - a.y * b.x });
/** @param {Vector} a @param {Vector} b @returns {Vector} */
const minus = (a, b) => ({ x: a.x - b.x, y: a.y - b.y, z: a.z - b.z });
/** @param {Vector} v */
const length = ({ x, y, z }) => Math.hypot(x, y, z);
/** @param {Surface} surface @returns {Vector} the width, depth and height of its bounding box */
const sizeOf = (surface) => {
  const bounds = surface.bounds();
  return minus(/** @type {Vector} */ (bounds?.max), /** @type {Vector} */ (bounds?.min));
};

/** The point of a patch. @param {Patch} patch @param {number} u @param {number} v */
const pointAt = (patch, u, v) => /** @type {Vector} */ (patch.eval(u, v));

/** The handle of a cubic for a quarter of a circle, 4/3 · (√2 − 1). */
const K = 0.5522847498307936;
/** A flat quarter of a ring: all its points are in one plane, two of its edges are curved. */
const RING = new Patch(
  [1, 4 / 3, 5 / 3, 2].flatMap((r) => [
    [r, 0, 0],
    [r, K * r, 0],
    [K * r, r, 0],
    [0, r, 0],
  ]),
);

/** @type {Record<string, () => Proof>} */
export const surfaceProofs = {
  "t-in-k"() {
    const [u, t] = [0.2, 0.6];
    const k = (/** @type {number} */ x) => [(1 - x) ** 3, 3 * (1 - x) ** 2 * x, 3 * (1 - x) * x ** 2, x ** 3];
    const weights = Curve.bernstein(3, u);
    const matches = (/** @type {number[]} */ values) =>
      values.every((value, i) => Math.abs(value - weights[i]) < 1e-15);
    return {
      words: `At u = 0.2 the Bernstein polynomials are ${listed(weights)}. The right-hand sides with u in place of t give ${listed(k(u))}; with t = 0.6 left in they give ${listed(k(t))}.`,
      holds: matches(k(u)) && !matches(k(t)),
    };
  },

  "curve-p-2"() {
    const row = [
      [0, 0],
      [1, 2],
      [2, 2],
      [3, 0],
    ];
    const [right, wrong] = [row, [row[0], row[1], row[3], [0, 0]]].map((points) => new Curve(points).eval(1));
    return {
      words: `The row (0, 0), (1, 2), (2, 2), (3, 0) ends at (${right.x}, ${right.y}). With index 2 written twice, and zeros in the entry that is never set, it ends at (${wrong.x}, ${wrong.y}).`,
      holds: right.x === 3 && wrong.x === 0,
    };
  },

  "scale-axis"() {
    const pot = Surface.teapot();
    const aboutZ = pot.transform([0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    const aboutX = pot.transform([1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1]);
    const [size, turned, upright] = [pot, aboutZ, aboutX].map(sizeOf);
    const near = (/** @type {number} */ a, /** @type {number} */ b) => Math.abs(a - b) < 1e-12;
    return {
      words: `The listed pot measures ${described(size)} along x, y and z, and its height is along z. After 90° about z it measures ${described(turned)}: the height is still along z. After 90° about x, ${described(upright)}: the height is along y.`,
      holds: near(size.z, 3.15) && near(turned.z, size.z) && near(turned.y, size.x) && near(upright.y, size.z),
    };
  },

  "forward-differential"() {
    const curve = new Curve([
      [0, 0],
      [1, 0],
      [0, 0],
      [2, 0],
    ]);
    const step = 0.25;
    const difference = curve.eval(step).x - curve.eval(0).x;
    const differential = step * curve.derivativeAt(0).x;
    return {
      words: `The cubic with the values 0, 1, 0, 2 and a step of ¼: the technique adds the difference B(¼) − B(0) = ${rounded(difference, 5)}; the differential B′(0) · ¼ is ${rounded(differential, 5)}.`,
      holds: Math.abs(difference - 0.453125) < 1e-15 && differential === 0.75,
    };
  },

  "sum-product"() {
    const net = Array.from({ length: 9 }, (_, i) => [i % 3, Math.floor(i / 3), (i * i) % 5]);
    const patch = new Patch(net, { degreeU: 2, degreeV: 2 });
    const [u, v] = [0.3, 0.6];
    const [inU, inV] = [Curve.bernstein(2, u), Curve.bernstein(2, v)];
    const weighted = (/** @type {(a: number, b: number) => number} */ weight) =>
      [0, 1, 2].map((axis) => net.reduce((sum, p, k) => sum + weight(inU[k % 3], inV[Math.floor(k / 3)]) * p[axis], 0));
    const { x, y, z } = pointAt(patch, u, v);
    const [products, sums] = [weighted((a, b) => a * b), weighted((a, b) => a + b)];
    const error = (/** @type {number[]} */ p) => Math.hypot(p[0] - x, p[1] - y, p[2] - z);
    return {
      words: `A quadratic patch at (0.3, 0.6) is at (${listed([x, y, z])}). Points weighted with products give (${listed(products)}), with sums (${listed(sums)}).`,
      holds: error(products) < 1e-12 && error(sums) > 1,
    };
  },

  "three-corners"() {
    const flat = RING.controlPoints().every((x, i) => i % 3 !== 2 || x === 0);
    const corners = [
      [0, 0],
      [1, 0],
      [0, 1],
      [1, 1],
    ].map(([u, v]) => pointAt(RING, u, v));
    const [a, b, c, d] = corners;
    const triangle = (/** @type {Vector} */ p, /** @type {Vector} */ q, /** @type {Vector} */ r) =>
      length(cross(minus(q, p), minus(r, p))) / 2;
    const [two, all] = [triangle(a, b, d) + triangle(a, d, c), RING.area()];
    return {
      words: `A flat quarter of a ring: all sixteen points lie in the plane of three corners, at distance 0. Its area is ${rounded(all, 2)}, that of its two triangles ${rounded(two, 2)}.`,
      holds: flat && all / two > 1.5,
    };
  },
};
