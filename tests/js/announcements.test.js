// What screen readers are told: one text after the last of several changes.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Announcer } from "#js/ui/announcer.js";

test("several changes in a row are announced once, with what else there is to say; after the end nothing is", (t) => {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const globals = /** @type {any} */ (globalThis);
  globals.window = globalThis;
  t.after(() => delete globals.window);
  const texts = [];
  const region = Object.defineProperty({}, "textContent", { set: (text) => texts.push(text) }); // keeps every text
  const speaker = new Announcer(/** @type {any} */ (region), () => "G1 at P3");
  for (const words of ["P1 at 199, 80", "P1 at 198, 80", "P1 at 197, 80"]) {
    speaker.say(words);
    t.mock.timers.tick(400);
  }
  assert.deepEqual(texts, [], "not while something changes");
  t.mock.timers.tick(100);
  assert.deepEqual(texts, ["P1 at 197, 80. G1 at P3"]);
  t.mock.timers.tick(10_000);
  assert.equal(texts.length, 1);
  speaker.say("P1 at 196, 80");
  speaker.end();
  t.mock.timers.tick(10_000);
  assert.equal(texts.length, 1);
});
