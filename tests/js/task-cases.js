// Tasks of the chapters against a stand-in for the figure that they are about.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";

export const load = (name) => import(new URL(`../../www/tasks/${name}.js`, import.meta.url).href);

/** What a task sees of <bezier-applet>: one curve of all points, or cubics that share their ends. */
export function applet({ points, whole = false, ...rest }) {
  const pieces = () => {
    if (element.basis === "matrix")
      return [{ curve: Curve.fromBasis(element.matrix.split(" ").map(Number), element.points) }];
    if (whole || element.points.length < 7) return [{ curve: new Curve(element.points) }];
    return new Spline(element.points).segments().map((curve) => ({ curve }));
  };
  const element = {
    points,
    basis: "bezier",
    t: 0.5,
    ...rest,
    insert(t) {
      const flat = new Spline(element.points).insert(t).controlPoints();
      element.points = Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
    },
    get figure() {
      const { basis, matrix, t, tree = null } = element;
      return { points: element.points, shown: element.points.length, basis, matrix, t, tree, pieces: pieces() };
    },
  };
  return element;
}

/**
 * One test for each task.
 *
 * @param {Record<string, { start(): any, vain: ((element: any) => unknown)[], right(element: any): unknown }>} tasks its start, what does
 *   not solve it, and what does; the answer that it reveals must count, too
 */
export function testTasks(tasks) {
  for (const [name, { start, vain, right }] of Object.entries(tasks)) {
    test(`task ${name}`, async () => {
      const { check, reveal, predict } = await load(name);
      const judged = (element) => {
        const verdict = check(element.figure, element);
        assert.equal(typeof verdict.words, "string");
        assert.ok(verdict.words.length > 0);
        return verdict.done;
      };
      const element = start();
      assert.equal(judged(element), false, "at the start");
      for (const attempt of vain) {
        attempt(element);
        assert.equal(judged(element), false, `${attempt}: ${check(element.figure, element).words}`);
      }
      right(element);
      assert.equal(judged(element), true, `${right}: ${check(element.figure, element).words}`);
      const other = start();
      reveal(other);
      assert.equal(judged(other), true, `revealed: ${check(other.figure, other).words}`);
      if (predict) {
        assert.ok(predict.options.length > 1 && predict.answer in predict.options && predict.because.length > 20);
        assert.equal(new Set(predict.options).size, predict.options.length);
      }
    });
  }
}
