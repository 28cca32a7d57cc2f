// Links to a place on a page: it is at the upper edge of the window when the page has been drawn, and the scroll is not animated.
import { test } from "node:test";
import { assertAnchorsLand } from "./anchors-page.js";

for (const [path, ids] of /** @type {const} */ ([
  ["/curves/", ["quadratic", "figure-hull", "joining", "figure-zoom"]],
  ["/surfaces/", ["cracks", "figure-gpu", "history", "files"]],
])) {
  test(`${path} opened at some of its anchors`, (t) => assertAnchorsLand(t, path, ids));
}

for (const [path, ids] of /** @type {const} */ ([
  ["/recipes/", ["icon-intersections", "teapot-three", "easing-to-linear", "style"]],
  ["/install/", ["slim", "vue"]],
  ["/migration/", ["paper-js", "curves-of-three-js"]],
  ["/benchmarks/", ["rust", "sizes"]],
])) {
  test(`${path} opened at some of its anchors`, (t) =>
    assertAnchorsLand(t, path, ids, { readsAddress: false, once: path !== "/recipes/" }));
}
