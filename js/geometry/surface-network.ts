// Networks of surfaces from patches and from JSON.
import { patchData, requireJSON } from "./brand.js";
import * as check from "./check.js";
import { flatten, nested } from "./points.js";
import type { PointsLike } from "./check.js";
import type { CorePatch } from "./patch/core-patch.js";
import type { Network, PatchData } from "./brand.js";

/** What `Surface.toJSON` returns; `Surface.fromJSON` also reads other forms of points. */
export interface SurfaceJSON {
  vertices: PointsLike;
  /** For each patch the vertex indices of its control points, u along the fast index */
  patches: ArrayLike<ArrayLike<number>>;
  /** For each patch its degrees in u and v; bicubic by default */
  degrees?: ArrayLike<ArrayLike<number>>;
}

/**
 * For each vertex the index of the first one with the same position.
 *
 * @internal
 */
export type JoinedOf = (vertices: Float64Array) => Float64Array;

/**
 * The network of patches of the same degrees.
 *
 * @internal
 */
export function checkedNetwork(
  data: { vertices: PointsLike; patches: ArrayLike<ArrayLike<number>> },
  options: { degreeU?: number; degreeV?: number } | undefined,
  joinedOf: JoinedOf,
): Network {
  const { vertices, patches } = check.object(data, "data");
  const { degreeU = 3, degreeV = 3 } = check.options(options, ["degreeU", "degreeV"]);
  check.whole(degreeU, "degreeU", 1, 64);
  check.whole(degreeV, "degreeV", 1, 64);
  const flat = flatten(vertices as PointsLike, 3, 3, "vertices").flat;
  const indices = patchIndices(patches, (degreeU + 1) * (degreeV + 1), flat.length / 3);
  const degrees = Array.from({ length: (2 * indices.length) / ((degreeU + 1) * (degreeV + 1)) }, (_, k) =>
    k % 2 ? degreeV : degreeU,
  );
  return { vertices: flat, joined: joinedOf(flat), degrees, indices };
}

/**
 * @param count the number of points of one net
 */
function patchIndices(patches: unknown, count: number, vertices: number): Uint32Array {
  if (!Array.isArray(patches)) throw new TypeError(`patches: expected an array, got ${check.describe(patches)}`);
  const all = new Uint32Array(patches.length * count);
  patches.forEach((net, k) => all.set(vertexIndices(net, count, vertices, `patches[${k}]`), k * count));
  return all;
}

/**
 * The network of patches: control points at the same position become one vertex.
 *
 * @internal
 */
export function networkOfPatches(patches: ArrayLike<CorePatch>, joinedOf: JoinedOf): Network {
  if (!Array.isArray(patches)) throw new TypeError(`patches: expected an array, got ${check.describe(patches)}`);
  return networkOfNets(Array.from(patches, checkedPatch), joinedOf); // also finds holes
}

/**
 * The network of nets.
 *
 * @internal
 */
export function networkOfNets(checked: PatchData[], joinedOf: JoinedOf): Network {
  const nets = checked.map(({ flat }) => flat);
  const vertices = new Float64Array(nets.reduce((sum, net) => sum + net.length, 0));
  let at = 0;
  for (const net of nets) {
    vertices.set(net, at);
    at += net.length;
  }
  const degrees = checked.flatMap(({ degreeU, degreeV }) => [degreeU, degreeV]);
  return { degrees, ...sharedVertices(vertices, joinedOf(vertices)) };
}

function checkedPatch(value: unknown, k: number): PatchData {
  return patchData(value, `patches[${k}]`);
}

/**
 * Keeps the first of the vertices with the same position.
 *
 * @internal
 * @param vertices overwritten
 */
export function sharedVertices(
  vertices: Float64Array,
  joined: Float64Array,
): { vertices: Float64Array; joined: Float64Array; indices: Uint32Array } {
  const indices = new Uint32Array(joined.length);
  let count = 0;
  for (let k = 0; k < joined.length; k++) {
    if (joined[k] < k) {
      indices[k] = indices[joined[k]];
      continue;
    }
    for (let axis = 0; axis < 3; axis++) vertices[3 * count + axis] = vertices[3 * k + axis];
    indices[k] = count++;
  }
  return { vertices: vertices.slice(0, 3 * count), joined: new Float64Array(count).map((_, k) => k), indices };
}

/**
 * A network as plain data.
 *
 * @internal
 * @param patches the vertex indices of each patch
 */
export function networkJSON({ vertices, degrees }: Network, patches: ArrayLike<number>[]) {
  return {
    vertices: nested(vertices, 3),
    patches: patches.map((indices) => Array.from(indices)),
    degrees: patches.map((_, k) => [degrees[2 * k], degrees[2 * k + 1]]),
  };
}

/**
 * The network of JSON.
 *
 * @internal
 */
export function networkOfJSON(json: SurfaceJSON, joinedOf: JoinedOf): Network {
  requireJSON(json, "vertices and patches", ({ patches }) => Array.isArray(patches));
  const { flat } = flatten(json.vertices, 3, 3, "vertices");
  const degrees = degreesOf(json.degrees, json.patches.length);
  const nets = Array.from(json.patches, (net, k) => {
    const needed = (degrees[2 * k] + 1) * (degrees[2 * k + 1] + 1);
    return vertexIndices(net, needed, flat.length / 3, `patches[${k}]`);
  });
  return { vertices: flat, joined: joinedOf(flat), degrees, indices: Uint32Array.from(nets.flat()) };
}

function degreesOf(degrees: unknown, patches: number): number[] {
  if (degrees === undefined) return new Array(2 * patches).fill(3);
  if (!Array.isArray(degrees)) throw new TypeError(`degrees: expected an array, got ${check.describe(degrees)}`);
  if (degrees.length !== patches) {
    throw new RangeError(`degrees: expected ${patches} pairs, one for each patch, got ${degrees.length}`);
  }
  return Array.from(degrees, (pair, k) => {
    const numbers = [...check.numbers(pair, `degrees[${k}]`)];
    if (numbers.length !== 2) throw new RangeError(`degrees[${k}]: expected 2 numbers, got ${numbers.length}`);
    return numbers.map((degree, i) => check.whole(degree, `degrees[${k}][${i}]`, 1, 64));
  }).flat();
}

/**
 * The vertex indices of one patch, checked.
 *
 * @internal
 */
export function vertexIndices(net: unknown, count: number, vertices: number, name: string): number[] {
  if (!check.isList(net)) throw new TypeError(`${name}: expected vertex indices, got ${check.describe(net)}`);
  if (net.length !== count) throw new RangeError(`${name}: expected ${count} vertex indices, got ${net.length}`);
  return Array.from(net, (index, i) => check.whole(index, `${name}[${i}]`, 0, vertices - 1));
}
