// The texts of the elements and the applet: one table, which a page can replace.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import {
  setTranslations,
  translated,
  translatedParts,
  translatedTable,
  translations,
} from "#js/editor/translations.js";
import { untyped } from "./reference.js";

const table = JSON.parse(await readFile(new URL("../../dist/texts.json", import.meta.url), "utf8"));

test("dist/texts.json: the texts are their own keys, and the places of their values are numbered from 0", () => {
  assert.ok(Object.keys(table).length > 150 && "Undo" in table && "{0} at {1}" in table);
  for (const [text, english] of Object.entries(table)) {
    assert.equal(text, english);
    const places = [...new Set([...text.matchAll(/\{(\d)\}/g)].map(([, k]) => Number(k)))].sort();
    assert.deepEqual(places, [...places.keys()], text);
  }
});

test("given texts take the place of the English ones until others are given", (t) => {
  t.after(() => setTranslations({}));
  let changes = 0;
  const counted = () => changes++;
  translations.addEventListener("change", counted);
  t.after(() => translations.removeEventListener("change", counted));
  const names = translatedTable({ a: "Undo", b: "Redo" });
  setTranslations({ Undo: "Rückgängig", "{0} at {1}": "{1}: {0}" });
  assert.deepEqual(
    [translated("Undo"), translated("Redo"), { ...names }],
    ["Rückgängig", "Redo", { a: "Rückgängig", b: "Redo" }],
  );
  assert.equal(translated("{0} at {1}", "P0", "3, 4"), "3, 4: P0");
  assert.deepEqual(translatedParts("{0} at {1}", "P0", 5), ["", 5, ": ", "P0", ""]);
  setTranslations({ Redo: "Wiederholen" });
  assert.deepEqual([translated("Undo"), translated("Redo"), changes], ["Undo", "Wiederholen", 2]);
  assert.equal(translated("{0} and {7}", "$&"), "$& and {7}");
  for (const wrong of [null, "de", { Undo: 1 }])
    assert.throws(
      () => setTranslations(untyped(wrong)),
      /^TypeError: (texts: expected an object of|Undo: expected a) string/,
    );
});

test("the example of the guide", async (t) => {
  t.after(() => setTranslations({}));
  const guide = await readFile(new URL("../../www/elements/index.md", import.meta.url), "utf8");
  const [, code] =
    guide.match(
      /\{#languages\}[\s\S]*?```js\nimport \{ setTranslations \} from "casteljau\/elements";\n([\s\S]*?)```/,
    ) ?? [];
  new Function("setTranslations", code)((/** @type {Record<string, string>} */ texts) => {
    for (const english of Object.keys(texts)) assert.ok(english in table, english);
    setTranslations(texts);
  });
  assert.equal(translated("{0} points shown", 4), "4 Punkte zu sehen");
});
