// Where a dragged point snaps.
import { chainOf } from "./commands.js";
import type { State } from "./state.js";
import type { Point2 } from "./state.js";

/** Snap distance. */
const SNAP_PX = 5;
const STEP = Math.PI / 12;

/**
 * The nearest place in a direction of a multiple of 15°, as seen from the point's neighbour on the curve, or from where
 * it came from.
 */
export function turnedBy15(state: State, index: number, to: Point2, from: Point2): Point2 {
  const [x, y] = anchorOf(state, index) ?? from;
  const angle = Math.round(Math.atan2(to[1] - y, to[0] - x) / STEP) * STEP;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const length = Math.max(0, (to[0] - x) * cos + (to[1] - y) * sin);
  return [x + length * cos, y + length * sin];
}

/** The end on the curve that a point off it belongs to. */
function anchorOf(state: State, index: number): Point2 | undefined {
  const chain = chainOf(state);
  if (!chain || chain.degree < 2) return undefined;
  const along = index % chain.degree;
  if (along === 1) return state.points[index - 1];
  return along === chain.degree - 1 ? state.points[index + 1] : undefined;
}

/**
 * Beside a joint: the place that makes it C1, or else the nearest on the line that makes it G1, if one is near.
 *
 * @param unitsPerPixel the length of a CSS pixel
 */
export function snapped(state: State, index: number, to: Point2, unitsPerPixel: number): Point2 {
  const chain = chainOf(state);
  if (!chain) return to;
  const { degree, spline } = chain;
  for (let joint = 1; joint < spline.segmentCount; joint++) {
    const [a, b, c] = [-1, 0, 1].map((step) => state.points[joint * degree + step]);
    const places = [smooth(index - joint * degree, a, b, c, to)].flat();
    const found = places.find((place) => Math.hypot(place[0] - to[0], place[1] - to[1]) <= SNAP_PX * unitsPerPixel);
    if (found) return found;
  }
  return to;
}

/**
 * @param step which of the three is moved: −1, 0, 1
 * @returns first C1, then G1
 */
function smooth(step: number, a: Point2, b: Point2, c: Point2, to: Point2): Point2[] {
  if (step === 0) return [[(a[0] + c[0]) / 2, (a[1] + c[1]) / 2], onLine(a, c, to)];
  const other = step === -1 ? c : step === 1 ? a : null;
  return other ? [[2 * b[0] - other[0], 2 * b[1] - other[1]], onLine(other, b, to)] : [];
}

/** The foot of the perpendicular. */
function onLine([x, y]: Point2, through: Point2, to: Point2): Point2 {
  const [dx, dy] = [through[0] - x, through[1] - y];
  const square = dx * dx + dy * dy;
  const along = square > 0 ? ((to[0] - x) * dx + (to[1] - y) * dy) / square : 0;
  return [x + along * dx, y + along * dy];
}
