// A companion that follows the applet that its `for` names, whichever of the two comes first.
import { Companion } from "./companion.js";
import { loader } from "../loader.js";
import { elementFor, followIds } from "./links.js";
import { quoted } from "../../ui/numbers.js";
import type { PropertyDeclarations } from "lit";

/** What a companion needs of an applet. */
export type Target = HTMLElement & { figure: any; edit(change: object, done: boolean): void };

export class Linked extends Companion {
  declare htmlFor: string;

  static properties: PropertyDeclarations = {
    htmlFor: { attribute: "for", reflect: true, useDefault: true },
  };

  #target: Target | null = null;
  #frame = 0;
  /** The id that is looked for. */
  #id = "";
  #unwatch: (() => void) | null = null;
  /** The kind of element whose definition is awaited. */
  #awaited = "";
  /** Whether its code is loaded. */
  #isLoading = false;
  /** Why the link does not work. */
  #broken = "";

  constructor() {
    super();
    this.htmlFor = "";
  }

  /** The applet that `for` names; null while there is none. */
  get target() {
    return this.#target;
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#look("");
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }

  /**
   * @internal
   * The user chooses t here.
   */
  setT(t: number, done: boolean) {
    if (this.#target) this.#target.edit({ t }, done);
    else Object.assign(this, { t });
    this.notify(done);
  }

  willUpdate() {
    if (this.isConnected && this.near) this.#look(this.htmlFor ?? "");
  }

  /**
   * What is wrong with the link, in words.
   *
   * @internal
   */
  problems() {
    return [this.#broken];
  }

  /**
   * Looks for the applet, and goes on looking while elements and ids change.
   *
   * @param id empty: no longer
   */
  #look(id: string) {
    if (id === this.#id) return;
    this.#id = id;
    this.#unwatch?.();
    this.#unwatch = id ? followIds(this, () => this.#find()) : null;
    this.#find();
  }

  #find() {
    const found = this.#id ? elementFor(this, this.#id) : null;
    const able = found !== null && "edit" in found;
    const awaited = found !== null && !able && found.localName.includes("-") && !customElements.get(found.localName);
    if (awaited) this.#awaitDefinition(found.localName);
    const what = found ? `a ${found.localName}${awaited ? " that is not defined" : ""}` : "which is nowhere";
    const broken =
      able || (awaited && this.#isLoading) || !this.#id
        ? ""
        : `for: expected the id of a bezier-applet, got ${quoted(this.#id)}, ${what}.`;
    if (broken !== this.#broken) this.requestUpdate();
    this.#broken = broken;
    this.#follow(able ? (found as Target) : null);
  }

  async #awaitDefinition(name: string) {
    if (this.#awaited === name) return;
    this.#awaited = name;
    this.#isLoading = loader.request(name);
    await customElements.whenDefined(name);
    this.#awaited = "";
    if (this.#id) this.#find();
  }

  #follow(target: Target | null) {
    if (target === this.#target) return;
    for (const type of ["update", "focusin", "focusout"]) {
      this.#target?.removeEventListener(type, this.#updated);
      target?.addEventListener(type, this.#updated);
    }
    this.#target = target;
    this.requestUpdate();
  }

  /** However often the applet changes, a companion is drawn once a frame. */
  #updated = (event: Event) => {
    if (event.type !== "update") return this.view?.handleFocus?.(event);
    if (this.near) this.#frame ||= requestAnimationFrame(() => this.#refresh());
  };

  #refresh() {
    this.#frame = 0;
    this.requestUpdate();
  }
}
