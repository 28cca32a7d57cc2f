import { html } from "lit";
import { shown } from "../../ui/numbers.js";

/** The slider of t. */
export function slider(t: number, [from, to]: number[], set: (t: number, done: boolean) => void) {
  const onSlide = (event: Event) => set(Number((event.target as HTMLInputElement).value), event.type === "change");
  return html`<label class="t bar"><i>t</i>
    <input type="range" aria-label="t" min=${from} max=${to} step="0.01" .value=${String(t)} @input=${onSlide} @change=${onSlide}>
    <span class="value" aria-hidden="true">${shown(t)}</span></label>`;
}
