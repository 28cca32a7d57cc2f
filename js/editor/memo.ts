// Values that are made again only when what they depend on has changed.

/**
 * Keeps one value for each name. A value has a number, its version, that others can depend on: a value whose arrays are
 * reused stays the same object.
 */
export class Memo {
  #kept: Map<string, { inputs: unknown[]; value: any; version: number }> = new Map();
  #versions = 0;

  /**
   * @param make is given the value before, to reuse it
   */
  get<T>(name: string, inputs: unknown[], make: (before: T | undefined) => T): T {
    const kept = this.#kept.get(name);
    if (kept && kept.inputs.length === inputs.length && kept.inputs.every((input, i) => Object.is(input, inputs[i])))
      return kept.value;
    const value = make(kept?.value);
    this.#kept.set(name, { inputs, value, version: ++this.#versions });
    return value;
  }

  /**
   * @returns 0 before the first value
   */
  version(name: string): number {
    return this.#kept.get(name)?.version ?? 0;
  }

  clear() {
    this.#kept.clear();
  }
}

/** A function that makes one value for each object, as long as the object exists. */
export function cached<Key extends object, Value>(make: (key: Key) => Value): (key: Key) => Value {
  const known: WeakMap<Key, { value: Value }> = new WeakMap();
  return (key) => {
    const entry = known.get(key) ?? { value: make(key) };
    known.set(key, entry);
    return entry.value;
  };
}
