// What all companions have in common: they wait until they are near, report what the user does and what is wrong.
import { adoptStyles, css, html, LitElement, noChange, nothing } from "lit";
import { acceptAttributeText } from "../attribute-text.js";
import { followTranslations } from "../follow-translations.js";
import { missing } from "../loading.js";
import type { LazyView, View, ViewClass } from "./loading.js";
import type { PropertyDeclarations, PropertyDeclaration } from "lit";

/** Root margin for lazy loading. */
const NEAR = "300px";
/** A message quotes no more of an attribute. */
const MAX_QUOTED = 40;

/**
 * @fires input - during a change by the user
 * @fires change - at the end of a change by the user
 * @csspart frame - everything except the message
 * @csspart message - an error message
 */
export class Companion extends LitElement {
  declare theme: string;
  declare label: string;

  static properties: PropertyDeclarations = {
    theme: { reflect: true, useDefault: true },
    label: { reflect: true, useDefault: true },
  };
  static styles = css`:host { display: block; min-block-size: 3rem; } :host([hidden]) { display: none; }`;
  /** What shows this kind of companion; each subclass has its own. */
  static view: LazyView<any>;

  static getPropertyDescriptor(name: PropertyKey, key: string | symbol, options: PropertyDeclaration) {
    // biome-ignore lint/complexity/noThisInStatic: Lit's method reads the prototype of the class it is called on
    return acceptAttributeText(super.getPropertyDescriptor(name, key, options), name, options);
  }

  /** What is to be undone when the element leaves the page. */
  #endings: (() => void)[] = [];
  #near = false;
  #said = "";
  /** What is wrong with the attributes, each once, from one rendering to the next. */
  #wrong: Set<string> = new Set();
  /**
   * What draws the element; null before it is loaded.
   *
   * @internal
   */
  view: View | null = null;

  constructor() {
    super();
    followTranslations(this);
    this.theme = "auto";
    this.label = "";
  }

  /** @internal Whether it works. */
  get near() {
    return this.#near;
  }

  createRenderRoot() {
    const root = super.createRenderRoot();
    // Events of the inputs inside are for this element, which dispatches its own.
    for (const type of ["input", "change"]) root.addEventListener(type, (event) => event.stopPropagation());
    return root;
  }

  connectedCallback() {
    super.connectedCallback();
    const observer = new IntersectionObserver((entries) => this.#seen(entries[entries.length - 1].isIntersecting), {
      rootMargin: NEAR,
    });
    observer.observe(this);
    const printing = () => this.renderNow();
    window.addEventListener("beforeprint", printing);
    this.#endings.push(
      () => observer.disconnect(),
      () => window.removeEventListener("beforeprint", printing),
    );
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    for (const end of this.#endings.splice(0)) end();
    this.#near = false;
    this.view?.stop?.();
  }

  /**
   * @internal
   * Dispatches the event for what the user does.
   */
  notify(done: boolean) {
    this.dispatchEvent(new Event(done ? "change" : "input", { bubbles: true, composed: true }));
  }

  /**
   * Shows a message in the element; "" shows none.
   *
   * @internal
   */
  say(message: string) {
    if (message === this.#said) return;
    this.#said = message;
    this.requestUpdate();
  }

  /**
   * @internal
   * What an attribute is used for: itself, or the default with a word about it.
   */
  checked<T>(name: string, value: T, usable: boolean, expected: string, fallback: T): T {
    if (usable) return value;
    const came = typeof value === "string" ? value : (this.getAttribute(name) ?? String(value));
    this.#wrong.add(`${name}: expected ${expected}, got “${came.slice(0, MAX_QUOTED)}”; ${fallback} is used.`);
    return fallback;
  }

  /** Far from what is seen, only the attributes are brought up to date. */
  render(): unknown {
    if (!this.#near) return noChange;
    this.#wrong.clear();
    const content = this.view?.content() ?? nothing;
    const message = [...this.problems(), ...this.#wrong, this.#said].filter(Boolean).join(" ");
    return html`${content}<p class="message" part="message" role="status">${message}</p>`;
  }

  /** @internal What else is wrong. */
  problems(): string[] {
    return [];
  }

  /** @internal Wherever it is: paper shows what no one has scrolled to. */
  renderNow() {
    const near = this.#near;
    const View = (this.constructor as typeof Companion).view.loaded;
    if (View) this.view ??= this.#createView(View);
    this.#near = true;
    this.requestUpdate();
    this.performUpdate();
    this.#near = near;
  }

  #seen(near: boolean) {
    if (near === this.#near) return;
    this.#near = near;
    if (near) this.wake();
  }

  /** @internal Fetches what shows it, and shows it. */
  async wake() {
    try {
      const View = await (this.constructor as typeof Companion).view.load();
      this.view ??= this.#createView(View);
      this.say(this.#said === missing() ? "" : this.#said);
    } catch {
      this.say(missing());
    }
    this.requestUpdate();
  }

  #createView(View: ViewClass) {
    const { styles } = this.constructor as typeof Companion;
    adoptStyles(this.renderRoot as ShadowRoot, [styles, ...View.styles]);
    return new View(this);
  }
}
