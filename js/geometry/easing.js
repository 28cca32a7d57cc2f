// Timing functions of CSS. They need no wasm.
import { finite, shown } from "./check.js";
import { cubicBezier } from "./easing-bezier.js";
import { readEasing, writeEasing } from "./easing-css.js";
import { linear, steps } from "./easing-piecewise.js";
import { fewestStops } from "./easing-stops.js";

/** @import { Timing } from "./easing-css.js" */

/**
 * What a timing function has besides being called.
 *
 * @typedef {object} EasingMembers
 * @property {string} css the function as CSS text: `cubic-bezier(…)`, `steps(…)`, `linear(…)` or `linear`
 * @property {(tolerance: number) => string} toLinear the function as a CSS `linear()`: its output differs by at most
 *   `tolerance` for inputs from 0 to 1, and for
 *   a cubic curve no `linear()` with fewer stops stays within 96 % of the tolerance; steps
 *   and linear() remain as they are. The outputs at 0 and 1 are exact. A RangeError for a tolerance below 10⁻⁴, or below
 *   10⁻⁴ of a larger y1 or y2, and for more than 32,767 steps
 */

/**
 * A timing function: output progress over input progress.
 *
 * @typedef {((x: number) => number) & EasingMembers} Easing
 */

/**
 * The timing function of CSS `cubic-bezier(x1, y1, x2, y2)`: the cubic curve from (0, 0) to (1, 1) with the handles
 * (x1, y1) and (x2, y2), as y over x.
 *
 *     const ease = easing(0.25, 0.1, 0.25, 1);
 *     ease(0.5); // 0.802403387584857
 *     ease.css; // "cubic-bezier(0.25, 0.1, 0.25, 1)"
 *
 * Exact at 0 and 1; between them the result is y(t) for a t with |x(t) − x| ≤ 10⁻¹⁵. Monotone where the curve is; never
 * NaN. Below 0 and above 1 it is extrapolated along the tangent at the end, as CSS defines it.
 *
 * Source: CSS Easing Functions Level 2.
 *
 * @overload
 * @param {number} x1 0 to 1
 * @param {number} y1
 * @param {number} x2 0 to 1
 * @param {number} y2
 * @returns {Easing}
 * @throws {RangeError} for an x1 or x2 outside of 0 to 1, a NaN or an infinity, here and in the function's calls
 */

/**
 * A CSS timing function: `ease`, `ease-in`, `ease-out`, `ease-in-out`, `linear`, `step-start`, `step-end`,
 * `cubic-bezier(…)`, `steps(…)` or `linear(…)`.
 *
 *     easing("steps(4, jump-none)")(0.5); // 0.6666666666666666
 *     easing("ease-out").toLinear(0.01); // a linear() for animations
 *
 * Letters of either case and comments are read as CSS does; `calc()` and `var()` are not. At a jump the output is the
 * one after it. Outside of 0 to 1 the first and the last part of `linear()` continue.
 *
 * Source: CSS Easing Functions Level 2.
 *
 * @overload
 * @param {string} css
 * @returns {Easing}
 * @throws {RangeError} for any other text, with `offset`, the position of the error in the text
 */

/**
 * @param {[css: string] | [x1: number, y1: number, x2: number, y2: number]} args
 * @returns {Easing}
 */
export function easing(...args) {
  const timing = checkedTiming(args);
  const evaluate = evaluator(timing);
  return Object.assign((/** @type {number} */ x) => evaluate(finite(x, "x")), {
    css: writeEasing(timing),
    toLinear: (/** @type {number} */ tolerance) =>
      writeEasing({ stops: fewestStops(timing, finite(tolerance, "tolerance")) }),
  });
}

/**
 * @param {readonly unknown[]} args
 * @returns {Timing}
 */
function checkedTiming(args) {
  const { length } = args;
  if (length > 1 && length < 5) return { handles: [0, 1, 2, 3].map((k) => handle(args[k], k)) };
  if (typeof args[0] === "string") return readEasing(args[0]);
  const got = length > 1 ? `${length} arguments` : shown(args[0]);
  throw new TypeError(`easing: expected a text or 4 numbers, got ${got}`);
}

/**
 * @param {unknown} value
 * @param {number} k
 */
function handle(value, k) {
  const name = ["x1", "y1", "x2", "y2"][k];
  const number = finite(value, name);
  if (k % 2 === 0 && (number < 0 || number > 1))
    throw new RangeError(`${name}: expected a number from 0 to 1, got ${number}`);
  return number;
}

/**
 * @param {Timing} timing
 * @returns {(x: number) => number}
 */
function evaluator(timing) {
  if ("handles" in timing) return cubicBezier(timing.handles);
  return "count" in timing ? steps(timing.count, timing.position) : linear(timing.stops);
}
