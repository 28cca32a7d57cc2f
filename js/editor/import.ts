// Figures out of text: points, an SVG path, or the plain data that an element gave.
import { Curve } from "../geometry/curve/curve.js";
import { readSvg } from "../io/svg-read.js";
import { extentAt } from "../wasm/packed-path.js";
import { messageOf } from "./check.js";
import { pairs } from "./plane.js";
import { pointsIn, stateOf } from "./schema.js";
import { withPoints } from "./state.js";
import type { State } from "./state.js";
import type { Point2 } from "./state.js";

/** More text than this is no figure. */
const MAX_CHARACTERS = 2e6;
/** A path that does not fit is made to, with so much room at the sides. */
const MARGIN_RATIO = 0.08;

/**
 * @throws {RangeError} with words for the user
 */
export function withText(state: State, text: string): State {
  try {
    return read(state, text);
  } catch (error) {
    throw new RangeError(`This is no figure: ${messageOf(error)}`);
  }
}

function read(state: State, text: string): State {
  if (text.length > MAX_CHARACTERS)
    throw new RangeError(`expected points, an SVG path or JSON, got ${text.length} characters`);
  const given = text.trim();
  if (/^[[{]/.test(given)) return withJson(state, given);
  const d = /^<|<svg|<path/i.test(given)
    ? (/\sd\s*=\s*["']([^"']+)/.exec(given)?.[1] ?? "")
    : /^[Mm]/.test(given)
      ? given
      : null;
  if (d === "") throw new RangeError("expected an SVG with a path, got one without");
  return d === null ? withPoints(state, pointsIn(given)) : withPath(state, d);
}

function withJson(state: State, text: string) {
  const json = JSON.parse(text);
  return Array.isArray(json) ? withPoints(state, json) : stateOf(json);
}

/** The first subpath, as cubics; a path would bring all of its methods. */
function withPath(state: State, d: string) {
  const { packed, error } = readSvg(d, 0);
  if (error) throw new RangeError(error.message);
  const [subpathCount] = packed;
  if (subpathCount === 0) throw new RangeError("expected an SVG path with a line in it, got none");
  const { closed, degrees, points: from, end } = extentAt(packed, 1);
  const given = pairs(packed.subarray(from, end));
  if (closed) given.push(given[0]);
  const points = [given[0]];
  let start = 0;
  for (const degree of packed.subarray(degrees, from)) {
    let curve = new Curve(given.slice(start, start + degree + 1));
    while (curve.degree < 3) curve = curve.elevate();
    points.push(...pairs(curve.controlPoints()).slice(1));
    start += degree;
  }
  return withPoints(
    { ...state, basis: "bezier", weights: [], degree: 3, joints: ["free"], shown: state.points.length },
    fitted(points, state.box),
  );
}

/** Moved and scaled into the box where they lie outside. */
function fitted(points: Point2[], box: State["box"]): Point2[] {
  const [left, top] = [0, 1].map((axis) => Math.min(...points.map((point) => point[axis])));
  const [right, bottom] = [0, 1].map((axis) => Math.max(...points.map((point) => point[axis])));
  if (left >= 0 && top >= 0 && right <= box.width && bottom <= box.height) return points;
  const room = 1 - 2 * MARGIN_RATIO;
  const scale = Math.min((room * box.width) / (right - left || 1), (room * box.height) / (bottom - top || 1));
  const [x, y] = [box.width / 2 - (scale * (left + right)) / 2, box.height / 2 - (scale * (top + bottom)) / 2];
  return points.map((point) => [x + scale * point[0], y + scale * point[1]]);
}

/**
 * @returns of a file that is too large, only so much that it is seen to be
 */
export function textIn(file: File): Promise<string> {
  return file.slice(0, MAX_CHARACTERS + 1).text();
}
