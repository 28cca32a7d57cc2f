// All that the word needs of the package, and all that is loaded of it before the reader does something: in the built site a
// module with only the methods that www/vite.config.js lists.
export { Spline } from "casteljau/core";
