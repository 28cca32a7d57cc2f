// The libraries that are asked, in the order of the tables.

/**
 * @typedef {{ name: string, packageName: string, claims: string }} Library
 *   claims: the curves that it takes, and how it is asked where that matters
 */

/** @type {Library[]} */
export const LIBRARIES = [
  {
    name: "casteljau",
    packageName: "casteljau",
    claims: "Curves of any degree, rational curves, paths. The tolerance of offsets is a tenth of that of the fact.",
  },
  {
    name: "bezier-js",
    packageName: "bezier-js",
    claims:
      "Quadratic and cubic curves. Intersections with a threshold of a millionth of the largest coordinate, with which it finds more of them than with its own. Its extrema also contain the zeros of the second derivative.",
  },
  {
    name: "paper.js",
    packageName: "paper",
    claims: "Cubic curves in the plane. Lines and quadratic curves are raised to cubics before it is asked.",
  },
  {
    name: "svg-path-properties",
    packageName: "svg-path-properties",
    claims: "Lengths of SVG paths, and points at a length.",
  },
  {
    name: "verb",
    packageName: "verb-nurbs",
    claims:
      "NURBS curves. Intersections with a tolerance of 10⁻⁶, with which it finds more of them than with smaller or larger ones; tangents are brought to the length 1.",
  },
];
