// casteljau/elements: all custom elements of the package, the code of each loaded when the page has one close to its visible
// part. casteljau/elements/easing and so on define one of them at once.
import { observe } from "./on-demand.js";

export { loadElement } from "./on-demand.js";
export { setTranslations } from "../editor/translations.js";
export type { BezierElementTagNameMap } from "./tag-names.js";
export type { BezierAppletElement, BezierSurfaceElement, AppletFigure, SurfaceFigure, SurfaceView } from "./types.js";
export type {
  BezierBernsteinElement,
  BezierEquationElement,
  BezierCoordinatesElement,
  BezierEasingElement,
} from "./companions/types.js";

if (globalThis.document) observe(document);
