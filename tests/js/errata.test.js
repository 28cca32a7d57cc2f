// The page of errata: each computation proves its correction, and each quotation is in the quoted text.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { proofs } from "../../www/errata/proofs.js";

const page = readFileSync(new URL("../../www/errata/index.md", import.meta.url), "utf8");
const used = [...page.matchAll(/data-proof="([\w-]+)"/g)].map(([, name]) => name);
/** The sections of the page and the files with their texts, which are not part of the project. */
const texts = {
  "lesson-1": "000_a6f0ab9c024df493.txt",
  "lesson-2": "001_875bb579ee9ff4f1.txt",
  lecture: "002_8843f2be2eea820c.txt",
  "chapter-11": "003_569472fa2b97ae7b.txt",
};

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

const QUOTATION = /“((?:[^“”]|“[^“”]*”)*)”/g;
/** The paragraphs that quote a text. @param {string} markdown */
const quotingParagraphs = (markdown) => markdown.split("\n\n").filter((paragraph) => paragraph.endsWith("{.says}"));
/** Text without the marks of Markdown and TeX, in single spaces. @param {string} text */
const plain = (text) => text.replaceAll(/\\[()]|[$*]/g, "").replaceAll(/\s+/g, " ");

test("every erratum quotes its text once, after the name of the section", () => {
  const articles = page.split("::: article").slice(1);
  assert.ok(articles.length > 20);
  for (const article of articles) {
    const paragraphs = quotingParagraphs(article);
    assert.equal(paragraphs.length, 1, article);
    assert.match(paragraphs[0], /^\*\*[^*]+\*\* “/);
  }
});

/** @param {string} file @returns {string} an empty text if there is no such file */
function readText(file) {
  try {
    return readFileSync(new URL(`../../../shared/seeds/${file}`, import.meta.url), "utf8");
  } catch {
    return "";
  }
}

for (const [id, file] of Object.entries(texts)) {
  const section = page.slice(page.indexOf(`{#${id}}`)).split(/^## /m)[0];
  const text = plain(readText(file));
  test(`quotations of ${id}`, { skip: !text && `../shared/seeds/${file} is absent` }, () => {
    const quotations = quotingParagraphs(section).flatMap((paragraph) => [...paragraph.matchAll(QUOTATION)]);
    assert.ok(quotations.length > 1);
    for (const [, quotation] of quotations) assert.ok(text.includes(plain(quotation)), quotation);
  });
}
