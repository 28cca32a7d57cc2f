import { basisNumbers } from "./basis.js";
import * as check from "./check.js";
import { Curve } from "./curve.js";
import { takeGrid } from "./grid-mesh.js";
import { flatten, nested, pointAt, samePoints, writePoint } from "./points.js";
import { gridOptions, takeMesh } from "./mesh.js";
import * as queries from "./surface-queries.js";
import { core, done, load, take } from "../wasm/surfaces-transfer.js";
import { tessellation } from "./tessellation.js";
import { Checked } from "../wasm/transfer.js";

/**
 * @import { BasisLike } from "./basis.js"
 * @import { MatrixLike, PointLike, PointsLike } from "./check.js"
 * @import { GridOptions, Mesh } from "./mesh.js"
 * @import { Point } from "./points.js"
 * @import { Curvature, PatchPoint, PatchDeCasteljau } from "./surface-queries.js"
 * @import { TessellationOptions } from "./tessellation.js"
 */

/**
 * The partial derivatives of a patch.
 *
 * @typedef {{ u: Point, v: Point, uu: Point, uv: Point, vv: Point }} Partials
 */

/**
 * One tensor-product Bézier patch of degrees 1 to 64, in space.
 *
 * S(u, v) = Σ Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with the net index j·(degreeU + 1) + i: u runs along the fast index. The corners come back
 * exactly. A patch is a value: every change returns a new one.
 */
export class Patch {
  /** @type {Float64Array} */
  #flat;
  /** @type {number} */
  #degreeU;
  /** @type {number} */
  #degreeV;

