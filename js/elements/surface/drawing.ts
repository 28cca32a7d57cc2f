// What the element needs as soon as it is near what is seen of the page, and not before; a file of its own in the bundle.
export { Gestures } from "./gestures.js";
export { Handles } from "./handles.js";
export { Labels } from "./labels.js";
export { Stage } from "./stage.js";
