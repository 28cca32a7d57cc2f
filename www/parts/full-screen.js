// A button of every figure shows it on the whole screen, with everything in it larger: for a projector. It is in the row of the
// controls if that is the end of the sheet, otherwise in the caption.

const ICON = '<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5"/></svg>';
/** Of the screen, the part that a figure fills. */
const FILLED = 0.96;

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
    if (document.fullscreenElement) return void document.exitFullscreen();
    // The figure keeps its width, so that it looks as on the page; zoom makes it larger, letters included.
    const { offsetWidth: width, offsetHeight: height } = figure;
    const zoom = Math.min((FILLED * screen.width) / width, (FILLED * screen.height) / height);
    figure.style.setProperty("--width", `${width}px`);
    figure.style.setProperty("--zoom", Math.max(1, zoom).toFixed(3));
    void figure.requestFullscreen();
  });
  figure.addEventListener("fullscreenchange", name);
}

if (document.fullscreenEnabled) for (const figure of document.querySelectorAll("figure")) addButton(figure);
