import { once } from "../loading.js";

/** The picture with its layers, and the controls. */
export const loadDrawing = once(() => import("./drawing.js"), "AppletController");

/** What draws and edits curves with weights, and their class. */
export const loadRational = once(() => import("./rational.js"), "RationalCurve");
