// Timing functions as CSS text; src/easing/css.rs reads and writes the same, message for message.
import { describe } from "./check.js";
import { JUMPS } from "./easing-piecewise.js";
import type { StepPosition, Stop } from "./easing-piecewise.js";

/**
 * A timing function in numbers: the handles of cubic-bezier(), the count and the position of steps(), or the stops of
 * linear().
 */
export type Handles = readonly number[];

export type Timing = { handles: Handles } | { count: number; position: StepPosition } | { stops: readonly Stop[] };

const KEYWORDS: Record<string, string> = {
  linear: "linear(0,1)",
  ease: "cubic-bezier(.25,.1,.25,1)",
  "ease-in": "cubic-bezier(.42,0,1,1)",
  "ease-out": "cubic-bezier(0,0,.58,1)",
  "ease-in-out": "cubic-bezier(.42,0,.58,1)",
  "step-start": "steps(1,start)",
  "step-end": "steps(1)",
};
/** Browsers limit the number of steps to this value. */
const MAX_STEPS = 2 ** 31 - 1;

const BLANKS = /(?:[ \t\n\r\f]+|\/\*.*?\*\/)*/sy;
const WORD = /[a-z-]+\(?/iy;
const NUMBER = /[+-]?(\d+(\.\d+)?|\.\d+)(e[+-]?\d+)?%?/iy;
const WHOLE = /^[+-]?\d+$/;
const UP_TO_SEPARATOR = /[^ \t\n\r\f,()]+\(?|./suy;

/** The text of a timing function, read from front to back. */
class Scanner {
  text: string;
  at: number;

  constructor(text: string) {
    this.text = text;
    this.at = 0;
    this.skip("");
  }

  /** The text that a pattern matches here, in lower case; empty if it does not match. */
  peek(pattern: RegExp) {
    pattern.lastIndex = this.at;
    return pattern.exec(this.text)?.[0].toLowerCase() ?? "";
  }

  /** Skips a token and the blanks after it. */
  skip(token: string) {
    this.at += token.length;
    this.at += this.peek(BLANKS).length;
  }

  skips(character: string) {
    const found = this.text[this.at] === character;
    if (found) this.skip(character);
    return found;
  }

  expect(character: string) {
    if (!this.skips(character)) this.refuse(`"${character}"`);
  }

  hasPercentage() {
    return this.peek(NUMBER).endsWith("%");
  }

  number() {
    const token = this.peek(NUMBER);
    const value = Number.parseFloat(token);
    if (!token) this.refuse("a number");
    if (!Number.isFinite(value)) this.refuse("a finite number");
    this.skip(token);
    return value + 0; // turns −0 into 0
  }

  refuse(expected: string, offset: number = this.at): never {
    this.at = offset;
    UP_TO_SEPARATOR.lastIndex = offset;
    const got = UP_TO_SEPARATOR.exec(this.text);
    const message = `easing: expected ${expected} at offset ${offset}, got ${got ? describe(got[0]) : "the end of the text"}`;
    throw Object.assign(new RangeError(message), { offset });
  }
}

/**
 * Reads a CSS timing function.
 *
 * @internal
 * @throws {RangeError} with `offset`
 */
export function readEasing(text: string): Timing {
  const scanner = new Scanner(text);
  const word = scanner.peek(WORD);
  const readers: Record<string, (scanner: Scanner) => Timing> = {
    "cubic-bezier(": readCubic,
    "steps(": readSteps,
    "linear(": readLinear,
  };
  const isKeyword = Object.hasOwn(KEYWORDS, word);
  if (!isKeyword && !Object.hasOwn(readers, word)) {
    const words = Object.keys(KEYWORDS);
    // Other libraries write `easeInOut`.
    const meant = words.find((known) => known.replaceAll("-", "") === word);
    scanner.refuse(meant ?? `${words.join(", ")}, cubic-bezier(…), steps(…) or linear(…)`);
  }
  scanner.skip(word);
  const timing = isKeyword ? readEasing(KEYWORDS[word]) : readers[word](scanner);
  if (!isKeyword) scanner.expect(")");
  if (scanner.at < text.length) scanner.refuse("the end of the text");
  return timing;
}

function readCubic(scanner: Scanner) {
  const handles = [0, 1, 2, 3].map((k) => {
    if (k) scanner.expect(",");
    const { at } = scanner;
    if (scanner.hasPercentage()) scanner.refuse("a number");
    const value = scanner.number();
    if (k % 2 === 0 && (value < 0 || value > 1)) scanner.refuse("a number from 0 to 1", at);
    return value;
  });
  return { handles };
}

function readSteps(scanner: Scanner) {
  const { at } = scanner;
  const isWhole = WHOLE.test(scanner.peek(NUMBER));
  const count = scanner.number();
  let position = "jump-end";
  if (scanner.skips(",")) {
    const word = scanner.peek(WORD);
    position = word.replace(/^(start|end)$/, "jump-$1");
    if (!Object.hasOwn(JUMPS, position)) scanner.refuse("jump-start, jump-end, jump-none, jump-both, start or end");
    scanner.skip(word);
  }
  const min = position === "jump-none" ? 2 : 1;
  if (!isWhole || count < min || count > MAX_STEPS) scanner.refuse(`a whole number from ${min} to ${MAX_STEPS}`, at);
  return { count, position: position as StepPosition };
}

function readLinear(scanner: Scanner) {
  const stops: [percentage: number | null, y: number][] = [];
  let count = 0;
  do {
    count++;
    const before = readPercentages(scanner);
    if (scanner.hasPercentage()) scanner.refuse("a number");
    const y = scanner.number();
    const percentages = before.length > 0 ? before : readPercentages(scanner);
    for (const percentage of percentages.length > 0 ? percentages : [null]) stops.push([percentage, y]);
  } while (scanner.skips(","));
  if (count < 2) scanner.refuse('","');
  return { stops: completeStops(stops) };
}

function readPercentages(scanner: Scanner) {
  const percentages: number[] = [];
  while (percentages.length < 2 && scanner.hasPercentage()) percentages.push(scanner.number());
  return percentages;
}

/** Makes the percentages ascend and fills in the missing ones: 0 and 100 at the ends, evenly spaced between others. */
function completeStops(stops: [percentage: number | null, y: number][]): Stop[] {
  stops[0][0] ??= 0;
  stops[stops.length - 1][0] ??= 100;
  let known = 0;
  let from = stops[0][0];
  let before = from;
  stops.forEach(([percentage], k) => {
    if (percentage === null) return;
    const to = Math.max(from, percentage);
    for (let i = known + 1; i <= k; i++) {
      const share = (i - known) / (k - known);
      before = Math.min(Math.max(from * (1 - share) + to * share, before), to); // rounding may descend
      stops[i][0] = before;
    }
    [known, from] = [k, to];
  });
  return stops as Stop[];
}

/**
 * A timing function as CSS text. Stops of equal output that follow each other share an argument of linear().
 *
 * @internal
 */
export function writeEasing(timing: Timing): string {
  if ("handles" in timing) return `cubic-bezier(${timing.handles.join(", ")})`;
  if ("count" in timing) {
    const position = timing.position.replace("jump-start", "start");
    return `steps(${timing.count}${position === "jump-end" ? "" : `, ${position}`})`;
  }
  const { stops } = timing;
  const last = stops.length - 1;
  const parts: string[] = [];
  for (let k = 0; k <= last; k++) {
    const [percentage, y] = stops[k];
    const isPair = last > 1 && k < last && stops[k + 1][1] === y;
    const isImplied = percentage === 100 * +(k === last) && k % last === 0;
    parts.push(y + (isPair ? ` ${percentage}% ${stops[++k][0]}%` : isImplied ? "" : ` ${percentage}%`));
  }
  return `linear(${parts.join(", ")})`.replace(/^linear\(0, 1\)$/, "linear");
}
