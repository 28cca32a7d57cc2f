// Everything that changes the state, by the page or by the user; undo and redo; the events that tell.
import { History } from "../../editor/history.js";
import { writeAttribute } from "../attribute-text.js";
import { AppletAttributes } from "./attributes.js";
import * as edits from "./edits.js";
import { FIELDS, jsonOf, stateOf } from "./fields.js";
import { figureOf } from "./figure.js";
import { BASIS_NAMES, firstState, allPointsToggled } from "./state.js";
import type { State } from "./state.js";
import type { Point2 } from "./state.js";
import type { Figure } from "./figure.js";

/** What a figure is made of: as long as these are the same, it is. */
const MAKINGS: readonly (keyof State)[] = ["points", "shown", "basis", "degree", "matrix", "labels"];

export class AppletEditing extends AppletAttributes {
  /** @internal */
  history = new History<State>(["view", "pointer", "segment"], ["view", "pointer"]);
  /** @internal What could not be done. */
  message = "";
  /** @internal Whether the message is good news. */
  good = false;
  /** What the user began with, for `reset`. */
  #origin: State | null = null;
  /** Whether the user has changed something. */
  #isTouched = false;
  #made: { state: State; figure: Figure } | null = null;

  /** All points, also the hidden ones; a copy. */
  get points(): Point2[] {
    return this.now().points.map(([x, y]) => [x, y]);
  }

  set points(points) {
    if (writeAttribute(this, "points", points)) return;
    this.#assign((state) => FIELDS.points.put(state, points));
  }

  /** The mode of each inner joint. */
  get joints() {
    return edits.modesOf(this.now());
  }

  set joints(joints) {
    if (writeAttribute(this, "joints", joints)) return;
    this.#assign((state) => edits.withJoints(state, (FIELDS.joints.put(state, joints) as State).joints));
  }

  get t() {
    return this.now().t;
  }

  set t(t) {
    if (!writeAttribute(this, "t", t)) this.display(FIELDS.t.put(this.now(), t));
  }

  /** Everything that is shown, as plain data. */
  get state(): Record<string, unknown> {
    return jsonOf(this.now());
  }

  set state(json) {
    const state = json === undefined ? firstState() : stateOf(json);
    this.#assign(() => state);
  }

  toJSON() {
    return this.state;
  }

  undo() {
    this.updateByPage((state) => this.history.undo(state), false);
  }

  redo() {
    this.updateByPage((state) => this.history.redo(state), false);
  }

  /** Everything as it was when the user came. */
  reset() {
    this.updateByPage((state) => this.#origin ?? state);
  }

  randomize(seed: number = Math.floor(Math.random() * 2 ** 32)) {
    this.updateByPage((state) => edits.randomized(state, seed));
  }

  /**
   * Shows the two halves at t.
   *
   * @returns of the selected segment
   */
  split(t: number = this.t): [import("../../index.js").Curve, import("../../index.js").Curve] {
    const next = FIELDS.show.put(FIELDS.t.put(this.now(), t), [...new Set([...this.now().layers, "halves"])]);
    const { pieces } = figureOf(next);
    if (!pieces.length) throw new RangeError("split: expected a curve, got too few points for one");
    this.updateByPage(() => next);
    return pieces[Math.min(next.segment, pieces.length - 1)].curve.split(t);
  }

  insertJoint(t?: number) {
    this.updateByPage((state) => edits.inserted(state, t));
  }

  removePoint(index: number) {
    this.updateByPage((state) => edits.removed(state, index));
  }

  appendPoint(point: Point2) {
    this.updateByPage((state) => edits.appended(state, point));
  }

  /** Few points, or all. */
  toggleMode() {
    this.updateByPage(allPointsToggled);
  }

  /**
   * As if the user did it in the figure: a point moved, or values written as in the state's JSON.
   *
   * @param done whether the undo step is complete
   */
  steer(
    {
      index,
      point,
      ...values
    }: { index?: number; point?: Point2; t?: number; points?: Point2[]; basis?: string; matrix?: number[] },
    done = true,
  ) {
    if (this.readonly && (index !== undefined || values.points)) return;
    const given = values as Record<string, unknown>;
    this.updateOpenStep((state) => {
      const next = Object.entries(FIELDS).reduce(
        (at, [name, { put }]) => (given[name] === undefined ? at : put(at, given[name])),
        state,
      );
      return index === undefined ? next : edits.withPointAt(next, index, point);
    });
    if (done) this.commit();
  }

  /**
   * @internal
   * @returns of the state as it is now
   */
  made(): Figure {
    const state = this.now();
    const same = this.#made && MAKINGS.every((name) => this.#made?.state[name] === state[name]);
    if (!this.#made || !same) this.#made = { state, figure: figureOf(state) };
    return this.#made.figure;
  }

  /**
   * @internal
   */
  display(state: State) {
    if (state === this.now()) return;
    this.setState(state);
    this.requestUpdate();
  }

  /**
   * @internal
   * By the page: an undo step, but no events. What is refused changes nothing.
   */
  updateByPage(change: (state: State) => State, step = true) {
    this.commit();
    const before = this.now();
    this.#origin ??= before;
    const next = change(before);
    if (step) this.history.touch(before);
    this.display(next);
    this.history.close(next);
  }

  /** The page sets a property. Before the first action of the user, this is what `reset` restores, and no undo step. */
  #assign(change: (state: State) => State) {
    this.updateByPage(change, this.#isTouched);
    if (!this.#isTouched) this.#origin = null;
  }

  /**
   * @internal
   * A part of what the user is doing; `commit` completes it.
   */
  updateOpenStep(change: (state: State) => State) {
    const before = this.now();
    const next = change(before);
    this.#origin ??= before;
    this.#isTouched = true;
    this.history.touch(before);
    this.display(next);
    this.fire("input");
  }

  /** @internal What the user was doing is complete. */
  commit() {
    if (!this.history.close(this.now())) return;
    this.fire("change");
    this.requestUpdate();
  }

  /**
   * @internal
   * Something the user does at once. What cannot be done is told of.
   * @returns whether it was done
   */
  updateByUser(change: (state: State) => State): boolean {
    this.commit();
    return this.attempt(() => {
      this.updateOpenStep(change);
      this.commit();
    });
  }

  /**
   * @internal
   */
  attempt(act: () => void): boolean {
    let message = "";
    try {
      act();
    } catch (error) {
      message = error instanceof Error ? error.message : String(error);
    }
    this.say(message);
    return message === "";
  }

  /**
   * @internal
   * @param good whether nothing is wrong
   */
  say(message: string, good = false) {
    if (message === this.message) return;
    this.message = message;
    this.good = good;
    this.requestUpdate();
  }

  /** @internal Esc: what the user was doing has not been done. */
  revert() {
    const before = this.history.abandon();
    if (!before) return;
    this.display(before);
    this.fire("input");
  }

  /** @internal What the picture is called. */
  get name() {
    return this.label || `${BASIS_NAMES[this.now().basis]} curve with control points that can be moved`;
  }

  /** @internal The first state that a user sees. */
  get origin() {
    return this.#origin ?? this.now();
  }

  /**
   * @internal
   */
  fire(type: "input" | "change") {
    this.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  }
}
