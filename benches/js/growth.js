// The cost per item at several sizes, which must not grow.
import { Bezier } from "bezier-js";
import { Curve, Path, Spline, Surface } from "casteljau";
import { assertSame, median, timesInTurn } from "./harness.js";
import { cubics, random } from "./inputs.js";
import { measure, outlines } from "./path.js";
import { checkLoop, netsOf } from "./teapot.js";

/**
 * One size: the number of items of one call.
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
    return {
      size: patches,
      items: patches,
      check: () => checkLoop(surface, netsOf(surface), 4),
      ours: reusing(surface, 4),
    };
  });
}

/**
 * @param {Surface} surface
 * @param {number} segments
 */
function reusing(surface, segments) {
  /** @type {import("casteljau").Mesh | undefined} */
  let into;
  return () => {
    into = surface.grid({ segments, into });
    return into.normals[100];
  };
}

/**
 * A surface of several teapots at the same position, each with its own vertices.
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

/** The points of a random walk, all different. */
function walk(/** @type {number} */ count) {
  const next = random(3);
  let [x, y] = [0, 0];
  return Float64Array.from({ length: 2 * count }, (_, i) => {
    if (i % 2 === 0) {
      x += next();
      return x;
    }
    y += next() - 0.5;
    return y;
  });
}

/** Interpolating splines; the item is a point. */
function interpolateSteps() {
  return [100, 1000, 10_000, 100_000].map((count) => {
    const points = walk(count);
    return {
      size: count,
      items: count,
      check: () => assertSame("interpolate", points, jointsOf(Spline.interpolate(points)), 0),
      ours: () => Spline.interpolate(points).segmentCount,
    };
  });
}

/**
 * The joints of a cubic spline.
 *
 * @param {Spline} spline
 */
const jointsOf = (spline) => spline.controlPoints().filter((_, i) => i % 6 < 2);

/** Moving one handle with C2 at all joints, which changes the whole spline; the item is a segment. */
function moveSteps() {
  return [100, 1000, 10_000, 100_000].map((count) => {
    const spline = Spline.interpolate(walk(count + 1));
    const joints = new Array(count).fill("c2");
    const move = () => spline.movePoint(3 * (count >> 1) + 1, [0, 0], { joints });
    return {
      size: count,
      items: count,
      check: () =>
        assertSame(
          "movePoint",
          [0, 0],
          move()
            .controlPoints()
            .slice(6 * (count >> 1) + 2)
            .slice(0, 2),
          0,
        ),
      ours: () => move().segmentCount,
    };
  });
}

/** Parsing and measuring path data; the item is a character. */
function pathSteps() {
  return [1e4, 1e5, 1e6, 1e7].map((characters) => {
    const d = outlines(characters);
    return {
      size: characters,
      items: characters,
      check: () => assertSame("path", measure(d).box, measure(Path.fromSVG(d).toSVG()).box, 0),
      ours: () => measure(d).length,
    };
  });
}

/** Equidistant points of a cubic; the item is a point. */
function equidistantSteps() {
  const [numbers] = cubics(1);
  const curve = new Curve(numbers);
  return [10, 100, 1000, 10_000, 100_000].map((steps) => ({
    size: steps,
    items: steps,
    check: () => {
      const ts = curve.equidistantTimes(steps);
      const half = curve.subsegment(0, ts[steps / 2]).length();
      assertSame("half of the steps", [0.5 * curve.length()], [half], 1e-11 * half);
    },
    ours: () => curve.equidistantTimes(steps)[steps >> 1],
  }));
}

/** The nearest point of a spline; the item is a segment. */
function nearestSteps() {
  return [4, 16, 64, 256].map((count) => {
    const spline = Spline.interpolate(walk(count + 1));
    const query = { x: count / 4, y: 3 };
    return {
      size: count,
      items: count,
      check: () => {
        const each = spline.segments().map((curve) => curve.nearest(query).distance);
        assertSame("nearest", [Math.min(...each)], [spline.nearest(query).distance], 1e-12);
      },
      ours: () => spline.nearest(query).distance,
    };
  });
}

export const rows = [
  { id: "growth-segments", work: "teapot, 4 … 256 segments, reused: per vertex", steps: segmentSteps },
  { id: "growth-patches", work: "32 … 32,000 patches, 4 segments, reused: per patch", steps: patchSteps },
  { id: "growth-sample", work: "10 … 100,000 points of a cubic, reused: per point", steps: sampleSteps },
  { id: "growth-equidistant", work: "10 … 100,000 equidistant points of a cubic: per point", steps: equidistantSteps },
  { id: "growth-path", work: "path data of 10 kB … 10 MB: parse, bounds, length: per character", steps: pathSteps },
  { id: "growth-nearest", work: "nearest point of 4 … 256 segments: per segment", steps: nearestSteps },
  { id: "growth-interpolate", work: "natural spline through 100 … 100,000 points: per point", steps: interpolateSteps },
  { id: "growth-move", work: "a handle of 100 … 100,000 C2 segments moved: per segment", steps: moveSteps },
];

/**
 * The costs of a row at all its sizes, and the largest growth.
 *
 * @param {{ id: string, work: string, steps: () => Step[] }} row
 * @param {import("./harness.js").Effort} effort
 */
export function growthRow({ id, work, steps: makeSteps }, effort) {
  const steps = makeSteps();
  for (const { check } of steps) check();
  const times = timesInTurn(
    steps.map(({ ours }) => ours),
    effort,
  );
  const costs = steps.map(({ size, items }, k) => ({ size, ns: median(times[k]) / items }));
  return { id, work, costs, ours: largestGrowth(costs.map(({ ns }) => ns)), ratio: null };
}

/**
 * The largest ratio of the cost per item at one size to the cost at a smaller size. A cost that decreases with the size
 * (that of the call itself) is not growth.
 *
 * @param {number[]} costs
 */
function largestGrowth(costs) {
  return Math.max(...costs.map((cost, k) => cost / Math.min(...costs.slice(0, k + 1))));
}
