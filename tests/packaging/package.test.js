// What the tarball holds, and what the judges of packages say about it.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { publint } from "publint";
import { formatMessage } from "publint/utils";
import { installed, run } from "./fixture.js";

const root = fileURLToPath(new URL("../../", import.meta.url));
const fixture = await installed();
after(fixture.remove);

test("the tarball holds dist and the texts, nothing else", async () => {
  const names = (await run("tar", ["-tzf", fixture.tarball])).split("\n").map((name) => name.replace("package/", ""));
  const expected =
    /^(dist\/((index|core|surfaces|slim|applet|elements(-(shared(-\d)?|surface|applet|companions))?|bezier-app)\.js|casteljau\.wasm|custom-elements\.json|types\/[\w/-]+\.d\.ts)|package\.json|README\.md|CHANGELOG\.md|LICENSE-(MIT|APACHE))$/;
  assert.deepEqual(
    names.filter((name) => !expected.test(name)),
    [],
  );
});

test("no file of the tarball names a folder of the machine that built it", async () => {
  const names = [
    "index.js",
    "core.js",
    "surfaces.js",
    "slim.js",
    "applet.js",
    "elements.js",
    "elements-shared.js",
    "elements-surface.js",
    "elements-applet.js",
    "elements-companions.js",
    "bezier-app.js",
    "casteljau.wasm",
  ];
  for (const name of names) {
    const text = await readFile(join(fixture.installed, "dist", name), "latin1");
    assert.doesNotMatch(text, /\/(home|root|Users|work)\/|\.cargo\/registry|\.rustup/, name);
  }
});

test("publint has nothing to say", async () => {
  const { messages, pkg } = await publint({ pkgDir: fixture.installed, strict: true });
  assert.deepEqual(
    messages.map((message) => formatMessage(message, pkg, { color: false })),
    [],
  );
});

test("attw has nothing to say", async () => {
  const attw = join(root, "node_modules/@arethetypeswrong/cli/dist/index.js");
  const options = ["--profile", "esm-only", "--exclude-entrypoints", "./casteljau.wasm"]; // a file, no module
  await run(process.execPath, [attw, fixture.tarball, "--no-emoji", "--no-color", ...options]);
});

for (const resolution of ["nodenext", "bundler"]) {
  test(`a strict TypeScript program finds the types (${resolution})`, async () => {
    const program = `import { Curve, init } from "casteljau";
import * as slim from "casteljau/slim";
import { bezierApp } from "casteljau/applet";
import { BezierSurface } from "casteljau/elements";
export const x: number = new Curve([[0, 0], [1, 2], [2, 0]]).eval(0.5).x;
export const both: Promise<void>[] = [init(), slim.init(fetch("casteljau.wasm"))];
export const app: Function = bezierApp;
export const turning: boolean = new BezierSurface().turn;
// @ts-expect-error: a curve is made of points
new Curve(7);
`;
    const path = await fixture.write(`types-${resolution}.ts`, program);
    const module = resolution === "nodenext" ? "nodenext" : "esnext";
    const options = ["--strict", "--noEmit", "--target", "es2022", "--lib", "es2022,dom", "--types", ""];
    const tsc = join(root, "node_modules/typescript/bin/tsc");
    const all = [tsc, ...options, "--module", module, "--moduleResolution", resolution, "--ignoreConfig", path];
    await run(process.execPath, all, { cwd: fixture.folder });
  });
}
