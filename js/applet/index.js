import { init } from "../index.js";

/** Placeholder. */
export function bezierApp() {
  return init();
}
