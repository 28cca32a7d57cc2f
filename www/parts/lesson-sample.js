// <lesson-sample name="eval">: the code of www/samples/eval.js and .rs in two tabs, and a button that runs the former. The JavaScript can be
// edited; what has been edited runs in a worker (sample-worker.js), for at most so long:
const MAX_SECONDS = 5;
// The code itself is in the page already (www/build/samples.js writes it there); without JavaScript both stand below each other.
import { button, uniqueId } from "./dom.js";

/** Each sample's module, fetched when it is run. @type {Record<string, () => Promise<{ sample(print: (...values: unknown[]) => void): unknown }>>} */
const MODULES = /** @type {any} */ (import.meta.glob("../samples/*.js"));

const TITLES = { js: "JavaScript", rs: "Rust" };

/**
 * What edited code prints.
 *
 * @param {string} code
 * @returns {Promise<string>}
 */
function runEdited(code) {
  const worker = new Worker(new URL("./sample-worker.js", import.meta.url), { type: "module" });
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timeout;
  const result = new Promise((resolve) => {
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = ({ message }) => resolve(message || "The worker could not be started.");
    timeout = setTimeout(() => resolve(`stopped after ${MAX_SECONDS} seconds`), 1000 * MAX_SECONDS);
    worker.postMessage(code);
  });
  return result.finally(() => {
    clearTimeout(timeout);
    worker.terminate();
  });
}

export class LessonSample extends HTMLElement {
  /** @type {HTMLButtonElement[]} */ #tabs = [];
  /** @type {HTMLElement[]} */ #panels = [];
  #output = document.createElement("output");
  /** @type {HTMLElement | null} */ #code = null;
  #original = "";
  #undo = button("Undo edits", () => this.#undoEdits());
  #built = false;

  connectedCallback() {
    if (!this.#built) this.#build();
    this.show(document.documentElement.dataset.language ?? "js");
  }

  #build() {
    this.#built = true;
    this.#panels = [...this.querySelectorAll("pre")];
    for (const panel of this.#panels) this.#tabs.push(this.#tab(panel));
    const list = document.createElement("div");
    list.setAttribute("role", "tablist");
    list.setAttribute("aria-label", "Language");
    list.append(...this.#tabs);
    list.addEventListener("keydown", (event) => this.#onKey(event));
    this.#makeEditable();
    const copy = button("Copy", () => this.#copy(copy));
    const bar = document.createElement("div");
    bar.className = "bar";
    bar.append(
      list,
      button("Run", () => void this.run(), "run"),
      this.#undo,
      copy,
    );
    this.#output.hidden = true;
    this.#output.setAttribute("aria-label", "Output");
    this.prepend(bar);
    this.append(this.#output);
  }

  #makeEditable() {
    this.#undo.hidden = true;
    this.#code = this.querySelector("pre[data-language=js] code");
    if (!this.#code) return;
    this.#original = this.#code.innerHTML;
    this.#code.contentEditable = "plaintext-only";
    this.#code.spellcheck = false;
    this.#code.setAttribute("role", "textbox");
    this.#code.setAttribute("aria-multiline", "true");
    this.#code.setAttribute("aria-label", "JavaScript, can be edited");
    this.#code.addEventListener("input", () => (this.#undo.hidden = !this.#isEdited));
  }

  get #isEdited() {
    return this.#code !== null && this.#code.innerHTML !== this.#original;
  }

  #undoEdits() {
    if (this.#code) this.#code.innerHTML = this.#original;
    this.#undo.hidden = true;
    this.#output.hidden = true;
    this.#code?.focus();
  }

  /** @param {HTMLElement} panel */
  #tab(panel) {
    const language = /** @type {keyof typeof TITLES} */ (panel.dataset.language ?? "js");
    const tab = button(TITLES[language], () => chooseLanguage(language));
    tab.id = uniqueId("tab");
    tab.setAttribute("role", "tab");
    tab.dataset.language = language;
    panel.id = uniqueId("panel");
    tab.setAttribute("aria-controls", panel.id);
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", tab.id);
    panel.tabIndex = 0;
    return tab;
  }

  /** Shows one language. @param {string} language "js" or "rs" */
  show(language) {
    this.#tabs.forEach((tab, i) => {
      const chosen = tab.dataset.language === language;
      tab.setAttribute("aria-selected", String(chosen));
      tab.tabIndex = chosen ? 0 : -1;
      this.#panels[i].hidden = !chosen;
    });
  }

  /** Runs the JavaScript and shows what it prints. */
  async run() {
    const lines = /** @type {string[]} */ ([]);
    this.#output.hidden = false;
    if (this.#isEdited) {
      this.#output.textContent = "running";
      this.#output.textContent = await runEdited(this.#code?.textContent ?? "");
      return;
    }
    try {
      const load = MODULES[`../samples/${this.getAttribute("name")}.js`];
      if (!load) throw new Error(`there is no sample of the name ${this.getAttribute("name")}`);
      await (await load()).sample((...values) => lines.push(values.join(" ")));
    } catch (error) {
      lines.push(String(error));
    }
    this.#output.textContent = lines.join("\n");
  }

  /** @param {KeyboardEvent} event */
  #onKey(event) {
    const at = this.#tabs.indexOf(/** @type {HTMLButtonElement} */ (event.target));
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: -1 }[event.key];
    if (to === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const tab = this.#tabs.at(to % this.#tabs.length);
    tab?.click();
    tab?.focus();
  }

  /** @param {HTMLButtonElement} copy */
  async #copy(copy) {
    const text = this.#panels.find((panel) => !panel.hidden)?.textContent ?? "";
    copy.textContent = await navigator.clipboard.writeText(`${text}\n`).then(
      () => "Copied",
      () => "Not allowed",
    );
    setTimeout(() => (copy.textContent = "Copy"), 2000);
  }
}

/** Whoever reads one sample in Rust reads them all in Rust. @param {string} language */
function chooseLanguage(language) {
  document.documentElement.dataset.language = language;
  for (const sample of document.querySelectorAll("lesson-sample")) /** @type {LessonSample} */ (sample).show(language);
}

customElements.define("lesson-sample", LessonSample);
