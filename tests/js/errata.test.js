// The page of errata: each computation proves its correction.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { proofs } from "../../www/errata/proofs.js";

const page = readFileSync(new URL("../../www/errata/index.md", import.meta.url), "utf8");
const used = [...page.matchAll(/data-proof="([\w-]+)"/g)].map(([, name]) => name);
for (const [name, prove] of Object.entries(proofs)) {
  test(`erratum ${name}`, () => {
    const { words, holds } = prove();
    assert.ok(holds, words);
    assert.doesNotMatch(words, /NaN|undefined|Infinity|null|-0\b(?!\.)/);
  });
}

test("every computation is on the page, and the page needs no other", () => {
  assert.deepEqual(used.sort(), Object.keys(proofs).sort());
});
