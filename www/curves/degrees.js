// One degree more, one degree less: the same curve, as long as that is possible.
import { Curve } from "casteljau";

/** A degree more than this, and the handles lie on each other. */
const MOST = 16;
/** What reduction may change, in the units of the picture, without being called a change. */
const SAME = 0.01;

/** @param {{ element: HTMLElement & { points: [number, number][] }, more: HTMLButtonElement, less: HTMLButtonElement, words: HTMLElement }} parts */
export function byDegree({ element, more, less, words }) {
  const update = () => {
    const degree = element.points.length - 1;
    more.disabled = degree >= MOST;
    less.disabled = degree <= 2;
  };
  const show = (/** @type {Curve} */ curve, /** @type {string} */ text) => {
    element.points = pairsOf(curve);
    words.textContent = `Degree ${curve.degree}. ${text}`;
    update();
  };
  more.addEventListener("click", () =>
    show(new Curve(element.points).elevate(), "Not a pixel of the curve has moved."),
  );
  less.addEventListener("click", () => {
    const { curve, error } = new Curve(element.points).reduce();
    show(
      curve,
      error < SAME ? "Not a pixel of the curve has moved." : `The curve has moved by up to ${error.toFixed(1)} px.`,
    );
  });
  element.addEventListener("update", update);
  update();
}

/** @param {Curve} curve @returns {[number, number][]} */
const pairsOf = (curve) => {
  const flat = curve.controlPoints();
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
};
