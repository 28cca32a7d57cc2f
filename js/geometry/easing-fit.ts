// CSS linear() for functions and for springs.
import { finite, options, positive } from "./check.js";
import { MIN_TOLERANCE, POLYLINE_SHARE, stopsOfRun } from "./easing-stops.js";
import type { Stop } from "./easing-piecewise.js";

/** How a function is approximated. */
export interface FitEasingOptions {
  /** The largest difference of the outputs, 0.002 by default; at least 10⁻⁴ of the largest output */
  tolerance?: number;
}

/** A spring that is released at distance 1 from its rest position: m x″ = −k (x − 1) − c x′. */
export interface SpringOptions {
  /** m, 1 by default */
  mass?: number;
  /** k, 100 by default */
  stiffness?: number;
  /** c, 10 by default */
  damping?: number;
  /** x′ at the start, in distances per second, 0 by default */
  velocity?: number;
  /**
   * The largest difference of the outputs, and the distance from 1 at which the spring counts as settled; 0.002 by
   * default
   */
  tolerance?: number;
}

const DEFAULT_TOLERANCE = 0.002;

/** The number of equal parts in which a function is always evaluated. */
const PARTS = 1024;
/** How often such a part is halved where the function bends. */
const MAX_HALVINGS = 10;
/** A spring with more oscillations needs thousands of stops. */
const MAX_OSCILLATIONS = 100;
/** Bisections of a time, down to its rounding. */
const BISECTIONS = 60;

/**
 * The stops of a linear() near a function on 0 to 1.
 *
 * @internal
 */
export function stopsOfFunction(f: (x: number) => number, given: FitEasingOptions | undefined): Stop[] {
  if (typeof f !== "function") throw new TypeError(`f: expected a function, got ${typeof f}`);
  const { tolerance = DEFAULT_TOLERANCE } = options(given, ["tolerance"]);
  positive(tolerance, "tolerance");
  const value = (x: number) => finite(f(x), `f(${x})`);
  const ys = Array.from({ length: PARTS + 1 }, (_, k) => value(k / PARTS));
  const scale = ys.reduce((largest, y) => Math.max(largest, Math.abs(y)), 1);
  if (!(tolerance >= MIN_TOLERANCE * scale)) {
    throw new RangeError(`tolerance: expected at least ${MIN_TOLERANCE} of the largest output, got ${tolerance}`);
  }
  const run: Stop[] = [[0, ys[0] / scale]];
  const share = tolerance * POLYLINE_SHARE;
  const add = (x0: number, y0: number, x1: number, y1: number, halvings: number) => {
    const x = (x0 + x1) / 2;
    const y = halvings > 0 ? value(x) : y0;
    if (halvings > 0 && Math.abs(y - (y0 + y1) / 2) > share) {
      add(x0, y0, x, y, halvings - 1);
      add(x, y, x1, y1, halvings - 1);
    } else run.push([100 * x1, y1 / scale]);
  };
  for (let k = 0; k < PARTS; k++) add(k / PARTS, ys[k], (k + 1) / PARTS, ys[k + 1], MAX_HALVINGS);
  return stopsOfRun(run, tolerance / scale, scale, ys[PARTS]);
}

/**
 * The stops of a linear() near the motion of a spring until it has settled, and the seconds that this takes.
 *
 * Source: the solution of the damped harmonic oscillator, for example Kreyszig, *Advanced Engineering Mathematics*, §2.4.
 *
 * @internal
 */
export function stopsOfSpring(given: SpringOptions | undefined): { stops: Stop[]; seconds: number } {
  const known = ["mass", "stiffness", "damping", "velocity", "tolerance"] as const;
  const {
    mass = 1,
    stiffness = 100,
    damping = 10,
    velocity = 0,
    tolerance = DEFAULT_TOLERANCE,
  } = options(given, known);
  for (const [name, value] of Object.entries({ mass, stiffness, damping, tolerance })) positive(value, name);
  finite(velocity, "velocity");
  const frequency = Math.sqrt(stiffness / mass);
  const decay = damping / (2 * mass);
  const { distance, bound } = oscillator(frequency, decay, velocity);
  let [low, high] = [0, 1 / frequency];
  while (bound(high) > tolerance) [low, high] = [high, 2 * high];
  for (let k = 0; k < BISECTIONS; k++) {
    const middle = (low + high) / 2;
    if (bound(middle) > tolerance) low = middle;
    else high = middle;
  }
  const oscillations = (Math.sqrt(Math.max(0, frequency ** 2 - decay ** 2)) * high) / (2 * Math.PI);
  if (!(oscillations <= MAX_OSCILLATIONS && high < Infinity)) {
    const got = `${damping} (${oscillations.toFixed(0)} oscillations)`;
    throw new RangeError(`damping: expected a spring that settles within ${MAX_OSCILLATIONS} oscillations, got ${got}`);
  }
  const progress = (x: number) => (x === 1 ? 1 : 1 - distance(x * high));
  return { stops: stopsOfFunction(progress, { tolerance }), seconds: high };
}

/**
 * The distance from the rest position over time, for 1 at the start, and a bound on its absolute value that decreases at
 * last.
 *
 * @param frequency ω, of the spring without damping
 * @param decay δ; ω = δ is critical damping
 * @param velocity towards the rest position
 */
function oscillator(frequency: number, decay: number, velocity: number) {
  const square = frequency ** 2 - decay ** 2;
  const rest = decay - velocity;
  const root = Math.sqrt(Math.abs(square));
  if (root <= 1e-6 * frequency) {
    return {
      distance: (t: number) => (1 + rest * t) * Math.exp(-decay * t),
      bound: (t: number) => (1 + Math.abs(rest) * t) * Math.exp(-decay * t),
    };
  }
  if (square > 0) {
    const sine = rest / root;
    return {
      distance: (t: number) => Math.exp(-decay * t) * (Math.cos(root * t) + sine * Math.sin(root * t)),
      bound: (t: number) => Math.exp(-decay * t) * Math.hypot(1, sine),
    };
  }
  // The slower of the two rates without cancellation: their product is ω².
  const rates = [frequency ** 2 / (decay + root), decay + root];
  const fast = (velocity - rates[0]) / (2 * root);
  const slow = 1 - fast;
  return {
    distance: (t: number) => slow * Math.exp(-rates[0] * t) + fast * Math.exp(-rates[1] * t),
    bound: (t: number) => Math.abs(slow) * Math.exp(-rates[0] * t) + Math.abs(fast) * Math.exp(-rates[1] * t),
  };
}
