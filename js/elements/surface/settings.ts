// The attributes as the drawing takes them. The last valid value stays in effect where a new one is invalid.
import { brief, numberIn, Problems, wordIn } from "../../editor/check.js";

/** Those with weights, which casteljau/nurbs makes. */
export const RATIONAL_MODELS = ["sphere", "torus", "cylinder", "cone"] as const;
export const MODELS = ["teapot", "teacup", "teaspoon", "patch", ...RATIONAL_MODELS] as const;
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
/** The smallest tolerance in pixels: a finer mesh looks the same. */
const MIN_PIXELS = 0.05;
/** Of de Casteljau's algorithm: the first row, all rows, the curve across them, its point. */
export const STEPS = 4;

export type Model = (typeof MODELS)[number];
export type RationalModel = (typeof RATIONAL_MODELS)[number];

export const isRational = (model: Model): model is RationalModel =>
  (RATIONAL_MODELS as readonly string[]).includes(model);
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

/** What the attributes say, checked one by one: the settings, but for those that are made of other attributes. */
interface Checked extends Omit<Settings, "detail" | "layers" | "shading"> {
  tolerance: number | null;
  pixels: number | null;
  flatness: number | null;
  shading: Shading | "curvature";
  show: Set<Layer>;
}
export type Attributes = Record<keyof Checked, unknown>;

/** One attribute and its property. */
interface Option<T> {
  /** Of which the property is, as Lit has it */
  type: unknown;
  /** The value of the property without the attribute */
  property: unknown;
  /** What it means */
  initial: T;
  /** Refuses with a RangeError or TypeError that names the attribute */
  check: (value: unknown, name: string) => T;
}

/** All attributes that change the scene. */
export const OPTIONS: { [Name in keyof Checked]: Option<Checked[Name]> } = {
  model: word(MODELS),
  parts: words(PARTS, PARTS, null),
  height: word(HEIGHTS),
  up: word(AXES),
  segments: whole(1, MAX_SEGMENTS, 12),
  tolerance: positive(),
  pixels: number<number | null>(MIN_PIXELS, 100, null),
  flatness: positive(),
  lines: whole(1, MAX_LINES, 4),
  shading: word([...SHADINGS, "curvature"]),
  show: words(LAYERS, ["surface"], "surface"),
  evaluation: word(EVALUATIONS),
  u: number(0, 1, 0.5),
  v: number(0, 1, 0.5),
  step: whole(1, STEPS, STEPS),
  swept: { type: Boolean, property: false, initial: false, check: Boolean },
  probe: { type: String, property: null, initial: null, check: pointIn },
};

export const ATTRIBUTE_NAMES = Object.keys(OPTIONS) as (keyof Attributes)[];

/** Checks the attributes of one element and keeps the last valid value of each. */
export class SettingsReader {
  #valid: Record<string, unknown> = {};
  #problems;

  /** @param report is called with what is wrong with an attribute */
  constructor(report: (problem: string) => void) {
    this.#problems = new Problems(report);
  }

  read(given: Attributes): Settings {
    for (const name of ATTRIBUTE_NAMES) this.#check(name, OPTIONS[name], given[name]);
    const { show, tolerance, pixels, flatness, shading, ...plain } = this.#valid as unknown as Checked;
    const detail = flatness ? { flatness } : pixels ? { pixels } : tolerance ? { tolerance } : null;
    return {
      ...plain,
      detail: detail ?? { segments: plain.segments },
      shading: shading === "curvature" ? "gaussian" : shading,
      layers: show,
    };
  }

  #check(name: string, { initial, check }: Option<unknown>, value: unknown) {
    this.#valid[name] ??= initial;
    this.#problems.attempt(name, () => {
      this.#valid[name] = value === null || value === undefined ? initial : check(value, name);
    });
  }
}

/** The settings of attributes that were never different. */
export function settingsOf(given: Attributes): Settings {
  return new SettingsReader(() => {}).read(given);
}

/**
 * @param known the first is the default
 */
function word<Word extends string>(known: readonly Word[]): Option<Word> {
  return { type: String, property: known[0], initial: known[0], check: (value, name) => wordIn(value, name, known) };
}

/** A list of words, separated by spaces. */
function words<Word extends string>(
  known: readonly Word[],
  initial: readonly Word[],
  property: string | null,
): Option<Set<Word>> {
  const check = (value: unknown, name: string) => {
    const given = String(value).split(/\s+/).filter(Boolean);
    given.forEach((each, k) => wordIn(each, `${name}[${k}]`, known));
    return new Set(known.filter((each) => given.includes(each)));
  };
  return { type: String, property, initial: new Set(initial), check };
}

function number<T extends number | null>(min: number, max: number, initial: T, expected?: string): Option<T | number> {
  const check = (value: unknown, name: string) =>
    numberIn(value === "" ? NaN : Number(value), name, min, max, expected);
  return { type: Number, property: initial, initial, check };
}

/** A positive number, or 0 or null for none. */
function positive(): Option<number | null> {
  return number<number | null>(0, Number.MAX_VALUE, null, "a positive number");
}

/** Rounded to a whole number. */
function whole(min: number, max: number, initial: number): Option<number> {
  const option = number(min, max, initial);
  return { ...option, check: (value, name) => Math.round(option.check(value, name)) };
}

/** Three numbers, or none. */
function pointIn(value: unknown, name: string): number[] | null {
  const numbers = String(value)
    .split(/[\s,]+/)
    .filter(Boolean)
    .map(Number);
  if (numbers.length === 0) return null;
  if (numbers.length !== 3 || !numbers.every(Number.isFinite))
    throw new RangeError(`${name}: expected three numbers, got ${brief(value)}`);
  return numbers;
}

/** A list of words as an attribute holds it, with one of them put in or taken out. */
export function toggled<Word extends string>(
  selected: Set<Word>,
  known: readonly Word[],
  each: Word,
  on: boolean,
): string {
  return known.filter((one) => (one === each ? on : selected.has(one))).join(" ");
}
