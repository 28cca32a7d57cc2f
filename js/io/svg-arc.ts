// Elliptical arcs as cubics; src/path/arc.rs and src/path/trigonometry.rs perform the same operations and explain them.
// `Math.sin` is not used, because its last digit differs between systems.
import { MAX_COORDINATE } from "../geometry/check.js";

/** The maximum angle of one cubic in radians, for the default tolerance: a distance of 1e-5 of the larger radius. */
export const MAX_PIECE_ANGLE = 0.9059;
const ROUNDING = 2 * Number.EPSILON;
const TERMS = 9;
const TANGENT_TERMS = 13;
/** They divide the interval of angles down to its rounding. */
const BISECTIONS = 50;
/** More than the relative rounding of an angle, and far too small to matter for the distance. */
const QUARTER_TURN_ROUNDING = 1e-13;

export type Pair = [number, number];

/** (cos x, sin x) for |x| ≤ π/4. */
function direction(x: number): Pair {
  const square = x * x;
  let [cos, sin] = [1, 1];
  for (let k = TERMS; k >= 1; k--) {
    const n = 2 * k;
    cos = 1 - (square / ((n - 1) * n)) * cos;
    sin = 1 - (square / (n * (n + 1))) * sin;
  }
  return [cos, sin * x];
}

/**
 * (cos, sin) of an angle in degrees, exact for multiples of 90°.
 *
 * @internal
 */
export function directionOfDegrees(degrees: number): Pair {
  const rest = degrees % 360;
  const quarters = Math.floor(rest / 90 + 0.5);
  const [x, y] = direction((rest - 90 * quarters) * (Math.PI / 180));
  switch ((quarters + 4) % 4) {
    case 1:
      return [-y, x];
    case 2:
      return [-x, -y];
    case 3:
      return [y, -x];
    default:
      return [x, y];
  }
}

/** A rounded angle may exceed a number of quarter turns by this part of a quarter turn. */
const ANGLE_ROUNDING = 1e-12;

/**
 * The least number of arcs of at most a quarter turn.
 *
 * @internal
 */
export function quarterTurns(radians: number): number {
  return Math.ceil(Math.abs(radians) / (Math.PI / 2) - ANGLE_ROUNDING);
}

/**
 * An angle in degrees, exact for the multiples of π/2 that f64 rounds to.
 *
 * @internal
 */
export function degreesOf(radians: number): number {
  return (radians * 180) / Math.PI;
}

/**
 * The angle of a unit vector in the first quadrant.
 *
 * @internal
 */
export function angleOf(x: number, y: number) {
  let [cos, tan] = [x, y / (1 + x)];
  for (let i = 0; i < 2; i++) {
    cos = Math.sqrt(0.5 * (1 + cos));
    tan = (tan * cos) / (1 + cos);
  }
  const square = tan * tan;
  let sum = 0;
  for (let k = TANGENT_TERMS - 1; k >= 0; k--) sum = 1 / (2 * k + 1) - square * sum;
  return 8 * tan * sum;
}

function rotate([vx, vy]: Pair, [x, y]: Pair): Pair {
  return [vx * x - vy * y, vx * y + vy * x];
}

/**
 * The maximum angle of one cubic in radians, at most a quarter turn, for a distance of at most `tolerance` (a part of the
 * larger radius): the solution of 2/27 sin⁶(θ/4) / cos²(θ/4) = tolerance, see src/path/arc.rs.
 */
function maxPieceAngle(tolerance: number): number {
  const bound = 13.5 * Math.max(tolerance, Number.EPSILON);
  let [low, high] = [0, Math.PI / 8];
  for (let k = 0; k < BISECTIONS; k++) {
    const middle = (low + high) / 2;
    const [cos, sin] = direction(middle);
    const square = sin * sin;
    if (square * square * square <= bound * cos * cos) low = middle;
    else high = middle;
  }
  // Rounding must not divide a quarter turn, whose angle is computed, into two.
  return 4 * low * (1 + QUARTER_TURN_ROUNDING);
}

/**
 * The cubics of an arc: for each the six coordinates after its start; null if the arc is a line.
 *
 * @internal
 * @param n radii, the angle of the first axis in degrees, the large and the sweep flag
 * @param tolerance the largest distance from the arc; 0 for 1e-5 of the larger radius
 * @param minPieces the smallest number of cubics
 * @param goesOn asked after each cubic; no more cubics are made where it returns false
 */
export function arc(
  x0: number,
  y0: number,
  n: Float64Array,
  x1: number,
  y1: number,
  tolerance = 0,
  minPieces = 1,
  goesOn: (cubics: number[]) => boolean = () => true,
): number[] | null {
  const axis = directionOfDegrees(n[2]);
  const [hx, hy] = rotate([x0 * 0.5 - x1 * 0.5, y0 * 0.5 - y1 * 0.5], [axis[0], -axis[1]]);
  let [rx, ry] = [Math.abs(n[0]), Math.abs(n[1])];
  let [dx, dy] = [hx / rx, hy / ry];
  const scale = Math.max(Math.abs(dx), Math.abs(dy));
  const [px, py] = [dx / scale, dy / scale];
  const part = Math.sqrt(px * px + py * py);
  let length = scale * part;
  if (!(rx > 0 && ry > 0 && length > 0 && length < Infinity)) return null;
  const largest = Math.max(Math.abs(x0), Math.abs(y0), Math.abs(x1), Math.abs(y1));
  let height = 0;
  if (length >= 1 - ROUNDING * (1 + largest / Math.min(rx, ry))) {
    [rx, ry, dx, dy, length] = [rx * length, ry * length, dx / length, dy / length, 1];
  } else {
    height = Math.sqrt((1 - length) * (1 + length));
  }
  if (!(Math.max(rx, ry) <= MAX_COORDINATE)) return null;
  const [large, sweep] = [n[3] !== 0, n[4] !== 0];
  const side = large === sweep ? 1 : -1;
  const u: Pair = [dx + side * (py * (height / part)), dy + side * (-px * (height / part))];
  const small = angleOf(height, length);
  const theta = large ? 2 * Math.PI - 2 * small : 2 * small;
  const maxAngle = tolerance ? maxPieceAngle(tolerance / Math.max(rx, ry)) : MAX_PIECE_ANGLE;
  const pieces = Math.max(Math.ceil(theta / maxAngle), minPieces);
  const step = direction(theta / (2 * pieces));
  if (!sweep) step[1] = -step[1];
  const handleRatio = ((4 / 3) * step[1]) / (1 + step[0]);
  const toUser = ([x, y]: Pair) => rotate([x * rx, y * ry], axis);
  const tangent = (beta: Pair) => {
    const end = rotate(u, rotate(beta, beta));
    const [x, y] = toUser([-end[1], end[0]]);
    return [x * handleRatio, y * handleRatio];
  };
  const cubics: number[] = [];
  let beta: Pair = [1, 0];
  let [x, y] = [x0, y0];
  let handle = tangent(beta);
  for (let left = pieces - 1; left >= 0; left--) {
    beta = rotate(beta, step);
    const middle = rotate(u, beta);
    const chord = toUser([-middle[1] * (2 * beta[1]), middle[0] * (2 * beta[1])]);
    const next = left === 0 ? [x1, y1] : [x0 + chord[0], y0 + chord[1]];
    const nextHandle = tangent(beta);
    cubics.push(x + handle[0], y + handle[1], next[0] - nextHandle[0], next[1] - nextHandle[1], next[0], next[1]);
    if (!goesOn(cubics)) break;
    [x, y, handle] = [next[0], next[1], nextHandle];
  }
  return cubics;
}
