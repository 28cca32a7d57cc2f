// Number inputs that refuse what is no number, say so beside the field, and keep the last good value.
import { html, noChange, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { quoted, readNumber } from "./numbers.js";
import { translated } from "../editor/translations.js";

/** What the fields are for. Keys name them. */
export interface FieldsPort {
  read: (key: string) => number;
  /** Throws what is to be said to the user */
  write: (key: string, value: number, done: boolean) => void;
  /** Something is to be drawn again */
  changed: () => void;
  /** Whether it took what was pasted, which is more than a number */
  paste?: (key: string, text: string) => boolean;
}

export class Fields {
  #port;
  /** The field that the user is in, whose text is left alone, and its value before. */
  #edited = { key: "", before: 0 };
  #errors: Map<string, string> = new Map();

  constructor(port: FieldsPort) {
    this.#port = port;
  }

  field(
    key: string,
    label: string,
    { step = "any", decimals = 3, disabled = false }: { step?: string; decimals?: number; disabled?: boolean } = {},
  ) {
    const error = this.#errors.get(key);
    const text = this.#edited.key === key ? noChange : String(Number(this.#port.read(key).toFixed(decimals)));
    return html`<input type="number" part="field" step=${step} aria-label=${label} .value=${live(text)} ?disabled=${disabled} aria-invalid=${error ? "true" : nothing} aria-describedby=${error ? `error-${key}` : nothing}
        @focus=${() => this.#begin(key)} @blur=${(event: Event) => this.#end(key, event)} @input=${(event: Event) => this.#typed(key, event)}
        @change=${(event: Event) => this.#done(key, event)} @keydown=${(event: KeyboardEvent) => this.#pressed(key, event)} @paste=${(event: ClipboardEvent) => this.#pasted(key, event)}>
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

  #begin(key: string) {
    this.#edited = { key, before: this.#port.read(key) };
  }

  #typed(key: string, event: Event) {
    if (this.#edited.key !== key) this.#begin(key);
    const value = numberIn(event);
    if (!Number.isNaN(value)) this.#write(key, value, false);
  }

  #done(key: string, event: Event) {
    const value = numberIn(event);
    if (!Number.isNaN(value)) {
      this.#edited.key = "";
      return this.#write(key, value, true);
    }
    const { validity, value: text } = event.target as HTMLInputElement;
    this.#refuse(key, validity?.badInput ? translated("what is none") : quoted(text));
  }

  /** The user leaves: the last good value is shown again. */
  #end(key: string, event: Event) {
    if (this.#edited.key !== key) return;
    if (Number.isNaN(numberIn(event)) && !this.#errors.has(key)) this.#done(key, event);
    this.leave();
  }

  #pressed(key: string, event: KeyboardEvent) {
    if (event.key !== "Escape" || this.#edited.key !== key) return;
    const { before } = this.#edited;
    this.#edited.key = ""; // its text is written, too
    this.#write(key, before, true);
    this.#begin(key);
    (event.target as HTMLInputElement).value = String(before);
  }

  #pasted(key: string, event: ClipboardEvent) {
    const text = (event.clipboardData?.getData("text") ?? "").trim();
    if (!Number.isNaN(readNumber(text))) return;
    event.preventDefault(); // a number input would take the digits and drop the rest
    if (!this.#port.paste?.(key, text)) this.#refuse(key, quoted(text));
  }

  #write(key: string, value: number, done: boolean) {
    try {
      this.#port.write(key, value, done);
      this.#errors.delete(key);
    } catch (error) {
      if (done || value !== this.#port.read(key)) this.say(key, error instanceof Error ? error.message : String(error));
    }
    this.#port.changed();
  }

  #refuse(key: string, came: string) {
    const good = this.#port.read(key);
    if (this.#edited.key === key && good !== this.#edited.before) this.#port.write(key, good, true); // what was typed before counts
    this.say(key, translated("Expected a number, got {0}; {1} is kept.", came, Number(good.toFixed(3))));
  }

  /** Says something at a field. */
  say(key: string, message: string) {
    this.#errors.set(key, message);
    this.#port.changed();
  }
}

/** @param event of a field */
function numberIn(event: Event) {
  return readNumber((event.target as HTMLInputElement).value);
}
