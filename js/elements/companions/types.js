// What pages see of the companions: types alone, which name nothing of the libraries inside.

/**
 * What companions have in common. Every attribute is a property of the same name, `for` is `htmlFor`. What cannot be used
 * counts as the default, and the element says so. Events "input" (while something moves) and "change" (when it is done)
 * tell what the user does, and bubble; what the page writes fires none.
 *
 * @typedef {object} CompanionProperties
 * @property {string} label what screen readers call it
 * @property {string} theme "light", "dark" or "auto"
 */

/**
 * A companion that may be linked to a `<bezier-applet>`: it shows the piece that the applet looks at and its `t`, and what the
 * user does here the applet does. Its own attributes count while it is linked to none.
 *
 * @typedef {object} LinkProperties
 * @property {string} htmlFor the applet's id; either of the two may be there first
 * @property {HTMLElement | null} target the applet; null while there is none
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
 * @property {number[][]} points pairs; they can be written as text, too: "x,y x,y …"
 * @property {number} t the parameter, from 0 to 1
 * @property {number | null} degree of the curve, by as many points as it needs; null: by all of them
 * @property {string} basis as in `<bezier-bernstein>`, or "matrix"
 * @property {string} matrix 16 numbers, row by row: the curve is [t³ t² t 1] · M · P
 * @property {string} form "sum" (weights times points), "matrix" or "casteljau"
 * @property {boolean} editable whether the numbers of the matrix can be changed
 */

/**
 * `<bezier-coordinates>`: the control points as a table of numbers. Pasted lines "x,y" fill it.
 *
 * @typedef {object} CoordinatesProperties
 * @property {number[][]} points pairs; they can be written as text, too: "x,y x,y …"
 */

/**
 * `<bezier-easing>`: an editor of CSS timing functions, and a field of a form. The attribute `value` is what it begins with
 * and goes back to when the form is reset: `cubic-bezier(x1, y1, x2, y2)`, or a keyword of CSS for one.
 *
 * @typedef {object} EasingProperties
 * @property {string} value `cubic-bezier(x1, y1, x2, y2)`; empty while it is required and nothing is chosen. What cannot be
 *   read changes nothing, and the element says so
 * @property {string | null} defaultValue the attribute `value`
 * @property {string} name in the form
 * @property {boolean} required whether one must be chosen
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
