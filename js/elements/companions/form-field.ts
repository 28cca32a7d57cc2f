// A companion that is a field of a form.
import { LitElement } from "lit";
import { writeAttribute } from "../attribute-text.js";
import { Companion } from "./companion.js";
import type { PropertyDeclarations, PropertyDeclaration } from "lit";

/** Properties that a form reads from the attributes, which therefore have to be up to date at any time. */
const READ_BY_FORMS: PropertyKey[] = ["name", "required", "disabled"];

/** What forms need besides the value. */
export class FormField extends Companion {
  declare defaultValue: string | null;
  declare name: string;
  declare required: boolean;
  declare disabled: boolean;

  static formAssociated = true;
  static shadowRootOptions = { ...LitElement.shadowRootOptions, delegatesFocus: true };
  static properties: PropertyDeclarations = {
    defaultValue: { attribute: "value", reflect: true, useDefault: true },
    name: { reflect: true, useDefault: true },
    required: { type: Boolean, reflect: true, useDefault: true },
    disabled: { type: Boolean, reflect: true, useDefault: true },
  };

  static getPropertyDescriptor(name: PropertyKey, key: string | symbol, options: PropertyDeclaration) {
    // biome-ignore lint/complexity/noThisInStatic: Lit's method reads the prototype of the class it is called on
    const accessor = super.getPropertyDescriptor(name, key, options);
    if (!READ_BY_FORMS.includes(name)) return accessor;
    return {
      ...accessor,
      set(this: FormField, value: unknown) {
        accessor.set?.call(this, value);
        if (this.#isMade) this.#reflect(String(name) as "name");
      },
    };
  }

  /** Before, the attributes are those of the page. */
  #isMade = false;
  /**
   * The form in which the element is a field, and its validity.
   *
   * @internal
   */
  internals = this.attachInternals();
  /** Whether a fieldset or the element itself is switched off. */
  #off = false;

  constructor() {
    super();
    this.defaultValue = null;
    this.name = "";
    this.required = false;
    this.disabled = false;
    this.#isMade = true;
    this.addEventListener("invalid", () => this.wake().then(() => this.renderNow())); // it must be seen what is missing
  }

  #reflect(name: "name" | "required" | "disabled") {
    const value = this[name];
    if (typeof value === "boolean") this.toggleAttribute(name, value);
    else if (value !== (this.getAttribute(name) ?? "")) this.setAttribute(name, value);
  }

  get form() {
    return this.internals.form;
  }

  /** The attribute `form`; frameworks write it to the property. */
  set form(id) {
    writeAttribute(this, "form", id ?? undefined);
  }

  get labels() {
    return this.internals.labels;
  }

  get validity() {
    return this.internals.validity;
  }

  get validationMessage() {
    return this.internals.validationMessage;
  }

  get willValidate() {
    return this.internals.willValidate;
  }

  checkValidity() {
    return this.internals.checkValidity();
  }

  reportValidity() {
    return this.internals.reportValidity();
  }

  /** @internal Whether it is switched off, by itself or by a fieldset. */
  get off() {
    return this.#off;
  }

  /** @internal What it is called: by the attribute, by a label of the page, or so. */
  nameFor(fallback: string) {
    const words = [...this.labels].map((label) => label.textContent?.trim()).filter(Boolean);
    return this.label || words.join(" ") || fallback;
  }

  formDisabledCallback(off: boolean) {
    this.#off = off;
    this.requestUpdate();
  }
}
