// Code that follows what is shown, with a button that copies it.
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
