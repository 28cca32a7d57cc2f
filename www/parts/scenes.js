// Scenes (build/scenes.js): the figure stays in view beside the text, or above it on narrow screens, where it may cover so much of the window.
const MAX_COVERED = 0.6;

/** Whether a figure is low enough to stay in view above the text. @param {HTMLElement} figure */
function setSticky(figure) {
  const sheet = /** @type {HTMLElement} */ (figure.querySelector(":scope > .sheet"));
  figure.classList.toggle("low", sheet.offsetHeight <= MAX_COVERED * innerHeight);
}

const observer = new ResizeObserver((entries) => {
  for (const { target } of entries) setSticky(/** @type {HTMLElement} */ (target.parentElement));
});
for (const sheet of document.querySelectorAll(".scene > figure > .sheet")) observer.observe(sheet);
