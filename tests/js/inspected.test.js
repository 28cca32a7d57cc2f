// What Node shows of curves and splines, and that unused classes are still left out of bundles.
import assert from "node:assert/strict";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { inspect } from "node:util";
import { Curve, Spline } from "casteljau";
import { build } from "esbuild";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");

test("console.log shows the points", () => {
  const curve = new Curve([0, 0, 1, 2.5, 2, 0]);
  assert.equal(inspect(curve), "Curve { points: [ [ 0, 0 ], [ 1, 2.5 ], [ 2, 0 ] ] }");
  const spline = new Spline([0, 0, 1, 1, 2, 0], { degree: 1, closed: true });
  const text = "Spline { points: [ [ 0, 0 ], [ 1, 1 ], [ 2, 0 ] ], degrees: [ 1, 1, 1 ], closed: true }";
  assert.equal(inspect(spline, { breakLength: Infinity }), text);
});

test("console.log shows the points inside of other values, down to the depth of the caller", () => {
  const line = new Curve([0, 0, 1, 1]);
  const shown = "Curve { points: [ [ 0, 0 ], [ 1, 1 ] ] }";
  assert.equal(inspect({ a: { b: line } }, { breakLength: Infinity, compact: true }), `{ a: { b: ${shown} } }`);
  assert.equal(inspect({ a: line }, { depth: 0 }), "{ a: [Curve] }");
  assert.deepEqual(Object.keys(line), []);
});

/** xtask/size.js checks its size. */
test("{ easing } is bundled without the classes of curves", async () => {
  const contents = `import { easing } from "./dist/index.js"; globalThis.used = easing;`;
  const options = /** @type {const} */ ({ bundle: true, minify: true, format: "esm", write: false });
  const { outputFiles } = await build({ stdin: { contents, resolveDir: root }, ...options });
  assert.doesNotMatch(outputFiles[0].text, /nodejs\.util\.inspect|WebAssembly/);
});
