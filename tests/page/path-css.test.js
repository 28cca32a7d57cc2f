// Paths as values of CSS properties: Chromium draws them where the path is.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Path } from "casteljau";
import { openPage } from "./browser.js";
import { assertNear } from "./gestures.js";

const PATHS = ["M20 30H120V130", "M50 50C100 0 200 100 250 50", "M0 0L100 50M0 90Q50 200 100 90"].map((d) =>
  Path.fromSVG(d),
);

test("motion along path() is where pointAtLength says, the end included", async (t) => {
  const page = await openPage(t, "about:blank");
  for (const path of PATHS) {
    const parts = [0, 0.25, 0.7, 1];
    const expected = parts.map((part) => path.pointAtLength(part * path.length())?.point);
    const seen = await page.evaluate(
      ([text, parts]) => {
        const moved = document.createElement("div");
        moved.style = `position: absolute; width: 10px; height: 10px; offset: path("${text}"); offset-rotate: 0deg; offset-anchor: center`;
        const around = document.createElement("div");
        around.style = "position: absolute; left: 0; top: 0; width: 300px; height: 300px";
        around.append(moved);
        document.body.append(around);
        return parts.map((part) => {
          moved.style.offsetDistance = `${100 * part}%`;
          const { x, y } = moved.getBoundingClientRect();
          return [x + 5, y + 5];
        });
      },
      /** @type {[string, number[]]} */ ([path.toSVG(), parts]),
    );
    assertNear(
      seen,
      expected.map((point) => [point?.x, point?.y]),
      0.1,
      path.toSVG(),
    );
  }
});

test("clip-path and shape-outside take shape()", async (t) => {
  const page = await openPage(t, "about:blank");
  for (const property of ["clip-path", "shape-outside"]) {
    for (const path of PATHS) {
      const css = path.toCSS({ fillRule: "evenodd" });
      assert.ok(await page.evaluate(([name, css]) => CSS.supports(name, css), [property, css]), `${property}: ${css}`);
    }
  }
});