  /**
   * @param {PointsLike} net (degreeU + 1)·(degreeV + 1) control points; a flat array holds three numbers each
   * @param {{ degreeU?: number, degreeV?: number }} [options] bicubic by default
   * @throws {RangeError} for a wrong count, a NaN or an infinity
   */
  constructor(net, options) {
    const { degreeU = 3, degreeV = 3 } = check.options(options);
    this.#degreeU = check.whole(degreeU, "degreeU", 1, 64);
    this.#degreeV = check.whole(degreeV, "degreeV", 1, 64);
    const inside = /** @type {unknown} */ (net);
    this.#flat = inside instanceof Checked ? inside.flat : flatten(net, 3, 3, "net").flat;
    const [count, needed] = [this.#flat.length / 3, (degreeU + 1) * (degreeV + 1)];
    if (count !== needed) {
      throw new RangeError(`net: expected ${needed} control points (degrees ${degreeU} × ${degreeV}), got ${count}`);
    }
  }

  /**
   * The bicubic patch of sixteen geometry points in another basis, which each row and then each column is taken from.
   *
   *     const patch = Patch.fromBasis("b-spline", net);
   *
   * @param {BasisLike} basis
   * @param {PointsLike} net row by row; with "hermite" a row is two points and two derivatives in u, and the last two rows
   *   are derivatives in v
   * @returns {Patch}
   */
  static fromBasis(basis, net) {
    const matrix = basisNumbers(basis);
    const { flat } = flatten(net, 3, 3, "net");
    if (flat.length !== 48) throw new RangeError(`net: expected 16 points, got ${flat.length / 3}`);
    load(flat, 16).set(matrix, 48);
    return patchOf(/** @type {any} */ (new Checked(take(0, core().patch_from_basis()), 3)), {});
  }

  /**
   * @param {{ net: PointsLike, degreeU?: number, degreeV?: number }} json what `toJSON` gave
   * @returns {Patch}
   */
  static fromJSON(json) {
    if (typeof json !== "object" || json === null) {
      throw new TypeError(`json: expected an object with net, got ${check.shown(json)}`);
    }
    return patchOf(json.net, { degreeU: json.degreeU, degreeV: json.degreeV });
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
   * @returns {Float64Array} the coordinates of the net, a copy
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
    core().patch_eval(...this.#at(u, v));
    return pointAt(take(0, 3), 0, 3);
  }

  /**
   * The first and second partial derivatives at (u, v).
   *
   * @param {number} u
   * @param {number} v
   * @returns {Partials}
   */
  partials(u, v) {
    core().patch_partials(...this.#at(u, v));
    const numbers = take(0, 15);
    const at = (/** @type {number} */ k) => pointAt(numbers, 3 * k, 3);
    return { u: at(0), v: at(1), uu: at(2), uv: at(3), vv: at(4) };
  }

  /**
   * The unit normal at (u, v), along ∂u × ∂v; at collapsed sides its limit, zero for a patch that is a curve or a point.
   *
   * @param {number} u
   * @param {number} v
   * @returns {Point}
   */
  normal(u, v) {
    core().patch_normal(...this.#at(u, v));
    return pointAt(take(0, 3), 0, 3);
  }

  /**
   * The curvatures at (u, v). Where ∂u × ∂v vanishes, as at a collapsed side, the limits from the patch's middle; zeros
   * where there are none (the tip of a cone, a patch that is a curve or a point).
   *
   * @param {number} u
   * @param {number} v
   * @returns {Curvature}
   */
  curvature(u, v) {
    core().patch_curvature(...this.#at(u, v));
    const [gaussian, mean, k1, k2] = take(0, 4);
    return { gaussian, mean, k1, k2 };
  }

  /**
   * Everything that de Casteljau's algorithm passes through on its way to the point: rows, then a curve, then the point.
   *
   * @param {number} u
   * @param {number} v
   * @returns {PatchDeCasteljau}
   */
  deCasteljau(u, v) {
    return queries.deCasteljau(this.#flat, this.#degreeU + 1, check.finite(u, "u"), check.finite(v, "v"));
  }

  /**
   * The curve of constant u: it runs along v.
   *
   * @param {number} u
   * @returns {Curve}
   */
  isocurveAtU(u) {
    return this.#isocurve(true, check.finite(u, "u"));
  }

  /**
   * The curve of constant v: it runs along u.
   *
   * @param {number} v
   * @returns {Curve}
   */
  isocurveAtV(v) {
    return this.#isocurve(false, check.finite(v, "v"));
  }

  /**
   * The pieces before and after u.
   *
   * @param {number} u
   * @returns {[Patch, Patch]}
   */
  splitU(u) {
    return this.#split(true, check.finite(u, "u"));
  }

  /**
   * The pieces before and after v.
   *
   * @param {number} v
   * @returns {[Patch, Patch]}
   */
  splitV(v) {
    return this.#split(false, check.finite(v, "v"));
  }

  /**
   * The four pieces about (u, v): (u−, v−), (u+, v−), (u−, v+), (u+, v+).
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
   * The same patch with degrees one higher.
   *
   * @returns {Patch}
   * @throws {RangeError} at degree 64
   */
  elevate() {
    load(this.#flat);
    const net = /** @type {any} */ (new Checked(take(0, core().patch_elevate(this.#degreeU, this.#degreeV)), 3));
    return patchOf(net, { degreeU: this.#degreeU + 1, degreeV: this.#degreeV + 1 });
  }

  /**
   * The smallest box that contains the patch, exact to rounding. Each of its faces takes at most 2²³ steps (2²⁶ above
   * degree 24), about one for each multiplication; where that is not enough, the face is at the best local extremum found
   * by then.
   *
   * @returns {{ min: Point, max: Point }}
   */
  bounds() {
    return /** @type {{ min: Point, max: Point }} */ (queries.bounds(this.#asSurface()));
  }

  /**
   * The area, within 1e-8 of itself; what the patch covers twice counts twice, a curve or a point is 0.
   *
   * At most 2²² steps, about one for each two multiplications (some milliseconds). Where the patch folds back, or has very
   * different sizes along its axes, the result is the best estimate and the fifth digit may be off; where coordinates differ
   * by many powers of ten, the fourth.
   *
   * @returns {number}
   */
  area() {
    return queries.area(this.#asSurface());
  }

  /**
   * A bound on the distance of the patch from the two triangles that join its corners, whichever diagonal they share.
   *
   * @returns {number}
   */
  flatness() {
    load(this.#flat);
    return core().patch_flatness(this.#degreeU, this.#degreeV);
  }

  /**
   * The point of the patch that is nearest to p, of all of it, sides and corners included.
   *
   * Two searches, by the square of the distance and, where it is below 2⁻¹⁶ of the size (2⁻⁴ if the first search reaches
   * its limit), by the distance itself, take at most 2²³ steps each (2²⁶ above degree 24), about one for each
   * multiplication. Where that is not enough, as where a whole curve of the patch is nearest, the point is the nearest
   * one found by then, at a local minimum of the distance.
   *
   * @param {PointLike} p
   * @returns {PatchPoint}
   */
  nearest(p) {
    return queries.onPatch(/** @type {any} */ (queries.nearest(this.#asSurface(), p)));
  }

  /**
   * All hits of a ray, by distance. `distance` is that of the point from the origin, however long `direction` is. Where
   * the ray touches the patch, and at a side that is a point, there is one hit; of a ray that runs within the patch those
   * are given where it crosses the sides, and the origin if it is on the patch.
   *
   * @param {PointLike} origin
   * @param {PointLike} direction
   * @returns {PatchPoint[]}
   * @throws {RangeError} for a direction of length 0, and when the search takes more than 2²⁷ steps, about one for each
   *   multiplication
   */
  intersectRay(origin, direction) {
    return queries.intersectRay(this.#asSurface(), origin, direction).map(queries.onPatch);
  }

  /**
   * The image under an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Patch}
   */
  transform(matrix) {
    load(this.#flat, 12).set(check.affine(matrix), this.#flat.length);
    core().points_transform(3, this.#flat.length / 3);
    return this.#like(take(0, this.#flat.length));
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
    return this.#like(flat);
  }

  /**
   * A mesh of one grid over the patch.
   *
   * @param {GridOptions} options
   * @returns {Mesh}
   */
  grid(options) {
    const wanted = gridOptions(options);
    const { u, v, quads, differences } = wanted;
    load(this.#flat);
    done(core().patch_grid(this.#degreeU, this.#degreeV, u, v, quads, differences));
    return takeGrid(1, wanted);
  }

  /**
   * A mesh of the patch; see `Surface.tessellate`.
   *
   * @param {TessellationOptions} options
   * @returns {Mesh}
   */
  tessellate(options) {
    const { args, extra, into, ...kind } = tessellation(options);
    load(this.#flat, extra.length).set(extra, this.#flat.length);
    done(core().patch_tessellate(this.#degreeU, this.#degreeV, ...args));
    return takeMesh(into, kind);
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
   * @returns {[number, number, number, number]} what the core's functions of (u, v) take
   */
  #at(u, v) {
    check.finite(u, "u");
    check.finite(v, "v");
    load(this.#flat);
    return [this.#degreeU, this.#degreeV, u, v];
  }

  #asSurface() {
    return queries.patchLoader(this.#flat, this.#degreeU, this.#degreeV);
  }

  /**
   * @param {boolean} constantU
   * @param {number} at
   */
  #isocurve(constantU, at) {
    load(this.#flat);
    const length = core().patch_isocurve(this.#degreeU, this.#degreeV, constantU, at);
    return new Curve(/** @type {any} */ (new Checked(take(0, length), 3)));
  }

  /**
   * @param {boolean} alongU
   * @param {number} at
   * @returns {[Patch, Patch]}
   */
  #split(alongU, at) {
    load(this.#flat);
    core().patch_split(this.#degreeU, this.#degreeV, alongU, at);
    const n = this.#flat.length;
    return [this.#like(take(0, n)), this.#like(take(n, 2 * n))];
  }

  /** @param {Float64Array} flat */
  #like(flat) {
    const net = /** @type {any} */ (new Checked(flat, 3));
    return patchOf(net, { degreeU: this.#degreeU, degreeV: this.#degreeV });
  }
}

// Outside of the class, see curve.js.

/**
 * @param {PointsLike} net
 * @param {{ degreeU?: number, degreeV?: number }} degrees
 */
function patchOf(net, degrees) {
  return new Patch(net, degrees);
}

/** @param {unknown} other */
function asPatch(other) {
  return check.instanceOf(other, "other", Patch);
}
