// A button of every figure shows it on the whole screen, with everything in it larger: for a projector. It is in the row of the
// controls if that is the end of the sheet, otherwise in the caption. On the whole screen, Page Down and Page Up show the next and the
// previous figure of the page, as the buttons of a presenter's remote control do.

const ICON = '<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5"/></svg>';
/** Of the screen, the part that a figure fills. */
const FILLED = 0.96;
/** By key, how many figures to go on. @type {Record<string, number>} */
const STEPS = { PageDown: 1, PageUp: -1 };

/** The figures that have a button. */
const figures = /** @type {HTMLElement[]} */ ([]);
/** Their size on the page: one that another one hides has none. @type {WeakMap<HTMLElement, { width: number, height: number }>} */
const sizes = new WeakMap();

/** The size of a figure on the page. @param {HTMLElement} figure */
function sizeOf(figure) {
  const parts = /** @type {HTMLElement[]} */ ([...figure.children]); // the figure itself may have no box (scenes.css)
  return {
    width: Math.max(...parts.map(({ offsetWidth }) => offsetWidth)),
    height: parts.reduce((sum, { offsetHeight }) => sum + offsetHeight, 0),
  };
}

/** @param {HTMLElement} figure */
function fill(figure) {
  // The figure keeps its width, so that it looks as on the page; zoom makes it larger, letters included.
  const { width, height } = sizes.get(figure) ?? sizeOf(figure);
  const zoom = Math.min((FILLED * screen.width) / width, (FILLED * screen.height) / height);
  figure.style.setProperty("--width", `${width}px`);
  figure.style.setProperty("--zoom", Math.max(1, zoom).toFixed(3));
  return figure.requestFullscreen();
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
    button.setAttribute("aria-label", document.fullscreenElement === figure ? "Exit full screen" : "Full screen");
  name();
  const row = figure.querySelector(":scope > .sheet > :is(bezier-applet, bezier-surface)[controls]:last-child");
  if (row) row.after(button);
  else caption.prepend(button);
  button.addEventListener("click", () => {
    if (document.fullscreenElement) return void leave();
    for (const each of figures) sizes.set(each, sizeOf(each));
    void fill(figure);
  });
  document.addEventListener("fullscreenchange", name);
  figures.push(figure);
}

/** @param {KeyboardEvent} event */
function step(event) {
  const at = figures.indexOf(/** @type {HTMLElement} */ (document.fullscreenElement));
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
