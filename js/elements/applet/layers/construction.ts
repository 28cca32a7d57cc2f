// How the curve comes from its points: polygon, hull, de Casteljau's construction, the halves.
import * as pen from "../../../applet/pen.js";
import { Curve } from "../../../paths.js";
import { along, faint, hollows, through } from "./sheet.js";
import { hue } from "./theme.js";
import type { Sheet } from "./sheet.js";
import type { Figure } from "../figure.js";
import type { State } from "../state.js";

export const polygon = {
  name: "polygon",
  title: "Control polygon",

  derive({ points, kinds }: Figure) {
    const waits = kinds.indexOf("wait");
    return points.slice(0, waits < 0 ? points.length : waits).flat();
  },

  draw(sheet: Sheet, flat: number[]) {
    through(sheet, flat);
    faint(sheet, pen.POLYGON_OPACITY, () => pen.stroke(sheet, sheet.theme.ink, pen.POLYGON_WIDTH));
  },
};

/** Of the points that hold the curve in: a B-spline's own, else those of the Bézier form. */
export const hull = {
  name: "hull",
  title: "Convex hull",
  costly: true as const,

  derive({ pieces, points }: Figure, { basis }: State) {
    if (basis !== "b-spline") return pieces.map(({ curve }) => curve.hull());
    return pieces.map(({ indices }) => new Curve(indices.map((i) => points[i])).hull());
  },

  draw(sheet: Sheet, hulls: Float64Array[]) {
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
  costly: true as const,

  derive: ({ pieces }: Figure, { t }: State) => pieces.map(({ curve }) => curve.deCasteljau(t)),

  draw(sheet: Sheet, constructions: Float64Array[][], _: Figure, { basis }: State) {
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

/** The control polygon of a curve whose points are nobody's handles. */
function drawOwnPolygon(sheet: Sheet, flat: Float64Array, colour: string) {
  through(sheet, flat);
  pen.stroke(sheet, colour, pen.POLYGON_WIDTH);
  hollows(sheet, flat, colour);
}

export const halves = {
  name: "halves",
  title: "Halves at t",

  derive: ({ pieces }: Figure, { t }: State) => pieces.map(({ curve }) => curve.split(t)),

  draw(sheet: Sheet, pairs: [Curve, Curve][], _figure: Figure, { layers, segment, labels }: State) {
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
