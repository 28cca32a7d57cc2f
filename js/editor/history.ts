// Undo and redo of immutable states: one step for each action, however many small changes it consists of.

/** The greatest number of steps that can be undone. */
const MAX_STEPS = 200;

export class History<State extends object> {
  /** Properties whose changes alone make no step. */
  #transient: readonly (keyof State)[];
  /** Properties that undo and redo leave as they are. */
  #kept: readonly (keyof State)[];
  #past: State[] = [];
  #future: State[] = [];
  /** The state before the action that is going on. */
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

  /** Whether an action is going on. */
  get open() {
    return this.#open !== null;
  }

  /** Before a change: it and further changes belong to one step until `close`. */
  touch(state: State) {
    this.#open ??= state;
  }

  /**
   * The step is complete.
   *
   * @returns whether an action was going on
   */
  close(state: State): boolean {
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
   * Forgets the action that is going on.
   *
   * @param state the present one
   * @returns the state before the action; null without one
   */
  abandon(state: State): State | null {
    const before = this.#open;
    this.#open = null;
    return before && this.#withKept(before, state);
  }

  /**
   * @param state the present one
   * @returns the state before the last step; the same state if there is no step
   */
  undo(state: State): State {
    this.close(state);
    return this.#step(this.#past, this.#future, state);
  }

  redo(state: State): State {
    this.close(state);
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
