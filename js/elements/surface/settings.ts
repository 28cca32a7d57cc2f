// The attributes as the drawing takes them: an unknown word or a number out of range counts as the default, as in HTML.

export const MODELS = ["teapot", "teacup", "teaspoon", "patch"] as const;
export const SHADINGS = ["smooth", "flat", "normals", "gaussian", "mean", "patches"] as const;
export const PARTS = ["lid", "rim", "body", "handle", "spout", "bottom"] as const;
export const HEIGHTS = ["squashed", "original"] as const;
export const AXES = ["z", "y"] as const;
export const EVALUATIONS = ["cpu", "forward", "gpu"] as const;
export const LAYERS = [
  "surface",
  "mesh",
  "isocurves",
  "tubes",
  "ribbons",
  "net",
  "casteljau",
  "place",
  "derivatives",
  "names",
] as const;

/** Cells along each direction of a patch. */
export const MAX_SEGMENTS = 64;
/** Strips of a patch each way that curves or tubes divide it into. */
export const MAX_LINES = 12;
/** A mesh finer than this on the screen shows nothing more. */
const MIN_PIXELS = 0.05;
/** Of de Casteljau's algorithm: the first row, all rows, the curve across them, its point. */
export const STEPS = 4;

export type Model = (typeof MODELS)[number];
export type Shading = (typeof SHADINGS)[number];
export type Part = (typeof PARTS)[number];
export type Layer = (typeof LAYERS)[number];

export interface Settings {
  model: Model;
  parts: Set<Part>;
  height: "squashed" | "original";
  up: "z" | "y";
  segments: number;
  detail: DetailSettings;
  lines: number;
  shading: Shading;
  layers: Set<Layer>;
  evaluation: "cpu" | "forward" | "gpu";
  u: number;
  v: number;
  step: number;
  swept: boolean;
  probe: number[] | null;
}

/**
 * What makes the mesh as fine as it is: the recursion of the text, or pixels, or a tolerance, or segments, whichever comes
 * first in this order and is there.
 */
export type DetailSettings = { segments: number } | { tolerance: number } | { pixels: number } | { flatness: number };

export type Attributes = Record<
  | "model"
  | "parts"
  | "height"
  | "up"
  | "segments"
  | "tolerance"
  | "pixels"
  | "flatness"
  | "lines"
  | "shading"
  | "show"
  | "evaluation"
  | "u"
  | "v"
  | "step"
  | "swept"
  | "probe",
  unknown
>;

export function settingsOf(given: Attributes): Settings {
  const segments = Math.round(number(given.segments, 1, MAX_SEGMENTS, 12));
  return {
    model: word(given.model, MODELS),
    parts: given.parts === null || given.parts === undefined ? new Set(PARTS) : words(given.parts, PARTS),
    height: word(given.height, HEIGHTS),
    up: word(given.up, AXES),
    segments,
    detail: detailOf(
      segments,
      number(given.tolerance, 0, Number.MAX_VALUE, 0),
      number(given.pixels, MIN_PIXELS, 100, 0),
      number(given.flatness, 0, Number.MAX_VALUE, 0),
    ),
    lines: Math.round(number(given.lines, 1, MAX_LINES, 4)),
    shading: given.shading === "curvature" ? "gaussian" : word(given.shading, SHADINGS),
    layers: words(given.show ?? "surface", LAYERS),
    evaluation: word(given.evaluation, EVALUATIONS),
    u: number(given.u, 0, 1, 0.5),
    v: number(given.v, 0, 1, 0.5),
    step: Math.round(number(given.step, 1, STEPS, STEPS)),
    swept: Boolean(given.swept),
    probe: point(given.probe),
  };
}

function detailOf(segments: number, tolerance: number, pixels: number, flatness: number): DetailSettings {
  return flatness > 0 ? { flatness } : pixels > 0 ? { pixels } : tolerance > 0 ? { tolerance } : { segments };
}

/**
 * @param known the first is the default
 */
function word<Word extends string>(value: unknown, known: readonly Word[]): Word {
  return known.find((each) => each === value) ?? known[0];
}

/**
 * @param value separated by spaces
 */
function words<Word extends string>(value: unknown, known: readonly Word[]): Set<Word> {
  const given = String(value).split(/\s+/);
  return new Set(known.filter((each) => given.includes(each)));
}

function number(value: unknown, least: number, most: number, otherwise: number) {
  const given = value === null || value === undefined || value === "" ? NaN : Number(value);
  return Number.isNaN(given) ? otherwise : Math.min(Math.max(given, least), most);
}

/** Three numbers; anything else is no point. */
function point(value: unknown): number[] | null {
  const numbers = String(value ?? "")
    .split(/[\s,]+/)
    .filter(Boolean)
    .map(Number);
  return numbers.length === 3 && numbers.every(Number.isFinite) ? numbers : null;
}

/** A list of words as an attribute holds it, with one of them put in or taken out. */
export function toggled<Word extends string>(
  chosen: Set<Word>,
  known: readonly Word[],
  each: Word,
  on: boolean,
): string {
  return known.filter((one) => (one === each ? on : chosen.has(one))).join(" ");
}
