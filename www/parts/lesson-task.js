// <lesson-task name="half-height" for="figure-id">what to do</lesson-task>: a task that checks itself.
//
// www/tasks/<name>.js has these exports. All are optional, but there must be `check`, `predict` or `answer`:
//   check(figure, element) → { done, words, restore }    pure; `element` is the one that `for` names, `figure` its property. The words
//     are shown while the reader moves something. `restore(element)` undoes what the answer must not depend on; a button calls it
//   reveal(element)                             shows the answer in that element
//   predict = { options: [string, …], answer: index, because: string }    asked first; a click is the guess
//   answer = { values: [number, …], hints: { "64": string, … }, because: string }    numbers to be typed; hints for wrong ones
//
// Tasks that are done are stored (progress-store.js) and are still done on the next visit.
import { button, element } from "./dom.js";
import { isSolved, markSolved } from "./progress-store.js";

/** @typedef {{ done: boolean, words: string, restore?(element: any): void }} Verdict */
/** @typedef {{ options: string[], answer: number, because: string }} Prediction */
/** @typedef {{ values: number[], hints: Record<string, string>, because: string }} Answer hints by the values, with spaces between */
/** @typedef {{ check?(figure: any, element: any): Verdict, reveal?(element: any): void, predict?: Prediction, answer?: Answer }} Task */

/** @type {Record<string, () => Promise<Task>>} */
const TASKS = /** @type {any} */ (import.meta.glob("../tasks/*.js"));

/** Events of a target: the reader moved something, or the page did. */
const EVENTS = ["input", "change", "update"];
/** A task is solved when the reader rests on an answer for so long: passing one does not solve it. */
const REST_MS = 600;

export class LessonTask extends HTMLElement {
  /** @type {Task} */ #task = {};
  #steps = element("div", { className: "steps" });
  #words = element("p", { className: "words" });
  #buttons = element("div", { className: "buttons" });
  /** @type {number | null} */ #guess = null;
  /** Whether the answer to a question has been shown: to choose it then is no prediction. */ #knowsAnswer = false;
  #restore = button("Put it back", () => this.#putBack());
  #check = button("Check", () => void this.check(), "primary");
  #reveal = button("Reveal", () => void this.reveal());
  #again = button("Try again", () => this.#tryAgain());
  /** Whether the reader has moved something: before, nothing is judged unasked. */ #touched = false;
  #frame = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #rest;
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
    clearTimeout(this.#rest);
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
    const { predict, answer } = this.#task;
    if (!isSolved(this.getAttribute("name") ?? "")) return this.#ask();
    this.state = "done";
    this.#open();
    this.#say(["You have solved this task before.", (predict ?? answer)?.because].filter(Boolean).join(" "));
  }

