// What the element needs for surfaces with weights, and not before; a file of its own in the bundle.
import { NurbsSurface, RationalSurface } from "../../nurbs.js";
import type { GridOptions, PointLike, Surface } from "../../surfaces.js";
import type { RationalModel } from "./settings.js";

const { grid, movePoint } = RationalSurface.prototype;

/** Gives a surface of the element's own the methods of `Surface` that the element calls. */
function withMethods(surface: RationalSurface): Surface {
  const methods = {
    nearest: () => null,
    ...("nearest" in surface ? { nearest: surface.nearest } : {}),
    /** Grids have one method. */
    grid: ({ method: _, ...options }: GridOptions) => grid.call(surface, options),
    movePoint: (index: number, to: PointLike) => withMethods(movePoint.call(surface, index, to)),
    subdivide() {
      throw new RangeError("flatness: expected a surface without weights; use segments, tolerance or pixels");
    },
  };
  return Object.assign(surface, methods) as unknown as Surface;
}

/** A copy of a surface of any entry point, as the element shows it. */
export const shownSurface = (surface: RationalSurface): Surface =>
  withMethods(RationalSurface.fromJSON(surface.toJSON()));

/** The surface in a text; see `RationalSurface.parse`. */
export const parsedSurface = (text: string): Surface => withMethods(RationalSurface.parse(text));

const ORIGIN = [0, 0, 0];

/** As large as the patch of the element. */
const BODIES: Record<RationalModel, (options: { axis: number[] }) => NurbsSurface> = {
  sphere: (options) => NurbsSurface.sphere(ORIGIN, 2, options),
  torus: (options) => NurbsSurface.torus(ORIGIN, 1.5, 0.5, options),
  cylinder: (options) => NurbsSurface.cylinder(ORIGIN, 1.5, 3, options),
  cone: (options) => NurbsSurface.cone(ORIGIN, 1.5, 3, options),
};

/** The surface of a model. */
export const rationalModel = (model: RationalModel, up: "z" | "y"): Surface =>
  withMethods(BODIES[model]({ axis: up === "z" ? [0, 0, 1] : [0, 1, 0] }).toSurface());
