// Operations on the region that the outline fills: each takes an outline and returns another one.
import { Path } from "casteljau";
import { contourOf, countPoints, MAX_POINTS, pathOf } from "./outline.js";

/** @typedef {import("./outline.js").Outline} Outline */

/** The boundary of a stroke or an offset is this close to the exact one, in units of the em. */
const TOLERANCE = 0.25;

/**
 * @param {Path} path
 * @returns {Outline}
 * @throws {RangeError} for too many points
 */
function outlineOf(path) {
  const outline = path.subpaths.map(contourOf);
  const { all } = countPoints(outline);
  if (all > MAX_POINTS) throw new RangeError(`expected at most ${MAX_POINTS} points, got ${all}`);
  return outline;
}

/**
 * The union of the regions inside the contours, whatever their directions: holes are filled.
 *
 * @param {Outline} outline
 */
export const unionOfContours = (outline) =>
  outlineOf(
    Path.combine(
      outline.map(({ spline }) => new Path([spline])),
      "union",
    ),
  );

/**
 * Whether contours overlap each other or themselves, so that fewer or other ones bound the same region.
 *
 * @param {Outline} outline
 */
export function hasOverlaps(outline) {
  const segments = (/** @type {Path} */ { subpaths }) =>
    subpaths.reduce((sum, { segmentCount }) => sum + segmentCount, 0);
  const path = pathOf(outline);
  const result = path.removeOverlaps();
  return result.subpathCount !== path.subpathCount || segments(result) !== segments(path);
}

/** The same filled region with contours that do not overlap. @param {Outline} outline */
export const removeOverlaps = (outline) => outlineOf(pathOf(outline).removeOverlaps());

/** The region of a stroke along the outline. @param {Outline} outline @param {number} width */
export const outlineStroke = (outline, width) => outlineOf(pathOf(outline).stroke(width, { tolerance: TOLERANCE }));

/** The filled region grown, or shrunk by a negative distance. @param {Outline} outline @param {number} distance */
export const offset = (outline, distance) => outlineOf(pathOf(outline).offset(distance, { tolerance: TOLERANCE }));
