import { once } from "../loading.js";

export type Drawing = typeof import("./drawing.js");

/** The picture in WebGL with what it needs, and the gestures. */
export const loadDrawing = once(() => import("./drawing.js"), "Stage");
