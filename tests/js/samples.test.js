// Every sample of the site runs: each prints what www/samples/<name>.txt holds (tests/samples/main.rs: its Rust twin).
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { codeHighlighter } from "../../www/build/highlight.js";
import { unwrap } from "../../www/build/samples.js";

const highlight = await codeHighlighter();
const folder = new URL("../../www/samples/", import.meta.url);
const read = (name) => readFileSync(new URL(name, folder), "utf8");
const files = readdirSync(folder);
const CHARACTERS = { lt: "<", gt: ">", quot: '"', amp: "&" };
const names = (ending) =>
  files.filter((file) => file.endsWith(`.${ending}`)).map((file) => file.slice(0, -ending.length - 1));

/** Below www/ "casteljau" means the package that this repository is, as built. */
for (const name of names("js")) {
  test(`sample ${name}`, async () => {
    const { sample } = await import(new URL(`${name}.js`, folder).href);
    const lines = [];
    await sample((...values) => lines.push(values.join(" ")));
    assert.equal(`${lines.join("\n")}\n`, read(`${name}.txt`));
  });

  test(`sample ${name}, as it is shown`, () => {
    for (const language of /** @type {const} */ (["js", "rs"])) {
      const shown = unwrap(read(`${name}.${language}`), language);
      assert.doesNotMatch(shown, /(function|fn) sample\b|\bprint\(|writeln!|pub\(crate\)/);
      assert.doesNotMatch(shown, /println!\( /, "a call over several lines keeps them");
      assert.match(shown, language === "js" ? /console\.log\(/ : /println!\(/);
      const text = highlight(shown, language).replace(/<[^>]*>/g, "");
      const plain = text.replace(/&(\w+);/g, (entity, name) => CHARACTERS[name] ?? entity);
      assert.equal(plain, shown);
    }
  });
}

test("every sample is there in both languages, with its output", () => {
  assert.ok(files.length > 0);
  for (const ending of ["rs", "txt"]) assert.deepEqual(names(ending), names("js"), `.js and .${ending}`);
  assert.equal(files.length, 3 * names("js").length, files.join(" "));
});
