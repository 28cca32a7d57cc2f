// Undo and redo: one step for each thing the user does, however many small changes it is made of.

/** @typedef {import("./state.js").State} State */

/** So many steps can be taken back. */
const MOST_STEPS = 200;

/** What is no work of the user's and so is not taken back. @type {readonly (keyof State)[]} */
const PASSING = ["view", "pointer", "segment"];

export class History {
  /** @type {State[]} */
  #past = [];
  /** @type {State[]} */
  #future = [];
  /** What was before the gesture that is going on. @type {State | null} */
  #open = null;

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** Whether a gesture is going on. */
  get open() {
    return this.#open !== null;
  }

  /**
   * Something is about to change; further changes belong to the same step until `close`.
   *
   * @param {State} state
   */
  touch(state) {
    this.#open ??= state;
  }

  /**
   * The step is complete.
   *
   * @param {State} state
   * @returns {boolean} whether a gesture was going on
   */
  close(state) {
    const before = this.#open;
    this.#open = null;
    if (!before) return false;
    if (differ(before, state)) {
      this.#past = [...this.#past.slice(1 - MOST_STEPS), before];
      this.#future = [];
    }
    return true;
  }

  /** Forgets the gesture that is going on. @returns {State | null} what was before it */
  abandon() {
    const before = this.#open;
    this.#open = null;
    return before;
  }

  /**
   * @param {State} state what is now
   * @returns {State} what was before; the same where there is nothing
   */
  undo(state) {
    this.close(state);
    return step(this.#past, this.#future, state);
  }

  /**
   * @param {State} state
   * @returns {State}
   */
  redo(state) {
    this.close(state);
    return step(this.#future, this.#past, state);
  }
}

/**
 * @param {State[]} from
 * @param {State[]} to
 * @param {State} state
 * @returns {State}
 */
function step(from, to, state) {
  const found = from.pop();
  if (!found) return state;
  to.push(state);
  return { ...found, view: state.view, pointer: state.pointer };
}

/**
 * @param {State} a
 * @param {State} b
 */
function differ(a, b) {
  return /** @type {(keyof State)[]} */ (Object.keys(a)).some((name) => a[name] !== b[name] && !PASSING.includes(name));
}
