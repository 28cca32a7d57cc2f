// What the element needs as soon as it is near what is seen of the page, and not before; a file of its own in the bundle.
export { AppletController } from "./controller.js";
export { frame } from "./frame.js";
export { style } from "./style.js";
