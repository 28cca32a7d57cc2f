// The Markdown of the site's pages: sections, numbers, figures, tasks, formulas, code, and the font for the formulas.
import assert from "node:assert/strict";
import { test } from "node:test";
import { codeHighlighter } from "../../www/build/highlight.js";
import { fileURLToPath } from "node:url";
import { includeFiles } from "../../www/build/include.js";
import { contentsOf, pathToRoot, readingTime } from "../../www/build/layout.js";
import { charactersOf } from "../../www/build/math-font.js";
import { markdown } from "../../www/build/markdown.js";

const md = markdown(await codeHighlighter());
const render = (text, chapter) => md.render(text, { chapter });

test("headings of the second level make sections with numbers, and the table of contents", () => {
  const html = render("## Splitting {#cut}\n\nText.\n\n### Two halves\n\n## Properties: hull, affine maps\n\nMore.", 3);
  assert.match(
    html,
    /^<section id="cut">\s*<div class="scene">\s*<div class="before">\s*<h2><span class="nr">3\.1<\/span> Splitting <a class="permalink" href="#cut"/,
  );
  assert.match(html, /<h3 id="two-halves"/);
  assert.match(html, /<\/section>\s*<section id="properties-hull-affine-maps">[\s\S]*<\/section>\s*$/);
  const plain = render("## Splitting {#cut}\n\nText.\n\n## Properties: hull, affine maps");
  const contents = contentsOf(plain).map(({ id, title }) => [id, title.replace(/<[^>]*>/g, "")]);
  const titles = { cut: "Splitting", "properties-hull-affine-maps": "Properties: hull, affine maps" };
  assert.deepEqual(contents, Object.entries(titles));
  assert.doesNotMatch(render("## Splitting"), /class="nr"/, "without a chapter there are no numbers");
});

