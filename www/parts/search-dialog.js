// The dialog of the search: a field, and results while typing.
import { searchIndex } from "./search-index.js";

/** How much of a section's text a result shows; an answer that something is not available has no more than this. */
const EXCERPT = 200;

/** @typedef {import("./search-index.js").Found} Found */

/**
 * @param {string} root the relative path to the first page
 * @returns {Promise<HTMLDialogElement>}
 */
export async function searchDialog(root) {
  const response = await fetch(`${root}search.json`);
  if (!response.ok) throw new Error(`search.json: expected an answer, got ${response.status}`);
  const find = searchIndex(await response.json());
  const dialog = document.createElement("dialog");
  dialog.className = "search";
  dialog.setAttribute("aria-label", "Search");
  dialog.innerHTML =
    '<input type="text" role="searchbox" aria-label="Search the reference and the chapters" placeholder="nearest point, watertight, cubic-bezier …" autocomplete="off" spellcheck="false"><p role="status"></p><ol></ol>';
  document.body.append(dialog);
  const field = /** @type {HTMLInputElement} */ (dialog.querySelector("input"));
  field.addEventListener("input", () => show(dialog, field.value.trim() ? find(field.value) : [], field.value, root));
  dialog.addEventListener("keydown", (event) => moveFocus(dialog, event));
  dialog.addEventListener("click", (event) => {
    const outside = event.target === dialog;
    if (outside || /** @type {Element} */ (event.target).closest("a")) dialog.close();
  });
  return dialog;
}

/** @param {HTMLDialogElement} dialog @param {Found[]} found @param {string} text @param {string} root */
function show(dialog, found, text, root) {
  const items = found.map(({ address, title, page, text: body }) => {
    const item = document.createElement("li");
    const link = document.createElement("a");
    link.href = root + address || "./";
    const [name, where] = [document.createElement("b"), document.createElement("span")];
    name.textContent = title;
    where.textContent = `${page === title ? "" : `${page} · `}${body.slice(0, EXCERPT)}`;
    link.append(name, where);
    item.append(link);
    return item;
  });
  dialog.querySelector("ol")?.replaceChildren(...items);
  const status = /** @type {HTMLElement} */ (dialog.querySelector("[role=status]"));
  status.textContent = text.trim() ? `${found.length || "No"} ${found.length === 1 ? "result" : "results"}` : "";
}

/** Arrow keys go through the results; Enter in the field opens the first. @param {HTMLDialogElement} dialog @param {KeyboardEvent} event */
function moveFocus(dialog, event) {
  const stops = /** @type {HTMLElement[]} */ ([...dialog.querySelectorAll("input, a")]);
  const at = stops.indexOf(/** @type {HTMLElement} */ (document.activeElement));
  if (event.key === "Enter" && at === 0) stops[1]?.click();
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (!step) return;
  event.preventDefault();
  stops[Math.min(Math.max(at + step, 0), stops.length - 1)].focus();
}
