// Undo and redo of immutable states. A step may consist of many changes.

/** The greatest number of steps that can be undone. */
const MAX_STEPS = 200;

export class History<State extends object> {
  /** Properties whose changes alone make no step. */
  #transient: readonly (keyof State)[];
  /** Properties that undo and redo leave as they are. */
  #kept: readonly (keyof State)[];
  #past: State[] = [];
  #future: State[] = [];
  /** The state before the open step. */
  #open: State | null = null;

  constructor(transient: readonly (keyof State)[] = [], kept: readonly (keyof State)[] = []) {
    this.#transient = transient;
    this.#kept = kept;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** Whether a step is open. */
  get isOpen() {
    return this.#open !== null;
  }

  /** Before a change: it and further changes belong to one step until `commit`. */
  begin(state: State) {
    this.#open ??= state;
  }

  /**
   * Completes the open step.
   *
   * @returns whether a step was open
   */
  commit(state: State): boolean {
    const before = this.#open;
    this.#open = null;
    if (!before) return false;
    const names = Object.keys(before) as (keyof State)[];
    if (names.some((name) => before[name] !== state[name] && !this.#transient.includes(name))) {
      this.#past = [...this.#past.slice(1 - MAX_STEPS), before];
      this.#future = [];
    }
    return true;
  }

  /**
   * Forgets the open step.
   *
   * @param state the present one
   * @returns the state before the step; null if none is open
   */
  rollback(state: State): State | null {
    const before = this.#open;
    this.#open = null;
    return before && this.#withKept(before, state);
  }

  /** Forgets all steps, also the open one. */
  clear() {
    [this.#past, this.#future, this.#open] = [[], [], null];
  }

  /**
   * @param state the present one
   * @returns the state before the last step; the same state if there is no step
   */
  undo(state: State): State {
    this.commit(state);
    return this.#step(this.#past, this.#future, state);
  }

  redo(state: State): State {
    this.commit(state);
    return this.#step(this.#future, this.#past, state);
  }

  #step(from: State[], to: State[], state: State): State {
    const found = from.pop();
    if (!found) return state;
    to.push(state);
    return this.#withKept(found, state);
  }

  /** A state from before with the kept properties of the present one. */
  #withKept(before: State, state: State): State {
    const next = { ...before };
    for (const name of this.#kept) next[name] = state[name];
    return next;
  }
}
