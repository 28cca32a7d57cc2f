// The public types of the companions. They do not mention the libraries that the elements use.

/**
 * What companions have in common. Every attribute is a property of the same name, `for` is `htmlFor`. An invalid value has
 * the effect of the default, and the element shows a message. The events "input" (during a change by the user) and "change"
 * (at its end) bubble; changes by the page do not fire them.
 */
export interface CompanionProperties {
  /** The name for screen readers */
  label: string;
  /** The colours; "auto" follows the color scheme of the user */
  theme: "light" | "dark" | "auto";
}

/**
 * A companion that can be linked to a `<bezier-applet>`: it shows the applet's selected segment and its `t`, and changes by
 * the user change the applet. Without a link its own attributes are used.
 */
export interface LinkProperties {
  /** The id of the applet; either of the two may be added first */
  htmlFor: string;
  /** The linked applet; null without one */
  target: HTMLElement | null;
}

/** `<bezier-bernstein>`: the weights of the control points over t, with a marker at t that can be dragged. */
export interface BernsteinProperties {
  /** 1 to 64 */
  degree: number;
  /** The parameter, from 0 to 1 */
  t: number;
  /** The functions whose weights are shown; "bezier": Bernstein polynomials */
  basis: "bezier" | "hermite" | "b-spline" | "catmull-rom";
}

/** `<bezier-equation>`: the curve's equation in MathML, with numbers. */
export interface EquationProperties {
  /** Pairs, or a text "x,y x,y …" */
  points: number[][];
  /** The parameter, from 0 to 1 */
  t: number;
  /** The degree of the curve, which uses as many points as it needs; null uses all points */
  degree: number | null;
  /** As in `<bezier-bernstein>`, or "matrix" */
  basis: "bezier" | "hermite" | "b-spline" | "catmull-rom" | "matrix";
  /** 16 numbers, row by row: the curve is [t³ t² t 1] · M · P */
  matrix: string;
  /** The form of the equation; "sum": weights times points */
  form: "sum" | "matrix" | "casteljau";
  /** Whether the numbers of the matrix can be changed */
  editable: boolean;
}

/** `<bezier-coordinates>`: the control points as a table of numbers. Pasted lines "x,y" fill it. */
export interface CoordinatesProperties {
  /** Pairs, or a text "x,y x,y …" */
  points: number[][];
}

/**
 * `<bezier-easing>`: an editor of CSS timing functions, and a form field. The attribute `value` is the initial value, which
 * a reset of the form restores: `cubic-bezier(x1, y1, x2, y2)` or a CSS keyword.
 */
export interface EasingProperties {
  /**
   * `cubic-bezier(x1, y1, x2, y2)`; empty if it is required and nothing is chosen. An invalid text
   * changes nothing, and the element shows a message
   */
  value: string;
  /** The attribute `value` */
  defaultValue: string | null;
  /** The name of the form field */
  name: string;
  /** Whether a value must be chosen */
  required: boolean;
  /** Whether the field cannot be changed and is left out of the form */
  disabled: boolean;
  /** "bezier-easing" */
  type: string;
  /** The form that the field belongs to */
  form: HTMLFormElement | null;
  /** The `<label>` elements of the field */
  labels: NodeList;
  /** What is wrong with the value, as of an `<input>` */
  validity: ValidityState;
  /** What the browser says about an invalid value */
  validationMessage: string;
  /** Whether the value is checked when the form is submitted */
  willValidate: boolean;
  /** Whether the value is valid; fires `invalid` if not */
  checkValidity: () => boolean;
  /** Like `checkValidity`, and shows the message */
  reportValidity: () => boolean;
  /** Sets a message that makes the value invalid; an empty one makes it valid */
  setCustomValidity: (message: string) => void;
}

export type BezierBernsteinElement = HTMLElement & CompanionProperties & LinkProperties & BernsteinProperties;
export type BezierEquationElement = HTMLElement & CompanionProperties & LinkProperties & EquationProperties;
export type BezierCoordinatesElement = HTMLElement & CompanionProperties & LinkProperties & CoordinatesProperties;
export type BezierEasingElement = HTMLElement & CompanionProperties & EasingProperties;
export type BezierBernsteinConstructor = { new (): BezierBernsteinElement; prototype: BezierBernsteinElement };
export type BezierEquationConstructor = { new (): BezierEquationElement; prototype: BezierEquationElement };
export type BezierCoordinatesConstructor = { new (): BezierCoordinatesElement; prototype: BezierCoordinatesElement };
export type BezierEasingConstructor = { new (): BezierEasingElement; prototype: BezierEasingElement };
