import { FormField } from "./form-field.js";
import { LazyView } from "./loading.js";
import { PRESETS, readTiming, timingText } from "./timing.js";

/**
 * @import { Handles } from "./timing.js"
 */

const MISSING = "Choose an easing.";

/** `<bezier-easing>`; what can be set from outside is documented in types.js. */
export class BezierEasing extends FormField {
  /** @type {import("lit").PropertyDeclarations} */
  static properties = { value: { attribute: false, noAccessor: true } };
  static view = new LazyView(() => import("./easing-view.js"), "EasingView");

  /** @internal @type {Handles} */
  handles = [...PRESETS.ease];
  /** Whether someone has chosen; and whether it was other than the attribute. */
  #chosen = false;
  #dirty = false;
  #custom = "";

  /** The timing function as CSS writes it; empty while it is required and not chosen. */
  get value() {
    return this.#chosen || !this.required ? timingText(this.handles) : "";
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
    this.#report();
  }

  /**
   * @param {string} name
   * @param {string | null} old
   * @param {string | null} text
   */
  attributeChangedCallback(name, old, text) {
    super.attributeChangedCallback(name, old, text);
    if (name === "value" && !this.#dirty) this.#adopt(text ?? "");
    if (name === "required") this.#report();
  }

  formResetCallback() {
    this.#dirty = false;
    this.#adopt(this.defaultValue ?? "");
  }

  /** @param {string} state */
  formStateRestoreCallback(state) {
    this.value = state;
  }

  /** @param {string} message what is wrong with it besides; empty: nothing */
  setCustomValidity(message) {
    this.#custom = String(message);
    this.#report();
  }

  /**
   * @internal
   * The user chooses.
   *
   * @param {Handles} handles
   * @param {boolean} done
   */
  choose(handles, done) {
    this.handles = handles;
    this.#chosen = this.#dirty = true;
    this.say("");
    this.#report();
    this.requestUpdate();
    this.tell(done);
    this.view?.chosen?.(done);
  }

  /**
   * A text from outside; what cannot be read changes nothing and is told.
   *
   * @param {string} text
   */
  #adopt(text) {
    this.say("");
    try {
      this.handles = text ? readTiming(text) : [...PRESETS.ease];
      this.#chosen = text !== "";
    } catch (error) {
      this.say(`value: ${error instanceof Error ? error.message : error}; ${timingText(this.handles)} is kept.`);
    }
    this.#report();
    this.requestUpdate();
  }

  /** What the form is to know. */
  #report() {
    const missing = this.required && !this.#chosen;
    this.internals.setFormValue(this.value, this.value);
    this.internals.setValidity(
      { valueMissing: missing, customError: this.#custom !== "" },
      this.#custom || (missing ? MISSING : ""),
    );
  }
}
