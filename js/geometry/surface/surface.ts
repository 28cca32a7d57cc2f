import { curveOf } from "../curve/curve.js";
import { patchOf } from "../patch/patch.js";
import { CoreSurface, surfaceFrom } from "./core-surface.js";
import { joinedOf, parsedNetwork } from "./network.js";
import { networkOfJSON } from "../surface-network.js";
import type { Curve } from "../curve/curve.js";
import type { Patch } from "../patch/patch.js";
import type { Network } from "../brand.js";
import type { SurfaceJSON } from "../surface-network.js";

/**
 * A network of Bézier patches that share control points.
 *
 *     const mesh = Surface.teapot().grid({ segments: 16 });
 */
export class Surface extends CoreSurface<Patch, Curve<3>> {
  /**
   * Parses the text of a surface. There are four formats, which differ in their first rows:
   *
   * - the format of `toText`;
   * - .bpt: the number of patches; for each patch a row with its degrees, followed by its points, one per row, u along
   *   the fast index. Points with equal coordinates become one vertex;
   * - the listing in which the teapot was published: the number of patches, for each a row of 16 vertex numbers from 1;
   *   the number of vertices, for each a row x y z. Bicubic;
   * - arrays of C source code, in which many programs carry the teapot: an array whose rows are 3 coordinates in braces,
   *   and an array whose rows are 16 vertex numbers in braces, in either order. The numbers are from 0 if 0 occurs,
   *   otherwise from 1. Declarations around the arrays and the comments of C are skipped. Bicubic; the vertices keep
   *   their order.
   *
   * In the other three formats a row is a line; spaces, tabs or commas separate its words. Empty lines and comments, from `#` to the end of the
   * line, are ignored. The time is proportional to the length of the text; counts are checked against that length
   * first.
   *
   * @param text the text in one of the four formats
   * @throws {RangeError} for a syntax error, with the line number, what was expected and what the text contains
   */
  static parse(text: string): Surface {
    return surfaceOf(parsedNetwork(text));
  }

  /**
   * The surface that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: SurfaceJSON): Surface {
    return surfaceOf(networkOfJSON(json, joinedOf));
  }

  /**
   * A curve of the full class.
   *
   * @internal
   */
  override _curveOf(flat: Float64Array): Curve<3> {
    return curveOf({ flat, dimension: 3 }) as Curve<3>;
  }

  /**
   * A patch of the full class.
   *
   * @internal
   */
  override _patchOf(flat: Float64Array, degreeU: number, degreeV: number): Patch {
    return patchOf(flat, degreeU, degreeV);
  }

  /**
   * A surface of the full class.
   *
   * @internal
   */
  override _surfaceOf(network: Network): this {
    return surfaceOf(network) as this;
  }
}

function surfaceOf(network: Network): Surface {
  return surfaceFrom(Surface, network); // outside of the class, see curve.js
}
