// <bezier-surface>: every model in every shading looks the same, whatever evaluates it.
import { test } from "node:test";
import { assertSamePictures, openSurface, SHADINGS } from "./surface-page.js";

for (const model of ["teapot", "teacup", "teaspoon", "patch"]) {
  test(`the ${model}: the core and the graphics card draw the same picture`, async (t) => {
    const page = await openSurface(t, `model="${model}" segments="9" show="surface mesh net"`);
    for (const shading of SHADINGS) await assertSamePictures(page, shading);
  });
}
