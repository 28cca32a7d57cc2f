import { once } from "../loading.js";

export type Drawing = typeof import("./drawing.js");

/** The picture with its layers, and the controls. */
export const loadDrawing = once(() => import("./drawing.js"), "AppletView");