test("a figure has an id, a number and its last paragraph as caption; an element in it is no paragraph", () => {
  const figure = '::: figure hull\n<bezier-applet id="a"></bezier-applet>\n\nThe **hull** of $P_0$.\n:::';
  const html = render(`${figure}\n\n::: figure ends\n<p>x</p>\n:::`, 1);
  assert.match(
    html,
    /<figure id="figure-hull">\s*<div class="sheet">\s*<bezier-applet id="a"><\/bezier-applet>\s*<\/div>\s*<figcaption>/,
  );
  assert.match(
    html,
    /<figcaption><span class="nr">Figure 1\.1<\/span> The <strong>hull<\/strong> of <span class="unbroken"><math>/,
  );
  assert.match(html, /href="#figure-hull" aria-label="Link to this figure">#<\/a><\/figcaption>\s*<\/figure>/);
  assert.equal(html.match(/figcaption>/g)?.length, 2, "a figure may have no caption");
  assert.match(html, /<p>x<\/p>\s*<\/div>\s*<\/figure>/);
});

/** The classes, elements and texts of a section, in order. @param {string} html */
const outline = (html) =>
  Array.from(
    html.matchAll(
      /<div class="(scene|before|after)">|<(figure) id="figure-(\w+)"|<lesson-(task|sample) |<(?:p|h3)[^>]*>(\w+)/g,
    ),
    ([, division, , figure, element, text]) => division ?? figure ?? element ?? text,
  ).join(" ");

test("a scene has a figure, the text that leads to it, and the text and tasks below it", () => {
  const figure = (/** @type {string} */ id) => `::: figure ${id}\n<x-y id="${id}"></x-y>\n:::\n\n`;
  const task = (/** @type {string} */ id) => `::: task half-height for=${id}\nMove\n:::\n\n`;
  const cases = /** @type {[string, string][]} */ ([
    [`one\n\n${figure("f")}two\n\n${task("f")}three`, "one f after two task Move three"],
    [`one\n\n${figure("f")}two\n\n${figure("g")}three`, "one f scene before two g after three"],
    [`${figure("f")}one\n\n### h\n\ntwo\n\n${figure("g")}`, "f after one scene before h two g"],
    [`${figure("f")}${task("f")}one\n\n${figure("g")}`, "f after task Move scene before one g"],
    [`${figure("f")}one\n\n${figure("g")}${task("g")}${task("f")}`, "f after one task Move scene g after task Move"],
    ["one\n\n::: sample grid\n:::\n\ntwo", "one two sample"],
  ]);
  for (const [text, expected] of cases)
    assert.equal(outline(render(`## A\n\n${text}`, 1)), `scene before ${expected}`, text);
  const moved = render(`## A\n\n${figure("f")}${figure("g")}${task("g")}::: task half-pixel for=f\n:::`, 1);
  const numbers = Array.from(
    moved.matchAll(/<lesson-task id="[\w-]+" name="([\w-]+)"[^>]*data-number="([\d.]+)"/g),
    ([, name, number]) => [name, number],
  );
  assert.deepEqual(
    numbers,
    [
      ["half-pixel", "1.1"],
      ["half-height", "1.2"],
    ],
    "a task stands with its figure",
  );
  assert.doesNotMatch(render(`## A\n\n${figure("f")}`), /scene/, "other pages have none");
});

test("a link to a figure without text says its number", () => {
  const figures = ["b", "a"].map((name) => `::: figure ${name}\n<p>x</p>\n:::`).join("\n\n");
  const html = render(`See [](#figure-a), [this](#figure-a).\n\n${figures}`, 2);
  assert.match(html, /See <a href="#figure-a">Figure\u00a02\.2<\/a>, <a href="#figure-a">this<\/a>/);
  assert.throws(() => render("[](#figure-c)", 2), /expected a figure of the page .* got #figure-c/);
});

test("tasks and samples; what is missing is named", () => {
  assert.match(
    render("::: task half-height for=parabola\nHow high?\n:::", 2),
    /<lesson-task id="task-half-height" name="half-height" for="parabola" data-number="2\.1">\s*<p>How high\?<\/p>\s*<\/lesson-task>/,
  );
  assert.match(render("::: sample grid\n:::"), /<pre tabindex="0" data-language="js"><code>.*class="keyword"/s);
  assert.throws(() => render("::: sample nowhere\n:::"), /expected the sample www\/samples\/nowhere\.js/);
  assert.throws(() => render("::: figure\nx\n:::"), /expected a name after/);
});

test("formulas become MathML, and a wrong one fails the build", () => {
  assert.match(render("A $t^2$ here."), /A <math><msup><mi>t<\/mi><mn[^>]*>2<\/mn><\/msup><\/math> here\./);
  assert.match(render("$$\n\\sum_{i=0}^n B_i\n$$"), /<math display="block"[^>]*>[\s\S]*<munderover>/);
  assert.throws(() => render("$\\nonsense{x}$"), /nonsense/);
});

test("code is coloured by words only, and nothing of it is lost", () => {
  const html = render('```js\nconst a = f("x<y", 12); // why\n```');
  const parts = { keyword: "const ", string: "&quot;x&lt;y&quot;", number: "12", comment: "// why" };
  for (const [kind, text] of Object.entries(parts))
    assert.ok(html.includes(`<span class="${kind}">${text}</span>`), kind);
  assert.match(html, /<\/span>a = f\(/);
  assert.doesNotMatch(html, /<span class="keyword">\s*=/);
});

test("the font has the characters of all formulas, letters in italics too", () => {
  const characters = charactersOf([render("$\\frac{h}{x} \\times \\Delta P$"), "outside: Ж"]);
  for (const character of "hxP×Δ") assert.ok(characters.includes(character), character);
  for (const italic of ["ℎ", "𝑥", "𝑃"]) assert.ok(characters.includes(italic), italic);
  assert.ok(!characters.includes("Ж"));
});

test("the way to the first page", () => {
  assert.deepEqual(["/", "/curves/", "/api/curve/", "/embed.html"].map(pathToRoot), ["", "../", "../../", ""]);
});

test("a line with an include is replaced by the file, relative to the page", () => {
  const page = { inputPath: fileURLToPath(new URL("../../www/curves/index.md", import.meta.url)) };
  const text = includeFiles({ page }, "Before.\n<!-- include sections/splines.md -->\n<!-- a comment -->");
  assert.match(text, /^Before\.\n## Splines: .*\{#splines\}\n/);
  assert.match(text, /<!-- a comment -->$/);
  assert.throws(() => includeFiles({ page }, "<!-- include sections/none.md -->"), /ENOENT/);
});

test("reading time counts words and tasks, not code and formulas", () => {
  const words = "word ".repeat(1800);
  const tasks = (/** @type {number} */ count) => '<lesson-task name="a"></lesson-task>'.repeat(count);
  const html = `<p>${words}</p><pre>${words}</pre><math>${words}</math><svg>${words}</svg>`;
  assert.deepEqual(["", words, html].map(readingTime), ["5 minutes", "15 minutes", "15 minutes"]);
  const times = [10, 15, 25, 36].map((count) => readingTime(words + tasks(count)));
  assert.deepEqual(times, ["45 minutes", "1 hour", "1½ hours", "2 hours"]);
});

test("an inline formula stays on one line with its punctuation", () => {
  const html = md.render("If $t$ is 1 ($n$ = 2), and $s$.").replaceAll(/<math.*?<\/math>/g, "M");
  assert.equal(html, '<p>If M is 1 <span class="unbroken">(M</span> = 2), and <span class="unbroken">M.</span></p>\n');
});
