// casteljau/elements/coordinates: defines `<bezier-coordinates>`.
import { BezierCoordinates as Coordinates } from "../companions/coordinates.js";
import { define } from "./define.js";

/** @import { BezierCoordinatesConstructor } from "../companions/types.js" */
/** @typedef {import("../companions/types.js").BezierCoordinatesElement} BezierCoordinatesElement */

/** The class of `<bezier-coordinates>`. */
export const BezierCoordinates = /** @type {BezierCoordinatesConstructor} */ (
  define("bezier-coordinates", Coordinates)
);
