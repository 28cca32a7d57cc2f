// The element's attributes: those that are parts of the state, read as any text, and those that are about the element.
import { followTranslations } from "../follow-translations.js";
import { LitElement } from "lit";
import { acceptAttributeText, CONTROLS } from "../attribute-text.js";
import { withJoints } from "../../editor/commands.js";
import { FIELDS, VIEW } from "../../editor/schema.js";
import { Editor } from "../../editor/editor.js";
import { firstState } from "../../editor/state.js";
import type { State } from "../../editor/state.js";

/** Defaults are not reflected. */
const text = (first: string) => ({
  converter: {
    fromAttribute: (value: string | null) => value ?? first,
    toAttribute: (value: unknown) => (value === first ? null : String(value)),
  },
  reflect: true,
});
/** Keeps the state and the attributes the same. */
export class AppletAttributes extends LitElement {
  declare controls: string | boolean | null;
  declare readonly: boolean;
  declare hotkeys: string;
  declare theme: string;
  declare label: string;

  static properties = {
    controls: CONTROLS,
    readonly: { type: Boolean, reflect: true },
    hotkeys: text("on"),
    theme: text("auto"),
    label: text(""),
  };

  static getPropertyDescriptor(name: PropertyKey, key: string | symbol, options: import("lit").PropertyDeclaration) {
    // biome-ignore lint/complexity/noThisInStatic: Lit's method reads the prototype of the class it is called on
    return acceptAttributeText(super.getPropertyDescriptor(name, key, options), name, options);
  }

  static get observedAttributes() {
    // biome-ignore lint/complexity/noThisInStatic: Lit's getter reads the properties of the class it is called on
    return [...super.observedAttributes, ...Object.keys(FIELDS)];
  }

  #editor = new Editor<State>(firstState(), ["view", "pointer", "segment"], ["view", "pointer"]);
  /** Attributes that have been written from outside and not yet been read. */
  #unread: Set<string> = new Set();
  /** What is wrong with the attributes; each is also said in the console, once. */
  #problems: Map<string, string> = new Map();
  /** What the attributes say, or what the state said when they were read. */
  #known: Map<string, string> = new Map(
    Object.entries(FIELDS).map(([name, { write }]) => [name, write(this.#editor.state)]),
  );
  #writing = false;

  constructor() {
    super();
    // The layers and joints are described anew for a new state.
    followTranslations(this, () => this.editor.show({ ...this.editor.state }));
    this.controls = null;
    this.readonly = false;
    this.hotkeys = "on";
    this.theme = "auto";
    this.label = "";
  }

  /** @internal The editor, in whose state all attributes have been read. */
  get editor(): Editor<State> {
    if (this.#unread.size) this.#read();
    return this.#editor;
  }

  /** @internal What is wrong with the attributes. */
  get problems() {
    return [...this.#problems.values()];
  }

  attributeChangedCallback(name: string, before: string | null, value: string | null) {
    if (!Object.hasOwn(FIELDS, name)) return super.attributeChangedCallback(name, before, value);
    if (this.#writing) return;
    this.#unread.add(name);
    this.requestUpdate();
  }

  willUpdate(changed: import("lit").PropertyValues) {
    super.willUpdate(changed);
    if (this.#unread.size) this.#read();
  }

  /** The last good value of an attribute stays where a new one is invalid. */
  #read() {
    const names = Object.keys(FIELDS).filter((name) => this.#unread.has(name));
    this.#unread.clear();
    let { state } = this.#editor;
    for (const name of names) {
      const before = this.#problems.get(name);
      this.#problems.delete(name);
      try {
        state = readAttribute(state, name, this.getAttribute(name));
      } catch (error) {
        const problem = error instanceof Error ? error.message : String(error);
        this.#problems.set(name, problem);
        if (problem !== before) console.warn(`<${this.localName}> ${problem}`);
      }
    }
    if (names.includes("joints")) state = withJoints(state, state.joints);
    for (const name of names) this.#known.set(name, FIELDS[name].write(state));
    this.#editor.show(state);
  }

  /** @internal What has changed otherwise than by an attribute is written into it. */
  reflectState() {
    const { state } = this.editor;
    this.#writing = true;
    for (const [name, { write }] of Object.entries(FIELDS)) {
      const value = write(state);
      if (value === this.#known.get(name)) continue;
      this.#known.set(name, value);
      this.#problems.delete(name);
      if ((name === "mode" || name === "weights") && value === "") this.removeAttribute(name);
      else this.setAttribute(name, value);
    }
    this.#writing = false;
  }
}

/** The state with what an attribute says; null stands for the default. */
function readAttribute(state: State, name: string, given: string | null): State {
  const { parse, put, get } = FIELDS[name];
  return put(state, given === null ? get(firstState()) : parse(given));
}

/** A number, a word, a list of numbers, or a view. */
function attributeText(value: unknown): string {
  if (Array.isArray(value)) return value.join(" ");
  if (typeof value !== "object" || value === null) return String(value);
  return VIEW.map((name) => (value as Record<string, unknown>)[name]).join(" ");
}

for (const name of Object.keys(FIELDS)) {
  if (["points", "joints", "t"].includes(name)) continue; // these are data, see element.js
  Object.defineProperty(AppletAttributes.prototype, name, {
    configurable: true,
    enumerable: true,
    get(this: any) {
      const { get, write } = FIELDS[name];
      return name === "show" ? write(this.editor.state) : get(this.editor.state);
    },
    set(this: HTMLElement, value: unknown) {
      if (value === null || value === undefined) this.removeAttribute(name);
      else this.setAttribute(name, attributeText(value));
    },
  });
}
