// All anchors of the chapters, on a wide and a narrow screen; anchors.test.js opens a few.
import { test } from "node:test";
import { anchorsOf, assertAnchorsLand } from "./anchors-page.js";
import { sectionsOf } from "./chapter-page.js";

const SECTIONS = [...sectionsOf("curves"), ...sectionsOf("surfaces")].map(({ path }) => path);
for (const path of [...SECTIONS, "/recipes/"]) {
  for (const width of [1280, 360]) {
    test(`${path} opened at each of its anchors, ${width} px wide`, async (t) => {
      await assertAnchorsLand(t, path, await anchorsOf(t, path), {
        viewport: { width, height: 800 },
        readsAddress: path !== "/recipes/",
      });
    });
  }
}
