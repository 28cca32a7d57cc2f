// Short computations that settle what a text says of surfaces.
import { Curve, Patch, Surface } from "casteljau";

/** @typedef {import("./proofs-curves.js").Found} Found */
/** @typedef {{ x: number, y: number, z: number }} Vector */

/** @param {number} x @param {number} [digits] */
const n = (x, digits = 3) => String(Number(x.toFixed(digits))).replace("-", "−");
/** @param {Vector} v */
const told = ({ x, y, z }) => `(${n(x, 2)}, ${n(y, 2)}, ${n(z, 2)})`;
/** @param {Vector} a @param {Vector} b @returns {Vector} */
const cross = (a, b) => ({ x: a.y * b.z - a.z * b.y, y: a.z * b.x - a.x * b.z, z: a.x * b.y - a.y * b.x });
/** @param {Vector} a @param {Vector} b */
const dot = (a, b) => a.x * b.x + a.y * b.y + a.z * b.z;
/** @param {Vector} a @param {Vector} b @returns {Vector} */
const minus = (a, b) => ({ x: a.x - b.x, y: a.y - b.y, z: a.z - b.z });

/** A patch over a square of side 3, lifted as told. @param {(i: number, j: number) => number} height @param {number} [degree] */
const lifted = (height, degree = 3) => {
  const side = Array.from({ length: degree + 1 }, (_, i) => i);
  return new Patch(
    side.flatMap((j) => side.map((i) => [i, j, height(i, j)])),
    { degreeU: degree, degreeV: degree },
  );
};

/** The point of a patch. @param {Patch} patch @param {number} u @param {number} v */
const pointAt = (patch, u, v) => /** @type {Vector} */ (patch.eval(u, v));

/** A flat quarter of a ring: all its points in one plane, two of its sides bent. */
const K = 0.5522847498307936; // 4/3 · (√2 − 1), a cubic's handle for a quarter of a circle
const RING = new Patch(
  [1, 4 / 3, 5 / 3, 2].flatMap((r) => [
    [r, 0, 0],
    [r, K * r, 0],
    [K * r, r, 0],
    [0, r, 0],
  ]),
);

