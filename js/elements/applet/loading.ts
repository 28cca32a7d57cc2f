import { once } from "../loading.js";

export type Drawing = typeof import("./drawing.js");
export type Rational = typeof import("./rational.js");

/** The picture with its layers, and the controls. */
export const loadDrawing = once(() => import("./drawing.js"), "AppletView");

/** What draws and edits curves with weights, with casteljau/nurbs. */
export const loadRational = once(() => import("./rational.js"), "RationalCurve");
