// Does more work cost more per item? Each row is one kind of work at several sizes.
import { Bezier } from "bezier-js";
import { Curve, Surface } from "casteljau";
import { assertSame, median, timesInTurn } from "./harness.js";
import { cubics } from "./inputs.js";
import { checkLoop, netsOf } from "./teapot.js";

/**
 * One size: so many items in one call.
 *
 * @typedef {{ size: number, items: number, check: () => void, ours: () => number }} Step
 */

const teapot = Surface.teapot();

/** Segments per patch side; the item is a vertex. */
function segmentSteps() {
  const nets = netsOf(teapot);
  return [4, 8, 16, 32, 64, 128, 256].map((segments) => ({
    size: segments,
    items: 32 * (segments + 1) ** 2,
    check: () => checkLoop(teapot, nets, segments),
    ours: reusing(teapot, segments),
  }));
}

/** Patches of 4 × 4 cells; the item is a patch. */
function patchSteps() {
  return [32, 320, 3200, 32_000].map((patches) => {
    const surface = teapots(patches / 32);
    return { size: patches, items: patches, check: () => checkLoop(surface, netsOf(surface), 4), ours: reusing(surface, 4) };
  });
}

/**
 * @param {Surface} surface
 * @param {number} segments
 */
function reusing(surface, segments) {
  /** @type {import("casteljau").Mesh | undefined} */
  let into;
  return () => (into = surface.grid({ segments, into })).normals[100];
}

/**
 * A surface of several teapots on the same place, each with vertices of its own.
 *
 * @param {number} count
 */
function teapots(count) {
  const { vertices, patches } = teapot;
  const all = new Float64Array(count * vertices.length);
  const nets = [];
  for (let k = 0; k < count; k++) {
    all.set(vertices, k * vertices.length);
    for (const net of patches) nets.push(net.map((i) => i + (k * vertices.length) / 3));
  }
  return new Surface({ vertices: all, patches: nets });
}

/** Points on a cubic; the item is a point. */
function sampleSteps() {
  const [numbers] = cubics(1);
  const [curve, peer] = [new Curve(numbers), new Bezier(numbers)];
  return [10, 100, 1000, 10_000, 100_000].map((points) => {
    const into = new Float64Array(2 * points);
    const theirs = () => peer.getLUT(points - 1).flatMap(({ x, y }) => [x, y]);
    return {
      size: points,
      items: points,
      check: () => assertSame("sample", theirs(), curve.sample(points - 1, { into }), 1e-11),
      ours: () => curve.sample(points - 1, { into })[points],
    };
  });
}

const ROWS = [
  { id: "growth-segments", work: "teapot, 4 … 256 segments, reused: per vertex", steps: segmentSteps },
  { id: "growth-patches", work: "32 … 32,000 patches, 4 segments, reused: per patch", steps: patchSteps },
  { id: "growth-sample", work: "10 … 100,000 points of a cubic, reused: per point", steps: sampleSteps },
];

/**
 * @param {import("./harness.js").Effort} effort
 * @param {(id: string) => boolean} wanted
 */
export function results(effort, wanted) {
  return ROWS.filter(({ id }) => wanted(id)).map(({ id, work, steps }) => grown(id, work, steps(), effort));
}

/**
 * @param {string} id
 * @param {string} work
 * @param {Step[]} steps
 * @param {import("./harness.js").Effort} effort
 */
function grown(id, work, steps, effort) {
  steps.forEach(({ check }) => check());
  const times = timesInTurn(steps.map(({ ours }) => ours), effort);
  const costs = steps.map(({ size, items }, k) => ({ size, ns: median(times[k]) / items }));
  return { id, work, costs, ours: growth(costs.map(({ ns }) => ns)), ratio: null };
}

/**
 * The most that an item costs against any smaller size. What is spread thinner as the work grows (the cost of the call
 * itself) is no growth.
 *
 * @param {number[]} costs
 */
function growth(costs) {
  return Math.max(...costs.map((cost, k) => cost / Math.min(...costs.slice(0, k + 1))));
}
