// Computes the proofs, one after the other, and marks where the reader is.
import "../parts/contents.js";
import { proofs } from "./proofs.js";

for (const line of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-proof]"))) {
  const { words, holds } = proofs[line.dataset.proof ?? ""]();
  line.textContent = words;
  line.dataset.holds = String(holds);
}
