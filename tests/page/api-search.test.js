// The search over chapters and reference: what it finds, its key and its dialog, in any folder.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { mathText } from "../../www/build/math-text.js";
import { ABSENT, TERMS as OTHER_TERMS } from "../../www/build/search-terms.js";
import { searchIndex } from "../../www/parts/search-index.js";
import { openPage, root } from "./browser.js";
import { serve } from "./server.js";

/** @type {import("../../www/build/search-documents.js").SearchDocument[]} */
const documents = JSON.parse(readFileSync(`${root}site/search.json`, "utf8"));
const find = searchIndex(documents);

/** What one of the first three results must be. @type {[string, RegExp][]} */
const TERMS = [
  ["nearest point", /^api\/(curve|spline|path|surface|patch)\/#nearest$/],
  ["arc length", /^api\/\w+\/#(length|lengthAt|timeAtLength|pointAtLength)$/],
  ["winding number", /^api\/path\/#windingNumber$/],
  ["teapot", /^(teapot\/|api\/surface\/#teapot|surfaces\/.)/],
  ["de Casteljau", /^(curves\/.|api\/(curve|patch)\/#deCasteljau$)/],
  ["tangent", /^api\/\w+\/#tangent$/],
  ["watertight", /^(surfaces\/.|api\/surface\/#(tessellate|volume))/],
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
  ["split", /^(api\/\w+\/#split|curves\/splitting\/)/],
  ["bernstein polynomials", /^(curves\/.|api\/curve\/#bernstein)/],
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

/** Other words than ours, and terms of theory: what the first result must be. @type {[string, RegExp][]} */
const FIRST = [
  ["kappa", /^curves\/(circles|derivatives)\/$/],
  ["0.5523", /^curves\/circles\/$/],
  ["lathe", /^recipes\/#stl-for-printing$/],
  ["triangulate", /^surfaces\/tessellation\/$/],
  ["getPointAtLength", /^api\/path\/#pointAtLength$/],
  ["smooth corner", /^(curves\/joining\/|api\/path\/#roundCorners)$/],
  ["nib", /^(ink\/|recipes\/#brush-stroke|api\/inkstroke\/#constructor|curves\/varying-width\/)$/],
  ["polyline", /^curves\/(parameter|recursive-rendering)\/$/],
  ["centroid", /^api\/path\/#moments$/],
  ["ease-in-out", /^(easing\/|curves\/uses\/)$/],
  ["parallel curve", /^curves\/offsets\/$/],
  ["curvature", /^curves\/derivatives\/$/],
  ["cusp", /^curves\/(shapes|derivatives|offsets)\/$/],
  ["inflection", /^curves\/shapes\/$/],
  ["least squares", /^curves\/fitting\/$/],
  ["curve fitting", /^curves\/fitting\/$/],
  ["variable width", /^curves\/varying-width\/$/],
  ["tension", /^curves\/splines\/$/],
  ["hermite", /^curves\/splines\/$/],
  ["arc length", /^curves\/arc-length\/$/],
  ["offset curve", /^curves\/offsets\/$/],
  ["intersections", /^curves\/intersections\/$/],
  ["split", /^(curves|surfaces)\/splitting\/$/],
];

for (const [text, expected] of FIRST) {
  test(`“${text}” is found first`, () => {
    const addresses = find(text).map(({ address }) => address);
    assert.match(addresses[0] ?? "nothing", expected, addresses.join(" "));
  });
}

test("both kinds of a thing are among the first results", () => {
  for (const [text, ...expected] of [
    ["smooth corner", "curves/joining/", "api/path/#roundCorners"],
    ["kappa", "curves/derivatives/", "curves/circles/"],
    ["thickness", "api/path/#stroke", "recipes/#brush-stroke"],
  ]) {
    const addresses = find(text).map(({ address }) => address);
    for (const address of expected)
      assert.ok(addresses.slice(0, 3).includes(address), `${text}: ${addresses.join(" ")}`);
  }
});

test("what is not available is said, with what to do instead", () => {
  for (const text of ["triangulate", "morph", "text outlines", "potrace", "subdivision surface"]) {
    const found = find(text)
      .slice(0, 3)
      .find(({ title }) => title.endsWith("not available"));
    assert.ok(found, `${text}: ${find(text).map(({ title }) => title)}`);
  }
  for (const text of ["tessellate", "fit", "path"]) assert.doesNotMatch(find(text)[0].title, /not available/);
});

test("the words and answers of the search belong to places that exist", () => {
  const addresses = new Set(documents.map(({ address }) => address));
  for (const address of [...Object.keys(OTHER_TERMS), ...ABSENT.map(({ address }) => address)])
    assert.ok(addresses.has(address), address);
});

test("excerpts keep formulas", () => {
  const textOf = (/** @type {string} */ address) => documents.find((each) => each.address === address)?.text ?? "";
  assert.match(textOf("curves/parameter/"), /At t = 0 the point is at one end .* written B\(t\)\./);
  assert.match(textOf("curves/quadratic/"), /Go the fraction t of the way from A to B:/);
  for (const { address, text } of documents.filter(({ address }) => /^(curves|surfaces)\/./.test(address)))
    assert.doesNotMatch(text, /[<>]m|\(\)| ,|undefined/, address);
  for (const [formula, text] of [
    [
      "<math><mrow><mi>h</mi><mo>=</mo><mfrac><mn>4</mn><mn>3</mn></mfrac><mo>−</mo><mi>x</mi></mrow></math>",
      "h = 4/3 − x",
    ],
    ["<math><mrow><mo>−</mo><msubsup><mi>B</mi><mi>i</mi><mi>n</mi></msubsup></mrow></math>", "−B_i^n"],
    [
      '<math><msup><mi>t</mi><mn>12</mn></msup><mspace width="1em"/><msub><mi>P</mi><mn>01</mn></msub></math>',
      "t¹² P₀₁",
    ],
    ["<math><msqrt><mi>a</mi><mo>+</mo><mi>b</mi></msqrt></math>", "√(a + b)"],
  ])
    assert.equal(mathText(formula), text);
});

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
  await field.fill("windingNumber");
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
