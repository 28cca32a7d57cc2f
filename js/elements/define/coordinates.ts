// casteljau/elements/coordinates: defines `<bezier-coordinates>`.
import { BezierCoordinates as Coordinates } from "../companions/coordinates.js";
import { define } from "./define.js";
import type { BezierCoordinatesConstructor } from "../companions/types.js";

export { setTranslations } from "../../editor/translations.js";
export type { BezierCoordinatesElement } from "../companions/types.js";

/** The class of `<bezier-coordinates>`. */
export const BezierCoordinates = define("bezier-coordinates", Coordinates) as BezierCoordinatesConstructor;
