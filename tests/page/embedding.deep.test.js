// Elements in someone else's page come and go a thousand times: counted objects and the scripts' heap do not grow.
import assert from "node:assert/strict";
import { test } from "node:test";
import { frames } from "./browser.js";
import { begunAgain, comeAndGo, openStrict, populate, settled } from "./embedding-page.js";
import { leftOver } from "./ledger.js";

const TIMES = 1000;
/** Until then the browser compiles what is called often. */
const WARM_UP = 250;
/** A mere byte kept for each time and kind would not be seen; an element, a listener or a closure is. */
const KEPT_BYTES_PER_TIME = 40;

test("every kind of element comes and goes a thousand times and leaves nothing", async (t) => {
  const page = await openStrict(t);
  const client = await page.context().newCDPSession(page);
  const empty = await page.evaluate(() => ledger.count()); // the test's own tool listens, too
  const names = await populate(page);
  await settled(page);
  const begun = await page.evaluate(() => ledger.count());
  await comeAndGo(page, WARM_UP);
  await settled(page);
  await begunAgain(page, begun);
  const [before, leftBefore] = [await page.evaluate(() => ledger.count()), await leftOver(client)];
  await comeAndGo(page, TIMES);
  await settled(page);
  await begunAgain(page, before);
  const [after, leftAfter] = [await page.evaluate(() => ledger.count()), await leftOver(client)];
  assert.deepEqual({ ...after, frames: 0 }, { ...before, frames: 0 }, "while they are in the page");
  assert.equal(leftAfter.nodes, leftBefore.nodes, "nodes");
  assert.equal(leftAfter.listeners, leftBefore.listeners, "listeners of all kinds");
  assert.ok(after.contexts <= names.length, `${after.contexts} graphics contexts`);
  const grown = (leftAfter.bytes - leftBefore.bytes) / TIMES;
  assert.ok(grown < KEPT_BYTES_PER_TIME * names.length, `${grown} bytes each time`);
  await page.evaluate(() => all.forEach((element) => element.remove()));
  await frames(page);
  const gone = await page.evaluate(() => [ledger.count(), ledger.types()]);
  assert.deepEqual(gone[0], { ...empty, contexts: after.contexts }, `when they are gone: ${gone[1]}`);
});
