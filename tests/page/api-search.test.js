// The search over chapters and reference: what it finds, its key and its dialog, in any folder.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { searchIndex } from "../../www/parts/search-index.js";
import { openPage, root } from "./browser.js";
import { serve } from "./server.js";

const find = searchIndex(JSON.parse(readFileSync(`${root}site/search.json`, "utf8")));

/** What one of the first three results must be. @type {[string, RegExp][]} */
const TERMS = [
  ["nearest point", /^api\/(curve|spline|path|surface|patch)\/#nearest$/],
  ["arc length", /^api\/\w+\/#(length|lengthAt|timeAtLength|pointAtLength)$/],
  ["winding number", /^api\/path\/#windingNumber$/],
  ["teapot", /^(teapot\/|api\/surface\/#teapot|surfaces\/#)/],
  ["de Casteljau", /^(curves\/#|api\/(curve|patch)\/#deCasteljau$)/],
  ["tangent", /^api\/\w+\/#tangent$/],
  ["watertight", /^(surfaces\/#|api\/surface\/#(tessellate|volume))/],
  ["cubic-bezier", /^(easing\/|api\/easing\/)/],
  ["project", /^api\/curve\/#nearest$/],
  ["getPointAtTime", /^api\/curve\/#eval$/],
  ["bounding box", /^api\/\w+\/#(controlB|b)ounds$/],
  ["offset curve", /^api\/(curve|spline)\/#offset$/],
  ["intersections", /^api\/\w+\/#(selfI|i)ntersections$/],
  ["fit", /^api\/spline\/#fit$/],
  ["b-spline", /^api\/spline\/#(from|to)BSpline$/],
  ["tessellate", /^api\/(surface|patch)\/#tessellate$/],
  ["curvature", /^api\/\w+\/#curvature$/],
  ["timesAtCoordinate", /^api\/\w+\/#timesAtCoordinate$/],
  ["split", /^(api\/\w+\/#split|curves\/#split)/],
  ["bernstein polynomials", /^(curves\/#|api\/curve\/#bernstein)/],
  ["STL", /^api\/mesh\/#toSTL$/],
  ["flatten", /^api\/\w+\/#flatten$/],
  ["PointLike", /^api\/types\/#PointLike$/],
  ["text along a path", /^recipes\/#text-along-path$/],
  ["shape builder", /^recipes\/#shape-builder$/],
  ["Content-Security-Policy", /^install\/#csp$/],
  ["paper.js", /^migration\/#paper-js$/],
  ["benchmarks", /^benchmarks\//],
  ["bezier-surface", /^(api\/elements\/#bezier-surface|elements\/)/],
];

for (const [text, expected] of TERMS) {
  test(`“${text}” is found`, () => {
    const addresses = find(text).map(({ address }) => address);
    assert.ok(
      addresses.slice(0, 3).some((address) => expected.test(address)),
      addresses.join(" "),
    );
  });
}

test("a beginning, other letters and a slip of the keyboard find the same", () => {
  for (const text of ["tangen", "TANGENT", "tangnet"]) {
    assert.ok(
      find(text).some(({ address }) => address === "api/curve/#tangent"),
      text,
    );
  }
  assert.equal(find("Bézier curves")[0].address, find("bezier curves")[0].address);
  assert.deepEqual(find("xyzzyq"), []);
});

test("the key / opens the search, in any folder; Enter goes to the first result", async (t) => {
  const server = await serve({ "/some/folder/": `${root}site` });
  t.after(() => server.close());
  const page = await openPage(t, "/some/folder/curves/", { baseURL: server.url });
  await page.locator("[data-search]:enabled").waitFor();
  await page.keyboard.press("/");
  const field = page.getByRole("searchbox");
  await field.fill("winding number");
  await page.getByRole("dialog").getByRole("link").first().waitFor();
  assert.match((await page.getByRole("dialog").getByRole("status").textContent()) ?? "", /^\d+ results?$/);
  await field.press("Enter");
  await page.waitForURL("**/some/folder/api/path/#windingNumber");
});

test("the key / stays with fields, and Escape closes the search", async (t) => {
  const page = await openPage(t, "/easing/");
  const button = page.locator("[data-search]:enabled");
  await button.click();
  await page.getByRole("searchbox").press("/");
  assert.equal(await page.getByRole("searchbox").inputValue(), "/");
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "hidden" });
});
