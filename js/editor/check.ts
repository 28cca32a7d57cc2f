// What comes from outside is checked here; every refusal names the argument, what was expected and what came.

/** How a refused value is shown in a message. */
export function kindOf(value: unknown): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (value === null || typeof value !== "object") return typeof value === "function" ? "a function" : String(value);
  if ("localName" in value) return `a <${value.localName}> element`;
  return Array.isArray(value)
    ? `an array of ${value.length}`
    : Object.prototype.toString.call(value).slice("[object ".length, -1);
}

/** What went wrong, in words. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

export function finiteNumber(value: unknown, name: string, expected: string): number {
  if (typeof value !== "number") throw new TypeError(`${name}: expected ${expected}, got ${kindOf(value)}`);
  if (!Number.isFinite(value)) throw new RangeError(`${name}: expected ${expected}, got ${value}`);
  return value;
}

export function numberIn(
  value: unknown,
  name: string,
  min: number,
  max: number,
  expected = `a number from ${min} to ${max}`,
): number {
  const number = finiteNumber(value, name, expected);
  if (number < min || number > max) throw new RangeError(`${name}: expected ${expected}, got ${number}`);
  return number;
}

export function wholeIn(value: unknown, name: string, min: number, max: number): number {
  const number = numberIn(value, name, min, max);
  if (!Number.isInteger(number)) throw new RangeError(`${name}: expected a whole number, got ${number}`);
  return number;
}

export function wordIn<Word extends string>(value: unknown, name: string, known: readonly Word[]): Word {
  const found = known.find((each) => each === value);
  if (found) return found;
  const Refusal = typeof value === "string" ? RangeError : TypeError;
  throw new Refusal(`${name}: expected ${known.join(", ")}, got ${brief(value)}`);
}

/** The most that a message shows of a refused text. */
const MAX_SHOWN = 40;

export function brief(value: unknown): string {
  return kindOf(typeof value === "string" && value.length > MAX_SHOWN ? `${value.slice(0, MAX_SHOWN)}…` : value);
}

/** What is wrong with the attributes of an element. */
export class Problems {
  #messages: Map<string, string> = new Map();
  #report;

  /** @param report is called once with each message */
  constructor(report: (message: string) => void) {
    this.#report = report;
  }

  get messages(): string[] {
    return [...this.#messages.values()];
  }

  /**
   * Reads an attribute.
   *
   * @param read may throw; then the message of the error is reported
   */
  attempt(name: string, read: () => void) {
    const before = this.#messages.get(name);
    this.#messages.delete(name);
    try {
      read();
    } catch (error) {
      const message = messageOf(error);
      this.#messages.set(name, message);
      if (message !== before) this.#report(message);
    }
  }

  /** The attribute has a valid value now. */
  forget(name: string) {
    this.#messages.delete(name);
  }
}
