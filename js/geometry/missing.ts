/**
 * The methods that only the curves of `casteljau` have.
 *
 * @internal
 */
export const CURVE_METHODS =
  "torsion frames extrema timesAtCoordinate inflections cusps classify tangentsFrom toBasis reduce offset intersections selfIntersections distanceTo hausdorff " +
  "toThree";

/**
 * The static methods that only its curves have.
 *
 * @internal
 */
export const CURVE_STATICS = "interpolate fromBasis basisMatrix";

/**
 * The methods that only the splines of `casteljau` have.
 *
 * @internal
 */
export const SPLINE_METHODS =
  "torsion frames extrema timesAtCoordinate intersections selfIntersections simplify offset toBSpline toThree";

/**
 * The static methods that only its splines have.
 *
 * @internal
 */
export const SPLINE_STATICS = "interpolate fromBSpline fit";

/**
 * Gives a class of a small entry point the methods that only the class of `casteljau` has; they throw an error that says so.
 *
 * @internal
 * @param name of the class
 * @param entry the entry point that lacks them
 * @param methods their names, separated by blanks
 * @param statics the names of static methods
 */
export function explainMissing(
  Class: { prototype: object },
  name: string,
  entry: string,
  methods: string,
  statics: string,
) {
  const explain = (target: object, method: string) => {
    const value = () => {
      throw new TypeError(`${name}.${method} is in "casteljau", not in "${entry}"`);
    };
    Object.defineProperty(target, method, { value, configurable: true });
  };
  for (const method of methods.split(" ")) explain(Class.prototype, method);
  for (const method of statics.split(" ")) explain(Class, method);
}
