// Scenes (build/scenes.js): the figure stays in view beside the text, or above it on narrow screens, where it may cover so much of the window.
const MAX_COVERED = 0.6;

/** Whether a figure is low enough to stay in view above the text. @param {HTMLElement} figure */
function setSticky(figure) {
  const sheet = /** @type {HTMLElement} */ (figure.querySelector(":scope > .sheet"));
  figure.classList.toggle("low", sheet.offsetHeight <= MAX_COVERED * innerHeight);
}

/** The narrowest that a figure is made so that it fits. */
const MIN_WIDTH_PX = 480;

/** Makes a figure beside the text narrower, and so lower, if its sheet is taller than the window. @param {HTMLElement} figure */
function fit(figure) {
  const sheet = /** @type {HTMLElement} */ (figure.querySelector(":scope > .sheet"));
  const max = Number.parseFloat(getComputedStyle(sheet).maxHeight); // NaN without a task
  if (!BESIDE.matches || document.fullscreenElement || !(sheet.scrollHeight > max + 1)) return;
  const width = Math.floor((figure.offsetWidth * sheet.clientHeight) / sheet.scrollHeight);
  figure.style.maxInlineSize = `${Math.max(MIN_WIDTH_PX, width)}px`;
}

const BESIDE = matchMedia("(min-width: 60rem)"); // as in scenes.css
const figures = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(".side > figure")]);
const observer = new ResizeObserver((entries) => {
  for (const { target } of entries) {
    const figure = /** @type {HTMLElement} */ (target.closest("figure"));
    setSticky(figure);
    fit(figure);
  }
});
for (const part of document.querySelectorAll(".side > figure > .sheet, .side > figure > .sheet > *"))
  observer.observe(part);
addEventListener("resize", () => {
  for (const { style } of figures) style.maxInlineSize = "";
});

/** Brings the element that a task is about into view, where the sheet is so tall that it scrolls. @param {HTMLElement} task */
function showTarget(task) {
  const target = document.getElementById(task.getAttribute("for") ?? "");
  const sheet = /** @type {HTMLElement | null | undefined} */ (target?.closest("figure")?.querySelector(".sheet"));
  if (!target || !sheet || sheet.scrollHeight <= sheet.clientHeight + 1) return;
  const [{ top, height }, box] = [target.getBoundingClientRect(), sheet.getBoundingClientRect()];
  if (top < box.top || top + Math.min(height, box.height) > box.bottom) sheet.scrollTop += top - box.top;
}

for (const task of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(".scene lesson-task[for]")))
  task.addEventListener("click", () => showTarget(task));
