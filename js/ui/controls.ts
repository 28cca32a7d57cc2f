// Native form controls, as templates.
import { html, nothing } from "lit";

/**
 * @param names what the words are called, where not by themselves
 */
export function select(
  label: unknown,
  words: readonly string[],
  selected: string,
  names: Record<string, unknown>,
  act: (word: string) => void,
  off = false,
) {
  const changed = (event: Event) => act((event.target as HTMLSelectElement).value);
  const option = (word: string) =>
    html`<option value=${word} .selected=${word === selected}>${names[word] ?? word}</option>`;
  return html`<label class="line"><span>${label}</span><select ?disabled=${off} @change=${changed}>${words.map(option)}</select></label>`;
}

export function slider(
  label: unknown,
  name: string,
  value: number,
  { min, max, step }: { min: number; max: number; step: number },
  act: (value: number, done: boolean) => void,
) {
  const shown = step < 1 ? value.toFixed(step < 0.1 ? 2 : 1) : String(Number(value.toFixed(1)));
  const to = (done: boolean) => (event: Event) => act(Number((event.target as HTMLInputElement).value), done);
  return html`<label class="line"><span>${label}</span>
    <input type="range" name=${name} min=${Math.min(min, value)} max=${Math.max(max, value)} step=${step} .value=${String(value)} @input=${to(false)} @change=${to(true)}>
    <span class="value" aria-hidden="true">${shown.replace("-", "−")}</span></label>`;
}

export function checkbox(label: string, checked: boolean, act: (on: boolean) => void) {
  const changed = (event: Event) => act((event.target as HTMLInputElement).checked);
  return html`<label><input type="checkbox" .checked=${checked} @change=${changed}>${label}</label>`;
}

/**
 * @param more `name`: of a button that is a picture
 */
export function button(
  label: unknown,
  act: () => void,
  { key, name, off = false, pressed }: { key?: string; name?: string; off?: boolean; pressed?: boolean } = {},
) {
  return html`<button type="button" class=${name ? "icon" : ""} aria-label=${name ?? nothing} title=${name ?? nothing} ?disabled=${off}
    aria-keyshortcuts=${key ?? nothing} aria-pressed=${pressed ?? nothing} @click=${act}>${label}${key ? html` <kbd>${key}</kbd>` : nothing}</button>`;
}

export const icon = (d: string, solid = false) =>
  html`<svg viewBox="0 0 24 24" aria-hidden="true"><path class=${solid ? "solid" : ""} d=${d}></path></svg>`;
