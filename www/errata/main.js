// Computes the proofs, a few at a time so that the page can be scrolled meanwhile.
import "../parts/contents.js";
import { proofs } from "./proofs.js";

/** Shorter than a frame. */
const BREATH_MS = 12;

/** @param {HTMLElement[]} lines */
function prove(lines) {
  const start = performance.now();
  while (lines.length && performance.now() - start < BREATH_MS) {
    const line = /** @type {HTMLElement} */ (lines.shift());
    const { words, holds } = proofs[line.dataset.proof ?? ""]();
    line.textContent = words;
    line.dataset.holds = String(holds);
  }
  if (lines.length) setTimeout(() => prove(lines));
}

prove([.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-proof]"))]);
