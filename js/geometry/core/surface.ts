import { curveOf } from "./curve.js";
import { patchOf } from "./patch.js";
import { CoreSurface } from "../surface/core-surface.js";
import { CheckedNetwork, joinedOf, parsedNetwork, teapotNetwork, teasetNetwork } from "../surface/network.js";
import { networkOfJSON, networkOfPatches } from "../surface-network.js";
import { CheckedPoints } from "../../wasm/transfer.js";
import type { Curve } from "./curve.js";
import type { Patch } from "./patch.js";
import type { Network, TeapotOptions } from "../surface/network.js";
import type { CorePatch } from "../patch/core-patch.js";
import type { SurfaceJSON } from "../surface-network.js";

/**
 * A network of Bézier patches that share control points.
 *
 *     const mesh = Surface.teapot().grid({ segments: 16 });
 */
export class Surface extends CoreSurface<Patch, Curve<3>> {
  /** The Utah teapot: 32 patches; rim 0–3, body 4–11, handle 12–15, spout 16–19, lid 20–27, bottom 28–31. */
  static teapot(options?: TeapotOptions): Surface {
    return surfaceOf(teapotNetwork(options));
  }

  /**
   * Newell's teacup on its saucer: 26 patches; rim 0–3, outside 4–7, inside 8–11, handle 12–13, saucer 14–25. 46 pairs
   * of its edges are shared and 12 edges are open: the bottoms of cup and saucer and the ends of the handle.
   *
   * @param options the axis that points up, "z" by default; "y" gives the axes of the original data
   */
  static teacup(options?: { up?: "z" | "y" }): Surface {
    return surfaceOf(teasetNetwork(false, options));
  }

  /**
   * Newell's teaspoon: 16 patches, lying with its bowl open upwards and its handle along −y. As in the original data,
   * the end of the bowl and the tip have small gaps: 28 pairs of edges are shared and 8 edges are open.
   *
   * @param options the axis that points up, "z" by default
   */
  static teaspoon(options?: { up?: "z" | "y" }): Surface {
    return surfaceOf(teasetNetwork(true, options));
  }

  /**
   * Parses the text of a surface. There are four formats, which differ in their first rows:
   *
   * - the format of `toText`;
   * - .bpt: the number of patches; for each patch a row with its degrees, followed by its points, one per row, u along
   *   the fast index. Points with equal coordinates become one vertex;
   * - the listing in which the teapot was published: the number of patches, for each a row of 16 vertex numbers from 1;
   *   the number of vertices, for each a row x y z. Bicubic;
   * - arrays of C source code: rows of 3 coordinates in braces, and rows of 16 vertex numbers in braces, in either order.
   *   The numbers are from 0 if 0 occurs, otherwise from 1. Bicubic; the vertices keep their order.
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
   * The surface of patches, which may differ in their degrees. Control points at the same position become one vertex,
   * so neighbours that have the same points along an edge are joined there. The order of the patches is kept.
   *
   * @param patches patches of any degrees
   */
  static fromPatches(patches: readonly CorePatch[]): Surface {
    return surfaceOf(networkOfPatches(patches, joinedOf));
  }

  /**
   * @param json what `toJSON` returned
   */
  static fromJSON(json: SurfaceJSON): Surface {
    return surfaceOf(networkOfJSON(json, joinedOf));
  }

  /**
   * @internal
   */
  override _curveOf(flat: Float64Array): Curve<3> {
    return curveOf(new CheckedPoints(flat, 3)) as Curve<3>;
  }

  /**
   * @internal
   */
  override _patchOf(flat: Float64Array, degreeU: number, degreeV: number): Patch {
    return patchOf(flat, degreeU, degreeV);
  }

  /**
   * @internal
   */
  override _surfaceOf(network: Network): this {
    return surfaceOf(network) as this;
  }
}

function surfaceOf(network: Network): Surface {
  return new Surface(new CheckedNetwork(network) as any); // outside of the class, see curve.js
}
