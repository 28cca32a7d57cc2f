// How the curve comes from its points: polygon, hull, de Casteljau's construction, the halves.
import * as pen from "../../../applet/pen.js";
import { Curve } from "../../../paths.js";
import { along, faint, hollows, through } from "./sheet.js";
import { hue } from "./theme.js";

/** @typedef {import("./sheet.js").Sheet} Sheet */
/** @typedef {import("../figure.js").Figure} Figure */
/** @typedef {import("../state.js").State} State */

export const polygon = {
  name: "polygon",
  title: "Control polygon",

  /** @param {Figure} figure */
  derive({ points, kinds }) {
    const waits = kinds.indexOf("wait");
    return points.slice(0, waits < 0 ? points.length : waits).flat();
  },

  /**
   * @param {Sheet} sheet
   * @param {number[]} flat
   */
  draw(sheet, flat) {
    through(sheet, flat);
    faint(sheet, pen.POLYGON_OPACITY, () => pen.stroke(sheet, sheet.theme.ink, pen.POLYGON_WIDTH));
  },
};

/** Of the points that hold the curve in: a B-spline's own, else those of the Bézier form. */
export const hull = {
  name: "hull",
  title: "Convex hull",
  costly: /** @type {const} */ (true),

  /**
   * @param {Figure} figure
   * @param {State} state
   */
  derive({ pieces, points }, { basis }) {
    if (basis !== "b-spline") return pieces.map(({ curve }) => curve.hull());
    return pieces.map(({ indices }) => new Curve(indices.map((i) => points[i])).hull());
  },

  /**
   * @param {Sheet} sheet
   * @param {Float64Array[]} hulls
   */
  draw(sheet, hulls) {
    for (const flat of hulls) {
      sheet.lens.polygon(flat);
      pen.tint(sheet, sheet.theme.curve);
    }
  },
};

/** Above this degree the points of the construction would hide it. */
const MOST_HOLLOWS_DEGREE = 12;

/** Every level between the control points and the point at t, each with its hue. */
export const construction = {
  name: "construction",
  title: "De Casteljau at t",
  costly: /** @type {const} */ (true),

  /**
   * @param {Figure} figure
   * @param {State} state
   */
  derive: ({ pieces }, { t }) => pieces.map(({ curve }) => curve.deCasteljau(t)),

  /**
   * @param {Sheet} sheet
   * @param {Float64Array[][]} constructions
   * @param {Figure} _
   * @param {State} state
   */
  draw(sheet, constructions, _, { basis }) {
    for (const levels of constructions) {
      if (basis !== "bezier") drawOwnPolygon(sheet, levels[0], sheet.theme.quiet);
      levels.slice(1, -1).forEach((level, i) => {
        const colour = hue(sheet.theme, i + 1);
        through(sheet, level);
        pen.stroke(sheet, colour, pen.SCAFFOLD_WIDTH);
        if (levels.length <= MOST_HOLLOWS_DEGREE + 1) hollows(sheet, level, colour);
      });
    }
  },
};

/**
 * The control polygon of a curve whose points are nobody's handles.
 *
 * @param {Sheet} sheet
 * @param {Float64Array} flat
 * @param {string} colour
 */
function drawOwnPolygon(sheet, flat, colour) {
  through(sheet, flat);
  pen.stroke(sheet, colour, pen.POLYGON_WIDTH);
  hollows(sheet, flat, colour);
}

export const halves = {
  name: "halves",
  title: "Halves at t",

  /**
   * @param {Figure} figure
   * @param {State} state
   */
  derive: ({ pieces }, { t }) => pieces.map(({ curve }) => curve.split(t)),

  /**
   * @param {Sheet} sheet
   * @param {[Curve, Curve][]} pairs
   * @param {Figure} _figure
   * @param {State} state
   */
  draw(sheet, pairs, _figure, { layers, segment, labels }) {
    const { theme } = sheet;
    along(
      sheet,
      pairs.map(([first]) => first),
    );
    pen.stroke(sheet, theme.first, pen.HALF_WIDTH);
    along(
      sheet,
      pairs.map(([, second]) => second),
    );
    pen.stroke(sheet, theme.second, pen.HALF_WIDTH);
    if (!layers.has("names") || labels === "none" || layers.has("construction")) return;
    const named = pairs[Math.min(segment, pairs.length - 1)] ?? [];
    named.forEach((half, side) => drawOwnPolygon(sheet, half.controlPoints(), side ? theme.second : theme.first));
  },
};
