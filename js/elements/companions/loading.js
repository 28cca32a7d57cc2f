import { once } from "../loading.js";

/** @typedef {typeof import("./views.js")} Views */

/** Everything that companions show. */
export const loadViews = once(() => import("./views.js"), "EasingView");
