// The types of the elements by tag name, for document.createElement, querySelector and templates.
import type {
  BezierBernsteinElement,
  BezierCoordinatesElement,
  BezierEasingElement,
  BezierEquationElement,
} from "./companions/types.js";
import type { BezierAppletElement, BezierSurfaceElement } from "./types.js";

export interface BezierElementTagNameMap {
  "bezier-applet": BezierAppletElement;
  "bezier-bernstein": BezierBernsteinElement;
  "bezier-coordinates": BezierCoordinatesElement;
  "bezier-easing": BezierEasingElement;
  "bezier-equation": BezierEquationElement;
  "bezier-surface": BezierSurfaceElement;
}

declare global {
  interface HTMLElementTagNameMap extends BezierElementTagNameMap {}
}
