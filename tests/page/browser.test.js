// The helper itself: that it serves, that it notices.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./browser.js";

const page = (body) => `<!doctype html><html lang="en"><title>A page</title>${body}</html>`;

test("the package works in a page by import", async (t) => {
  const opened = await openPage(t, { html: page("") });
  const kind = await opened.evaluate(async () => {
    const { init } = await import("/dist/index.js");
    await init();
    return typeof init;
  });
  assert.equal(kind, "function");
});

test("a console error and a thrown error are noticed", async (t) => {
  const opened = await openPage(t, { html: page('<script>console.error("one"); throw new Error("two")</script>') });
  assert.deepEqual(
    opened.problems.map((problem) => problem.replace(/^(Uncaught )?(Error: )?/, "")),
    ["one", "two"],
  );
  opened.problems.length = 0;
});
