// Buttons that enlarge a figure about its point at t.

/** The applet's picture, in its own units. */
const [WIDTH, HEIGHT] = [670, 480];

/**
 * @param {NodeListOf<HTMLElement>} buttons
 * @param {HTMLElement & { t: number, figure: { pieces: { curve: { eval(t: number): { x: number, y: number } } }[] } }} applet
 */
export function zoomButtons(buttons, applet) {
  for (const button of buttons) {
    button.addEventListener("click", () =>
      applet.setAttribute("view", viewAt(Number(button.dataset.zoom), applet.figure.pieces[0].curve.eval(applet.t))),
    );
  }
}

/** @param {number} factor @param {{ x: number, y: number }} about */
export function viewAt(factor, { x, y }) {
  if (factor === 1) return `0 0 ${WIDTH} ${HEIGHT}`;
  const [width, height] = [WIDTH / factor, HEIGHT / factor];
  return [x - width / 2, y - height / 2, width, height].join(" ");
}
