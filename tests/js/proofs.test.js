// The page of errata proves what it says: each computation comes out as the page claims, and each is on the page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { proofs } from "../../www/errata/proofs.js";

const page = readFileSync(new URL("../../www/errata/index.md", import.meta.url), "utf8");
const asked = [...page.matchAll(/data-proof="([\w-]+)"/g)].map(([, name]) => name);

for (const [name, prove] of Object.entries(proofs)) {
  test(`erratum ${name}`, () => {
    const { words, holds } = prove();
    assert.ok(holds, words);
    assert.doesNotMatch(words, /NaN|undefined|Infinity|null|-0\b(?!\.)/);
  });
}

test("every proof is on the page, and the page asks for no other", () => {
  assert.deepEqual([...new Set(asked)].sort(), Object.keys(proofs).sort());
});
