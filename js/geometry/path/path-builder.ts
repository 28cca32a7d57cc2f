import * as check from "../check.js";
import { CommandBuilder } from "../../io/command-builder.js";
import { degreesOf, directionOfDegrees, quarterTurns } from "../../io/svg-arc.js";
import { checkTolerance } from "../../io/svg-write.js";
import { fittingRadii } from "./path-shapes.js";

const [ARC, CUBIC, LINE, MOVE, QUADRATIC] = [65, 67, 76, 77, 81];

const FULL_TURN = 2 * Math.PI;

/**
 * A path in the making, with the methods of a canvas context (`CanvasPath`): what a function draws on it becomes a path.
 *
 * As on a canvas, a command without a subpath starts one at its first point, and after `closePath` the next subpath starts where
 * the closed one did. Subpaths without a segment are omitted. Other than on a canvas, a NaN or an infinity is a RangeError.
 */
export class PathBuilder<P> {
  #builder;
  #tolerance;
  #pathOf;
  /** Whether there is a subpath. */
  #started = false;

  /**
   * Starts without commands.
   *
   * @internal
   * @param tolerance for arcs, 0 for the default
   */
  constructor(tolerance: number, pathOf: (packed: Float64Array) => P) {
    this.#builder = new CommandBuilder(tolerance);
    this.#tolerance = tolerance;
    this.#pathOf = pathOf;
  }

  /** Starts a subpath. */
  moveTo(x: number, y: number) {
    this.#draw(MOVE, { x, y });
    this.#started = true;
  }

  /** Adds a line. */
  lineTo(x: number, y: number) {
    if (this.#started) this.#draw(LINE, { x, y });
    else this.moveTo(x, y);
  }

  /**
   * Adds a quadratic curve.
   *
   * @param x1 the control point
   * @param x the end
   */
  quadraticCurveTo(x1: number, y1: number, x: number, y: number) {
    this.#start({ x1, y1 });
    this.#draw(QUADRATIC, { x1, y1, x, y });
  }

  /**
   * Adds a cubic curve.
   *
   * @param x1 the first control point
   * @param x2 the second control point
   * @param x the end
   */
  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number) {
    this.#start({ x1, y1 });
    this.#draw(CUBIC, { x1, y1, x2, y2, x, y });
  }

