// Each part of the state that can be written: as an attribute (any text), or as JSON (a value).
import { brief, kindOf, numberIn, wholeIn, wordIn } from "./check.js";
import * as states from "./state.js";
import type { State, View } from "./state.js";

export interface Field {
  /** An attribute's text as a value, which `put` checks */
  parse: (text: string) => unknown;
  /** Refuses with a RangeError or TypeError that names the field */
  put: (state: State, value: unknown) => State;
  /** A plain value; null where all points are shown */
  get: (state: State) => unknown;
  /** The value as an attribute */
  write: (state: State) => string;
}

/** A list of words or numbers in an attribute. */
const words = (text: string) => text.split(/[\s,]+/).filter(Boolean);
const trimmed = (text: string) => text.trim();

/** "" and words are no numbers. */
export function numberOf(text: string): number | string {
  const number = text.trim() === "" ? NaN : Number(text);
  return Number.isNaN(number) ? text : number;
}

function list(value: unknown, name: string, count?: number): unknown[] {
  if (!Array.isArray(value)) throw new TypeError(`${name}: expected an array, got ${kindOf(value)}`);
  if (count !== undefined && value.length !== count)
    throw new RangeError(`${name}: expected ${count} numbers, got ${value.length}`);
  return Array.from(value);
}

function field<Name extends keyof State>(
  name: Name,
  check: (value: unknown, state: State) => State[Name],
  more?: Partial<Field>,
): Field {
  return {
    parse: numberOf,
    put: (state, value) => ({ ...state, [name]: check(value, state) }),
    get: (state) => state[name],
    write: (state) => [state[name]].flat().join(" "),
    ...more,
  };
}

const number = (name: "tolerance" | "offset" | "t", min: number, max: number) =>
  field(name, (value) => numberIn(value, name, min, max));
const count = (name: "segments" | "ticks", max: number) => field(name, (value) => wholeIn(value, name, 1, max));

/** The numbers of a view, in the order of the attribute. */
export const VIEW = ["x", "y", "width", "height"] as const;

/** In the order in which they are read: what others depend on comes first. */
export const FIELDS: Record<string, Field> = {
  points: {
    parse: pointsIn,
    put: (state, value) => states.withPoints(state, value),
    get: ({ points }) => points.map(([x, y]) => [x, y]),
    write: ({ points }) => points.map((point) => point.join(",")).join(" "),
  },
  weights: field("weights", (value, { points }) => weightsIn(value, points.length), {
    parse: (text) => words(text).map(numberOf),
    get: ({ weights }) => [...weights],
  }),
  basis: field("basis", (value) => wordIn(value, "basis", states.BASES), { parse: trimmed }),
  matrix: field("matrix", (value) => list(value, "matrix", 16).map((x, i) => numberIn(x, `matrix[${i}]`, -1e6, 1e6)), {
    parse: (text) => words(text).map(numberOf),
    get: ({ matrix }) => [...matrix],
  }),
  degree: field("degree", (value) => (value === "n" ? value : wholeIn(value, "degree", 1, states.MAX_DEGREE)), {
    parse: (text) => (trimmed(text) === "n" ? "n" : numberOf(text)),
  }),
  visiblePoints: {
    parse: (text) => (trimmed(text) === "" ? null : numberOf(text)), // as it is written
    put: (state, value) => ({
      ...state,
      shown: value === null ? state.points.length : wholeIn(value, "visiblePoints", 2, state.points.length),
    }),
    get: ({ points, shown }) => (shown < points.length ? shown : null),
    write: ({ points, shown }) => (shown < points.length ? String(shown) : ""),
  },
  joints: field(
    "joints",
    (value) => list(value, "joints").map((mode, k) => wordIn(mode, `joints[${k}]`, states.MODES)),
    {
      parse: words,
      get: ({ joints }) => [...joints],
    },
  ),
  show: {
    parse: words,
    put: (state, value) =>
      states.withLayers(
        state,
        list(value, "show").map((name, k) => wordIn(name, `show[${k}]`, states.LAYER_NAMES)),
      ),
    get: ({ layers }) => [...layers],
    write: ({ layers }) => [...layers].join(" "),
  },
  t: field("t", (value, state) => numberIn(value, "t", ...states.rangeOfT(state))),
  segment: field("segment", (value) => wholeIn(value, "segment", 0, states.MAX_POINTS)),
  labels: field("labels", (value) => wordIn(value, "labels", states.LABELS), { parse: trimmed }),
  tolerance: number("tolerance", 0.01, 200),
  segments: count("segments", 200),
  offset: number("offset", -500, 500),
  ticks: count("ticks", 200),
  view: {
    parse: (text) => Object.fromEntries(words(text).map((word, i) => [VIEW[i] ?? "more", numberOf(word)])),
    put: (state, value) => states.withView(state, viewIn(value)),
    get: ({ view }) => ({ ...view }),
    write: ({ view }) => VIEW.map((name) => view[name]).join(" "),
  },
};

/** None, or one for each point. */
function weightsIn(value: unknown, count: number): number[] {
  if (Array.isArray(value) && value.length === 0) return [];
  return list(value, "weights", count).map((x, i) =>
    numberIn(x, `weights[${i}]`, states.MIN_WEIGHT, states.MAX_WEIGHT),
  );
}

function viewIn(value: unknown): View {
  if (typeof value !== "object" || value === null || "more" in value)
    throw new TypeError(`view: expected x, y, width and height, got ${kindOf(value)}`);
  const given = value as Record<string, unknown>;
  const [x, y] = [given.x, given.y].map((place, i) => numberIn(place, `${VIEW[i]} of view`, -1e6, 1e6));
  const [width, height] = [given.width, given.height].map((size, i) =>
    numberIn(size, `${VIEW[2 + i]} of view`, Number.MIN_VALUE, 1e6),
  );
  return { x, y, width, height };
}

/** "x,y x,y …": any spaces and commas between the numbers. */
export function pointsIn(text: string): unknown[] {
  const numbers = words(text).map(numberOf);
  if (numbers.length % 2 !== 0)
    throw new RangeError(
      `points: expected pairs of numbers, got ${numbers.length} ${numbers.length === 1 ? `word (${brief(text)})` : "numbers"}`,
    );
  return Array.from({ length: numbers.length / 2 }, (_, i) => {
    const pair = [numbers[2 * i], numbers[2 * i + 1]];
    const wrong = pair.find((x) => typeof x === "string");
    if (wrong !== undefined) throw new RangeError(`points[${i}]: expected numbers, got ${brief(wrong)}`);
    return pair;
  });
}

/** The state as plain data: the points, and what is not as at first. */
export function jsonOf(state: State): Record<string, unknown> {
  const first = states.firstState();
  const entries = Object.entries(FIELDS).filter(
    ([name, { write }]) => name === "points" || write(state) !== write(first),
  );
  return Object.fromEntries(entries.map(([name, { get }]) => [name, get(state)]));
}

/** The state that plain data describes; what it leaves out has its default. */
export function stateOf(json: unknown): State {
  if (typeof json !== "object" || json === null || Array.isArray(json))
    throw new TypeError(`state: expected an object with points, got ${kindOf(json)}`);
  const given = json as Record<string, unknown>;
  return Object.entries(FIELDS).reduce(
    (state, [name, { put }]) => (given[name] === undefined ? state : put(state, given[name])),
    states.firstState(),
  );
}
