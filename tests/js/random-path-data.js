// Path data of all kinds, right and wrong, from small random numbers: tests/path/texts.rs makes the same, so that both
// doors can be asked for the same answers.

/** Mulberry32 (Tommy Ettinger, 2017): 32 bits. */
export class Rng {
  constructor(seed) {
    this.state = seed | 0;
  }

  next() {
    this.state = (this.state + 0x6d2b79f5) | 0;
    let t = this.state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return (t ^ (t >>> 14)) >>> 0;
  }

  below(n) {
    return this.next() % n;
  }

  pick(words) {
    return words[this.below(words.length)];
  }
}

const COMMANDS = ["M", "m", "L", "l", "H", "h", "V", "v", "C", "c", "S", "s", "Q", "q", "T", "t", "A", "a", "Z", "z"];
const GARBAGE = [",", ",,", "-", "+", ".", "e", "1e", "--", "x", "NaN", "é", "😀", "\u00a0", "1e999", "2", "M"];
const SEPARATORS = [" ", " ", " ", ",", ", ", " ,\t", "\n", "  "];
const ARGUMENTS = { Z: 0, H: 1, V: 1, C: 6, S: 4, Q: 4, A: 7, M: 2, L: 2, T: 2 };

function number(rng) {
  const sign = rng.pick(["", "", "", "-", "-", "+"]);
  const [a, b] = [rng.below(1000), rng.below(10_000)];
  const kind = rng.below(12);
  if (kind < 4) return `${sign}${a % 100}`;
  if (kind < 7) return `${sign}${a}.${b}`;
  if (kind < 9) return `${sign}.${b}`;
  if (kind === 9) return `${sign}${a % 10}e${b % 8}`;
  if (kind === 10) return `${sign}${a % 10}.${b}E-${b % 12}`;
  return `${sign}${a}${b}${a}.${b}${b}${a}${b}`;
}

/** Path data; one in eight has something wrong in it. */
export function pathText(rng) {
  const wrong = rng.below(8) === 0;
  let text = rng.pick(["M", "m"]);
  text += number(rng);
  text += ` ${number(rng)}`;
  const commands = rng.below(8);
  for (let i = 0; i < commands; i++) {
    const command = rng.pick(COMMANDS);
    text += rng.pick(["", "", " ", "\n"]);
    text += command;
    const groups = rng.below(4) === 0 ? 1 + rng.below(3) : 1;
    const count = ARGUMENTS[command.toUpperCase()];
    for (let k = 0; k < groups * count; k++) {
      if (wrong && rng.below(16) === 0) text += rng.pick(GARBAGE);
      if (k > 0) text += rng.pick(SEPARATORS);
      text += count === 7 && (k % 7 === 3 || k % 7 === 4) ? rng.pick(["0", "1"]) : number(rng);
    }
  }
  return text;
}

/** FNV-1a (Fowler, Noll and Vo), 32 bits, of ASCII. */
export function hash(state, text) {
  for (const byte of new TextEncoder().encode(text)) state = Math.imul(state ^ byte, 0x01000193) >>> 0;
  return state;
}
