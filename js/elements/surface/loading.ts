import { once } from "../loading.js";
import type * as drawing from "./drawing.js";

export type Drawing = typeof drawing;

/** The picture in WebGL with what it needs, and the gestures. */
export const loadDrawing = once(() => import("./drawing.js"), "Stage");
