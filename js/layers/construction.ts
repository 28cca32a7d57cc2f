// How the curve comes from its points: polygon, hull, de Casteljau's construction, the halves.
import * as pen from "../ui/pen.js";
import { Curve } from "../geometry/curve/curve.js";
import { along, faint, hollows, through } from "./draw-context.js";
import { hue } from "./theme.js";
import { translated } from "../editor/translations.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { State } from "../editor/state.js";

export const polygon = {
  name: "polygon",
  title: () => translated("Control polygon"),

  derive({ points, kinds }: Figure) {
    const waits = kinds.indexOf("wait");
    return points.slice(0, waits < 0 ? points.length : waits).flat();
  },

  draw(context: DrawContext, flat: number[]) {
    through(context, flat);
    faint(context, pen.POLYGON_OPACITY, () => pen.stroke(context, context.theme.ink, pen.POLYGON_WIDTH));
  },
};

/** Of the points that hold the curve in: a B-spline's own, else those of the Bézier form. */
export const hull = {
  name: "hull",
  title: () => translated("Convex hull"),
  costly: true as const,

  derive({ pieces, points }: Figure, { basis }: State) {
    if (basis !== "b-spline") return pieces.map(({ curve }) => curve.hull());
    return pieces.map(({ indices }) => new Curve(indices.map((i) => points[i])).hull());
  },

  draw(context: DrawContext, hulls: Float64Array[]) {
    for (const flat of hulls) {
      context.lens.polygon(flat);
      pen.tint(context, context.theme.curve);
    }
  },
};

/** Above this degree the points of the construction would hide it. */
const MAX_HOLLOWS_DEGREE = 12;

/** Every level between the control points and the point at t, each with its hue. */
export const construction = {
  name: "construction",
  title: () => translated("De Casteljau at t"),
  costly: true as const,

  derive: ({ pieces }: Figure, { t }: State) => pieces.map(({ curve }) => curve.deCasteljau(t)),

  draw(context: DrawContext, constructions: Float64Array[][], _: Figure, { basis }: State) {
    for (const levels of constructions) {
      if (basis !== "bezier") drawOwnPolygon(context, levels[0], context.theme.quiet);
      levels.slice(1, -1).forEach((level, i) => {
        const colour = hue(context.theme, i + 1);
        through(context, level);
        pen.stroke(context, colour, pen.SCAFFOLD_WIDTH);
        if (levels.length <= MAX_HOLLOWS_DEGREE + 1) hollows(context, level, colour);
      });
    }
  },
};

/** The Bézier polygon of a curve of another basis, whose control points have no handles. */
function drawOwnPolygon(context: DrawContext, flat: Float64Array, colour: string) {
  through(context, flat);
  pen.stroke(context, colour, pen.POLYGON_WIDTH);
  hollows(context, flat, colour);
}

export const halves = {
  name: "halves",
  title: () => translated("Halves at t"),

  derive: ({ pieces }: Figure, { t }: State) => pieces.map(({ curve }) => curve.split(t)),

  draw(context: DrawContext, pairs: [Curve, Curve][], _figure: Figure, { layers, segment, labels }: State) {
    const { theme } = context;
    along(
      context,
      pairs.map(([first]) => first),
    );
    pen.stroke(context, theme.first, pen.HALF_WIDTH);
    along(
      context,
      pairs.map(([, second]) => second),
    );
    pen.stroke(context, theme.second, pen.HALF_WIDTH);
    if (!layers.has("names") || labels === "none" || layers.has("construction")) return;
    const named = pairs[Math.min(segment, pairs.length - 1)] ?? [];
    named.forEach((half, side) => drawOwnPolygon(context, half.controlPoints(), side ? theme.second : theme.first));
  },
};
