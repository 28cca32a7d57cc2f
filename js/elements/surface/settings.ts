// The attributes as the drawing takes them. The last valid value stays in effect where a new one is invalid.

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
  /** Undefined for what is invalid */
  read: (value: unknown) => T | undefined;
  /** What is valid, for messages */
  expected: string;
}

/** All attributes that change the scene. */
export const OPTIONS: { [Name in keyof Checked]: Option<Checked[Name]> } = {
  model: word(MODELS),
  parts: words(PARTS, PARTS, null),
  height: word(HEIGHTS),
  up: word(AXES),
  segments: whole(1, MAX_SEGMENTS, 12),
  tolerance: positive(),
  pixels: { ...number<number | null>(MIN_PIXELS, 100, null), expected: `a number from ${MIN_PIXELS} to 100` },
  flatness: positive(),
  lines: whole(1, MAX_LINES, 4),
  shading: word([...SHADINGS, "curvature"]),
  show: words(LAYERS, ["surface"], "surface"),
  evaluation: word(EVALUATIONS),
  u: number(0, 1, 0.5),
  v: number(0, 1, 0.5),
  step: whole(1, STEPS, STEPS),
  swept: { type: Boolean, property: false, initial: false, read: Boolean, expected: "true or false" },
  probe: { type: String, property: null, initial: null, read: pointOf, expected: "three numbers" },
};

export const ATTRIBUTE_NAMES = Object.keys(OPTIONS) as (keyof Attributes)[];

/** Checks the attributes of one element and keeps the last valid value of each. */
export class SettingsReader {
  #valid: Record<string, unknown> = {};
  /** The invalid values that were reported. */
  #invalid: Map<string, unknown> = new Map();
  #report: (problem: string) => void;

  constructor(report: (problem: string) => void) {
    this.#report = report;
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

  #check(name: string, { initial, read, expected }: Option<unknown>, value: unknown) {
    const valid = value === null || value === undefined ? initial : read(value);
    if (valid !== undefined) {
      this.#valid[name] = valid;
      this.#invalid.delete(name);
      return;
    }
    this.#valid[name] ??= initial;
    if (!this.#invalid.has(name) || !Object.is(this.#invalid.get(name), value)) {
      this.#invalid.set(name, value);
      this.#report(`${name}: expected ${expected}, got ${typeof value === "string" ? `"${value}"` : value}`);
    }
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
  return {
    type: String,
    property: known[0],
    initial: known[0],
    read: (value) => known.find((each) => each === value),
    expected: known.join(", "),
  };
}

/** A list of words, separated by spaces. */
function words<Word extends string>(
  known: readonly Word[],
  initial: readonly Word[],
  property: string | null,
): Option<Set<Word>> {
  return {
    type: String,
    property,
    initial: new Set(initial),
    read: (value) => {
      const given = String(value).split(/\s+/).filter(Boolean);
      const isKnown = given.every((each) => known.some((one) => one === each));
      return isKnown ? new Set(known.filter((each) => given.includes(each))) : undefined;
    },
    expected: `some of the words ${known.join(", ")}`,
  };
}

function number<T extends number | null>(min: number, max: number, initial: T): Option<T | number> {
  return {
    type: Number,
    property: initial,
    initial,
    read: (value) => {
      const given = value === "" ? NaN : Number(value);
      return given >= min && given <= max ? given : undefined;
    },
    expected: `a number from ${min} to ${max}`,
  };
}

/** Rounded to a whole number. */
function whole(min: number, max: number, initial: number): Option<number> {
  const { read, ...option } = number(min, max, initial);
  return {
    ...option,
    read: (value) => {
      const given = read(value);
      return given === undefined ? undefined : Math.round(given);
    },
  };
}

/** A positive number, or 0 or null for none. */
function positive(): Option<number | null> {
  return { ...number<number | null>(0, Number.MAX_VALUE, null), expected: "a positive number" };
}

/** Three numbers. */
function pointOf(value: unknown): number[] | null | undefined {
  const numbers = String(value)
    .split(/[\s,]+/)
    .filter(Boolean)
    .map(Number);
  if (numbers.length === 0) return null;
  return numbers.length === 3 && numbers.every(Number.isFinite) ? numbers : undefined;
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
