// Words on the page: the label at P3 at once; for screen readers, a little later, what has changed.
import { setText, Announcer } from "../ui/announcer.js";
import { description, jointLabel } from "./words.js";
import type { State } from "./state.js";
import type { Derived } from "./derive.js";
import type { View } from "./view.js";

export class Voice {
  #view;
  #shown: { state: State; derived: Derived } | null = null;
  #announced = "";
  #speaker;

  constructor(view: View) {
    this.#view = view;
    this.#speaker = new Announcer(view.live, () => this.#news());
  }

  show(state: State, derived: Derived) {
    const { verdict, text } = jointLabel(derived);
    setText(this.#view.verdict, verdict);
    this.#view.verdict.dataset.verdict = verdict;
    setText(this.#view.label, text);
    if (this.#shown?.state === state) return;
    const first = this.#shown === null;
    this.#shown = { state, derived };
    if (!first) return this.#speaker.say();
    this.#announced = verdict; // what is there from the start is described, not announced
    this.#news();
  }

  /** @param words announced together with what has changed at P3 */
  say(words: string) {
    this.#speaker.say(words);
  }

  end() {
    this.#speaker.end();
  }

  #news() {
    if (!this.#shown) return "";
    const { state, derived } = this.#shown;
    setText(this.#view.description, description(state, derived));
    const { verdict, text } = jointLabel(derived);
    const news = verdict === this.#announced ? "" : text;
    this.#announced = verdict;
    return news;
  }
}
