// The page is the camera; this starts it and keeps the path in the address.
import "../parts/page.js";
import { keepInAddress } from "../figures/lib/address.js";
import { CameraPath } from "./camera-path.js";
import { checked } from "./state.js";

customElements.define("camera-path", CameraPath);
const camera = /** @type {CameraPath} */ (document.querySelector("camera-path"));

keepInAddress(camera, {
  read: (state) => {
    camera.state = checked(state);
  },
  write: () => ({
    ...camera.state,
    points: camera.state.points.map((point) => point.map((value) => Number(value.toFixed(2)))),
  }),
});
