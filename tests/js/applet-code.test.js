// The code that <bezier-applet> gives along: it runs, and finds the point that is shown.
import assert from "node:assert/strict";
import { test } from "node:test";
import { codeOf } from "#js/editor/code.js";
import { FIELDS, stateOf } from "#js/editor/schema.js";
import { figureOf } from "#js/editor/figure.js";
import { BASES, firstState } from "#js/editor/state.js";
import { Curve, Spline } from "#js/index.js";

const { points } = firstState();
const pointOf = (code) =>
  new Function("Spline", "Curve", `${code.replace(/import.*\n/, "")}; return { x, y };`)(Spline, Curve);

for (const basis of BASES) {
  test(`${basis}: the program's point is the one at t, in every segment and beyond its ends`, () => {
    for (const t of [-0.2, 0, 0.25, 1, 1.3]) {
      for (const segment of [0, 1, 99]) {
        const state = stateOf({ points, basis, show: ["extrapolation"], t, segment });
        const figure = figureOf(state);
        const { x, y } = pointOf(codeOf(state, figure, "js"));
        const shown = figure.pieces[Math.min(segment, figure.pieces.length - 1)].curve.eval(t);
        assert.ok(Math.hypot(x - shown.x, y - shown.y) < 0.01, `t = ${t} in ${segment}: ${x}, ${y}`);
      }
    }
  });
}

test("where there is no curve every language says so", () => {
  const state = stateOf({ points, visiblePoints: 3 });
  for (const language of /** @type {const} */ (["js", "rust", "canvas"]))
    assert.equal(codeOf(state, figureOf(state), language), "// Too few points for a curve.\n");
});

test('visible-points="" shows all points, as it is read', () => {
  const { parse, put, write } = FIELDS.visiblePoints;
  const few = put(firstState(), parse("4"));
  assert.equal(few.shown, 4);
  assert.equal(write(put(few, parse(""))), "");
});
