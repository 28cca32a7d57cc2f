// Code that follows what is shown, with a button that copies it; several versions of it are tabs.
import { html } from "lit";

/**
 * @param {{ name: string, text: string }} options `name`: what it is, such as "CSS"
 */
export const codeBox = ({ name, text }) => html`
  <div class="code">
    <div class="bar"><b>${name}</b><span role="status"></span><button @click=${(/** @type {Event} */ event) => copy(/** @type {HTMLElement} */ (event.currentTarget), text)} aria-label="Copy ${name}">Copy</button></div>
    <pre tabindex="0" aria-label=${name}><code>${text}</code></pre>
  </div>
`;

/**
 * Code in several languages, of which one is shown.
 *
 * @param {{ tabs: readonly { name: string, text: string }[], selected: number, select: (index: number) => void }} options
 */
export const codeTabs = ({ tabs, selected, select }) => html`
  <div class="code">
    <div class="bar">
      <div role="tablist" aria-label="Code" @keydown=${(/** @type {KeyboardEvent} */ event) => selectByKey(event, tabs.length, selected, select)}>
        ${tabs.map(({ name }, k) => html`<button role="tab" aria-selected=${k === selected} aria-controls="code" tabindex=${k === selected ? 0 : -1} @click=${() => select(k)}>${name}</button>`)}
      </div>
      <span role="status"></span><button @click=${(/** @type {Event} */ event) => copy(/** @type {HTMLElement} */ (event.currentTarget), tabs[selected].text)} aria-label="Copy ${tabs[selected].name}">Copy</button>
    </div>
    <pre id="code" role="tabpanel" tabindex="0" aria-label=${tabs[selected].name}><code>${tabs[selected].text}</code></pre>
  </div>
`;

/**
 * Tabs as in the pattern of ARIA: the arrow keys select.
 *
 * @param {KeyboardEvent} event
 * @param {number} count
 * @param {number} selected
 * @param {(index: number) => void} select
 */
function selectByKey(event, count, selected, select) {
  const next = { ArrowRight: selected + 1, ArrowLeft: selected - 1, Home: 0, End: -1 }[event.key];
  if (next === undefined) return;
  event.preventDefault();
  const index = (next + count) % count;
  select(index);
  /** @type {HTMLElement} */ (/** @type {Element} */ (event.currentTarget).children[index]).focus();
}

/**
 * To the clipboard; where that is refused the text is selected, ready for the keyboard.
 *
 * @param {HTMLElement} button
 * @param {string} text
 */
async function copy(button, text) {
  const box = /** @type {HTMLElement} */ (button.closest(".code"));
  const status = /** @type {HTMLElement} */ (box.querySelector("[role=status]"));
  try {
    await navigator.clipboard.writeText(text);
    status.textContent = "Copied";
  } catch {
    getSelection()?.selectAllChildren(/** @type {HTMLElement} */ (box.querySelector("code")));
    status.textContent = "Selected: press Ctrl+C";
  }
}
