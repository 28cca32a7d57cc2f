import { once } from "../loading.js";

/** @typedef {typeof import("./drawing.js")} Drawing */

/** The picture with its layers, and the controls. */
export const loadDrawing = once(() => import("./drawing.js"), "Hands");
