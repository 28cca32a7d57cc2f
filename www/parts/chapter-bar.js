// The bar of a section: its list of sections is closed by Escape and by a click beside it.
const list = /** @type {HTMLDetailsElement} */ (document.querySelector(".chapter-bar details"));

list.addEventListener("toggle", () => {
  if (list.open) list.querySelector("[aria-current]")?.scrollIntoView({ block: "nearest" });
});
document.addEventListener("pointerdown", ({ target }) => {
  if (!list.contains(/** @type {Node} */ (target))) list.open = false;
});
document.addEventListener("keydown", ({ key }) => {
  if (key !== "Escape" || !list.open) return;
  list.open = false;
  list.querySelector("summary")?.focus();
});
