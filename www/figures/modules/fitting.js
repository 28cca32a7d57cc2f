// What the figures of fitting and simplifying use of the package: in the built site a module with only the methods that www/vite.config.js lists.
export { Path, Spline } from "casteljau";