  /**
   * Adds an arc of a circle, and a line to its start if there is a subpath.
   *
   * @param x the centre
   * @param startAngle in radians, from the x-axis towards the y-axis
   * @param endAngle in radians
   * @param counterclockwise whether the angle decreases, by default false; a full turn at most
   */
  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise?: boolean) {
    check.finite(radius, "radius");
    this.ellipse(x, y, radius, radius, 0, startAngle, endAngle, counterclockwise);
  }

  /**
   * Adds an arc of an ellipse, and a line to its start if there is a subpath.
   *
   * @param x the centre
   * @param radiusX the length of the first semi-axis
   * @param radiusY the length of the second semi-axis
   * @param rotation the angle from the x-axis to the first semi-axis, in radians
   * @param startAngle in radians, from the first semi-axis towards the second
   * @param endAngle in radians
   * @param counterclockwise whether the angle decreases, by default false; a full turn at most
   */
  ellipse(
    x: number,
    y: number,
    radiusX: number,
    radiusY: number,
    rotation: number,
    startAngle: number,
    endAngle: number,
    counterclockwise?: boolean,
  ) {
    const values = { x, y, radiusX, radiusY, rotation, startAngle, endAngle };
    for (const [name, value] of Object.entries(values)) check.finite(value, name);
    check.nonNegative(radiusX, "radiusX");
    check.nonNegative(radiusY, "radiusY");
    const backwards = check.optionalBoolean(counterclockwise, "counterclockwise");
    const turn = arcAngle(startAngle, endAngle, backwards);
    const [cos, sin] = directionOfDegrees(degreesOf(rotation));
    const at = (angle: number) => {
      const [u, v] = directionOfDegrees(degreesOf(angle));
      const [a, b] = [radiusX * u, radiusY * v];
      return { x: x + (a * cos - b * sin), y: y + (a * sin + b * cos) };
    };
    const start = at(startAngle);
    if (this.#started) this.#draw(LINE, start);
    else this.moveTo(start.x, start.y);
    const isFull = Math.abs(turn) === FULL_TURN;
    const parts = quarterTurns(turn);
    const [degrees, sweep] = [degreesOf(rotation), turn > 0 ? 1 : 0];
    for (let k = 1; k <= parts; k++) {
      const end = k === parts && isFull ? start : at(k === parts ? startAngle + turn : startAngle + (turn * k) / parts);
      this.#draw(ARC, { radiusX, radiusY, degrees, large: 0, sweep, ...end });
    }
  }

  /**
   * Adds an arc that is tangent to the lines from the current point to (x1, y1) and from there to (x2, y2), and a line to
   * its start.
   *
   * @param x1 the corner
   * @param x2 a point on the second line
   */
  arcTo(x1: number, y1: number, x2: number, y2: number, radius: number) {
    for (const [name, value] of Object.entries({ x1, y1, x2, y2, radius })) check.finite(value, name);
    check.nonNegative(radius, "radius");
    this.#start({ x1, y1 });
    const back = unit(this.#builder.x - x1, this.#builder.y - y1);
    const on = unit(x2 - x1, y2 - y1);
    const sine = on[0] * back[1] - on[1] * back[0];
    // The distance from the corner is radius / tan(θ/2) for the angle θ between the lines.
    const distance = (radius * (1 + (back[0] * on[0] + back[1] * on[1]))) / Math.abs(sine);
    if (radius === 0 || sine === 0 || !check.isCoordinate(distance)) return this.lineTo(x1, y1);
    this.lineTo(x1 + back[0] * distance, y1 + back[1] * distance);
    const end = { x: x1 + on[0] * distance, y: y1 + on[1] * distance };
    this.#draw(ARC, { radiusX: radius, radiusY: radius, degrees: 0, large: 0, sweep: sine > 0 ? 1 : 0, ...end });
  }

  /**
   * Adds a rectangle as a closed subpath.
   *
   * @param x a corner
   */
  rect(x: number, y: number, width: number, height: number) {
    this.roundRect(x, y, width, height, 0);
  }

  /**
   * Adds a rectangle with round corners as a closed subpath.
   *
   * @param x a corner
   * @param width if negative, the rectangle extends to the left
   * @param height if negative, the rectangle extends to smaller y
   * @param radii one radius, or as in CSS the radii of 1 to 4 corners, from the one at (x, y) with the x-axis to the
   *   right and the y-axis down clockwise; by default 0. All are reduced by one factor if two do not fit on a side
   */
  roundRect(x: number, y: number, width: number, height: number, radii: number | ArrayLike<number> = 0) {
    for (const [name, value] of Object.entries({ x, y, width, height })) check.finite(value, name);
    const [w, h] = [Math.abs(width), Math.abs(height)];
    const [a, b, c, d] = fittingRadii(cornerRadii(radii), w, h);
    const [right, down] = [Math.sign(width) || 1, Math.sign(height) || 1];
    const sweep = right * down > 0 ? 1 : 0;
    const at = (u: number, v: number) => ({ x: x + right * u, y: y + down * v });
    const line = (to: { x: number; y: number }) => {
      if (to.x !== this.#builder.x || to.y !== this.#builder.y) this.#draw(LINE, to);
    };
    const arc = (r: number, to: { x: number; y: number }) => {
      if (r > 0) this.#draw(ARC, { radiusX: r, radiusY: r, degrees: 0, large: 0, sweep, ...to });
    };
    this.#draw(MOVE, at(a, 0));
    line(at(w - b, 0));
    arc(b, at(w, b));
    line(at(w, h - c));
    arc(c, at(w - c, h));
    line(at(d, h));
    arc(d, at(0, h - d));
    line(at(0, a));
    arc(a, at(a, 0));
    this.#builder.close();
    this.moveTo(x, y);
  }

  /** Closes the subpath with a line to its start, unless it ends there. */
  closePath() {
    if (this.#started) this.#builder.close();
  }

  /**
   * The path that has been drawn; the builder is empty afterwards.
   *
   * @throws {RangeError} for a tolerance below 4 ulps of the largest coordinate
   */
  build(): P {
    this.#builder.end(false);
    const packed = this.#builder.packed();
    this.#builder = new CommandBuilder(this.#tolerance);
    this.#started = false;
    checkTolerance(packed, this.#tolerance);
    return this.#pathOf(packed);
  }

  /** Starts a subpath at a point, if there is none. */
  #start(point: Record<string, number>) {
    if (this.#started) return;
    this.#draw(MOVE, point);
    this.#started = true;
  }

  #draw(command: number, values: Record<string, number>) {
    let at = 0;
    for (const name in values) {
      const value = values[name];
      this.#builder.args[at++] = check.finite(value, name);
    }
    if (this.#builder.draw(command)) return;
    const got = Object.values(values).join(" ");
    throw new RangeError(`builder: expected coordinates from -2^500 to 2^500 (3.27e150), got ${got}`);
  }
}

/** The signed angle of an arc, at most a full turn. */
function arcAngle(start: number, end: number, backwards: boolean) {
  const angle = backwards ? start - end : end - start;
  const turns = angle >= FULL_TURN ? FULL_TURN : ((angle % FULL_TURN) + FULL_TURN) % FULL_TURN;
  return backwards ? -turns : turns;
}

/** A unit vector; zero for a zero vector. */
function unit(x: number, y: number): [number, number] {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
}

/** The radii of the four corners, as the property `border-radius` of CSS completes them. */
function cornerRadii(radii: unknown): number[] {
  const list = typeof radii === "number" ? [check.finite(radii, "radii")] : [...check.numbers(radii, "radii")];
  if (list.length < 1 || list.length > 4) throw new RangeError(`radii: expected 1 to 4 numbers, got ${list.length}`);
  const negative = list.find((radius) => radius < 0);
  if (negative !== undefined) throw new RangeError(`radii: expected numbers from 0, got ${negative}`);
  const [a, b = a, c = a, d = b] = list;
  return [a, b, c, d];
}
