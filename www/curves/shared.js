// Figures that show the same points in different ways: what moves in one moves in all.

/** @typedef {HTMLElement & { points: [number, number][] }} WithPoints */

/** @param {readonly Element[]} elements */
export function sharePoints(elements) {
  for (const from of /** @type {WithPoints[]} */ (elements)) {
    const pass = () => {
      for (const to of /** @type {WithPoints[]} */ (elements)) if (to !== from) to.points = from.points;
    };
    from.addEventListener("input", pass);
    from.addEventListener("change", pass);
  }
}
