// What `<bezier-applet>` shows, without its picture: the editor, the figure of its state, and the message below the picture.
import { followTranslations } from "../follow-translations.js";
import { AppletAttributes } from "./attributes.js";
import { messageOf } from "../../editor/check.js";
import { Editor } from "../../editor/editor.js";
import { figureOf } from "../../editor/figure.js";
import { Memo } from "../../editor/memo.js";
import { BASIS_NAMES, firstState } from "../../editor/state.js";
import { translated } from "../../editor/translations.js";
import type { LitElement } from "lit";
import type { Figure } from "../../editor/figure.js";
import type { State } from "../../editor/state.js";
import type * as rational from "./rational.js";

/** What draws and edits curves with weights. */
export type Rational = typeof rational;

/** The element as its controller sees it. */
export type AppletHost = LitElement & {
  model: AppletModel;
  controls: string | boolean | null;
  readonly: boolean;
  hotkeys: string;
  theme: string;
  /** Renders the controls at once if they are to be rendered */
  renderControls: () => void;
};

/** The properties of a state that `figureOf` reads. */
const FIGURE_INPUTS: readonly (keyof State)[] = ["points", "weights", "shown", "basis", "degree", "matrix", "labels"];

export class AppletModel {
  /** What could not be done, or what has been done. */
  message = "";
  /** Whether the message reports a success. */
  isSuccess = false;
  #host: LitElement & { label: string };
  #editor = new Editor<State>(firstState(), ["view", "segment"], ["view"]);
  attributes: AppletAttributes;
  #memo = new Memo();
  #rational: Rational | null = null;

  constructor(host: LitElement & { label: string }) {
    this.#host = host;
    this.attributes = new AppletAttributes(host, this.#editor);
    this.#editor.subscribe((event) => {
      if (event !== "input") host.requestUpdate(); // after a change, also to write the attributes
      if (event !== "state") this.fire(event);
    });
    // The layers and joints are described anew for a new state.
    followTranslations(host, () => this.#renew());
  }

  /** The editor, in whose state all attributes have been read. */
  get editor(): Editor<State> {
    this.attributes.read();
    return this.#editor;
  }

  get state(): State {
    return this.editor.state;
  }

  /** What is wrong with the attributes. */
  get problems() {
    return this.attributes.problems;
  }

  /** What draws and edits curves with weights, once it is loaded. */
  get rational() {
    return this.#rational;
  }

  set rational(rational) {
    this.#rational = rational;
    this.#renew();
  }

  /** The curves of the state; computed once for each state with other curves. */
  get figure(): Figure {
    const { state } = this;
    const inputs = FIGURE_INPUTS.map((name) => state[name]);
    return this.#memo.get("figure", [...inputs, this.#rational], () => figureOf(state, this.#rational?.RationalCurve));
  }

  /** The name of the picture for screen readers. */
  get name() {
    return (
      this.#host.label || translated("{0} curve with control points that can be moved", BASIS_NAMES[this.state.basis])
    );
  }

  attributeChanged(name: string) {
    this.attributes.changed(name);
  }

  /**
   * Does something that may be refused: the refusal becomes the message.
   *
   * @returns whether it was done
   */
  attempt(act: () => void): boolean {
    let message = "";
    try {
      act();
    } catch (error) {
      message = messageOf(error);
    }
    this.say(message);
    return message === "";
  }

  /** Shows a message below the picture. */
  say(message: string, isSuccess = false) {
    if (message === this.message) return;
    this.message = message;
    this.isSuccess = isSuccess;
    this.#host.requestUpdate();
  }

  fire(type: "input" | "change") {
    this.#host.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  }

  #renew() {
    this.editor.replaceState({ ...this.editor.state });
  }
}
