// <lesson-progress data-tasks="half-height half-pixel …">About 60 minutes …</lesson-progress>: how many of these tasks are solved; with
// data-buttons, there are buttons that export and reset this. Lists of sections mark those whose tasks are solved.
import { button, element } from "./dom.js";
import { exportText, forgetChapter, isSolved } from "./progress-store.js";

const FILE_NAME = "casteljau-progress.json";

class LessonProgress extends HTMLElement {
  #bar = document.createElement("progress");
  #words = element("span", { role: "status" });
  #isBuilt = false;

  connectedCallback() {
    if (!this.#isBuilt) this.#build();
    document.addEventListener("task-state", this);
    this.handleEvent();
  }

  disconnectedCallback() {
    document.removeEventListener("task-state", this);
  }

  #build() {
    this.#isBuilt = true;
    const time = element("span", {}, ...this.childNodes);
    this.#bar.setAttribute("aria-label", "Solved tasks");
    this.append(...(time.textContent ? [time] : []), this.#bar, this.#words);
    if (this.dataset.buttons === undefined) return;
    this.append(
      button("Export", () => download(exportText())),
      button("Reset", () => this.#reset()),
    );
  }

  /** Counts again. */
  handleEvent() {
    const tasks = namesOf(this);
    const done = tasks.filter(isSolved).length;
    this.#bar.max = tasks.length;
    this.#bar.value = done;
    this.#words.textContent = `${done} of ${tasks.length} tasks solved`;
    for (const section of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("li[data-tasks]")))
      section.classList.toggle("solved", namesOf(section).length > 0 && namesOf(section).every(isSolved));
  }

  #reset() {
    if (!confirm("Forget which tasks of this chapter you have solved?")) return;
    forgetChapter();
    for (const task of /** @type {NodeListOf<import("./lesson-task.js").LessonTask>} */ (
      document.querySelectorAll("lesson-task")
    ))
      task.reset();
    this.handleEvent();
  }
}

/** @param {HTMLElement} element */
const namesOf = ({ dataset }) => dataset.tasks?.split(" ").filter(Boolean) ?? [];

/** @param {string} text */
function download(text) {
  const url = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  element("a", { href: url, download: FILE_NAME }).click();
  setTimeout(() => URL.revokeObjectURL(url));
}

customElements.define("lesson-progress", LessonProgress);
