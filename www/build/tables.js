// Tables of the generated pages.
import { escapeHtml } from "./highlight.js";

/** A table that scrolls sideways where it is too wide. @param {string} table HTML @param {string} label for screen readers */
export const scrollable = (table, label) =>
  `<div class="scroll" tabindex="0" role="region" aria-label="${label}">${table}</div>`;

/**
 * A table whose first column is text and whose other columns are numbers or texts.
 *
 * @param {string} label for screen readers
 * @param {readonly string[]} head
 * @param {readonly (readonly string[])[]} rows
 */
export function tableHtml(label, head, rows) {
  const cells = (/** @type {readonly string[]} */ row) =>
    row
      .map((cell, k) => (k === 0 ? `<th scope="row">${escapeHtml(cell)}</th>` : `<td>${escapeHtml(cell)}</td>`))
      .join("");
  const names = head.map((name) => `<th scope="col">${escapeHtml(name)}</th>`).join("");
  const body = rows.map((row) => `<tr>${cells(row)}</tr>`).join("\n");
  return scrollable(`<table class="numbers"><thead><tr>${names}</tr></thead><tbody>\n${body}\n</tbody></table>`, label);
}
