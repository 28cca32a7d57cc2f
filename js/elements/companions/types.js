// The public types of the companions. They do not mention the libraries that the elements use.

/**
 * What companions have in common. Every attribute is a property of the same name, `for` is `htmlFor`. An invalid value has
 * the effect of the default, and the element shows a message. The events "input" (during a change by the user) and "change"
 * (at its end) bubble; changes by the page do not fire them.
 *
 * @typedef {object} CompanionProperties
 * @property {string} label the name for screen readers
 * @property {string} theme "light", "dark" or "auto"
 */

/**
 * A companion that can be linked to a `<bezier-applet>`: it shows the applet's selected segment and its `t`, and changes by
 * the user change the applet. Without a link its own attributes are used.
 *
 * @typedef {object} LinkProperties
 * @property {string} htmlFor the id of the applet; either of the two may be added first
 * @property {HTMLElement | null} target the linked applet; null without one
 */

/**
 * `<bezier-bernstein>`: the weights of the control points over t, with a marker at t that can be dragged.
 *
 * @typedef {object} BernsteinProperties
 * @property {number} degree 1 to 64
 * @property {number} t the parameter, from 0 to 1
 * @property {string} basis "bezier" (Bernstein polynomials), "hermite", "b-spline" or "catmull-rom"
 */

/**
 * `<bezier-equation>`: the curve's equation in MathML, with numbers.
 *
 * @typedef {object} EquationProperties
 * @property {number[][]} points pairs, or a text "x,y x,y …"
 * @property {number} t the parameter, from 0 to 1
 * @property {number | null} degree the degree of the curve, which uses as many points as it needs; null uses all points
 * @property {string} basis as in `<bezier-bernstein>`, or "matrix"
 * @property {string} matrix 16 numbers, row by row: the curve is [t³ t² t 1] · M · P
 * @property {string} form "sum" (weights times points), "matrix" or "casteljau"
 * @property {boolean} editable whether the numbers of the matrix can be changed
 */

/**
 * `<bezier-coordinates>`: the control points as a table of numbers. Pasted lines "x,y" fill it.
 *
 * @typedef {object} CoordinatesProperties
 * @property {number[][]} points pairs, or a text "x,y x,y …"
 */

/**
 * `<bezier-easing>`: an editor of CSS timing functions, and a form field. The attribute `value` is the initial value, which
 * a reset of the form restores: `cubic-bezier(x1, y1, x2, y2)` or a CSS keyword.
 *
 * @typedef {object} EasingProperties
 * @property {string} value `cubic-bezier(x1, y1, x2, y2)`; empty if it is required and nothing is chosen. An invalid text
 *   changes nothing, and the element shows a message
 * @property {string | null} defaultValue the attribute `value`
 * @property {string} name the name of the form field
 * @property {boolean} required whether a value must be chosen
 * @property {boolean} disabled whether the field cannot be changed and is left out of the form
 * @property {string} type "bezier-easing"
 * @property {HTMLFormElement | null} form the form that the field belongs to
 * @property {NodeList} labels the `<label>` elements of the field
 * @property {ValidityState} validity what is wrong with the value, as of an `<input>`
 * @property {string} validationMessage what the browser says about an invalid value
 * @property {boolean} willValidate whether the value is checked when the form is submitted
 * @property {() => boolean} checkValidity whether the value is valid; fires `invalid` if not
 * @property {() => boolean} reportValidity like `checkValidity`, and shows the message
 * @property {(message: string) => void} setCustomValidity sets a message that makes the value invalid; an empty one makes it valid
 */

/** @typedef {HTMLElement & CompanionProperties & LinkProperties & BernsteinProperties} BezierBernsteinElement */
/** @typedef {HTMLElement & CompanionProperties & LinkProperties & EquationProperties} BezierEquationElement */
/** @typedef {HTMLElement & CompanionProperties & LinkProperties & CoordinatesProperties} BezierCoordinatesElement */
/** @typedef {HTMLElement & CompanionProperties & EasingProperties} BezierEasingElement */
/** @typedef {{ new (): BezierBernsteinElement, prototype: BezierBernsteinElement }} BezierBernsteinConstructor */
/** @typedef {{ new (): BezierEquationElement, prototype: BezierEquationElement }} BezierEquationConstructor */
/** @typedef {{ new (): BezierCoordinatesElement, prototype: BezierCoordinatesElement }} BezierCoordinatesConstructor */
/** @typedef {{ new (): BezierEasingElement, prototype: BezierEasingElement }} BezierEasingConstructor */

export {};
