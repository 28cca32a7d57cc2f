// Numbers as people write and read them.

/** What is read: a decimal, with a point, an exponent if need be, and either minus. */
const NUMBER = /^[+\-−]?(\d+\.?\d*|\.\d+)(e[+\-−]?\d+)?$/i;
/** A message quotes no more of what came. */
const MAX_QUOTED = 24;

/**
 * @returns NaN for what is no finite number
 */
export function readNumber(text: string): number {
  const trimmed = text.trim();
  const value = NUMBER.test(trimmed) ? Number(trimmed.replaceAll("−", "-")) : NaN;
  return Number.isFinite(value) ? value : NaN;
}

/**
 * Points, two numbers each: "x,y x,y …", or one line each, as tables are copied.
 *
 * @throws {RangeError} naming the line
 */
export function readPoints(text: string): [number, number][] {
  const lines = text.split(/\r\n|\r|\n/).map((line) => line.trim());
  return lines.flatMap((line, i) => {
    const words = line.split(/[\s,;]+/).filter(Boolean);
    const where = lines.length > 1 ? `line ${i + 1}: ` : "";
    if (words.length % 2) throw new RangeError(`${where}expected pairs of numbers x,y, got ${quoted(line)}`);
    const numbers = words.map(readNumber);
    const bad = numbers.findIndex(Number.isNaN);
    if (bad >= 0) throw new RangeError(`${where}expected a number, got ${quoted(words[bad])}`);
    return Array.from(
      { length: numbers.length / 2 },
      (_, k) => [numbers[2 * k], numbers[2 * k + 1]] as [number, number],
    );
  });
}

/** What came, in words for a message. */
export function quoted(text: string) {
  if (text === "") return "nothing";
  return `“${text.length > MAX_QUOTED ? `${text.slice(0, MAX_QUOTED)}…` : text}”`;
}

/** A number with so many decimals, without zeros at the end; very large and very small ones with an exponent. */
export function shown(x: number, decimals = 3) {
  const size = Math.abs(x);
  if (size >= 1e7) return minus(x.toExponential(2));
  const short = Number(x.toFixed(decimals));
  if (short === 0 && size > 0 && size < 1e-4) return minus(x.toExponential(1));
  return minus(String(short + 0)); // no −0
}

/** A number as a fraction of small numbers where it is one, such as 1/6. */
export function shownFraction(x: number) {
  for (const divisor of [1, 2, 3, 6]) {
    const top = x * divisor;
    if (Math.abs(top - Math.round(top)) < 1e-12 && Math.abs(top) < 1e6)
      return minus(`${Math.round(top) + 0}${divisor > 1 ? `/${divisor}` : ""}`);
  }
  return shown(x, 4);
}

/** With a minus as wide as a plus. */
const minus = (text: string) => text.replaceAll("-", "−");
