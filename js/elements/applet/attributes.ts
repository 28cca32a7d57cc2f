// The attributes of `<bezier-applet>` that are parts of the state: any text is read, and what has changed otherwise is written.
import { attributeName, writeAttribute } from "../attribute-text.js";
import { Problems } from "../../editor/check.js";
import { withJoints } from "../../editor/commands.js";
import { FIELDS, VIEW } from "../../editor/schema.js";
import { firstState } from "../../editor/state.js";
import type { LitElement, ReactiveController } from "lit";
import type { Editor } from "../../editor/editor.js";
import type { State } from "../../editor/state.js";

/** The fields of the state, by their attributes. */
export const FIELD_NAMES: ReadonlyMap<string, string> = new Map(
  Object.keys(FIELDS).map((name) => [attributeName(name), name]),
);

/** Keeps the state and the attributes the same. */
export class AppletAttributes implements ReactiveController {
  #host: LitElement;
  #editor: Editor<State>;
  /** Attributes that have been written from outside and not yet been read. */
  #unread: Set<string> = new Set();
  #problems = new Problems((problem) => console.warn(`<${this.#host.localName}> ${problem}`));
  /** What the attributes say, or what the state said when they were read. */
  #known: Map<string, string>;
  #isWriting = false;

  constructor(host: LitElement, editor: Editor<State>) {
    this.#host = host;
    this.#editor = editor;
    this.#known = new Map(Object.entries(FIELDS).map(([name, { write }]) => [name, write(editor.state)]));
    host.addController(this);
  }

  /** What is wrong with the attributes. */
  get problems() {
    return this.#problems.messages;
  }

  /** An attribute has changed. It is read later, because its meaning may depend on attributes that come after it. */
  changed(name: string) {
    if (this.#isWriting) return;
    this.#unread.add(name);
    this.#host.requestUpdate();
  }

  hostUpdate() {
    this.read();
  }

  /** While the user is doing something, the attributes stay as they are. */
  hostUpdated() {
    if (!this.#editor.isOpen) this.#write();
  }

  /** Reads what has been written. The last good value of an attribute stays where a new one is invalid. */
  read() {
    if (!this.#unread.size) return;
    const names = Object.keys(FIELDS).filter((name) => this.#unread.has(name));
    this.#unread.clear();
    let { state } = this.#editor;
    for (const name of names) {
      this.#problems.attempt(name, () => {
        state = readAttribute(state, name, this.#host.getAttribute(attributeName(name)));
      });
    }
    if (names.includes("joints")) state = withJoints(state, state.joints);
    for (const name of names) this.#known.set(name, FIELDS[name].write(state));
    this.#editor.replaceState(state);
  }

  /** What has changed otherwise than by an attribute is written into it. */
  #write() {
    const { state } = this.#editor;
    this.#isWriting = true;
    for (const [name, { write }] of Object.entries(FIELDS)) {
      const value = write(state);
      if (value === this.#known.get(name)) continue;
      this.#known.set(name, value);
      this.#problems.forget(name);
      writeAttribute(this.#host, name, EMPTY_MEANS_NONE.includes(name) && value === "" ? undefined : value);
    }
    this.#isWriting = false;
  }
}

/** The state with what an attribute says; null stands for the default. */
function readAttribute(state: State, name: string, given: string | null): State {
  const { parse, put, get } = FIELDS[name];
  return put(state, given === null ? get(firstState()) : parse(given));
}

/** Fields whose attribute is absent where their text would be empty. */
const EMPTY_MEANS_NONE = ["visiblePoints", "weights"];

/** A number, a word, a list of numbers, or a view. */
function attributeText(value: unknown): string {
  if (Array.isArray(value)) return value.join(" ");
  if (typeof value !== "object" || value === null) return String(value);
  return VIEW.map((name) => (value as Record<string, unknown>)[name]).join(" ");
}

/** The attributes whose properties have values of their own: lists, and t. */
const DATA = ["points", "joints", "t"];

/**
 * Defines a property for each other attribute: it is written as an attribute is, and read from the state.
 *
 * @param stateOf the state of an element
 */
export function defineProperties<Element extends HTMLElement>(
  prototype: Element,
  stateOf: (element: Element) => State,
) {
  for (const name of Object.keys(FIELDS)) {
    if (DATA.includes(name)) continue;
    Object.defineProperty(prototype, name, {
      configurable: true,
      enumerable: true,
      get(this: Element) {
        const { get, write } = FIELDS[name];
        return name === "show" ? write(stateOf(this)) : get(stateOf(this));
      },
      set(this: Element, value: unknown) {
        writeAttribute(this, name, value === null || value === undefined ? undefined : attributeText(value));
      },
    });
  }
}
