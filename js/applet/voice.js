// Words on the page: the label at P3 at once; for screen readers, a little later, what has changed.
import { description, jointLabel } from "./words.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./derive.js").Derived} Derived */
/** @typedef {import("./view.js").View} View */

/** So long after the last change something is said: a drag is told once. */
const PAUSE_MS = 500;

export class Voice {
  #view;
  /** @type {{ state: State, derived: Derived } | null} */
  #shown = null;
  #words = "";
  #told = "";
  #timer = 0;

  /** @param {View} view */
  constructor(view) {
    this.#view = view;
  }

  /**
   * @param {State} state
   * @param {Derived} derived
   */
  show(state, derived) {
    const { verdict, text } = jointLabel(state, derived);
    setText(this.#view.verdict, verdict);
    this.#view.verdict.dataset.verdict = verdict;
    setText(this.#view.label, text);
    if (this.#shown?.state === state) return;
    const first = this.#shown === null;
    this.#shown = { state, derived };
    if (!first) return this.#wait();
    this.#told = verdict; // what is there from the start is described, not announced
    this.#speak();
  }

  /** @param {string} words announced together with what has changed at P3 */
  say(words) {
    this.#words = words;
    this.#wait();
  }

  end() {
    clearTimeout(this.#timer);
  }

  #wait() {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.#speak(), PAUSE_MS);
  }

  #speak() {
    if (!this.#shown) return;
    const { state, derived } = this.#shown;
    setText(this.#view.description, description(state, derived));
    const { verdict, text } = jointLabel(state, derived);
    const news = verdict === this.#told ? "" : text;
    this.#told = verdict;
    if (this.#words || news) this.#view.live.textContent = [this.#words, news].filter(Boolean).join(". ");
    this.#words = "";
  }
}

/**
 * Only where it differs: a text node that is replaced for nothing costs a layout.
 *
 * @param {HTMLElement} element
 * @param {string} text
 */
function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
