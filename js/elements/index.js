// casteljau/elements: all custom elements of the package. Importing this module defines them; casteljau/elements/easing and
// so on define one.
export { BezierApplet } from "./define/applet.js";
export { BezierBernstein } from "./define/bernstein.js";
export { BezierCoordinates } from "./define/coordinates.js";
export { BezierEasing } from "./define/easing.js";
export { BezierEquation } from "./define/equation.js";
export { BezierSurface } from "./define/surface.js";

/** @typedef {import("./tag-names.js").BezierElementTagNameMap} BezierElementTagNameMap */
/** @typedef {import("./types.js").BezierAppletElement} BezierAppletElement */
/** @typedef {import("./types.js").BezierSurfaceElement} BezierSurfaceElement */
/** @typedef {import("./types.js").AppletFigure} AppletFigure */
/** @typedef {import("./types.js").SurfaceFigure} SurfaceFigure */
/** @typedef {import("./types.js").SurfaceView} SurfaceView */
/** @typedef {import("./companions/types.js").BezierBernsteinElement} BezierBernsteinElement */
/** @typedef {import("./companions/types.js").BezierEquationElement} BezierEquationElement */
/** @typedef {import("./companions/types.js").BezierCoordinatesElement} BezierCoordinatesElement */
/** @typedef {import("./companions/types.js").BezierEasingElement} BezierEasingElement */