/** @type {Record<string, () => Found>} */
export const surfaceProofs = {
  "u-or-v"() {
    const patch = lifted((i, j) => i + 10 * j);
    const along = patch.isocurveAtV(0).controlPoints();
    const numbers = [0, 1, 2, 3].map((k) => along[3 * k] + 4 * along[3 * k + 1] + 1);
    return {
      words: `Keep v = 0 and let u run: the curve has the control points ${numbers.join(", ")}.`,
      holds: numbers.join() === "1,2,3,4",
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
      words: `The row (0, 0), (1, 2), (2, 2), (3, 0) ends at (${right.x}, ${right.y}). With index 2 written twice, and zeros where nothing was written, at (${wrong.x}, ${wrong.y}).`,
      holds: right.x === 3 && wrong.x === 0,
    };
  },

  winding() {
    const patch = lifted((i, j) => (i * (3 - i) + j * (3 - j)) / 2);
    const at = (/** @type {number} */ u, /** @type {number} */ v) => pointAt(patch, u / 16, v / 16);
    const [a, b, c] = [at(8, 8), at(8, 9), at(9, 9)]; // one step of v first, as listed
    const { u, v } = patch.partials(0.5, 0.5);
    const normal = cross(/** @type {Vector} */ (u), /** @type {Vector} */ (v));
    const agreement = dot(cross(minus(b, a), minus(c, a)), normal);
    return {
      words: `The quad in the middle of a patch, in the order of the listing: its normal times ∂u × ∂v is ${agreement.toExponential(1)}.`,
      holds: agreement < 0,
    };
  },

  "scale-axis"() {
    const size = (/** @type {Surface} */ pot) =>
      minus(/** @type {Vector} */ (pot.bounds()?.max), /** @type {Vector} */ (pot.bounds()?.min));
    const pot = Surface.teapot();
    const wide = pot.transform([1, 0, 0, 0, 0, 4 / 3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    return {
      words: `The listed pot measures ${told(size(pot))}: 3.15 is its height, and z is up. Stretched along y it measures ${told(size(wide))}, as high as before; Newell's measures ${told(size(Surface.teapot({ height: "original" })))}.`,
      holds:
        Math.abs(size(wide).z - 3.15) < 1e-12 && Math.abs(size(Surface.teapot({ height: "original" })).z - 4.2) < 1e-12,
    };
  },

  poles() {
    const pot = Surface.teapot();
    const { collapsed } = pot.topology();
    const { u } = pot.patch(20).partials(0.5, 0);
    const { v } = pot.patch(20).partials(0.5, 0);
    const area = Math.hypot(...Object.values(cross(/** @type {Vector} */ (u), /** @type {Vector} */ (v))));
    const count = typeof collapsed === "number" ? collapsed : collapsed.length;
    return {
      words: `Sides of the teapot's patches that are one point: ${count}. At the tip of the lid |∂u × ∂v| = ${n(area)}.`,
      holds: count > 0 && area < 1e-12,
    };
  },

  cracks() {
    const side = Surface.teapot().patch(4).isocurveAtU(0);
    const polyline = (/** @type {number} */ segments) => side.sample(segments);
    const [coarse, fine] = [polyline(3), polyline(4)];
    const piece = (/** @type {number} */ k) => new Curve([...coarse.slice(3 * k, 3 * k + 6)], { dimension: 3 });
    const gaps = [1, 2, 3].map((i) =>
      Math.min(...[0, 1, 2].map((k) => piece(k).nearest([...fine.slice(3 * i, 3 * i + 3)]).distance)),
    );
    return {
      words: `A side of the teapot's body, cut in three on one patch and in four on its neighbour: the gap is up to ${n(Math.max(...gaps))} wide, the pot 3.15 high.`,
      holds: Math.max(...gaps) > 0.001,
    };
  },

  "rank-one"() {
    const [a, b] = [
      [1, 2, 4, 3],
      [2, 1, 1, 5],
    ];
    const product = (/** @type {number} */ i, /** @type {number} */ j) => a[i] * b[j];
    const pairs = [0, 1, 2].flatMap((i) => [i + 1, i + 2, i + 3].filter((k) => k < 4).map((k) => [i, k]));
    const minors = pairs.flatMap(([i, k]) =>
      pairs.map(([j, l]) => product(i, j) * product(k, l) - product(i, l) * product(k, j)),
    );
    return {
      words: `Heights a_i b_j: all ${minors.length} determinants of 2 × 2 parts of the net are 0. Eight numbers say it all; a patch has sixteen.`,
      holds: minors.length === 36 && minors.every((minor) => minor === 0),
    };
  },

  "diagonal-degree"() {
    const patch = lifted(
      (i, j) =>
        [
          [0, 2, 1],
          [3, 1, 0],
          [1, 4, 2],
        ][i][j],
      2,
    );
    let heights = Array.from({ length: 6 }, (_, i) => pointAt(patch, i / 5, i / 5).z);
    const differences = [];
    for (let k = 1; k <= 5; k++) {
      heights = heights.slice(1).map((h, i) => h - heights[i]);
      differences.push(heights[0]);
    }
    return {
      words: `Heights along the diagonal u = v of a patch with nine points: the fourth differences are ${n(differences[3])}, the fifth ${n(Math.abs(differences[4]), 12)}. Degree 4.`,
      holds: Math.abs(differences[3]) > 1e-3 && Math.abs(differences[4]) < 1e-12,
    };
  },

  "inner-rows"() {
    const patch = lifted((i, j) => (i % 3 && j % 3 ? 3 : 0));
    const row = new Curve([0, 1, 2, 3].map((i) => [i, 1, i % 3 ? 3 : 0]));
    const away = patch.nearest(row.eval(0.5)).distance;
    return {
      words: `The curve of the second row, at its middle, is ${n(away, 2)} away from the patch, whose net is 3 wide.`,
      holds: away > 0.1,
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
      Math.hypot(...Object.values(cross(minus(q, p), minus(r, p)))) / 2;
    const [two, all] = [triangle(a, b, d) + triangle(a, d, c), RING.area()];
    return {
      words: `A flat quarter of a ring: all sixteen points lie in the plane of three corners, at distance 0. Its area is ${n(all, 2)}, that of its two triangles ${n(two, 2)}.`,
      holds: flat && all / two > 1.5,
    };
  },

  "no-plane"() {
    const patch = Surface.teapot().patch(20);
    const [a, b, c] = [
      [0, 0],
      [1, 0],
      [0, 1],
    ].map(([u, v]) => pointAt(patch, u, v));
    const area = Math.hypot(...Object.values(cross(minus(b, a), minus(c, a))));
    return {
      words: `On the teapot's lid the corners (0, 0) and (1, 0) of a patch are one point: three corners that include both span a triangle of area ${n(area)}.`,
      holds: area < 1e-12,
    };
  },
};