  #ask() {
    const { predict, answer } = this.#task;
    this.dataset.state = "open";
    if (predict) this.#askFirst(predict);
    else if (answer) this.#askNumbers(answer);
    else this.#open();
  }

  #clear() {
    this.disconnectedCallback();
    this.#guess = null;
    this.#touched = this.#opened = false;
    this.#steps.replaceChildren();
    this.#buttons.replaceChildren();
    this.#say("");
  }

  /** Asks the question anew, also if it has been solved. */
  #tryAgain() {
    this.#clear();
    this.#ask();
    /** @type {HTMLElement | null} */ (this.querySelector("button, input"))?.focus({ preventScroll: true });
  }

  /** Starts again, with the question first. */
  reset() {
    this.#clear();
    this.#start();
    this.dispatchEvent(new Event("task-state", { bubbles: true }));
  }

  /** The prediction: one of several, before anything can be tried. @param {Prediction} predict */
  #askFirst({ options }) {
    const answers = element("div", { className: "answers", role: "group", ariaLabel: "Guess first" });
    const buttons = options.map((text, i) =>
      button(text, () => {
        this.#guess = i;
        for (const each of buttons) each.disabled = true;
        buttons[i].setAttribute("aria-pressed", "true");
        if (!this.#task.check) return this.#finishQuiz();
        this.#say("Now try it.");
        this.#open();
        this.#check.focus({ preventScroll: true });
      }),
    );
    answers.append(...buttons);
    this.#steps.append(answers);
  }

  /** Numbers to be typed. @param {Answer} answer */
  #askNumbers({ values, hints, because }) {
    const input = /** @type {any} */ (
      element("input", { type: "text", inputMode: values.length > 1 ? "text" : "decimal", autocomplete: "off" })
    );
    const name = values.length > 1 ? `Your answer, ${values.length} numbers` : "Your answer";
    const form = element("form", {}, element("label", {}, element("span", {}, name), input));
    const check = () => {
      const typed = numbersIn(input.value, values.length);
      if (typed === null)
        return this.#say(`Type ${values.length > 1 ? `${values.length} numbers` : "a number"} first.`);
      if (typed.some((value, i) => value !== values[i]))
        return this.#say(hints[typed.join(" ")] ?? "That is not the answer yet.");
      if (this.state === "open") this.state = "done";
      this.#buttons.replaceChildren(this.#again);
      this.#say(because);
    };
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      check();
    });
    const reveal = button("Reveal", () => {
      this.state = "revealed";
      input.value = values.join(", ");
      this.#buttons.replaceChildren(this.#again);
      this.#say(because);
    });
    this.#steps.append(form);
    this.#buttons.replaceChildren(button("Check", check, "primary"), reveal);
  }

  /** Without anything to try, the guess is the answer. */
  #finishQuiz() {
    const isRight = this.#guess === this.#task.predict?.answer;
    const judged = this.#judged();
    this.state = isRight ? "done" : "wrong";
    this.#knowsAnswer = true;
    this.#markAnswer();
    this.#buttons.replaceChildren(this.#again);
    this.#again.focus({ preventScroll: true });
    this.#say(judged);
  }

  /** Lets the reader try. */
  #open() {
    this.#opened = true;
    this.#restore.hidden = true;
    this.#showButtons();
    this.#listen();
  }

  /** Those of the state: what is solved can only be tried again. */
  #showButtons() {
    const { check, reveal } = this.#task;
    const isOver = this.state !== "open";
    this.#buttons.replaceChildren(
      ...(check && this.state !== "done" ? [this.#check] : []),
      ...(reveal && !isOver ? [this.#reveal] : []),
      ...(isOver ? [this.#again] : []),
      ...(check ? [this.#restore] : []),
    );
  }

  /** Marks the right one among the options. */
  #markAnswer() {
    const { predict } = this.#task;
    this.querySelectorAll(".answers button").forEach((each, i) =>
      each.classList.toggle("right", i === predict?.answer),
    );
  }

  #listen() {
    this.#target = this.#opened && this.#task.check ? this.target : null;
    for (const type of EVENTS) this.#target?.addEventListener(type, this);
  }

  /** Judges at most once a frame, after the reader moved something. @param {Event} event */
  handleEvent(event) {
    this.#touched ||= event.type !== "update";
    clearTimeout(this.#rest);
    if (!this.#touched || this.state === "done") return;
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      const verdict = this.#verdict();
      this.#show(verdict);
      if (verdict.done && this.state === "open") this.#rest = setTimeout(() => void this.check(), REST_MS);
    });
  }

  /** The target's script is loaded when it is near: where that takes long, the buttons wait. */
  async #defined() {
    if (this.target) await customElements.whenDefined(this.target.localName);
  }

  /** Checks now, and shows what is missing. */
  async check() {
    await this.#defined();
    const verdict = this.#verdict();
    if (verdict.done) this.#finish(verdict.words);
    else this.#show(verdict);
  }

  /** @param {Verdict} verdict */
  #show({ words, restore }) {
    this.#restore.hidden = !restore;
    this.#say(words);
  }

  /** Undoes what the answer must not depend on, as if the reader had done it. */
  #putBack() {
    const { target } = this;
    this.#verdict().restore?.(target);
    target?.dispatchEvent(new Event("change", { bubbles: true, composed: true }));
    /** @type {HTMLElement | null} */ (this.#buttons.querySelector("button"))?.focus();
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
    this.state = "revealed";
    this.#task.reveal?.(this.target);
    this.#restore.hidden = true;
    this.#markAnswer();
    this.#showButtons();
    this.#again.focus({ preventScroll: true });
    this.#say(["This is one answer.", this.#verdict().words, this.#judged()].filter(Boolean).join(" "));
  }

  /** @param {string} words */
  #finish(words) {
    const hasFocus = this.#buttons.contains(document.activeElement);
    this.state = "done";
    this.#restore.hidden = true;
    this.#markAnswer();
    this.#showButtons();
    if (hasFocus) this.#again.focus({ preventScroll: true });
    this.#say([words, this.#judged()].filter(Boolean).join(" "));
  }

  /** Whether the guess was right, and why. */
  #judged() {
    const { predict } = this.#task;
    if (!predict || this.#guess === null) return "";
    const right =
      this.#guess === predict.answer
        ? this.#knowsAnswer
          ? "Right."
          : "You predicted it."
        : `You predicted: ${predict.options[this.#guess]}. The answer is: ${predict.options[predict.answer]}.`;
    return `${right} ${predict.because}`;
  }

  /** @param {string} words */
  #say(words) {
    if (this.#words.textContent !== words) this.#words.textContent = words;
  }
}

/**
 * The numbers of an answer, or null if there are not as many as expected. A comma in a single number separates thousands.
 *
 * @param {string} text
 * @param {number} count
 */
function numbersIn(text, count) {
  const plain = text.replaceAll("−", "-").trim();
  const words = count === 1 ? [plain.replace(/[\s,](?=\d{3}\b)/g, "")] : plain.split(/[\s,;]+/);
  const numbers = words.map((word) => (word === "" ? NaN : Number(word)));
  return numbers.length === count && numbers.every(Number.isFinite) ? numbers : null;
}

customElements.define("lesson-task", LessonTask);
