// All that the word needs of the package, and all that is loaded of it before the reader does something.
export { Spline } from "casteljau/core";
