import { basisNumbers } from "./basis.js";
import * as check from "./check.js";
import { curveOf } from "./curve/curve.js";
import { readGrid } from "./grid-mesh.js";
import { netNumbers } from "./net.js";
import { nested, pointAt, samePoints, writePoint } from "./points.js";
import { gridOptions, readMesh } from "./mesh.js";
import * as queries from "./surface-queries.js";
import { core, unwrapCount, writeArguments, readResult } from "../wasm/surfaces-transfer.js";
import { tessellation } from "./tessellation.js";
import { CheckedPoints } from "../wasm/transfer.js";

/**
 * @import { BasisLike } from "./basis.js"
 * @import { MatrixLike, PointLike } from "./check.js"
 * @import { Curve } from "./curve/curve.js"
 * @import { GridOptions, Mesh } from "./mesh.js"
 * @import { NetLike } from "./net.js"
 * @import { Point } from "./points.js"
 * @import { Curvature, PatchPoint, PatchDeCasteljau } from "./surface-queries.js"
 * @import { TessellationOptions } from "./tessellation.js"
 */

/**
 * What `Patch.toJSON` returns; `Patch.fromJSON` also reads other forms of nets.
 *
 * @typedef {object} PatchJSON
 * @property {NetLike} net
 * @property {number} [degreeU] 3 by default
 * @property {number} [degreeV] 3 by default
 */

/**
 * The partial derivatives of a patch.
 *
 * @typedef {{ u: Point, v: Point, uu: Point, uv: Point, vv: Point }} Partials
 */

/**
 * One tensor-product Bézier patch of degrees 1 to 64 in u and in v, in 3D.
 *
 * S(u, v) = Σ Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with the net index j·(degreeU + 1) + i: u runs along the fast index. The corners are
 * returned exactly. Patches are immutable: every change returns a new one.
 */
export class Patch {
  /** @type {Float64Array} */
  #flat;
  /** @type {number} */
  #degreeU;
  /** @type {number} */
  #degreeV;

  /**
   * @param {NetLike} net (degreeU + 1)·(degreeV + 1) control points, u along the fast index: a flat list, or an array of
   *   degreeV + 1 rows; an array of numbers holds three for each point
   * @param {{ degreeU?: number, degreeV?: number }} [options] bicubic by default
   * @throws {RangeError} for a wrong count, a NaN or an infinity
   */
  constructor(net, options) {
    const { degreeU = 3, degreeV = 3 } = check.options(options, ["degreeU", "degreeV"]);
    this.#degreeU = check.whole(degreeU, "degreeU", 1, 64);
    this.#degreeV = check.whole(degreeV, "degreeV", 1, 64);
    const checked = /** @type {unknown} */ (net);
    this.#flat = checked instanceof CheckedPoints ? checked.flat : netNumbers(net, degreeU, degreeV);
  }

  /**
   * The bicubic patch of sixteen geometry points in another basis: each row and then each column is converted to the
   * Bézier basis.
   *
   *     const patch = Patch.fromBasis("b-spline", net);
   *
   * @param {BasisLike} basis
   * @param {NetLike} net row by row; in the Hermite basis, a row holds two points and two derivatives in u, and the
   *   last two rows are derivatives in v
   * @returns {Patch}
   */
  static fromBasis(basis, net) {
    const matrix = basisNumbers(basis);
    writeArguments(netNumbers(net, 3, 3), 16).set(matrix, 48);
    return patchOf(/** @type {any} */ (new CheckedPoints(readResult(0, core().patch_from_basis()), 3)), {});
  }

  /**
   * @param {PatchJSON} json what `toJSON` returned
   * @returns {Patch}
   */
  static fromJSON(json) {
    if (typeof json !== "object" || json === null) {
      throw new TypeError(`json: expected an object with net, got ${check.describe(json)}`);
    }
    return patchOf(json.net, { degreeU: json.degreeU, degreeV: json.degreeV });
  }

  /**
   * See `brand.js`.
   *
   * @internal
   * @returns {"patch"}
   */
  get casteljauType() {
    return "patch";
  }

  /** The degree in u. */
  get degreeU() {
    return this.#degreeU;
  }

  /** The degree in v. */
  get degreeV() {
    return this.#degreeV;
  }

  /**
   * @returns {Float64Array} a copy of the coordinates of the net
   */
  controlPoints() {
    return this.#flat.slice();
  }

  /**
   * Whether both have the same degrees and each control point lies within a distance of its counterpart.
   *
   * @param {Patch} other
   * @param {number} [tolerance]
   * @returns {boolean}
   */
  equals(other, tolerance = 0) {
    const o = asPatch(other);
    return this.#degreeU === o.#degreeU && samePoints(this.#flat, o.#flat, 3, tolerance);
  }

