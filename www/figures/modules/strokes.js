// What the figures of strokes use of the package: in the built site a module with only the methods that www/vite.config.js lists.
export { Curve, Path } from "casteljau";
