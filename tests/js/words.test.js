// Names in js/ are standard terms: none of the words that only this project used for them.
import assert from "node:assert/strict";
import { readdir, readFile } from "node:fs/promises";
import { test } from "node:test";

const folder = new URL("../../js/", import.meta.url);

/** What each word is called instead. @type {[RegExp, string][]} */
const WORDS = [
  [/\bMOST_\w+/g, "MAX_…"],
  [/\bLEAST_\w+/g, "MIN_…"],
  [/\b(Hands|Acting|acts)\b/g, "AppletController, actions"],
  [/\b(Desk|Turning|Lease|Fineness)\b/g, "SurfaceController, AutoRotation, ContextSlot, DetailSettings"],
  [/\b(Sheet|Place)\b/g, "DrawContext, Point2"],
  [
    /\b(told|tell|tells|heard|attended|dusted|deafen|leases|DeskPort)\b/g,
    "notify, messages, announced, focusedPoint, roundedToPixels",
  ],
  [/\b(least|most)\b/g, "min, max"],
  [/\b(chosen|during|byUser|byPage|settle|giveUp)\b/g, "selected, dispatch by someone, commit, revert"],
  [/\b(knob|hollow|truth|fewest)\b/g, "controlPoint, ring, continuityLabels, minPoints"],
];

/** A source without comments and texts. @param {string} source */
const codeOf = (source) =>
  source.replace(/\/\*[\s\S]*?\*\/|\/\/.*|"(?:[^"\\\n]|\\.)*"|`(?:[^`\\]|\\.)*`/g, (found) =>
    found.replace(/[^\n]/g, " "),
  );

/** The sources, without what is generated. */
async function sources() {
  const names = await readdir(folder, { recursive: true });
  return names.filter((name) => name.endsWith(".ts") && !name.startsWith("glue"));
}

test("types are imported by `import type`, where the lint of import cycles sees them", async () => {
  const found = [];
  for (const name of await sources()) {
    const code = await readFile(new URL(name, folder), "utf8");
    for (const [inline] of code.matchAll(/(?<!=> |await )\bimport\("[^"]*"\)/g)) found.push(`${name}: ${inline}`);
  }
  assert.deepEqual(found, []);
});

test("identifiers are standard terms", async () => {
  const names = await sources();
  assert.ok(names.length > 200);
  const found = [];
  for (const name of names) {
    const code = codeOf(await readFile(new URL(name, folder), "utf8"));
    for (const [pattern, instead] of WORDS)
      for (const [word] of code.matchAll(pattern)) found.push(`${name}: ${word}; instead: ${instead}`);
  }
  assert.deepEqual(found, []);
});
