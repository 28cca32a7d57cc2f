import { LazyView } from "./loading.js";
import { Pointed } from "./pointed.js";

/** `<bezier-coordinates>`; what can be set from outside is documented in types.js. */
export class BezierCoordinates extends Pointed {
  static view = new LazyView(() => import("./coordinates-view.js"), "CoordinatesView");
}
