import { CorePath, packedFrom, packedFromJSON, pathFrom } from "../path/core-path.js";
import type { Shape } from "../path/core-path.js";
import type { SplineJSON } from "../spline/core-spline.js";

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
   * @param json what `toJSON` returned
   */
  static fromJSON(json: { subpaths: SplineJSON[] }): Path {
    return pathOf(packedFromJSON(json));
  }

  /**
   * The path of a curve, a spline, a path, or an array of these; the subpaths of paths are copied.
   *
   * @param shapes curves, splines and paths in the plane
   * @throws {TypeError} for other values, and for 3D ones
   */
  static from(shapes: Shape | ArrayLike<Shape>, ...surplus: never[]): Path {
    return pathOf(packedFrom(shapes, surplus));
  }

  /**
   * @internal
   */
  override _pathOf(packed: Float64Array): this {
    return pathOf(packed) as this;
  }
}

function pathOf(packed: Float64Array): Path {
  return pathFrom(Path, packed); // outside of the class, see ../curve/curve.js
}
