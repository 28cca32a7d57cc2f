import { once } from "../loading.js";

/** @typedef {typeof import("./drawing.js")} Drawing */

/** The picture in WebGL with what it needs, and the hands. */
export const loadDrawing = once(() => import("./drawing.js"), "Stage");
