// What the attributes of <bezier-surface> amount to, without a page.
import assert from "node:assert/strict";
import { test } from "node:test";
import { settingsOf } from "#js/elements/surface/settings.js";
import { Surface } from "#js/index.js";

test("any number in an attribute is one that can be drawn with", () => {
  for (const name of ["segments", "tolerance", "pixels", "flatness", "lines", "u", "v", "step"]) {
    for (const value of [Infinity, -Infinity, NaN, 1e308, 5e-324, 0, -1, "Infinity", "x", "", null]) {
      const { detail: fineness, lines, u, v, step } = settingsOf(/** @type {any} */ ({ [name]: value }));
      for (const number of [...Object.values(fineness), lines, u, v, step])
        assert.ok(Number.isFinite(number), `${name}="${value}": ${number}`);
    }
  }
  const { detail: fineness } = settingsOf(/** @type {any} */ ({ tolerance: Infinity }));
  assert.ok(Surface.teapot().tessellate(/** @type {any} */ (fineness)).indices.length > 0);
});
