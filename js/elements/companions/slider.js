import { html } from "lit";
import { shown } from "./numbers.js";

/**
 * The slider of t.
 *
 * @param {number} t
 * @param {number[]} interval
 * @param {(t: number, done: boolean) => void} set
 */
export function slider(t, [from, to], set) {
  const slid = (/** @type {Event} */ event) =>
    set(Number(/** @type {HTMLInputElement} */ (event.target).value), event.type === "change");
  return html`<label class="t bar"><i>t</i>
    <input type="range" aria-label="t" min=${from} max=${to} step="0.01" .value=${String(t)} @input=${slid} @change=${slid}>
    <span class="value" aria-hidden="true">${shown(t)}</span></label>`;
}
