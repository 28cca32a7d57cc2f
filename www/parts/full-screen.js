// A button of every figure shows it on the whole screen, with everything in it larger: for a projector. It is in the row of the
// controls if that is the end of the sheet, otherwise in the caption. In a chapter the tasks of the figure are beside or below it. On
// the whole screen, Page Down and Page Up show the next and the previous figure of the page, as the buttons of a presenter's remote
// control do.

const ICON = '<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5"/></svg>';
/** Of the screen, the part that is filled. */
const FILLED = 0.96;
/** Between a figure and its tasks, as in scenes.css. */
const GAP_PX = 24;
/** By key, how many figures to go on. @type {Record<string, number>} */
const STEPS = { PageDown: 1, PageUp: -1 };

/** @typedef {{ width: number, height: number }} Size */

/** The figures that have a button. */
const figures = /** @type {HTMLElement[]} */ ([]);
/** Their sizes on the page, and those of their tasks: one that another one hides has none. @type {WeakMap<HTMLElement, Size[]>} */
const sizes = new WeakMap();

/** What fills the screen: the scene, without its text (scenes.css), or a figure elsewhere. @param {HTMLElement} figure */
const filling = (figure) => /** @type {HTMLElement} */ (figure.closest(".scene") ?? figure);

/** The size of some elements below each other, without what clips them. @param {Iterable<Element>} elements @returns {Size} */
function sizeOf(elements) {
  const parts = /** @type {HTMLElement[]} */ ([...elements]);
  return {
    width: Math.max(0, ...parts.map(({ offsetWidth }) => offsetWidth)),
    height: parts.reduce((sum, { scrollHeight, offsetHeight }) => sum + Math.max(scrollHeight, offsetHeight), 0),
  };
}

/** The sizes on the page of a figure, which itself may have no box (scenes.css), and of its tasks. @param {HTMLElement} figure */
const sizesOf = (figure) => [
  sizeOf(figure.children),
  sizeOf(figure.closest(".scene")?.querySelectorAll("lesson-task") ?? []),
];

/** @param {HTMLElement} figure */
function fill(figure) {
  // The figure keeps its width, so that it looks as on the page; zoom makes it larger, letters included.
  const [own, tasks] = sizes.get(figure) ?? sizesOf(figure);
  const gap = tasks.width > 0 ? GAP_PX : 0;
  const [maxWidth, maxHeight] = [FILLED * screen.width, FILLED * screen.height];
  const zoom = (/** @type {number} */ width, /** @type {number} */ height) =>
    Math.min(maxWidth / width, maxHeight / height);
  const width = own.width + gap + tasks.width;
  const beside = zoom(width, Math.max(own.height, tasks.height));
  const below = zoom(Math.max(own.width, tasks.width), own.height + gap + tasks.height);
  const element = filling(figure);
  // What is too high can be scrolled.
  element.classList.toggle("beside", beside >= below && width <= maxWidth);
  element.style.setProperty("--width", `${own.width}px`);
  element.style.setProperty("--task-width", `${tasks.width}px`);
  element.style.setProperty("--zoom", Math.max(1, beside, below).toFixed(3));
  return element.requestFullscreen();
}

/** Leaves the whole screen, from whichever figure: the browser would go back to the one before. */
async function leave() {
  while (document.fullscreenElement) await document.exitFullscreen();
}

/** @param {HTMLElement} figure */
function addButton(figure) {
  const caption = figure.querySelector(":scope > figcaption");
  if (!caption) return;
  const button = document.createElement("button");
  button.type = "button";
  button.className = "full-screen";
  button.innerHTML = ICON;
  const name = () =>
    button.setAttribute(
      "aria-label",
      document.fullscreenElement === filling(figure) ? "Exit full screen" : "Full screen",
    );
  name();
  const row = figure.querySelector(":scope > .sheet > :is(bezier-applet, bezier-surface)[controls]:last-child");
  if (row) row.after(button);
  else caption.prepend(button);
  button.addEventListener("click", () => {
    if (document.fullscreenElement) return void leave();
    for (const each of figures) sizes.set(each, sizesOf(each));
    void fill(figure);
  });
  document.addEventListener("fullscreenchange", name);
  figures.push(figure);
}

/** @param {KeyboardEvent} event */
function step(event) {
  const at = figures.findIndex((figure) => filling(figure) === document.fullscreenElement);
  const next = figures[at + (STEPS[event.key] ?? 0)];
  // The elements use these keys, too: to move a point in space.
  if (at < 0 || !next || next === figures[at] || event.defaultPrevented) return;
  event.preventDefault();
  void fill(next);
}

if (document.fullscreenEnabled) {
  for (const figure of document.querySelectorAll("figure")) addButton(figure);
  addEventListener("keydown", step);
}
