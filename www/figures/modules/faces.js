// What the figures of the faces of shapes use of the package: in the built site a module with only the methods that www/vite.config.js lists.
export { Path } from "casteljau";
