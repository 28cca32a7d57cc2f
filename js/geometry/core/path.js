import { CorePath, packedFrom, packedFromJSON, pathFrom } from "../path/core-path.js";

/**
 * @import { Shape } from "../path/core-path.js"
 * @import { SplineJSON } from "../spline/spline-value.js"
 */

/**
 * A list of 2D splines, open or closed: outlines with holes, icons, anything that SVG path data can describe. It may be
 * empty.
 *
 *     const ring = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
 *     ring.contains([0.5, 2]); // true
 *     ring.length(); // 24
 */
export class Path extends CorePath {
  /**
   * The path that `toJSON` described.
   *
   * @param {{ subpaths: SplineJSON[] }} json what `toJSON` returned
   * @returns {Path}
   */
  static fromJSON(json) {
    return pathOf(packedFromJSON(json));
  }

  /**
   * The path of a curve, a spline, a path, or an array of these; the subpaths of paths are copied.
   *
   * @param {Shape | ArrayLike<Shape>} shapes curves, splines and paths in the plane
   * @param {never[]} surplus
   * @returns {Path}
   * @throws {TypeError} for other values, and for 3D ones
   */
  static from(shapes, ...surplus) {
    return pathOf(packedFrom(shapes, surplus));
  }

  /**
   * @internal
   * @override
   * @param {Float64Array} packed
   * @returns {this}
   */
  _pathOf(packed) {
    return /** @type {this} */ (pathOf(packed));
  }
}

/**
 * @param {Float64Array} packed
 * @returns {Path}
 */
function pathOf(packed) {
  return pathFrom(Path, packed); // outside of the class, see ../curve/curve.js
}
