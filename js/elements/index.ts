// casteljau/elements: all custom elements of the package. Importing this module defines them; casteljau/elements/easing and
// so on define one.
export { BezierApplet } from "./define/applet.js";
export { BezierBernstein } from "./define/bernstein.js";
export { BezierCoordinates } from "./define/coordinates.js";
export { BezierEasing } from "./define/easing.js";
export { BezierEquation } from "./define/equation.js";
export { BezierSurface } from "./define/surface.js";

export { setTranslations } from "../editor/translations.js";
export type { BezierElementTagNameMap } from "./tag-names.js";
export type { BezierAppletElement, BezierSurfaceElement, AppletFigure, SurfaceFigure, SurfaceView } from "./types.js";
export type {
  BezierBernsteinElement,
  BezierEquationElement,
  BezierCoordinatesElement,
  BezierEasingElement,
} from "./companions/types.js";
