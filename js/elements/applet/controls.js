// Native form controls, as templates.
import { html, nothing } from "lit";

/**
 * @param {unknown} label
 * @param {readonly string[]} words
 * @param {string} chosen
 * @param {Record<string, unknown>} names what the words are called, where not by themselves
 * @param {(word: string) => void} act
 * @param {boolean} [off]
 */
export function choice(label, words, chosen, names, act, off = false) {
  const changed = (/** @type {Event} */ event) => act(/** @type {HTMLSelectElement} */ (event.target).value);
  const option = (/** @type {string} */ word) =>
    html`<option value=${word} .selected=${word === chosen}>${names[word] ?? word}</option>`;
  return html`<label class="line"><span>${label}</span><select ?disabled=${off} @change=${changed}>${words.map(option)}</select></label>`;
}

/**
 * @param {unknown} label
 * @param {string} name
 * @param {number} value
 * @param {{ min: number, max: number, step: number }} range
 * @param {(value: number, done: boolean) => void} act
 */
export function slider(label, name, value, { min, max, step }, act) {
  const to = (/** @type {boolean} */ done) => (/** @type {Event} */ event) =>
    act(Number(/** @type {HTMLInputElement} */ (event.target).value), done);
  return html`<label class="line"><span>${label}</span>
    <input type="range" name=${name} min=${Math.min(min, value)} max=${Math.max(max, value)} step=${step} .value=${String(value)} @input=${to(false)} @change=${to(true)}>
    <span class="value" aria-hidden="true">${step < 1 ? value.toFixed(step < 0.1 ? 2 : 1) : Number(value.toFixed(1))}</span></label>`;
}

/**
 * @param {string} label
 * @param {boolean} checked
 * @param {(on: boolean) => void} act
 */
export function box(label, checked, act) {
  const changed = (/** @type {Event} */ event) => act(/** @type {HTMLInputElement} */ (event.target).checked);
  return html`<label><input type="checkbox" .checked=${checked} @change=${changed}>${label}</label>`;
}

/**
 * @param {unknown} label
 * @param {() => void} act
 * @param {{ key?: string, name?: string, off?: boolean, pressed?: boolean }} [more] `name`: of a button that is a picture
 */
export function button(label, act, { key, name, off = false, pressed } = {}) {
  return html`<button type="button" class=${name ? "icon" : ""} aria-label=${name ?? nothing} title=${name ?? nothing} ?disabled=${off}
    aria-keyshortcuts=${key ?? nothing} aria-pressed=${pressed ?? nothing} @click=${act}>${label}${key ? html` <kbd>${key}</kbd>` : nothing}</button>`;
}

/**
 * @param {string} d
 * @param {boolean} [solid]
 */
export const icon = (d, solid = false) =>
  html`<svg viewBox="0 0 24 24" aria-hidden="true"><path class=${solid ? "solid" : ""} d=${d}></path></svg>`;
