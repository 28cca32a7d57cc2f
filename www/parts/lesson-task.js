// <lesson-task name="half-height" for="figure-id">what to do</lesson-task>: a task that checks itself.
//
// www/tasks/<name>.js has these exports. All are optional, but there must be `check` or `predict`:
//   check(figure, element) → { done, words }    pure; `element` is the one that `for` names, `figure` its property
//   reveal(element)                             shows the answer in that element
//   live = true                                 shows the words of `check` while the reader moves something
//   predict = { options: [string, …], answer: index, because: string }    asked first
//
// Tasks that are done are stored (progress-store.js) and are still done on the next visit.
import { button, element, uniqueId } from "./dom.js";
import { isSolved, markSolved } from "./progress-store.js";

/** @typedef {{ done: boolean, words: string }} Verdict */
/** @typedef {{ options: string[], answer: number, because: string }} Prediction */
/** @typedef {{ check?(figure: any, element: any): Verdict, reveal?(element: any): void, live?: boolean, predict?: Prediction }} Task */

/** @type {Record<string, () => Promise<Task>>} */
const TASKS = /** @type {any} */ (import.meta.glob("../tasks/*.js"));

/** Events of a target: the reader moved something, or the page did. */
const EVENTS = ["input", "change", "update"];

export class LessonTask extends HTMLElement {
  /** @type {Task} */ #task = {};
  #steps = element("div", { className: "steps" });
  #words = element("p", { className: "words" });
  #buttons = element("div", { className: "buttons" });
  /** @type {number | null} */ #guess = null;
  /** Whether the reader has moved something: before, nothing is judged unasked. */ #touched = false;
  /** Whether the reader is moving something: passing an answer does not solve the task, stopping at it does. */ #isMoving = false;
  #frame = 0;
  #built = false;
  #opened = false;
  /** @type {EventTarget | null} */ #target = null;

  connectedCallback() {
    if (!this.#built) void this.#build();
    else this.#listen();
  }

  disconnectedCallback() {
    for (const type of EVENTS) this.#target?.removeEventListener(type, this);
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#target = null;
  }

  /** "open" until the task is "done", or its answer "revealed", or the answer to a question "wrong". */
  get state() {
    return this.dataset.state ?? "open";
  }

  set state(to) {
    this.dataset.state = to;
    if (to === "done") markSolved(this.getAttribute("name") ?? "");
    this.dispatchEvent(new Event("task-state", { bubbles: true }));
  }

  /** The element that the task is about, or null. */
  get target() {
    const id = this.getAttribute("for");
    return id ? document.getElementById(id) : null;
  }

  async #build() {
    this.#built = true;
    const prompt = element("div", { className: "prompt" }, ...this.childNodes);
    this.#words.setAttribute("role", "status");
    this.append(prompt, this.#steps, this.#buttons, this.#words);
    try {
      const load = TASKS[`../tasks/${this.getAttribute("name")}.js`];
      if (!load) throw new Error(`there is no task of the name ${this.getAttribute("name")}`);
      this.#task = await load();
    } catch (error) {
      return this.#say(String(error));
    }
    this.#start();
  }

  #start() {
    const { predict } = this.#task;
    if (isSolved(this.getAttribute("name") ?? "")) {
      this.state = "done";
      this.#open();
      this.#say(["You have solved this task before.", predict?.because].filter(Boolean).join(" "));
    } else {
      this.dataset.state = "open";
      if (predict) this.#askFirst(predict);
      else this.#open();
    }
  }

  /** Starts again, with the question first. */
  reset() {
    this.disconnectedCallback();
    this.#guess = null;
    this.#touched = this.#opened = this.#isMoving = false;
    this.#steps.replaceChildren();
    this.#say("");
    this.#start();
    this.dispatchEvent(new Event("task-state", { bubbles: true }));
  }

