// The public interface. Importing it compiles nothing; the first call does.
export { init } from "./init.js";
export { Curve } from "./curve.js";
export { Spline } from "./spline.js";
export { Path } from "./path.js";
export { Patch } from "./patch.js";
export { Surface } from "./surface.js";
export { Mesh } from "./mesh.js";
export { easing } from "./easing.js";
