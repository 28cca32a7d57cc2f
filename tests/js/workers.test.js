// The worker of the installation page, in Node.
import assert from "node:assert/strict";
import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { Worker } from "node:worker_threads";
import { Path } from "casteljau";

/** What browsers define in a worker. */
const GLOBALS = `
import { parentPort } from "node:worker_threads";
globalThis.onmessage = null;
globalThis.postMessage = (data) => parentPort.postMessage(data);
parentPort.on("message", (data) => globalThis.onmessage({ data }));
`;

test("values are sent to a worker and back as plain data", async () => {
  const page = await readFile(new URL("../../www/install/index.md", import.meta.url), "utf8");
  const code = page.match(/```js\n\/\/ worker\.js\n(.*?)```/s)?.[1];
  assert.ok(code);
  const absolute = code.replace('"casteljau"', JSON.stringify(import.meta.resolve("casteljau")));
  const worker = new Worker(new URL(`data:text/javascript,${encodeURIComponent(GLOBALS + absolute)}`));
  const paths = [Path.circle([0, 0], 2), Path.rect([0, -0], 3, 3)];
  worker.postMessage(paths.map((path) => path.toJSON()));
  const [answer] = await once(worker, "message");
  await worker.terminate();
  assert.ok(Path.fromJSON(answer).equals(paths[0].union(paths[1])));
  assert.deepEqual(structuredClone(paths[0]), {});
});
