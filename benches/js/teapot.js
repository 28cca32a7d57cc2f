// Grids of the teapot, compared with three.js and with a hand-written loop.
import { Surface } from "casteljau";
import { TeapotGeometry } from "three/addons/geometries/TeapotGeometry.js";
import { buffers, grid, weights } from "./baseline.js";
import { assertSame } from "./harness.js";

/** Positions and normals are f32; the teapot is 3.15 units high. */
const TOLERANCE = 1e-6;
/** Half of the height of three's teapot: with this size its units equal ours. */
const HALF_HEIGHT = 1.575;

const teapot = Surface.teapot();
const nets = netsOf(teapot);

/**
 * The control points of all patches, 48 numbers each, as the hand-written loop needs them.
 *
 * @param {Surface} surface
 */
export function netsOf(surface) {
  const { vertices, patches } = surface;
  return Float64Array.from(patches.flatMap((net) => [...net].flatMap((i) => [...vertices.subarray(3 * i, 3 * i + 3)])));
}

/**
 * The teapot of three.js in our proportions (without the wider lid).
 *
 * @param {number} segments
 */
const three = (segments) => new TeapotGeometry(HALF_HEIGHT, segments, true, true, true, false, true);

/**
 * Undoes the transformation of three.js, which rotates the teapot so that y is up and moves its middle to the origin:
 * (x, y, z) becomes (x, z - half the height, -y).
 *
 * @param {ArrayLike<number>} numbers
 * @param {number} raise
 */
const toOurAxes = (numbers, raise) =>
  Float64Array.from(numbers, (n, i) => (i % 3 === 0 ? n : i % 3 === 1 ? -numbers[i + 1] : numbers[i - 1] + raise));

/**
 * three.js omits triangles with two equal corners.
 *
 * @param {{ positions: ArrayLike<number>, indices: ArrayLike<number> }} mesh
 */
function withoutDegenerate({ positions, indices }) {
  const same = (/** @type {number} */ a, /** @type {number} */ b) =>
    [0, 1, 2].every((k) => positions[3 * a + k] === positions[3 * b + k]);
  const kept = [];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [indices[i], indices[i + 1], indices[i + 2]];
    if (!same(a, b) && !same(b, c) && !same(a, c)) kept.push(a, b, c);
  }
  return kept;
}

/** @param {number} segments */
function checkThree(segments) {
  const mesh = teapot.grid({ segments });
  const { attributes, index } = three(segments);
  assertSame("three's positions", toOurAxes(attributes.position.array, HALF_HEIGHT), mesh.positions, TOLERANCE);
  assertSame("three's normals", toOurAxes(attributes.normal.array, 0), mesh.normals, TOLERANCE);
  assertSame("three's indices", /** @type {any} */ (index).array, withoutDegenerate(mesh), 0);
}

/**
 * @param {import("casteljau").Surface} surface
 * @param {Float64Array} nets
 * @param {number} segments
 */
export function checkLoop(surface, nets, segments) {
  const mesh = surface.grid({ segments });
  const out = buffers(nets.length / 48, segments);
  grid(nets, segments, weights(segments), out);
  assertSame("the loop's positions", out.positions, mesh.positions, TOLERANCE);
  assertSame("the loop's normals", out.normals, mesh.normals, TOLERANCE);
  assertSame("the loop's indices", out.indices, mesh.indices, 0);
}

/** @param {number} segments */
function loopSides(segments) {
  const [prepared, out] = [weights(segments), buffers(32, segments)];
  return {
    reused() {
      grid(nets, segments, prepared, out);
      return out.normals[100];
    },
    fresh() {
      const mesh = buffers(32, segments);
      grid(nets, segments, weights(segments), mesh);
      return mesh.normals[100];
    },
  };
}

/** @param {number} segments */
function ourSides(segments) {
  const into = teapot.grid({ segments });
  return {
    reused: () => teapot.grid({ segments, into }).normals[100],
    fresh: () => teapot.grid({ segments }).normals[100],
  };
}

/**
 * @param {number} segments
 * @returns {import("./harness.js").Row[]}
 */
function rowsAt(segments) {
  const [our, loop] = [ourSides(segments), loopSides(segments)];
  const items = 1;
  const threes = {
    peer: "three TeapotGeometry",
    items,
    check: () => checkThree(segments),
    theirs: () => three(segments).attributes.normal.array[100],
  };
  const loops = { peer: "loop by hand", items, check: () => checkLoop(teapot, nets, segments) };
  const [id, work] = [`teapot-${segments}`, `teapot, ${segments} segments`];
  return [
    { ...threes, id: `${id}-reused-three`, work: `${work}, ours reused`, ours: our.reused },
    { ...loops, id: `${id}-reused-loop`, work: `${work}, both reused`, theirs: loop.reused, ours: our.reused },
    { ...threes, id: `${id}-fresh-three`, work: `${work}, fresh arrays`, ours: our.fresh },
    { ...loops, id: `${id}-fresh-loop`, work: `${work}, fresh arrays`, theirs: loop.fresh, ours: our.fresh },
  ];
}

export const rows = [16, 64].flatMap(rowsAt);
