// The refusal of a task whose figure has been changed: the answer holds for the points of the page.

/** @typedef {import("../../parts/lesson-task.js").Verdict} Verdict */

/**
 * The verdict if points are not where the page has them, with the function that puts them back; otherwise null.
 *
 * @param {ArrayLike<ArrayLike<number>>} points
 * @param {readonly (readonly number[])[]} start
 * @param {(element: any) => void} [restore]
 * @returns {Verdict | null}
 */
export function movedPoints(points, start, restore = (element) => (element.points = start)) {
  const isSame = points.length === start.length && start.every((at, i) => at.every((x, axis) => points[i][axis] === x));
  return isSame
    ? null
    : { done: false, words: "The answer is asked for the points of the page; these have moved.", restore };
}
