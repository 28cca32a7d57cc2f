import { once } from "../loading.js";

export type Drawing = typeof import("./drawing.js");
export type Rational = typeof import("./rational.js");

/** The picture in WebGL with what it needs, and the gestures. */
export const loadDrawing = once(() => import("./drawing.js"), "Stage");

/** Surfaces with weights, with casteljau/nurbs. */
export const loadRational = once(() => import("./rational.js"), "rationalModel");
