// What is measured on the curve: the point nearest to the pointer, the parallel, ticks of equal length.
import { SCAFFOLD_WIDTH, stroke, TANGENT_WIDTH } from "../../../applet/pen.js";
import { strokesAcross } from "./base.js";
import { short } from "./features.js";
import { along, dashed, hollows, lines } from "./sheet.js";
import { ways } from "./ways.js";

/** @typedef {import("../../../index.js").Curve} Curve */
/** @typedef {import("./sheet.js").Sheet} Sheet */
/** @typedef {import("../figure.js").Figure} Figure */
/** @typedef {import("../state.js").State} State */
/** @typedef {{ t: number, point: { x: number, y: number }, distance: number }} Found */

export const nearest = {
  name: "nearest",
  title: "Nearest to the pointer",

  /**
   * @param {Figure} figure
   * @param {State} state
   * @returns {{ pointer: readonly number[], found: Found, pieces: number } | null}
   */
  derive({ pieces, spline }, { pointer }) {
    if (!pointer || !pieces.length) return null;
    const all = spline ? [spline.nearest(pointer)] : pieces.map(({ curve }, k) => behind(curve.nearest(pointer), k));
    const found = all.reduce((best, each) => (each.distance < best.distance ? each : best));
    return { pointer, found, pieces: pieces.length };
  },

  /**
   * @param {Sheet} sheet
   * @param {{ pointer: number[], found: Found } | null} data
   */
  draw(sheet, data) {
    if (!data) return;
    const { x, y } = data.found.point;
    lines(sheet, [...data.pointer, x, y]);
    dashed(sheet, sheet.theme.ink, TANGENT_WIDTH);
    hollows(sheet, [x, y], sheet.theme.ink);
  },

  /** @param {{ found: Found, pieces: number } | null} data */
  tell(data) {
    if (!data) return "Nearest point: point at a place of the picture";
    const { t, distance } = data.found;
    const k = Math.min(Math.floor(t), data.pieces - 1);
    const where = data.pieces > 1 ? `${(t - k).toFixed(3)} on piece ${k + 1}` : t.toFixed(3);
    return `Nearest point: t = ${where}, ${short(distance)} px away`;
  },
};

/**
 * @param {Found} found
 * @param {number} k
 * @returns {Found} with t as a spline counts it
 */
function behind(found, k) {
  return { ...found, t: found.t + k };
}

/** The parallel is right to this share of a pixel, but not to more than this in the plane. */
const OFFSET_PX = 0.05;
const FINEST_OFFSET = 1e-6;

export const offset = {
  name: "offset",
  title: "Offset curve",
  costly: /** @type {const} */ (true),

  /**
   * @param {Figure} figure
   * @param {State} state
   */
  derive({ pieces, spline }, { offset, view, box }) {
    const tolerance = Math.max((OFFSET_PX * view.width) / box.width, FINEST_OFFSET);
    const splines = spline
      ? [spline.offset(offset, { tolerance })]
      : pieces.map(({ curve }) => curve.offset(offset, { tolerance }));
    return { curves: splines.flatMap((each) => each.segments()), distance: offset };
  },

  /**
   * @param {Sheet} sheet
   * @param {{ curves: Curve[] }} data
   */
  draw(sheet, { curves }) {
    along(sheet, curves);
    stroke(sheet, sheet.theme.level1, SCAFFOLD_WIDTH);
  },

  /** @param {{ curves: Curve[], distance: number }} data */
  tell: ({ curves, distance }) =>
    `Offset curve at ${short(distance)} px: ${curves.length === 1 ? "one piece" : `${curves.length} pieces`}`,
};

const TICK_HALF = 7;

export const ticks = {
  name: "ticks",
  title: "Equal lengths",
  costly: /** @type {const} */ (true),

  /**
   * @param {Figure} figure
   * @param {State} state
   */
  derive({ pieces, spline }, { ticks }) {
    if (!spline)
      return {
        across: pieces.flatMap(({ curve }) => [...ways(curve, curve.equidistantTimes(ticks))]),
        length: null,
        ticks,
      };
    const ts = spline.equidistantTimes(ticks);
    const across = pieces.flatMap(({ curve }, k) => {
      const last = k === pieces.length - 1;
      const own = ts.filter((t) => t >= k && (last || t < k + 1)).map((t) => t - k);
      return own.length ? [...ways(curve, own)] : [];
    });
    return { across, length: spline.length(), ticks };
  },

  /**
   * @param {Sheet} sheet
   * @param {{ across: number[] }} data points and unit tangents
   */
  draw(sheet, { across }) {
    const strokes = across.map((value, i) => (i % 4 === 2 ? -across[i + 1] : i % 4 === 3 ? across[i - 1] : value));
    strokesAcross(sheet, strokes, TICK_HALF);
    stroke(sheet, sheet.theme.ink, TANGENT_WIDTH);
  },

  /** @param {{ length: number | null, ticks: number }} data */
  tell: ({ length, ticks }) =>
    length === null ? "" : `Length ${short(length)} px, a tick every ${short(length / ticks)} px`,
};
