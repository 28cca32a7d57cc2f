// The layers of rational curves. Most are those of curves without weights, for which a rational curve gets the methods that these
// layers call; those that would be wrong are left out. This file is loaded for weights only.
import * as pen from "../ui/pen.js";
import { Curve } from "../geometry/curve/curve.js";
import { RationalCurve } from "../nurbs.js";
import { weightWords } from "../editor/descriptions.js";
import { translated } from "../editor/translations.js";
import { weightPoints } from "../editor/weights.js";
import { lines, mark } from "./draw-context.js";
import { ALL_LAYERS } from "./index.js";
import { selected, weights } from "./weights.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { Layer } from "./draw-figure.js";
import type { Piece } from "../editor/figure.js";
import type { State } from "../editor/state.js";

/** Layers whose results are known for polynomials only. */
const POLYNOMIAL = new Set(["tree", "offset", "envelope"]);
/** The least tolerance: of the coordinates that points can have, several units in the last place. */
const FINEST = 1e-9;

/** A rational curve with the methods of `Curve` that layers call. */
class LayerCurve extends RationalCurve<2> {
  /** Every level of de Casteljau's algorithm on the points (wP, w), divided by w. */
  deCasteljau(t: number): Float64Array[] {
    const [flat, weights] = [this.controlPoints(), this.weights()];
    const homogeneous = Array.from(weights, (w, i) => [w * flat[2 * i], w * flat[2 * i + 1], w]);
    return new Curve(homogeneous, { dimension: 3 }).deCasteljau(t).map((level) => {
      const places = new Float64Array((level.length / 3) * 2);
      for (let i = 0; i < level.length / 3; i++) {
        places[2 * i] = level[3 * i] / level[3 * i + 2];
        places[2 * i + 1] = level[3 * i + 1] / level[3 * i + 2];
      }
      return places;
    });
  }

  override split(t: any): any {
    return super.split(t as number).map(layerCurve);
  }

  override subsegment(t0: number, t1: number): LayerCurve {
    return layerCurve(super.subsegment(t0, t1));
  }

  hull() {
    return new Curve(this.controlPoints(), { dimension: 2 }).hull();
  }

  cubics(tolerance: number) {
    return this.toSpline({ tolerance: Math.max(tolerance, FINEST) }).segments();
  }

  derivative() {
    return new Derivative(this, 1);
  }

  equidistantTimes(parts: number) {
    const step = this.length() / parts;
    return Float64Array.from({ length: parts + 1 }, (_, k) => (k === parts ? 1 : this.timeAtLength(k * step)));
  }

  /** The kind of a conic section, by w₁² / (w₀w₂). */
  classify() {
    if (this.degree !== 2) return "rational";
    const [w0, w1, w2] = this.weights();
    const ratio = (w1 * w1) / (w0 * w2);
    return ratio < 1 ? "ellipse" : ratio > 1 ? "hyperbola" : "parabola";
  }
}

/** A derivative of a rational curve, as a function of t. */
class Derivative {
  #curve;
  #order;

  constructor(curve: RationalCurve<2>, order: number) {
    this.#curve = curve;
    this.#order = order;
  }

  evalAt(ts: ArrayLike<number>) {
    return Float64Array.from(
      Array.from(ts).flatMap((t) => {
        const { x, y } = this.#curve.derivativeAt(t, this.#order);
        return [x, y];
      }),
    );
  }

  sample(segments: number) {
    return this.evalAt(Array.from({ length: segments + 1 }, (_, k) => k / segments));
  }

  derivative() {
    return new Derivative(this.#curve, this.#order + 1);
  }
}

function layerCurve(curve: RationalCurve<2>): LayerCurve {
  return new LayerCurve(curve.controlPoints(), curve.weights(), { dimension: 2 });
}

/** A figure whose pieces are its rational ones. */
function withPieces(figure: Figure): Figure {
  const pieces = figure.rational.map(({ curve, indices }) => ({ curve: layerCurve(curve), indices }));
  return { ...figure, pieces: pieces as unknown as Piece[] };
}

/** The rational basis functions wᵢ Bᵢ(t) / Σ wⱼ Bⱼ(t). */
function weightsAt(figure: Figure, { segment, t }: State) {
  const piece = selected(figure, segment);
  if (!piece) return { flat: [], values: [] };
  const curve = piece.curve as unknown as LayerCurve;
  const own = curve.weights();
  const products = Curve.bernstein(curve.degree, t).map((value, i) => value * own[i]);
  const sum = products.reduce((total, each) => total + each, 0);
  return { flat: curve.controlPoints(), values: products.map((each) => each / sum) };
}

/** The radius of the ring of a weight, in CSS pixels. */
const RADIUS = 5.5;
const ROOM = 8;
const DISTANCE = 21;

/** What the weight of a point is called: w1 for P1. */
export const weightName = (name: string) => `w${name.slice(1)}`;

/** The direction across a leg, to the side where the piece's other points are not. */
function outwards([[x0, y0], [x1, y1]]: readonly (readonly [number, number])[], points: Figure["points"]) {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const side = points.reduce((sum, [x, y]) => sum + dx * (y - y0) - dy * (x - x0), 0);
  return pen.unit(side > 0 ? [dy, -dx] : [-dy, dx]);
}

/** The handles of the weights on the legs, and what they are. */
const weightHandles: Layer = {
  derive: (figure) => weightPoints(figure),

  draw(
    context: DrawContext,
    places: [number, number][],
    { points, names, weights, degree }: Figure,
    { layers, labels },
  ) {
    const { ctx, theme, px } = context;
    if (!layers.has("polygon")) {
      const isInner = (i: number) => i % degree > 0 && i % degree < degree - 1; // the others are tangents
      lines(
        context,
        places.flatMap((_, i) => (isInner(i) ? [...points[i], ...points[i + 1]] : [])),
      );
      pen.stroke(context, theme.quiet, pen.POLYGON_WIDTH);
    }
    const piece = (i: number) => i - (i % degree);
    places.forEach(([x, y], i) => {
      const at = mark(context, x, y, ROOM);
      if (!at) return;
      ctx.beginPath();
      ctx.arc(at[0], at[1], RADIUS * px, 0, 2 * Math.PI);
      ctx.fillStyle = theme.paper;
      ctx.fill();
      pen.stroke(context, theme.handle, 2);
      if (labels === "none") return;
      const away = outwards([points[i], points[i + 1]], points.slice(piece(i), piece(i) + degree + 1));
      context.words.push({
        text: `${weightName(names[i + 1])} = ${weightWords(weights?.[i + 1] ?? 1)}`,
        at,
        away,
        gap: DISTANCE,
        rank: 1,
      });
    });
  },

  describe: (_, { weights }) =>
    translated(
      "Weights: {0}; the ring on the leg before a point changes its weight",
      weights.map(weightWords).join(", "),
    ),
};

/** From the back to the front. */
export const RATIONAL_LAYERS: readonly Layer[] = ALL_LAYERS.filter(({ name }) => !POLYNOMIAL.has(name ?? "")).flatMap(
  (layer) => {
    const derive = layer === weights ? weightsAt : layer.derive;
    const rational = { ...layer, derive: (figure: Figure, state: State) => derive(withPieces(figure), state) };
    return layer.name === "names" ? [weightHandles, rational] : [rational]; // below the points, above all lines
  },
);
