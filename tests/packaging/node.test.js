// The installed tarball in Node.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { PRINTED, PROGRAM, installed, run } from "./fixture.js";

const fixture = await installed();
after(fixture.remove);

const node = async (name, text) => run(process.execPath, [await fixture.write(name, text)], { cwd: fixture.folder });

test("import", async () => {
  assert.equal(await node("import.js", PROGRAM), PRINTED);
});

test("require", async () => {
  const program = PROGRAM.replace(/^import (.*) from (.*);$/m, "const $1 = require($2);");
  assert.equal(await node("require.cjs", program), PRINTED);
});

test("easing by import and by require", async () => {
  const program = `import { easing } from "casteljau/easing";\nconsole.log(easing("steps(4)")(0.6), easing("ease").css);\n`;
  const required = program.replace(/^import (.*) from (.*);$/m, "const $1 = require($2);");
  const printed = "0.5 cubic-bezier(0.25, 0.1, 0.25, 1)";
  assert.equal(await node("easing.js", program), printed);
  assert.equal(await node("easing.cjs", required), printed);
});

test("slim with the wasm file of the package", async () => {
  const program = `import { readFile } from "node:fs/promises";
import { init } from "casteljau/slim";
await init(readFile(new URL(import.meta.resolve("casteljau/casteljau.wasm"))));
${PROGRAM.replace('"casteljau"', '"casteljau/slim"')}`;
  assert.equal(await node("slim.js", program), PRINTED);
});

test("the applet module loads without a document", async () => {
  const program = `import { bezierApp } from "casteljau/applet"; console.log(typeof bezierApp);`;
  assert.equal(await node("applet.js", program), "function");
});

test("the elements load without a document, and define nothing", async () => {
  const program = `import "casteljau/elements";
import { BezierSurface } from "casteljau/elements/surface"; console.log(typeof BezierSurface, typeof customElements, typeof document);`;
  assert.equal(await node("elements.js", program), "function undefined undefined");
});

test("the version can be read", async () => {
  const program = `console.log(require("casteljau/package.json").version)`;
  assert.match(await node("version.cjs", program), /^\d+\.\d+\.\d+$/);
});
