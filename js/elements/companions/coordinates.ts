import { LazyView } from "./loading.js";
import { LinkedWithPoints } from "./with-points.js";

/** `<bezier-coordinates>`; what can be set from outside is documented in types.js. */
export class BezierCoordinates extends LinkedWithPoints {
  static view = new LazyView(() => import("./coordinates-view.js"), "CoordinatesView");
}
