// Tasks of the chapters against a stand-in for the figure that they are about.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";

export const load = (name) => import(new URL(`../../www/tasks/${name}.js`, import.meta.url).href);

/** What a task sees of <bezier-applet>: one curve of all points, or cubics that share their ends. */
export function applet({ points, whole = false, ...rest }) {
  const pieces = () => {
    if (element.basis === "b-spline")
      return Spline.fromBSpline(element.points)
        .segments()
        .map((curve) => ({ curve }));
    if (element.basis === "matrix") return [{ curve: Curve.fromBasis(element.matrix, element.points) }];
    if (whole || element.points.length < 7) return [{ curve: new Curve(element.points) }];
    return new Spline(element.points).segments().map((curve) => ({ curve }));
  };
  const element = {
    points,
    basis: "bezier",
    t: 0.5,
    ...rest,
    insertJoint(t) {
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

/** How many wrong ways that look right each task is tried with. */
const MIN_WRONG = 3;

/**
 * One test for each row: the name of a task, its start, at least three ways that look right and do not solve it, and what does. The answer
 * that the task reveals must count, too. An attempt is a function of the element, or properties that are assigned to it. A refusal that can
 * be undone is: the task is then as before the attempt.
 *
 * @param {[string, any, any[], any][]} rows
 * @param {(start: any) => any} make the element of a start; a function as start makes its own
 */
export function testTasks(rows, make = (start) => (start.points ? applet(start) : { ...start })) {
  const made = (start) => (typeof start === "function" ? start() : make(start));
  const attempt = (element, act) => (typeof act === "function" ? act(element) : Object.assign(element, act));
  for (const [name, start, vain, right] of rows)
    test(`task ${name}`, async () => {
      assert.ok(vain.length >= MIN_WRONG, `expected ${MIN_WRONG} wrong ways, got ${vain.length}`);
      const { check, reveal, predict } = await load(name);
      const judge = (element, expected, what) => {
        const { done, words, restore } = check(element.figure, element);
        assert.equal(typeof words, "string");
        assert.ok(words.length > 0);
        assert.equal(done, expected, `${what}: ${words}`);
        if (!restore) return;
        assert.equal(done, false);
        restore(element);
        const after = check(element.figure, element);
        assert.ok(after.words !== words && !after.restore, `${what}, restored: ${after.words}`);
      };
      const [element, other] = [made(start), made(start)];
      judge(element, false, "at the start");
      vain.forEach((act, k) => {
        attempt(element, act);
        judge(element, false, `attempt ${k}`);
      });
      attempt(element, right);
      judge(element, true, "solved");
      reveal(other);
      judge(other, true, "revealed");
      if (predict) checkPrediction(predict);
    });
}

/** A prediction has different options, one of which is the answer, and a reason. */
export function checkPrediction({ options, answer, because }) {
  assert.ok(options.length > 1 && answer in options && because.length > 20);
  assert.equal(new Set(options).size, options.length);
}
