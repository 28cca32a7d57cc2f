// What the element needs for weights, and not before; a file of its own in the bundle.
export { RationalCurve } from "../../nurbs.js";
export { RATIONAL_LAYERS } from "../../layers/rational.js";
export { steppedWeight, withWeight, withWeightPointAt } from "../../editor/weights.js";
export { WeightHandles } from "./weight-handles.js";
