// Number inputs that refuse what is no number, say so beside the field, and keep the last good value.
import { html, noChange, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { quoted, readNumber } from "./numbers.js";

/**
 * What the fields are for. Keys name them.
 *
 * @typedef {object} FieldsPort
 * @property {(key: string) => number} read
 * @property {(key: string, value: number, done: boolean) => void} write throws what is to be said to the user
 * @property {() => void} changed something is to be drawn again
 * @property {(key: string, text: string) => boolean} [paste] whether it took what was pasted, which is more than a number
 */

export class Fields {
  #port;
  /** The field that the user is in, whose text is left alone, and its value before. */
  #edited = { key: "", before: 0 };
  /** @type {Map<string, string>} */
  #errors = new Map();

  /** @param {FieldsPort} port */
  constructor(port) {
    this.#port = port;
  }

  /**
   * @param {string} key
   * @param {string} label
   * @param {{ step?: string, decimals?: number, disabled?: boolean }} [options]
   */
  field(key, label, { step = "any", decimals = 3, disabled = false } = {}) {
    const error = this.#errors.get(key);
    const text = this.#edited.key === key ? noChange : String(Number(this.#port.read(key).toFixed(decimals)));
    return html`<input type="number" part="field" step=${step} aria-label=${label} .value=${live(text)} ?disabled=${disabled} aria-invalid=${error ? "true" : nothing} aria-describedby=${error ? `error-${key}` : nothing}
        @focus=${() => this.#begin(key)} @blur=${(/** @type {Event} */ event) => this.#end(key, event)} @input=${(/** @type {Event} */ event) => this.#typed(key, event)}
        @change=${(/** @type {Event} */ event) => this.#done(key, event)} @keydown=${(/** @type {KeyboardEvent} */ event) => this.#pressed(key, event)} @paste=${(/** @type {ClipboardEvent} */ event) => this.#pasted(key, event)}>
      ${error ? html`<span class="error" id=${`error-${key}`} role="alert">${error}</span>` : nothing}`;
  }

  /** Takes all messages away. */
  clear() {
    this.#errors.clear();
  }

  /** The field that the user is in shows what is true again. */
  leave() {
    this.#edited.key = "";
    this.#port.changed();
  }

  /** @param {string} key */
  #begin(key) {
    this.#edited = { key, before: this.#port.read(key) };
  }

  /**
   * @param {string} key
   * @param {Event} event
   */
  #typed(key, event) {
    if (this.#edited.key !== key) this.#begin(key);
    const value = numberIn(event);
    if (!Number.isNaN(value)) this.#write(key, value, false);
  }

  /**
   * @param {string} key
   * @param {Event} event
   */
  #done(key, event) {
    const value = numberIn(event);
    if (!Number.isNaN(value)) {
      this.#edited.key = "";
      return this.#write(key, value, true);
    }
    const { validity, value: text } = /** @type {HTMLInputElement} */ (event.target);
    this.#refuse(key, validity?.badInput ? "what is none" : quoted(text));
  }

  /**
   * The user leaves: the last good value is shown again.
   *
   * @param {string} key
   * @param {Event} event
   */
  #end(key, event) {
    if (this.#edited.key !== key) return;
    if (Number.isNaN(numberIn(event)) && !this.#errors.has(key)) this.#done(key, event);
    this.leave();
  }

  /**
   * @param {string} key
   * @param {KeyboardEvent} event
   */
  #pressed(key, event) {
    if (event.key !== "Escape" || this.#edited.key !== key) return;
    const { before } = this.#edited;
    this.#edited.key = ""; // its text is written, too
    this.#write(key, before, true);
    this.#begin(key);
    /** @type {HTMLInputElement} */ (event.target).value = String(before);
  }

  /**
   * @param {string} key
   * @param {ClipboardEvent} event
   */
  #pasted(key, event) {
    const text = (event.clipboardData?.getData("text") ?? "").trim();
    if (!Number.isNaN(readNumber(text))) return;
    event.preventDefault(); // a number input would take the digits and drop the rest
    if (!this.#port.paste?.(key, text)) this.#refuse(key, quoted(text));
  }

  /**
   * @param {string} key
   * @param {number} value
   * @param {boolean} done
   */
  #write(key, value, done) {
    try {
      this.#port.write(key, value, done);
      this.#errors.delete(key);
    } catch (error) {
      if (done || value !== this.#port.read(key)) this.say(key, error instanceof Error ? error.message : String(error));
    }
    this.#port.changed();
  }

  /**
   * @param {string} key
   * @param {string} came
   */
  #refuse(key, came) {
    const good = this.#port.read(key);
    if (this.#edited.key === key && good !== this.#edited.before) this.#port.write(key, good, true); // what was typed before counts
    this.say(key, `Expected a number, got ${came}; ${Number(good.toFixed(3))} is kept.`);
  }

  /**
   * Says something at a field.
   *
   * @param {string} key
   * @param {string} message
   */
  say(key, message) {
    this.#errors.set(key, message);
    this.#port.changed();
  }
}

/** @param {Event} event of a field */
function numberIn(event) {
  return readNumber(/** @type {HTMLInputElement} */ (event.target).value);
}
