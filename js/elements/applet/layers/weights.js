// How much each point counts at t: discs whose areas are the weights.
import { RIM_WIDTH, stroke } from "../../../applet/pen.js";
import { Curve } from "../../../paths.js";
import { isSeen } from "./sheet.js";

/** @typedef {import("./sheet.js").Sheet} Sheet */
/** @typedef {import("../figure.js").Figure} Figure */
/** @typedef {import("../figure.js").Piece} Piece */
/** @typedef {import("../state.js").State} State */

/** The radius of a disc of weight 1, in CSS pixels. */
const WHOLE_RADIUS = 34;
const OPACITY = 0.22;
/** Smaller ones read 0.00. */
const LEAST_READ = 0.005;

export const weights = {
  name: "weights",
  title: "Weights at t",

  /**
   * @param {Figure} figure
   * @param {State} state
   */
  derive: (figure, state) => weightsAt(figure, state),

  /**
   * @param {Sheet} sheet
   * @param {ReturnType<typeof weightsAt>} data
   */
  draw(sheet, { flat, values }) {
    values.forEach((value, i) => drawDisc(sheet, flat[2 * i], flat[2 * i + 1], value));
  },

  /** @param {ReturnType<typeof weightsAt>} data */
  tell: ({ values }) => (values.length ? `Weights at t: ${[...values].map(read).join(", ")}` : ""),
};

/**
 * The points of the selected piece and their weights, which sum to the point at t.
 *
 * @param {Figure} figure
 * @param {State} state
 * @returns {{ flat: ArrayLike<number>, values: ArrayLike<number> & { map: Function, forEach: (each: (value: number, i: number) => void) => void, length: number } & Iterable<number> }}
 */
export function weightsAt(figure, { basis, segment, t }) {
  const piece = selected(figure, segment);
  if (!piece) return { flat: [], values: [] };
  const own = () => piece.indices.flatMap((i) => figure.points[i]);
  if (figure.matrix) return { flat: own(), values: blend(figure.matrix, t) };
  if (basis === "b-spline") return { flat: own(), values: uniformBSpline(figure.degree, t) };
  return { flat: piece.curve.controlPoints(), values: Curve.bernstein(piece.curve.degree, t) };
}

/**
 * @param {Figure} figure
 * @param {number} segment
 * @returns {Piece | undefined}
 */
export function selected({ pieces }, segment) {
  return pieces[Math.min(segment, pieces.length - 1)];
}

/**
 * [t³ t² t 1]·M.
 *
 * @param {ArrayLike<number>} m
 * @param {number} t
 */
function blend(m, t) {
  return [0, 1, 2, 3].map((k) => ((m[k] * t + m[4 + k]) * t + m[8 + k]) * t + m[12 + k]);
}

/**
 * The blending functions of the uniform B-spline, by the recursion of Cox and de Boor: t in the window's own span.
 *
 * @param {number} degree
 * @param {number} t
 * @returns {number[]} the oldest point's first
 */
function uniformBSpline(degree, t) {
  let values = [1];
  for (let d = 1; d <= degree; d++) {
    const next = new Array(d + 1).fill(0);
    values.forEach((value, j) => {
      const share = (t + d - 1 - j) / d;
      next[j] += (1 - share) * value;
      next[j + 1] += share * value;
    });
    values = next;
  }
  return values;
}

/**
 * A negative weight is a hollow disc: it pushes the curve away.
 *
 * @param {Sheet} sheet
 * @param {number} x
 * @param {number} y
 * @param {number} value
 */
function drawDisc(sheet, x, y, value) {
  const { ctx, theme, px } = sheet;
  const at = sheet.lens.place(x, y);
  if (!isSeen(sheet, at)) return;
  const colour = value < 0 ? theme.handle : theme.curve;
  ctx.beginPath();
  ctx.arc(at[0], at[1], WHOLE_RADIUS * Math.sqrt(Math.min(Math.abs(value), MOST_DRAWN)) * px, 0, 2 * Math.PI);
  ctx.globalAlpha = value < 0 ? 0 : OPACITY;
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.globalAlpha = 1;
  stroke(sheet, colour, RIM_WIDTH);
  if (Math.abs(value) >= LEAST_READ)
    sheet.words.push({ text: read(value), at, away: [0, 1], gap: NUMBER_DISTANCE, rank: 1 });
}

/** Outside of [0, 1] weights of high degrees are larger than any picture. */
const MOST_DRAWN = 9;
const NUMBER_DISTANCE = 19;

/** @param {number} value */
function read(value) {
  return (Math.abs(value) < 1000 ? value.toFixed(2) : value.toExponential(1)).replace("-", "−");
}
