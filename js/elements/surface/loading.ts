import { once } from "../loading.js";
import type * as drawing from "./drawing.js";
import type * as rational from "./rational.js";

export type Drawing = typeof drawing;
export type Rational = typeof rational;

/** The picture in WebGL with what it needs, and the gestures. */
export const loadDrawing = once(() => import("./drawing.js"), "Stage");

/** Surfaces with weights. */
export const loadRational = once(() => import("./rational.js"), "rationalModel");
