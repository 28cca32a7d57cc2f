// Timing functions of CSS. They need no wasm.
import { describe, finite } from "./check.js";
import { cubicBezier } from "./easing-bezier.js";
import { readEasing, writeEasing } from "./easing-css.js";
import { stopsOfFunction, stopsOfSpring } from "./easing-fit.js";
import { linear, steps } from "./easing-piecewise.js";
import { fewestStops } from "./easing-stops.js";
import type { Timing } from "./easing-css.js";
import type { FitEasingOptions, SpringOptions } from "./easing-fit.js";

/** What a timing function has besides being called. */
export interface EasingMembers {
  /** The function as CSS text: `cubic-bezier(…)`, `steps(…)`, `linear(…)` or `linear` */
  css: string;
  /** The text of `css`, so that `${ease}` can be written into a style */
  toString: () => string;
  /**
   * The function as a CSS `linear()` whose output differs by at most `tolerance` for inputs from 0 to 1. For a cubic
   * curve no `linear()` with fewer stops stays within 96 % of the tolerance, and the outputs at 0 and 1 are exact.
   * A `linear()` keeps its jumps and ends, and loses the stops between them that the tolerance permits; `steps()` remain
   * as they are. Throws a RangeError for a tolerance below 10⁻⁴, or below 10⁻⁴ of a larger y1, y2 or stop, and for more
   * than 32,767 steps
   */
  toLinear: (tolerance: number) => string;
}

/** A timing function: output progress over input progress. */
export type Easing = ((x: number) => number) & EasingMembers;

/**
 * The timing function of a spring, and the time until it has settled. `duration`: in milliseconds, for
 * `animation-duration` or `element.animate`
 */
export type SpringEasing = Easing & { duration: number };

/** What `easing` is: a function with two others. */
export interface EasingStatics {
  /**
   * A CSS `linear()` for any function of the progress from 0 to 1, within a tolerance, 0.002 by default. The function
   * is evaluated at 1,025 places, and at more where it bends; a jump becomes a steep line. Throws a RangeError where
   * its value is not finite
   */
  from: (f: (x: number) => number, options?: FitEasingOptions) => Easing;
  /**
   * A CSS `linear()` for a spring with `mass`, `stiffness`, `damping` and initial `velocity`, until it stays within
   * the tolerance of 1; `duration` is the time for that, in milliseconds. Throws a RangeError for a spring that needs
   * more than 100 oscillations
   */
  spring: (options?: SpringOptions) => SpringEasing;
}

/**
 * A CSS timing function: output progress y over input progress x.
 *
 *     const ease = easing(0.25, 0.1, 0.25, 1); // cubic-bezier(x1, y1, x2, y2)
 *     ease(0.5); // 0.802403387584857
 *     ease.css; // "cubic-bezier(0.25, 0.1, 0.25, 1)"
 *     easing("steps(4, jump-none)")(0.5); // 0.6666666666666666
 *     easing("ease-out").toLinear(0.01); // a linear() for animations
 *
 * The arguments are the handles (x1, y1) and (x2, y2) of a cubic curve from (0, 0) to (1, 1), with x1 and x2 from 0 to 1,
 * or a text: `ease`, `ease-in`, `ease-out`, `ease-in-out`, `linear`, `step-start`, `step-end`, `cubic-bezier(…)`,
 * `steps(…)` or `linear(…)`. Letters of either case and comments are read as CSS does; `calc()` and `var()` are not.
 *
 * A cubic curve is exact at 0 and 1; between them the result is y(t) for a t with |x(t) − x| ≤ 10⁻¹⁵. It is monotone
 * where the curve is, and never NaN. Below 0 and above 1 it is extrapolated along the tangent at the end, as CSS defines
 * it. At a jump of `steps()` and `linear()` the result is the value after it; outside of 0 to 1 the first and the last part
 * of `linear()` continue.
 *
 * Throws a RangeError for an x1 or x2 outside of 0 to 1, for a NaN or an infinity, here and in the function's calls, and
 * for any other text; then `offset` is the position of the error in the text.
 *
 * Source: CSS Easing Functions Level 2.
 */
export const easing: {
  (x1: number, y1: number, x2: number, y2: number): Easing;
  (css: string): Easing;
} & EasingStatics = /* @__PURE__ */ Object.assign((...args: unknown[]) => easingOf(checkedTiming(args)), {
  from: (f: (x: number) => number, options: FitEasingOptions | undefined) =>
    easingOf({ stops: stopsOfFunction(f, options) }),
  spring: (options: SpringOptions | undefined) => {
    const { stops, seconds } = stopsOfSpring(options);
    return Object.assign(easingOf({ stops }), { duration: 1000 * seconds });
  },
});

function easingOf(timing: Timing): Easing {
  const evaluate = evaluator(timing);
  const css = writeEasing(timing);
  return Object.assign((x: number) => evaluate(finite(x, "x")), {
    css,
    toString: () => css,
    toLinear: (tolerance: number) => writeEasing({ stops: fewestStops(timing, finite(tolerance, "tolerance")) }),
  });
}

function checkedTiming(args: readonly unknown[]): Timing {
  const { length } = args;
  if (length > 1 && length < 5) return { handles: [0, 1, 2, 3].map((k) => handle(args[k], k)) };
  if (typeof args[0] === "string") return readEasing(args[0]);
  const got = length > 1 ? `${length} arguments` : describe(args[0]);
  throw new TypeError(`easing: expected a text or 4 numbers, got ${got}`);
}

function handle(value: unknown, k: number) {
  const name = ["x1", "y1", "x2", "y2"][k];
  const number = finite(value, name);
  if (k % 2 === 0 && (number < 0 || number > 1))
    throw new RangeError(`${name}: expected a number from 0 to 1, got ${number}`);
  return number;
}

function evaluator(timing: Timing): (x: number) => number {
  if ("handles" in timing) return cubicBezier(timing.handles);
  return "count" in timing ? steps(timing.count, timing.position) : linear(timing.stops);
}
