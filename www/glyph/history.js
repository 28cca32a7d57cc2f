// Undo and redo over values that never change.

/**
 * @template T
 */
export class History {
  /** @type {T[]} */
  #past = [];
  /** @type {T[]} */
  #future = [];

  /** @param {T} now */
  constructor(now) {
    this.now = now;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** @param {T} next @returns {boolean} whether it is another */
  push(next) {
    if (next === this.now) return false;
    this.#past.push(this.now);
    this.#future = [];
    this.now = next;
    return true;
  }

  undo() {
    if (!this.canUndo) return this.now;
    this.#future.push(this.now);
    this.now = /** @type {T} */ (this.#past.pop());
    return this.now;
  }

  redo() {
    if (!this.canRedo) return this.now;
    this.#past.push(this.now);
    this.now = /** @type {T} */ (this.#future.pop());
    return this.now;
  }
}