  /**
   * The point at (u, v), by de Casteljau's algorithm along u and then along v.
   *
   * @param {number} u
   * @param {number} v
   * @returns {Point}
   */
  eval(u, v) {
    core().patch_eval(...this.#writeAt(u, v));
    return pointAt(readResult(0, 3), 0, 3);
  }

  /**
   * The first and second partial derivatives at (u, v).
   *
   * @param {number} u
   * @param {number} v
   * @returns {Partials}
   */
  partials(u, v) {
    core().patch_partials(...this.#writeAt(u, v));
    const numbers = readResult(0, 15);
    const at = (/** @type {number} */ k) => pointAt(numbers, 3 * k, 3);
    return { u: at(0), v: at(1), uu: at(2), uv: at(3), vv: at(4) };
  }

  /**
   * The unit normal at (u, v) in the direction of ∂u × ∂v. At collapsed edges it is the limit; it is zero for a patch
   * that is a curve or a point.
   *
   * @param {number} u
   * @param {number} v
   * @returns {Point}
   */
  normal(u, v) {
    core().patch_normal(...this.#writeAt(u, v));
    return pointAt(readResult(0, 3), 0, 3);
  }

  /**
   * The curvatures at (u, v). Where ∂u × ∂v vanishes, as at a collapsed edge, they are the limits on the line from the
   * patch's middle, and zero if there is no limit (the tip of a cone, a patch that is a curve or a point).
   *
   * @param {number} u
   * @param {number} v
   * @returns {Curvature}
   */
  curvature(u, v) {
    core().patch_curvature(...this.#writeAt(u, v));
    const [gaussian, mean, k1, k2] = readResult(0, 4);
    return { gaussian, mean, k1, k2 };
  }

  /**
   * All intermediate points of de Casteljau's algorithm for S(u, v): rows, then a curve, then the point.
   *
   * @param {number} u
   * @param {number} v
   * @returns {PatchDeCasteljau}
   */
  deCasteljau(u, v) {
    return queries.deCasteljau(this.#flat, this.#degreeU + 1, check.finite(u, "u"), check.finite(v, "v"));
  }

  /**
   * The curve u = constant, which runs along v.
   *
   * @param {number} u
   * @returns {Curve}
   */
  isocurveAtU(u) {
    return this.#isocurve(true, check.finite(u, "u"));
  }

  /**
   * The curve v = constant, which runs along u.
   *
   * @param {number} v
   * @returns {Curve}
   */
  isocurveAtV(v) {
    return this.#isocurve(false, check.finite(v, "v"));
  }

  /**
   * Splits the patch at u into two.
   *
   * @param {number} u
   * @param {never[]} surplus
   * @returns {[Patch, Patch]}
   */
  splitU(u, ...surplus) {
    check.noSurplus(surplus, "splitU", 1, "split(u, v)");
    return this.#split(true, check.finite(u, "u"));
  }

  /**
   * Splits the patch at v into two.
   *
   * @param {number} v
   * @param {never[]} surplus
   * @returns {[Patch, Patch]}
   */
  splitV(v, ...surplus) {
    check.noSurplus(surplus, "splitV", 1, "split(u, v)");
    return this.#split(false, check.finite(v, "v"));
  }

  /**
   * Splits the patch at (u, v) into four: before both, after u, after v, after both.
   *
   * @param {number} u
   * @param {number} v
   * @returns {[Patch, Patch, Patch, Patch]}
   */
  split(u, v) {
    check.finite(u, "u");
    const [below, above] = this.splitV(v);
    return [...below.splitU(u), ...above.splitU(u)];
  }

  /**
   * The same patch with both degrees raised by one.
   *
   * @param {never[]} surplus
   * @returns {Patch}
   * @throws {RangeError} at degree 64
   */
  elevate(...surplus) {
    check.noSurplus(surplus, "elevate", 0);
    writeArguments(this.#flat);
    const net = /** @type {any} */ (
      new CheckedPoints(readResult(0, core().patch_elevate(this.#degreeU, this.#degreeV)), 3)
    );
    return patchOf(net, { degreeU: this.#degreeU + 1, degreeV: this.#degreeV + 1 });
  }

  /**
   * The smallest box that contains the patch, exact up to rounding. Each face of the box takes at most 2²³ steps (2²⁶
   * above degree 24), about one for each multiplication. If that is not enough, the face is at the best local extremum
   * found so far.
   *
   * @returns {{ min: Point, max: Point }}
   */
  bounds() {
    return /** @type {{ min: Point, max: Point }} */ (queries.bounds(this.#surfaceWriter()));
  }

  /**
   * The surface area with a relative error below 1e-8. Regions that the patch covers twice count twice; the area of a
   * patch that is a curve or a point is 0.
   *
   * It takes at most 2²² steps, about one for each two multiplications (some milliseconds). Where the patch folds back,
   * or has very different sizes along its axes, the result is the best estimate and its fifth digit may be wrong; where
   * coordinates differ by many powers of ten, the fourth.
   *
   * @returns {number}
   */
  area() {
    return queries.area(this.#surfaceWriter());
  }

  /**
   * An upper bound on the distance of the patch from the two triangles that join its corners, for either diagonal.
   *
   * @returns {number}
   */
  flatness() {
    writeArguments(this.#flat);
    return core().patch_flatness(this.#degreeU, this.#degreeV);
  }

  /**
   * The point of the patch that is nearest to p (the global minimum of the distance), edges and corners included.
   *
   * Two searches take at most 2²³ steps each (2²⁶ above degree 24), about one for each multiplication. The first uses
   * the square of the distance. The second uses the distance itself and runs where the distance is below 2⁻¹⁶ of the
   * size (2⁻⁴ if the first search reaches its limit). If a search reaches its limit, as where a whole curve of the
   * patch is nearest, the result is the nearest point found so far, a local minimum of the distance.
   *
   * @param {PointLike} p
   * @returns {PatchPoint}
   */
  nearest(p) {
    return queries.withoutPatch(/** @type {any} */ (queries.nearest(this.#surfaceWriter(), p)));
  }

  /**
   * All intersections with a ray, sorted by distance. `distance` is that of the point from the origin, independent of
   * the length of `direction`. Where the ray is tangent to the patch, and at a collapsed edge, there is one
   * intersection. For a ray that lies in the patch, they are its crossings of the edges, and the origin if it is on the
   * patch.
   *
   * @param {PointLike} origin
   * @param {PointLike} direction
   * @returns {PatchPoint[]}
   * @throws {RangeError} for a direction of length 0, and if the search takes more than 2²⁷ steps, about one for each
   *   multiplication
   */
  intersectRay(origin, direction) {
    return queries.intersectRay(this.#surfaceWriter(), origin, direction).map(queries.withoutPatch);
  }

  /**
   * The patch transformed by an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Patch}
   */
  transform(matrix) {
    writeArguments(this.#flat, 12).set(check.affine(matrix), this.#flat.length);
    core().points_transform(3, this.#flat.length / 3);
    return this.#withNet(readResult(0, this.#flat.length));
  }

  /**
   * The patch with one control point moved.
   *
   * @param {number} index
   * @param {PointLike} to
   * @returns {Patch}
   */
  movePoint(index, to) {
    check.whole(index, "index", 0, this.#flat.length / 3 - 1);
    const flat = this.#flat.slice();
    writePoint(flat, 3 * index, to, 3, "to");
    return this.#withNet(flat);
  }

  /**
   * A mesh of one grid of samples of the patch.
   *
   * @param {GridOptions} options
   * @returns {Mesh}
   */
  grid(options) {
    const checked = gridOptions(options);
    const { u, v, quads, differences } = checked;
    writeArguments(this.#flat);
    unwrapCount(core().patch_grid(this.#degreeU, this.#degreeV, u, v, quads, differences));
    return readGrid(1, checked);
  }

  /**
   * A mesh of the patch; see `Surface.tessellate`. Here `weld` is "none" by default, so that the mesh has uvs.
   *
   * @param {TessellationOptions} options
   * @returns {Mesh}
   */
  tessellate(options) {
    const { args, extra, into, ...kind } = tessellation(options, "none");
    writeArguments(this.#flat, extra.length).set(extra, this.#flat.length);
    unwrapCount(core().patch_tessellate(this.#degreeU, this.#degreeV, ...args));
    return readMesh(into, kind);
  }

  /**
   * @returns {{ net: number[][], degreeU: number, degreeV: number }}
   */
  toJSON() {
    return { net: nested(this.#flat, 3), degreeU: this.#degreeU, degreeV: this.#degreeV };
  }

  /**
   * Writes the net to the arena.
   *
   * @param {number} u
   * @param {number} v
   * @returns {[number, number, number, number]} the arguments of the core's functions of (u, v)
   */
  #writeAt(u, v) {
    check.finite(u, "u");
    check.finite(v, "v");
    writeArguments(this.#flat);
    return [this.#degreeU, this.#degreeV, u, v];
  }

  #surfaceWriter() {
    return queries.patchWriter(this.#flat, this.#degreeU, this.#degreeV);
  }

  /**
   * @param {boolean} constantU
   * @param {number} at
   */
  #isocurve(constantU, at) {
    writeArguments(this.#flat);
    const length = core().patch_isocurve(this.#degreeU, this.#degreeV, constantU, at);
    return curveOf(new CheckedPoints(readResult(0, length), 3));
  }

  /**
   * @param {boolean} alongU
   * @param {number} at
   * @returns {[Patch, Patch]}
   */
  #split(alongU, at) {
    writeArguments(this.#flat);
    core().patch_split(this.#degreeU, this.#degreeV, alongU, at);
    const n = this.#flat.length;
    return [this.#withNet(readResult(0, n)), this.#withNet(readResult(n, 2 * n))];
  }

  /** @param {Float64Array} flat */
  #withNet(flat) {
    const net = /** @type {any} */ (new CheckedPoints(flat, 3));
    return patchOf(net, { degreeU: this.#degreeU, degreeV: this.#degreeV });
  }
}

// Outside of the class, see curve.js.

/**
 * @param {NetLike} net
 * @param {{ degreeU?: number, degreeV?: number }} degrees
 */
function patchOf(net, degrees) {
  return new Patch(net, degrees);
}

/** @param {unknown} other */
function asPatch(other) {
  return check.instanceOf(other, "other", Patch, "a Patch");
}
