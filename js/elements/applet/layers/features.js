// Places of the curve that stand out: its exact box, extrema, inflections.
import { POLYGON_WIDTH, stroke, TANGENT_WIDTH } from "../../../applet/pen.js";
import { strokesAcross } from "./base.js";
import { dashed, hollows } from "./sheet.js";
import { ways } from "./ways.js";

/** @typedef {import("../../../index.js").Curve} Curve */
/** @typedef {import("./sheet.js").Sheet} Sheet */
/** @typedef {import("../figure.js").Figure} Figure */

const EXTREMUM_HALF = 26;
const INFLECTION_HALF = 10;

export const bounds = {
  name: "bounds",
  title: "Exact boxes",
  costly: /** @type {const} */ (true),

  /** @param {Figure} figure */
  derive: ({ pieces }) => ({
    boxes: pieces.map(({ curve }) => curve.bounds()),
    touches: pieces.flatMap(({ curve }) => extremaOf(curve).points),
  }),

  /**
   * @param {Sheet} sheet
   * @param {{ boxes: ReturnType<Curve["bounds"]>[], touches: number[] }} data
   */
  draw(sheet, { boxes, touches }) {
    for (const { min, max } of boxes) {
      sheet.lens.polygon([min.x, min.y, max.x, min.y, max.x, max.y, min.x, max.y]);
      dashed(sheet, sheet.theme.quiet, POLYGON_WIDTH);
    }
    hollows(sheet, touches, sheet.theme.quiet);
  },

  /** @param {{ boxes: ReturnType<Curve["bounds"]>[] }} data */
  tell({ boxes }) {
    const range = (/** @type {"x" | "y"} */ axis) =>
      `${axis} from ${short(Math.min(...boxes.map(({ min }) => min[axis])))} to ${short(Math.max(...boxes.map(({ max }) => max[axis])))}`;
    return boxes.length ? `Exact box: ${range("x")}, ${range("y")}` : "";
  },
};

export const extrema = {
  name: "extrema",
  title: "Extrema",
  costly: /** @type {const} */ (true),

  /** @param {Figure} figure */
  derive({ pieces }) {
    const found = pieces.map(({ curve }) => extremaOf(curve));
    return {
      points: found.flatMap(({ points }) => points),
      strokes: found.flatMap(({ strokes }) => strokes),
      ts: found.map(({ ts }) => ts),
    };
  },

  /**
   * @param {Sheet} sheet
   * @param {{ points: number[], strokes: number[] }} data
   */
  draw(sheet, { points, strokes }) {
    strokesAcross(sheet, strokes, EXTREMUM_HALF);
    stroke(sheet, sheet.theme.level1, TANGENT_WIDTH);
    hollows(sheet, points, sheet.theme.level1);
  },

  /** @param {{ ts: number[][] }} data */
  tell: ({ ts }) => list("Extrema", ts),
};

/**
 * Inner extrema of x, then of y.
 *
 * @param {Curve} curve
 * @returns {{ ts: number[], points: number[], strokes: number[] }} `strokes`: the points with the directions of their tangents
 */
export function extremaOf(curve) {
  const { x, y } = curve.extrema();
  const ts = [...x, ...y];
  const points = [...curve.evalAt(ts)];
  const strokes = ts.flatMap((_, k) => [points[2 * k], points[2 * k + 1], ...(k < x.length ? [0, 1] : [1, 0])]);
  return { ts, points, strokes };
}

export const inflections = {
  name: "inflections",
  title: "Inflections",
  costly: /** @type {const} */ (true),

  /** @param {Figure} figure */
  derive({ pieces }) {
    const ts = pieces.map(({ curve }) => [...curve.inflections()]);
    const across = pieces.flatMap(({ curve }, k) => [...ways(curve, ts[k])]);
    return { ts, across, kinds: pieces.map(({ curve }) => curve.classify()) };
  },

  /**
   * A stroke along the curve's normal, and a hollow mark.
   *
   * @param {Sheet} sheet
   * @param {{ across: number[] }} data
   */
  draw(sheet, { across }) {
    const strokes = across.map((value, i) => (i % 4 === 2 ? -across[i + 1] : i % 4 === 3 ? across[i - 1] : value));
    strokesAcross(sheet, strokes, INFLECTION_HALF);
    stroke(sheet, sheet.theme.level2, 2);
    hollows(
      sheet,
      across.filter((_, i) => i % 4 < 2),
      sheet.theme.level2,
    );
  },

  /** @param {{ ts: number[][], kinds: string[] }} data */
  tell: ({ ts, kinds }) => (kinds.length ? `${list("Inflections", ts)} (${few(kinds).join(", ")})` : ""),
};

/** More than these are not listed. */
const MOST_LISTED = 6;

/**
 * @param {string} what
 * @param {number[][]} ts of each piece
 */
function list(what, ts) {
  const all = ts.flatMap((each, k) =>
    each.map((t) => (ts.length > 1 ? `${t.toFixed(3)} on piece ${k + 1}` : t.toFixed(3))),
  );
  return all.length ? `${what} at t = ${few(all).join(", ")}` : `${what}: none inside`;
}

/** @param {string[]} all */
function few(all) {
  return all.length > MOST_LISTED ? [...all.slice(0, MOST_LISTED), "…"] : all;
}

/** @param {number} value */
export function short(value) {
  return String(Math.round(10 * value) / 10);
}
