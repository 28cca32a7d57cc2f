// Values that are made again only when what they depend on has changed.

/**
 * Keeps one value for each name. A value has a number, its version, that others can depend on: a value whose arrays are
 * reused stays the same object.
 */
export class Memo {
  /** @type {Map<string, { inputs: unknown[], value: any, version: number }>} */
  #kept = new Map();
  #versions = 0;

  /**
   * @template T
   * @param {string} name
   * @param {unknown[]} inputs
   * @param {(before: T | undefined) => T} make is given the value before, to reuse it
   * @returns {T}
   */
  get(name, inputs, make) {
    const kept = this.#kept.get(name);
    if (kept && kept.inputs.length === inputs.length && kept.inputs.every((input, i) => Object.is(input, inputs[i])))
      return kept.value;
    const value = make(kept?.value);
    this.#kept.set(name, { inputs, value, version: ++this.#versions });
    return value;
  }

  /**
   * @param {string} name
   * @returns {number} 0 before the first value
   */
  version(name) {
    return this.#kept.get(name)?.version ?? 0;
  }

  clear() {
    this.#kept.clear();
  }
}
