import * as check from "../check.js";
import { PathMeasures } from "./path-measures.js";
import * as regions from "./path-boolean.js";

/**
 * @import { Moments, RegionOptions } from "./path-measures.js"
 * @import { PathValue } from "./path-value.js"
 */

/** Operations on the region that a path fills. */
export class PathRegions extends PathMeasures {
  /**
   * The union of two regions: the points inside this path, inside the other one, or both.
   *
   *     Path.circle([0, 0], 1).union(Path.circle([1, 0], 1));
   *
   * Open subpaths are closed by lines. The contours of the result are simple and do not cross: winding numbers are 0
   * and 1, so that both fill rules agree. Outer contours run counter-clockwise (x right, y up; clockwise on a canvas),
   * holes clockwise; each outer contour is followed by its holes. Segments that nothing else touches are returned bit
   * for bit, reversed where the direction requires it. The boundary lies within 1e-9 of the size from the exact one;
   * outlines that are closer than that count as one.
   *
   * @param {PathValue} other
   * @param {RegionOptions} [options]
   * @returns {this}
   * @throws {RangeError} for more segments or intersections than the limit
   */
  union(other, options) {
    return this._pathOf(regions.combineTwo(this._packed, other, "union", options));
  }

  /**
   * The intersection of two regions: the points inside both paths. See `union`.
   *
   * @param {PathValue} other
   * @param {RegionOptions} [options]
   * @returns {this}
   */
  intersect(other, options) {
    return this._pathOf(regions.combineTwo(this._packed, other, "intersect", options));
  }

  /**
   * The difference of two regions: the points inside this path and outside of the other one. See `union`.
   *
   * @param {PathValue} other
   * @param {RegionOptions} [options]
   * @returns {this}
   */
  subtract(other, options) {
    return this._pathOf(regions.subtract(this._packed, other, options));
  }

  /**
   * The symmetric difference of two regions: the points inside exactly one of the paths. See `union`.
   *
   * @param {PathValue} other
   * @param {RegionOptions} [options]
   * @returns {this}
   */
  exclude(other, options) {
    return this._pathOf(regions.combineTwo(this._packed, other, "exclude", options));
  }

  /**
   * The region that the path fills, with simple contours. See `union`.
   *
   * @param {RegionOptions} [options]
   * @returns {this}
   */
  removeOverlaps(options) {
    return this._pathOf(regions.removeOverlaps(this._packed, options));
  }

  /**
   * The parts into which another path divides the region: one path for each, with its holes. The other path is not
   * filled; its open subpaths stay open. A part of it that ends inside the region divides nothing.
   *
   * @param {PathValue} other
   * @param {RegionOptions} [options]
   * @returns {this[]}
   */
  divide(other, options) {
    return regions.divide(this._packed, other, options).map((packed) => this._pathOf(packed));
  }

  /**
   * The parts of this path inside a region. This path is not filled: its open subpaths stay open, and closed ones that
   * leave the region become open pieces. See `union`.
   *
   * @param {PathValue} region
   * @param {RegionOptions} [options] how `region` is filled
   * @returns {this}
   */
  clip(region, options) {
    return this._pathOf(regions.clip(this._packed, region, options));
  }

  /**
   * The signed area inside, positive for counter-clockwise subpaths (x right, y up), ½∮ x dy − y dx: each point counts
   * with its winding number. With a fill rule, the area of the region that the path fills, which is never negative. Open
   * subpaths are closed by a line.
   *
   *     const twice = Path.fromSVG("M0 0H1V1H0Z M0 0H1V1H0Z");
   *     twice.area(); // 2
   *     twice.area({ fillRule: "nonzero" }); // 1
   *
   * @override
   * @param {RegionOptions} [options]
   * @returns {number}
   */
  area(options) {
    return hasFillRule(options) ? this.removeOverlaps(options).area() : super.area();
  }

  /**
   * The integrals of 1, x, y, x², xy and y² over the inside, weighted as in `area`; the centre of mass is (x, y) /
   * area. With a fill rule, over the region that the path fills.
   *
   * @override
   * @param {RegionOptions} [options]
   * @returns {Moments}
   */
  moments(options) {
    return hasFillRule(options) ? this.removeOverlaps(options).moments() : super.moments();
  }
}

/** @param {RegionOptions | undefined} options */
function hasFillRule(options) {
  return check.options(options, ["fillRule"]).fillRule !== undefined;
}
