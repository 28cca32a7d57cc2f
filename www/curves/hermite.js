// The Hermite data of a cubic, live: its ends, and the velocities there.
import { Curve } from "casteljau";

/**
 * @param {HTMLElement} words
 * @param {HTMLElement & { points: [number, number][] }} applet
 */
export function hermiteReadout(words, applet) {
  const update = () => (words.textContent = hermiteWords(applet.points));
  applet.addEventListener("update", update);
  update();
}

/** @param {[number, number][]} points */
export function hermiteWords(points) {
  if (points.length !== 4) return "";
  const data = new Curve(points).toBasis("hermite");
  const pair = (/** @type {number} */ i) => `(${Math.round(data[2 * i])}, ${Math.round(data[2 * i + 1])})`;
  return `From ${pair(0)} with the velocity ${pair(2)}, to ${pair(1)} with ${pair(3)}.`.replaceAll("-", "−");
}
