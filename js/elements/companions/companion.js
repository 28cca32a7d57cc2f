// What all companions have in common: they wait until they are near, tell what the user does, and say what is wrong.
import { html, LitElement } from "lit";

/** A companion begins its work when it is so near to what is seen of the page. */
const NEAR = "300px";
/** A message quotes no more of an attribute. */
const MOST_QUOTED = 40;

export class Companion extends LitElement {
  /** @type {import("lit").PropertyDeclarations} */
  static properties = { theme: { reflect: true }, label: { reflect: true } };

  /** What is to be undone when the element leaves the page. @type {(() => void)[]} */
  #endings = [];
  #near = false;
  #said = "";
  /** What is wrong with the attributes, from one rendering to the next. @type {string[]} */
  #wrong = [];

  constructor() {
    super();
    this.theme = "auto";
    this.label = "";
  }

  /** Whether it works. @protected */
  get near() {
    return this.#near;
  }

  createRenderRoot() {
    const root = super.createRenderRoot();
    // What the inputs inside tell is for this element; it tells the page itself.
    for (const type of ["input", "change"]) root.addEventListener(type, (event) => event.stopPropagation());
    return root;
  }

  connectedCallback() {
    super.connectedCallback();
    const observer = new IntersectionObserver((entries) => this.#seen(entries[entries.length - 1].isIntersecting), { rootMargin: NEAR });
    observer.observe(this);
    const printing = () => this.renderNow();
    window.addEventListener("beforeprint", printing);
    this.#endings.push(() => observer.disconnect(), () => window.removeEventListener("beforeprint", printing));
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    for (const end of this.#endings.splice(0)) end();
    this.#near = false;
  }

  /**
   * Tells the page what the user does.
   *
   * @protected
   * @param {boolean} done
   */
  tell(done) {
    this.dispatchEvent(new Event(done ? "change" : "input", { bubbles: true, composed: true }));
  }

  /** @protected @param {string} message */
  say(message) {
    if (message === this.#said) return;
    this.#said = message;
    this.requestUpdate();
  }

  /**
   * What an attribute is used for: itself, or the default with a word about it.
   *
   * @protected
   * @template T
   * @param {string} name
   * @param {T} value
   * @param {boolean} usable
   * @param {string} expected
   * @param {T} fallback
   * @returns {T}
   */
  checked(name, value, usable, expected, fallback) {
    if (usable) return value;
    const came = typeof value === "string" ? value : this.getAttribute(name) ?? String(value);
    this.#wrong.push(`${name}: expected ${expected}, got “${came.slice(0, MOST_QUOTED)}”; ${fallback} is used.`);
    return fallback;
  }

  shouldUpdate() {
    return this.#near;
  }

  render() {
    this.#wrong = [];
    const content = this.content();
    const message = [...this.problems(), ...this.#wrong, this.#said].filter(Boolean).join(" ");
    return html`${content}<p class="message" part="message" role="status">${message}</p>`;
  }

  /** @protected @returns {unknown} what there is to see */
  content() {
    return "";
  }

  /** @protected @returns {string[]} what else is wrong */
  problems() {
    return [];
  }

  /** Wherever it is: paper shows what no one has scrolled to. @protected */
  renderNow() {
    const near = this.#near;
    this.#near = true;
    this.requestUpdate();
    this.performUpdate();
    this.#near = near;
  }

  /** @param {boolean} near */
  #seen(near) {
    if (near === this.#near) return;
    this.#near = near;
    if (near) this.requestUpdate();
  }
}
