import { affine } from "../affine.js";
import * as check from "../check.js";
import { CheckedNetwork, joinedOf } from "./network.js";
import { flatten, writePoint } from "../points.js";
import { networkJSON, vertexIndices } from "../surface-network.js";
import { surfaceText } from "../../io/surface-text.js";
import { core, writeArguments, readResult } from "../../wasm/surfaces-transfer.js";
import type { TransformLike, PointLike, PointsLike } from "../check.js";
import type { Network } from "./network.js";
import type { PatchValue } from "../patch/patch-value.js";

/**
 * The vertices and patches of a surface. The members with an underscore are for the classes that extend this one, see
 * `CurveValue`.
 *
 * @template P the class of its patches
 */
export class SurfaceValue<P extends PatchValue = PatchValue> {
  #network: Network;
  /** For each patch the start of its indices, and at last their number; once asked for */
  #starts: Uint32Array | undefined;

  /**
   * The surface of patches of the same degrees, whose control points are given as indices into a list of vertices.
   *
   * @param data for each patch its (degreeU + 1)·(degreeV + 1) vertex indices, u along the fast index
   * @param options `degreeU`: 3 by default; `degreeV`: 3 by default
   * @throws {RangeError} for an index without a vertex, a wrong count, a NaN or an infinity
   */
  constructor(
    data: { vertices: PointsLike; patches: ArrayLike<ArrayLike<number>> },
    options?: { degreeU?: number; degreeV?: number },
  ) {
    const checked = data as unknown;
    if (checked instanceof CheckedNetwork) {
      this.#network = checked.network;
      return;
    }
    this.#network = checkedNetwork(data, options);
  }

  /**
   * The surface as text from which `parse` creates a bit-identical surface (except that vertices which have been moved
   * to the same position are joined): the row `surface`; `vertices` and their number, then a row x y z for each;
   * `patches` and their number, then for each a row with its degrees in u and v, followed by its net, for each j a row
   * with the vertex numbers, from 0, of the points Pᵢⱼ.
   */
  toText(...surplus: never[]): string {
    check.noSurplus(surplus, "toText", 0);
    return surfaceText(this.#network);
  }

  /**
   * The vertices and, for each patch, its vertex indices and degrees. As with `toText`, vertices which have been moved
   * to the same position are joined in the surface that `fromJSON` returns.
   */
  toJSON(): { vertices: number[][]; patches: number[][]; degrees: number[][] } {
    return networkJSON(this.#network, this.patches);
  }

  /** A copy of the coordinates of the vertices. */
  get vertices() {
    return this.#network.vertices.slice();
  }

  /** For each patch a copy of the vertex indices of its control points. */
  get patches() {
    return Array.from({ length: this.patchCount }, (_, k) => this.#indicesOf(k).slice());
  }

  /** The number of patches. */
  get patchCount() {
    return this.#network.degrees.length / 2;
  }

  /**
   * One patch.
   *
   * @param k the number of the patch, from 0
   */
  patch(k: number): P {
    check.whole(k, "patch", 0, this.patchCount - 1);
    const { vertices, degrees } = this.#network;
    const indices = this.#indicesOf(k);
    const net = new Float64Array(3 * indices.length);
    indices.forEach((index, i) => net.set(vertices.subarray(3 * index, 3 * index + 3), 3 * i));
    return this._patchOf(net, degrees[2 * k], degrees[2 * k + 1]);
  }

  /**
   * The surface with one vertex moved, together with all vertices that had the same position when the surface was
   * created. So patches that were joined stay joined, and others do not become joined.
   *
   * @param index the number of the control point, from 0
   * @param to the new position
   */
  movePoint(index: number, to: PointLike): this {
    const { joined } = this.#network;
    if (joined.length === 0) throw new RangeError("vertices: expected at least 1, got 0");
    check.whole(index, "index", 0, joined.length - 1);
    const vertices = this.vertices;
    writePoint(vertices, 3 * index, to, 3, "to");
    const moved = vertices.slice(3 * index, 3 * index + 3);
    joined.forEach((first, k) => {
      if (first === joined[index]) vertices.set(moved, 3 * k);
    });
    return this._surfaceOf({ ...this.#network, vertices });
  }

  /**
   * The surface transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform(matrix: TransformLike): this {
    const { vertices } = this.#network;
    writeArguments(vertices, 12).set(affine(matrix), vertices.length);
    const length = core().points_transform(3, vertices.length / 3);
    return this._surfaceOf({ ...this.#network, vertices: readResult(0, length) });
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "surface" {
    return "surface";
  }

  /**
   * @internal
   */
  casteljauData(): Network {
    return this.#network;
  }

  /**
   * A surface of the same class. The class of each entry point implements it.
   *
   * @internal
   */
  _surfaceOf(network: Network): this {
    throw new TypeError(`expected a class that makes surfaces of ${network.degrees.length / 2} patches`);
  }

  /**
   * A patch. The class of each entry point implements it.
   *
   * @internal
   */
  _patchOf(flat: Float64Array, degreeU: number, degreeV: number): P {
    throw new TypeError(`expected a class that makes ${degreeU} × ${degreeV} patches of ${flat.length} numbers`);
  }

  /**
   * @internal
   * Writes the surface to the arena with room for `extra` more numbers, and returns the arena and the index of that
   * room.
   * @param withJoined false for functions that treat patches separately
   */
  _write(extra = 0, withJoined = true): { view: Float64Array; at: number } {
    const { vertices, degrees, indices, joined } = this.#network;
    const from = 3 + degrees.length;
    const joinedAt = from + vertices.length + indices.length;
    const joinedCount = withJoined ? joined.length : 0;
    const at = joinedAt + joinedCount;
    const view = writeArguments(Float64Array.of(vertices.length / 3, degrees.length / 2, joinedCount), at + extra);
    view.set(degrees, 3);
    view.set(vertices, from);
    view.set(indices, from + vertices.length);
    if (withJoined) view.set(joined, joinedAt);
    return { view, at };
  }

  /** The vertex indices of a patch, not copied. */
  #indicesOf(k: number) {
    const { degrees, indices } = this.#network;
    if (!this.#starts) {
      this.#starts = new Uint32Array(this.patchCount + 1);
      for (let i = 0; i < this.patchCount; i++) {
        this.#starts[i + 1] = this.#starts[i] + (degrees[2 * i] + 1) * (degrees[2 * i + 1] + 1);
      }
    }
    return indices.subarray(this.#starts[k], this.#starts[k + 1]);
  }
}

function checkedNetwork(
  data: { vertices: PointsLike; patches: ArrayLike<ArrayLike<number>> },
  options?: { degreeU?: number; degreeV?: number },
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
