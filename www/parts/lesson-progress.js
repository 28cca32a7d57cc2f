// <lesson-progress>About 60 minutes …</lesson-progress>: how many tasks of the page are solved, with buttons that export and reset this.
import { button, element } from "./dom.js";
import { exportText, forgetPage } from "./progress-store.js";

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
    this.append(
      time,
      this.#bar,
      this.#words,
      button("Export", () => download(exportText())),
      button("Reset", () => this.#reset()),
    );
  }

  /** @returns {import("./lesson-task.js").LessonTask[]} */
  get #tasks() {
    return /** @type {any[]} */ ([...document.querySelectorAll("lesson-task")]);
  }

  /** Counts again. */
  handleEvent() {
    const tasks = this.#tasks;
    const done = tasks.filter(({ dataset }) => dataset.state === "done").length;
    this.#bar.max = tasks.length;
    this.#bar.value = done;
    this.#words.textContent = `${done} of ${tasks.length} tasks solved`;
  }

  #reset() {
    if (!confirm("Forget which tasks of this page you have solved?")) return;
    forgetPage();
    for (const task of this.#tasks) task.reset();
  }
}

/** @param {string} text */
function download(text) {
  const url = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  element("a", { href: url, download: FILE_NAME }).click();
  setTimeout(() => URL.revokeObjectURL(url));
}

customElements.define("lesson-progress", LessonProgress);
