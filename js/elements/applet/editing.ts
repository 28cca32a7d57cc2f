// What the page can call: everything that changes the state, and the events for changes by the user.
import { writeAttribute } from "../attribute-text.js";
import { AppletAttributes } from "./attributes.js";
import * as commands from "../../editor/commands.js";
import { FIELDS, jsonOf, stateOf } from "../../editor/schema.js";
import { figureOf } from "../../editor/figure.js";
import { BASIS_NAMES, firstState, allPointsToggled } from "../../editor/state.js";
import { translated } from "../../editor/translations.js";
import type { State } from "../../editor/state.js";
import type { Point2 } from "../../editor/state.js";
import type { Figure } from "../../editor/figure.js";

/** What a figure is made of: as long as these are the same, it is. */
const MAKINGS: readonly (keyof State)[] = ["points", "weights", "shown", "basis", "degree", "matrix", "labels"];

export class AppletEditing extends AppletAttributes {
  /** @internal What could not be done. */
  message = "";
  /** @internal Whether the message is good news. */
  good = false;
  #made: { state: State; figure: Figure } | null = null;
  #rational: import("./loading.js").Rational | null = null;

  constructor() {
    super();
    this.editor.subscribe((event) => {
      if (event === "input") this.fire("input");
      else this.requestUpdate();
      if (event === "change") this.fire("change");
    });
  }

  /** @internal What draws and edits curves with weights, once it is loaded. */
  get rational() {
    return this.#rational;
  }

  /** @internal */
  set rational(rational) {
    this.#rational = rational;
    this.#made = null;
    this.editor.show({ ...this.editor.state }); // the figure is another
  }

  /** All points, also the hidden ones; a copy. */
  get points(): Point2[] {
    return this.editor.state.points.map(([x, y]) => [x, y]);
  }

  set points(points) {
    if (writeAttribute(this, "points", points)) return;
    this.#assign((state) => FIELDS.points.put(state, points));
  }

  /** The mode of each inner joint. */
  get joints() {
    return commands.modesOf(this.editor.state);
  }

  set joints(joints) {
    if (writeAttribute(this, "joints", joints)) return;
    this.#assign((state) => commands.withJoints(state, (FIELDS.joints.put(state, joints) as State).joints));
  }

  get t() {
    return this.editor.state.t;
  }

  set t(t) {
    if (!writeAttribute(this, "t", t)) this.editor.show(FIELDS.t.put(this.editor.state, t));
  }

  /** Everything that is shown, as plain data. */
  get state(): Record<string, unknown> {
    return jsonOf(this.editor.state);
  }

  set state(json) {
    const state = json === undefined ? firstState() : stateOf(json);
    this.#assign(() => state);
  }

  toJSON() {
    return this.state;
  }

  undo() {
    this.editor.undo();
  }

  redo() {
    this.editor.redo();
  }

  /** Everything as it was when the user came. */
  reset() {
    this.editor.reset();
  }

  randomize(seed: number = Math.floor(Math.random() * 2 ** 32)) {
    this.#call((state) => commands.randomized(state, seed));
  }

  /**
   * Shows the two halves at t.
   *
   * @returns of the selected segment
   */
  split(t: number = this.t): ReturnType<import("../types.js").AppletProperties["split"]> {
    const next = FIELDS.show.put(FIELDS.t.put(this.editor.state, t), [
      ...new Set([...this.editor.state.layers, "halves"]),
    ]);
    const { pieces: polynomial, rational } = figureOf(next, this.#rational?.RationalCurve);
    const pieces = rational.length ? rational : polynomial;
    if (!pieces.length) throw new RangeError("split: expected a curve, got too few points for one");
    this.#call(() => next);
    return pieces[Math.min(next.segment, pieces.length - 1)].curve.split(t);
  }

  insertJoint(t?: number) {
    this.#call((state) => commands.inserted(state, t));
  }

  removePoint(index: number) {
    this.#call((state) => commands.removed(state, index));
  }

  appendPoint(point: Point2) {
    this.#call((state) => commands.appended(state, point));
  }

  /** Few points, or all. */
  toggleMode() {
    this.#call(allPointsToggled);
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
    }: {
      index?: number;
      point?: Point2;
      t?: number;
      points?: Point2[];
      weights?: number[];
      basis?: string;
      matrix?: number[];
    },
    done = true,
  ) {
    if (this.readonly && (index !== undefined || values.points || values.weights)) return;
    const given = values as Record<string, unknown>;
    const change = (state: State) => {
      const next = Object.entries(FIELDS).reduce(
        (at, [name, { put }]) => (given[name] === undefined ? at : put(at, given[name])),
        state,
      );
      return index === undefined ? next : commands.withPointAt(next, index, point);
    };
    this.editor.dispatch(change, { origin: "user", merge: true });
    if (done) this.editor.commit();
  }

  /**
   * @internal
   * @returns of the state as it is now
   */
  currentFigure(): Figure {
    const { state } = this.editor;
    const same = this.#made && MAKINGS.every((name) => this.#made?.state[name] === state[name]);
    if (!this.#made || !same) this.#made = { state, figure: figureOf(state, this.#rational?.RationalCurve) };
    return this.#made.figure;
  }

  /** The page sets a property. Before the first action of the user, this is what `reset` restores, and no undo step. */
  #assign(change: (state: State) => State) {
    this.editor.dispatch(change, { origin: "page", initial: true });
  }

  /** A method of the page: an undo step, but no events. What is refused changes nothing. */
  #call(change: (state: State) => State) {
    this.editor.dispatch(change, { origin: "page" });
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

  /** @internal What the picture is called. */
  get name() {
    return (
      this.label || translated("{0} curve with control points that can be moved", BASIS_NAMES[this.editor.state.basis])
    );
  }

  /**
   * @internal
   */
  fire(type: "input" | "change") {
    this.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  }
}
