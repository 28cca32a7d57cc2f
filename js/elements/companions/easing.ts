import { FormField } from "./form-field.js";
import { LazyView } from "./loading.js";
import { PRESETS, readTiming, timingText } from "./timing.js";
import { translated } from "../../editor/translations.js";
import type { Handles } from "./timing.js";
import type { PropertyDeclarations } from "lit";

/** `<bezier-easing>`; what can be set from outside is documented in types.js. */
export class BezierEasing extends FormField {
  static properties: PropertyDeclarations = { value: { attribute: false, noAccessor: true } };
  static view = new LazyView(() => import("./easing-view.js"), "EasingView");

  /**
   * The two inner control points of the timing function: x1, y1, x2, y2.
   *
   * @internal
   */
  handles: Handles = [...PRESETS.ease];
  /** Whether someone has chosen; and whether it was other than the attribute. */
  #hasValue = false;
  #dirty = false;
  #custom = "";

  /** The timing function as CSS writes it; empty while it is required and not chosen. */
  get value() {
    return this.#hasValue || !this.required ? timingText(this.handles) : "";
  }

  set value(text) {
    this.#dirty = true;
    this.#adopt(String(text ?? ""));
  }

  get type() {
    return "bezier-easing";
  }

  connectedCallback() {
    super.connectedCallback();
    this.performUpdate(); // properties that were set before the element was defined: its form has them at once
    this.#report();
  }

  attributeChangedCallback(name: string, old: string | null, text: string | null) {
    super.attributeChangedCallback(name, old, text);
    if (name === "value" && !this.#dirty) this.#adopt(text ?? "");
    if (name === "required") this.#report();
  }

  formResetCallback() {
    this.#dirty = false;
    this.#adopt(this.defaultValue ?? "");
  }

  formStateRestoreCallback(state: string) {
    this.value = state;
  }

  /** @param message what is wrong with it besides; empty: nothing */
  setCustomValidity(message: string) {
    this.#custom = String(message);
    this.#report();
  }

  /**
   * @internal
   * The user chooses.
   */
  choose(handles: Handles, done: boolean) {
    this.handles = handles;
    this.#hasValue = this.#dirty = true;
    this.say("");
    this.#report();
    this.requestUpdate();
    this.notify(done);
    this.view?.onChange?.(done);
  }

  /** A text from outside; what cannot be read changes nothing and is told. */
  #adopt(text: string) {
    this.say("");
    try {
      this.handles = text ? readTiming(text) : [...PRESETS.ease];
      this.#hasValue = text !== "";
    } catch (error) {
      this.say(`value: ${error instanceof Error ? error.message : error}; ${timingText(this.handles)} is kept.`);
    }
    this.#report();
    this.requestUpdate();
  }

  /** What the form is to know. */
  #report() {
    const missing = this.required && !this.#hasValue;
    this.internals.setFormValue(this.value, this.value);
    this.internals.setValidity(
      { valueMissing: missing, customError: this.#custom !== "" },
      this.#custom || (missing ? translated("Choose an easing.") : ""),
    );
  }
}
