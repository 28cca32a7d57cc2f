// Undo and redo: one step for each thing the user does, however many small changes it is made of.

import type { State } from "./state.js";

/** So many steps can be taken back. */
const MAX_STEPS = 200;

/** What is no work of the user's and so is not taken back. */
const PASSING: readonly (keyof State)[] = ["view", "pointer", "segment"];

export class History {
  #past: State[] = [];
  #future: State[] = [];
  /** What was before the gesture that is going on. */
  #open: State | null = null;

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

  /** Something is about to change; further changes belong to the same step until `close`. */
  touch(state: State) {
    this.#open ??= state;
  }

  /**
   * The step is complete.
   *
   * @returns whether a gesture was going on
   */
  close(state: State): boolean {
    const before = this.#open;
    this.#open = null;
    if (!before) return false;
    if (differ(before, state)) {
      this.#past = [...this.#past.slice(1 - MAX_STEPS), before];
      this.#future = [];
    }
    return true;
  }

  /** Forgets the gesture that is going on. @returns what was before it */
  abandon(): State | null {
    const before = this.#open;
    this.#open = null;
    return before;
  }

  /**
   * @param state what is now
   * @returns what was before; the same where there is nothing
   */
  undo(state: State): State {
    this.close(state);
    return step(this.#past, this.#future, state);
  }

  redo(state: State): State {
    this.close(state);
    return step(this.#future, this.#past, state);
  }
}

function step(from: State[], to: State[], state: State): State {
  const found = from.pop();
  if (!found) return state;
  to.push(state);
  return { ...found, view: state.view, pointer: state.pointer };
}

function differ(a: State, b: State) {
  return (Object.keys(a) as (keyof State)[]).some((name) => a[name] !== b[name] && !PASSING.includes(name));
}
