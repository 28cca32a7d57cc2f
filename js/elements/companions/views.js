// Everything that companions show: a file of its own, fetched when one of them comes near.
export { BernsteinView } from "./bernstein-view.js";
export { CoordinatesView } from "./coordinates-view.js";
export { EasingView } from "./easing-view.js";
export { EquationView } from "./equation-view.js";
