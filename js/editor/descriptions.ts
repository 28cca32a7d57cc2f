// What `<bezier-applet>` says.
import { actionOf } from "./actions.js";
import { modesOf } from "./commands.js";
import type { ActionName } from "./actions.js";
import { BASIS_NAMES } from "./state.js";
import { translated, translatedTable } from "./translations.js";
import type { State, JointMode } from "./state.js";
import type { Continuity, Figure } from "./figure.js";
import type { Curve } from "../index.js";

export const MODE_NAMES: Record<JointMode, string> = /* @__PURE__ */ translatedTable({
  free: "free",
  g1: "G1",
  c1: "C1",
  c2: "C2",
  g2: "G2",
  auto: "automatic",
});

export const instructions = () =>
  translated(
    "Every control point is a pair of sliders, x and y. Tab goes from point to point in the order of the curve. " +
      "The arrow keys move a point by 1 pixel, with Shift by 10, with Alt by a tenth. A question mark lists all keys.",
  );

const helpOf = (...names: ActionName[]) =>
  names.flatMap((name) => {
    const help = actionOf(name).help?.();
    return help ? [help] : [];
  });

/**
 * All keys and what they do.
 *
 * @param weights whether there are weights
 */
export const keyList = (weights = false): (readonly [string, string])[] => [
  ["Tab", translated("next point")],
  ["← ↑ → ↓", translated("move the point by 1, with Shift by 10, with Alt by 0.1")],
  ...(weights
    ? [["← →", translated("at a weight: smaller or larger by 5 %, with Shift ten times, with Alt a tenth")] as const]
    : []),
  ["Enter", translated("at a joint: hold it another way")],
  ["Delete", translated("take the point away, the curve heals; with Shift only the point")],
  ...helpOf("insert", "undo", "redo", "randomize", "toggle"),
  ["Esc", translated("take the drag back")],
  ["?", translated("this list")],
  [translated("Shift while dragging"), translated("steps of 15°")],
  [translated("Alt while dragging"), translated("break the joint")],
  [translated("Ctrl while dragging"), translated("no snapping; Ctrl and the wheel zoom")],
];

const RADIAN_IN_DEGREES = 180 / Math.PI;

export interface JointFacts {
  /** What is true: C0, G1, C1, G2, C2 */
  verdict: string;
  /** By which the tangent turns */
  angle: string;
  /** Of the two tangents' lengths */
  ratio: string;
  /** The point's name, or the joint's number */
  at: string;
}

/**
 * What is true at a joint now.
 *
 * @param joint from 1
 */
export function jointFacts({ pieces, names }: Figure, joint: number, continuity: Continuity): JointFacts {
  const shared = pieces[joint - 1].indices.at(-1);
  const isPoint = shared !== undefined && shared === pieces[joint].indices[0];
  return {
    verdict: verdictOf(continuity),
    angle: continuity.g1 ? "0°" : degrees(continuity.angle), // rounding is no turn
    ratio: ratioOf(leg(pieces[joint - 1].curve, false), leg(pieces[joint].curve, true)),
    at: isPoint ? names[shared] : translated("joint {0}", joint),
  };
}

function verdictOf({ c0, g1, c1, g2, c2 }: Continuity) {
  if (c2) return "C2";
  return [c1 && "C1", g2 && "G2"].filter(Boolean).join(" ") || (g1 ? "G1" : c0 ? "C0" : "open");
}

/** The length of the derivative at an end. */
function leg(curve: Curve, start: boolean) {
  const flat = curve.controlPoints();
  const [x0, y0, x1, y1] = start ? flat : flat.subarray(-4);
  return curve.degree * Math.hypot(x1 - x0, y1 - y0);
}

function ratioOf(before: number, after: number) {
  return before > 0 && after > 0
    ? `1 : ${Number((after / before).toPrecision(3))}`
    : translated("no length on one side");
}

/** Two digits at least, so that a small angle does not read as none. */
function degrees(radians: number) {
  if (!Number.isFinite(radians)) return translated("no tangent");
  const value = Math.abs(radians) * RADIAN_IN_DEGREES;
  return `${value >= 10 ? Math.round(value) : Number(value.toPrecision(2))}°`;
}

export function jointWords({ angle, ratio }: JointFacts) {
  return translated("turns by {0}, tangents {1}", angle, ratio);
}

export const placeWords = ([x, y]: readonly number[]): string => `${rounded(x)}, ${rounded(y)}`;

const rounded = (x: number) => Number(x.toFixed(1));

/** Weights range over powers of ten. */
export const weightWords = (weight: number): string => String(Number(weight.toPrecision(4)));

/** A description reads out no more points than this. */
const MAX_NAMED = 24;

/**
 * The picture in words.
 *
 * @param messages those of the layers
 */
export function description(state: State, figure: Figure, joints: readonly JointFacts[], messages: readonly string[]) {
  const { pieces, rational, points, names, kinds, degree } = figure;
  const kind = rational.length
    ? rational.length === 1
      ? translated("1 rational Bézier curve of degree {0}", degree)
      : translated("{0} rational Bézier curves of degree {1}", rational.length, degree)
    : state.basis === "bezier"
      ? pieces.length === 1
        ? translated("1 Bézier curve of degree {0}", degree)
        : translated("{0} Bézier curves of degree {1}", pieces.length, degree)
      : `${pieces.length} ${BASIS_NAMES[state.basis]}`;
  const places = points.slice(0, MAX_NAMED).map((point, i) => {
    const at = placeWords(point);
    return kinds[i] === "off"
      ? translated("{0} at {1}, off the curve", names[i], at)
      : translated("{0} at {1}", names[i], at);
  });
  const more = points.length - MAX_NAMED;
  const modes = modesOf(state);
  return [
    pieces.length + rational.length ? kind : translated("Too few points for a curve"),
    [...places, ...(more > 0 ? [translated("and {0} more", more)] : [])].join("; "),
    ...joints.map((facts, k) => {
      const { at, verdict } = facts;
      const held = modes[k] && modes[k] !== "free" && MODE_NAMES[modes[k]];
      return held
        ? translated("At {0}: {1}, {2}, held {3}", at, verdict, jointWords(facts), held)
        : translated("At {0}: {1}, {2}", at, verdict, jointWords(facts));
    }),
    translated("t is {0}", state.t.toFixed(2)),
    ...messages,
  ].join(". ");
}
