// An editor without DOM: its immutable state, changes by the page and by the user, undo and redo, and subscribers.
import { History } from "./history.js";

/**
 * The events of an editor. "state": there is another state; "input": the user has changed something, and the step may go on;
 * "change": the user's step is complete.
 */
export type EditorEvent = "state" | "input" | "change";

export interface Dispatch {
  /** Who changes something: "page" makes an undo step, "user" in addition "input" and "change" */
  by: "page" | "user";
  /** Whether more changes belong to the same step; `commit` completes it. False by default */
  merge?: boolean;
  /** Whether a change by the page before the first one by the user makes no step, and is what `reset` returns to */
  initial?: boolean;
}

export class Editor<State extends object> {
  #state: State;
  #history;
  /** The first state that a user has seen; null until something changes. */
  #initialState: State | null = null;
  /** Whether the user has changed something. */
  #isTouched = false;
  #listeners = new Set<(event: EditorEvent) => void>();

  /**
   * @param transient properties whose changes alone make no step
   * @param kept properties that undo, redo and `revert` leave as they are
   */
  constructor(state: State, transient: readonly (keyof State)[] = [], kept: readonly (keyof State)[] = []) {
    this.#state = state;
    this.#history = new History<State>(transient, kept);
  }

  get state(): State {
    return this.#state;
  }

  /** The state that `reset` returns to. */
  get initialState(): State {
    return this.#initialState ?? this.#state;
  }

  get canUndo() {
    return this.#history.canUndo;
  }

  get canRedo() {
    return this.#history.canRedo;
  }

  /** Whether a step is not complete. */
  get isOpen() {
    return this.#history.isOpen;
  }

  /** @returns ends it */
  subscribe(listener: (event: EditorEvent) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Shows another state, which makes no step. */
  replaceState(state: State) {
    if (state === this.#state) return;
    this.#state = state;
    this.#notify("state");
  }

  /** Changes the state. A change that throws changes nothing. */
  dispatch(change: (state: State) => State, { by, merge = false, initial = false }: Dispatch) {
    if (!merge) this.commit();
    const before = this.#state;
    const next = change(before);
    if (by === "user") this.#isTouched = true;
    if (this.#isTouched || !initial) {
      this.#initialState ??= before;
      this.#history.begin(before);
    } else this.#initialState = null;
    this.replaceState(next);
    if (by === "user") this.#notify("input");
    if (by === "page") this.#history.commit(next);
    else if (!merge) this.commit();
  }

  /** Completes the open step. */
  commit() {
    if (this.#history.commit(this.#state)) this.#notify("change");
  }

  /** Rolls back the open step; the kept properties stay as they are. */
  revert() {
    const before = this.#history.rollback(this.#state);
    if (!before) return;
    this.replaceState(before);
    this.#notify("input");
  }

  /** @param by "user" fires "input" and "change", as other changes by the user do */
  undo(by: Dispatch["by"] = "page") {
    this.#step(() => this.#history.undo(this.#state), by);
  }

  redo(by: Dispatch["by"] = "page") {
    this.#step(() => this.#history.redo(this.#state), by);
  }

  #step(stateAfter: () => State, by: Dispatch["by"]) {
    this.commit();
    const before = this.#state;
    this.#initialState ??= before;
    this.replaceState(stateAfter());
    if (by === "page" || this.#state === before) return;
    this.#notify("input");
    this.#notify("change");
  }

  /** Forgets all steps; the state stays. */
  clearHistory() {
    this.#history.clear();
  }

  /** Returns to the initial state, as a step. */
  reset() {
    this.dispatch(() => this.initialState, { by: "page" });
  }

  #notify(event: EditorEvent) {
    for (const listener of [...this.#listeners]) listener(event);
  }
}