  /** The prediction: one of several, before anything can be tried. @param {Prediction} predict */
  #askFirst({ options }) {
    const name = uniqueId("guess");
    const radios = options.map((text, i) => {
      const radio = Object.assign(document.createElement("input"), { type: "radio", name, value: String(i) });
      return element("label", {}, radio, element("span", {}, text));
    });
    const field = element("fieldset", {}, element("legend", {}, "Predict first"), ...radios);
    const guess = button("That is my guess", () => {
      const chosen = /** @type {HTMLInputElement | null} */ (field.querySelector("input:checked"));
      if (!chosen) return this.#say("Choose one first.");
      this.#guess = Number(chosen.value);
      /** @type {any} */ (field).disabled = true;
      if (this.#task.check) this.#say("Now try it.");
      this.#open();
      /** @type {HTMLElement | null} */ (this.#buttons.querySelector("button"))?.focus();
      if (!this.#task.check) this.#finishQuiz();
    });
    this.#steps.append(field);
    this.#buttons.replaceChildren(guess);
  }

  /** Without anything to try, the guess is the answer. */
  #finishQuiz() {
    const isRight = this.#guess === this.#task.predict?.answer;
    this.state = isRight ? "done" : "wrong";
    if (!isRight) this.#buttons.replaceChildren(button("Try again", () => this.reset()));
    this.#say(this.#judged());
  }

  /** Lets the reader try. */
  #open() {
    this.#opened = true;
    const buttons = [];
    if (this.#task.check) buttons.push(button("Check", () => this.check()));
    if (this.#task.reveal) buttons.push(button("Reveal", () => this.reveal()));
    this.#buttons.replaceChildren(...buttons);
    this.#listen();
  }

  #listen() {
    this.#target = this.#opened && this.#task.check ? this.target : null;
    for (const type of EVENTS) this.#target?.addEventListener(type, this);
  }

  /** The live check: at most once a frame, after the reader moved something. @param {Event} event */
  handleEvent(event) {
    this.#touched ||= event.type !== "update";
    if (event.type !== "update") this.#isMoving = event.type === "input";
    if (!this.#touched || this.state !== "open") return;
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      const verdict = this.#verdict();
      if (verdict.done && !this.#isMoving) this.#finish(verdict.words);
      else if (this.#task.live) this.#say(verdict.words);
    });
  }

  /** The target's script is loaded when it is near: where that takes long, the buttons wait. */
  async #defined() {
    if (this.target) await customElements.whenDefined(this.target.localName);
  }

  /** Checks now, and shows what is missing. */
  async check() {
    await this.#defined();
    const { done, words } = this.#verdict();
    if (done) this.#finish(words);
    else this.#say(words);
  }

  /** @returns {Verdict} */
  #verdict() {
    const target = this.target;
    try {
      return this.#task.check?.(/** @type {any} */ (target)?.figure, target) ?? { done: false, words: "" };
    } catch (error) {
      return { done: false, words: `This cannot be checked: ${error}` };
    }
  }

  /** Shows the answer. What was done already stays done. */
  async reveal() {
    await this.#defined();
    const done = this.state === "done";
    if (!done) this.state = "revealed";
    this.#task.reveal?.(this.target);
    if (!done) this.#say(["This is one answer.", this.#verdict().words, this.#judged()].filter(Boolean).join(" "));
  }

  /** @param {string} words */
  #finish(words) {
    this.state = "done";
    this.#say([words, this.#judged()].filter(Boolean).join(" "));
  }

  /** Whether the guess was right, and why. */
  #judged() {
    const { predict } = this.#task;
    if (!predict || this.#guess === null) return "";
    const right =
      this.#guess === predict.answer
        ? "You predicted it."
        : `You predicted: ${predict.options[this.#guess]}. The answer is: ${predict.options[predict.answer]}.`;
    return `${right} ${predict.because}`;
  }

  /** @param {string} words */
  #say(words) {
    if (this.#words.textContent !== words) this.#words.textContent = words;
  }
}

customElements.define("lesson-task", LessonTask);
