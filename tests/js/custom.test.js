// The command `npx casteljau custom`: modules with some of the package's methods. custom-builds.test.js runs other tests with them.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { mkdir, mkdtemp, readFile, rm, symlink, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { promisify } from "node:util";
import * as complete from "casteljau";
import { Module } from "../../custom/cut.js";
import { encode } from "../../custom/encode.js";
import { allNames } from "../../custom/list.js";
import { customModule, sourceOf } from "../../custom/module.js";

const root = fileURLToPath(new URL("../../", import.meta.url));
const dist = join(root, "dist");
const command = join(dist, "custom/command.js");
const skip = !existsSync(command) && "dist/custom is part of a release: npm run test:all";

/** What the command needs, and a folder for what it writes. */
let folder = "";
/** @type {import("../../custom/module.js").Source} */
let source;
before(async () => {
  folder = await mkdtemp(join(tmpdir(), "casteljau-custom-"));
  await writeFile(join(folder, "package.json"), '{ "type": "module" }');
  if (skip) return;
  const json = (name) => JSON.parse(readFileSync(join(dist, "custom", name), "utf8"));
  source = sourceOf(json("pieces.json"), json("needs.json"), readFileSync(join(dist, "casteljau.wasm")));
});
after(() => rm(folder, { recursive: true, force: true }));

/** Runs the command in the folder. @param {string[]} words */
const run = (...words) => promisify(execFile)(process.execPath, [command, ...words], { cwd: folder });
/** The message of a refused call. @param {string[]} words */
const refusal = (...words) =>
  run(...words).then(
    () => assert.fail("expected a refusal"),
    ({ code, stderr }) => {
      assert.equal(code, 1);
      return stderr.trim();
    },
  );
/** Imports a module that the command wrote. @param {string} name @returns {Promise<any>} */
const load = (name) => import(pathToFileURL(join(folder, name)).href);
const ARCH = [0, 0, 1, 3, 4, -2, 5, 1];

test("custom: a length, and what is missing", { skip }, async () => {
  const { stdout } = await run("custom", "Curve.length", "--out", "src/length.js");
  assert.match(stdout, /^src\/length\.js: [\d.]+ kB, [\d.]+ kB with gzip; types: src\/length\.d\.ts\n$/);
  const { Curve, ...others } = await load("src/length.js");
  assert.deepEqual(Object.keys(others), ["init"]);
  assert.equal(new Curve(ARCH).length(), new complete.Curve(ARCH).length());
  assert.equal(new Curve(ARCH).length(1e-3), new complete.Curve(ARCH).length(1e-3));
  assert.equal(Curve.name, "Curve");
  assert.throws(() => new Curve([0]), { name: "RangeError", message: /^points: expected .*, got 1$/ });
  const firstLine = (await readFile(join(folder, "src/length.js"), "utf8")).split("\n", 1)[0];
  const words = "npx casteljau custom Curve.length --out src/length.js";
  assert.ok(firstLine.startsWith(`/*! ${words} |`), firstLine);
  for (const [name, act] of Object.entries({
    bounds: () => new Curve(ARCH).bounds(),
    degree: () => new Curve(ARCH).degree,
    fromJSON: () => Curve.fromJSON({ points: [] }),
  }))
    assert.throws(act, { name: "TypeError", message: `Curve.${name} is not in this build; add it: ${words}` });
});

test("custom: init compiles the module", { skip }, async () => {
  const { stdout } = await run("custom", "Path.fromSVG", "Path.pointAtLength", "--out", "init.mjs");
  assert.match(stdout, /smaller without\n {2}Path\.pointAtLength +[\d.]+ kB\n {2}Path\.fromSVG +[\d.]+ kB\n$/);
  const { Path, init } = await load("init.mjs");
  await init();
  const [ours, theirs] = [Path, complete.Path].map((Class) => Class.fromSVG("M0 0C1 3 4-2 5 1Z").pointAtLength(2));
  assert.deepEqual(ours, theirs);
  assert.ok(existsSync(join(folder, "init.d.mts")));
});

test("custom: all methods, a class alone, a function, names from a file", { skip }, async () => {
  await writeFile(join(folder, "names.txt"), "# what the page uses\nPatch.*\n\nCurve easing # and this\n");
  await run("custom", "--list", "names.txt", "--out", "all.js");
  const { Curve, Patch, easing } = await load("all.js");
  const net = Array.from({ length: 12 }, (_, k) => [k % 4, Math.floor(k / 4), k ** 2 % 7]);
  const [ours, theirs] = [Patch, complete.Patch].map((Class) => new Class(net, { degreeU: 3, degreeV: 2 }));
  assert.deepEqual(ours.eval(0.3, 0.4), theirs.eval(0.3, 0.4));
  assert.deepEqual(ours.toJSON(), theirs.toJSON());
  assert.equal(ours.area(), theirs.area());
  assert.equal(easing("ease")(0.3), complete.easing("ease")(0.3));
  assert.throws(() => new Curve(ARCH).eval(0.5), /Curve\.eval is not in this build/);
});

test("custom: without calls of the core there is no wasm", { skip }, async () => {
  await run("custom", "easing", "Curve.points", "--out", "points.mjs");
  const { Curve, easing, ...others } = await load("points.mjs");
  assert.deepEqual(others, {});
  assert.deepEqual(new Curve([0, 1, 2, 3]).points(), [
    { x: 0, y: 1 },
    { x: 2, y: 3 },
  ]);
  assert.equal(easing("linear")(0.25), 0.25);
  assert.doesNotMatch(await readFile(join(folder, "points.mjs"), "utf8"), /WebAssembly/);
});

test("custom: values of the package and of other builds are accepted", { skip }, async () => {
  await run("custom", "Curve.intersections", "--out", "one.js");
  await run("custom", "Curve.equals", "--out", "two.js");
  const [one, two] = [await load("one.js"), await load("two.js")];
  assert.equal(new one.Curve(ARCH).intersections(new complete.Curve([0, 0.5, 5, 0.5])).length, 3);
  assert.equal(new two.Curve(ARCH).equals(new one.Curve(ARCH)), true);
  assert.throws(() => new two.Curve(ARCH).equals({}), {
    message:
      "other: expected a Curve, got an object without keys; structuredClone and postMessage need toJSON() and fromJSON()",
  });
});

test("custom: the same words give the same bytes", { skip }, () => {
  const make = () => customModule(source, ["Curve.offset", "Spline.segments"], "npx casteljau custom");
  assert.deepEqual(make(), make());
});

test("custom: wrong words", { skip }, async () => {
  assert.match(
    await refusal("custom", "Curve.lenght", "--out", "a.js"),
    /^casteljau: Curve\.lenght: expected .*; did you mean Curve\.length\?$/,
  );
  assert.match(await refusal("custom", "union", "--out", "a.js"), /did you mean Path\.union\?$/);
  for (const name of ["RationalCurve", "NurbsCurve.circle", "NurbsCurve.*"])
    assert.match(
      await refusal("custom", "Curve.length", name, "--out", "a.js"),
      /^casteljau: \S+: expected a name of casteljau, got one of casteljau\/nurbs; import (RationalCurve|NurbsCurve) from there$/,
    );
  assert.match(await refusal("custom", "Curve.length"), /^casteljau: --out: expected a file/);
  assert.match(
    await refusal("custom", "Curve.length", "--out", "a.ts"),
    /expected a file that ends in \.js or \.mjs, got a\.ts$/,
  );
  assert.match(await refusal("custom", "--out", "a.js"), /^casteljau: expected names such as Curve\.length, got none/);
  assert.match(await refusal("custom", "Curve.length", "--into", "a.js"), /--into/);
  assert.match(
    await refusal("custom", "--list", "absent.txt", "--out", "a.js"),
    /--list: expected a file, got absent\.txt$/,
  );
  assert.match(await refusal("build"), /expected the command custom, got build$/);
  await writeFile(join(folder, "own.js"), "export {};\n");
  assert.match(
    await refusal("custom", "Curve.length", "--out", "own.js"),
    /expected a new file, or one that this command has made, got own\.js$/,
  );
  assert.match((await run("--help")).stdout, /^npx casteljau custom NAME/);
});

/** The programs of a user: each line that has to be refused by the compiler is preceded by a remark. */
const PROGRAM = `import { Curve, Path, type Nearest } from "./bezier.js";
const curve = new Curve([[0, 0], [1, 2], [2, 0]]);
const found: Nearest<2> = curve.nearest([1, 1]);
const { x }: { x: number; y: number } = found.point;
const points: number | undefined = Path.fromSVG("M0 0H1").pointAtLength(x)?.point.y;
// @ts-expect-error: it is not in the list
curve.frames(3);
// @ts-expect-error: it is not in the list
Curve.fromJSON({ points: [] });
// @ts-expect-error: its dimension is 3
const wrong: Nearest<2> = new Curve([[0, 0, 0], [1, 2, 3]]).nearest([1, 1, 1]);
export { points, wrong };
`;

test("custom: the types", { skip }, async () => {
  await run("custom", "Curve.nearest", "Path.fromSVG", "Path.pointAtLength", "--out", "typed/bezier.js");
  await writeFile(join(folder, "typed/program.ts"), PROGRAM);
  assert.equal(await compile(join(folder, "typed"), ["program.ts"]), "");
});

/** What the compiler has to say about files in a folder. @param {string} cwd @param {string[]} files */
async function compile(cwd, files) {
  const tsc = join(root, "node_modules/typescript/bin/tsc");
  const language = ["--target", "es2022", "--module", "nodenext", "--lib", "es2022,dom", "--types", ""];
  const options = ["--ignoreConfig", "--strict", "--noEmit", ...language];
  const compiler = promisify(execFile)(process.execPath, [tsc, ...options, ...files], { cwd });
  return (await compiler.catch((error) => error)).stdout;
}

test("custom --from: the names that a program uses, in TypeScript and in JavaScript", { skip }, async () => {
  const modules = join(folder, "program/node_modules");
  await mkdir(join(folder, "program/src"), { recursive: true });
  await mkdir(modules, { recursive: true });
  const write = (name, text) => writeFile(join(folder, "program/src", name), text);
  await write(
    "main.ts",
    `import { Curve, Path, easing } from "casteljau";
    import { half } from "./half.js";
    const lengths = ["a", "b"].map((text) => text.length);
    const path = Path.fromSVG("M0 0H1");
    const { subpathCount } = path;
    console.log(path.subpaths[0].segments().map((curve) => half(curve)?.length()), subpathCount, easing("ease"), lengths);
    `,
  );
  await write(
    "half.js",
    `/** @param {import("casteljau").Curve} curve */\nexport const half = (curve) => curve["halve"]()[0];\n`,
  );
  assert.match(
    await refusal("custom", "--from", "program/src"),
    /^casteljau: --from: expected TypeScript with a compiler API/,
  );
  await symlink(join(root, "node_modules/typescript-api"), join(modules, "typescript"), "junction");
  await symlink(root, join(modules, "casteljau"), "junction");
  const names = "Curve.halve Curve.length Path.fromSVG Path.subpathCount Path.subpaths Spline.segments easing";
  const { stdout } = await run("custom", "--from", "program/src");
  assert.equal(stdout, `npx casteljau custom ${names} --out src/bezier.js\n`);
  // The module that is made takes the place of the package, and the list stays the same.
  await run("custom", "--from", "program/src", "--out", "program/src/bezier.js");
  const main = await readFile(join(folder, "program/src/main.ts"), "utf8");
  await write("main.ts", main.replace('"casteljau"', '"./bezier.js"'));
  assert.equal((await run("custom", "--from", "program/src")).stdout, stdout);
  assert.match(await refusal("custom", "--from", "absent"), /--from: expected a folder, got absent$/);
});

test("custom: every name can be listed alone", { skip }, async () => {
  const names = allNames(source.pieces.names);
  await mkdir(join(folder, "alone"));
  for (const name of names) {
    const { code, wasm, types } = customModule(source, [name], "npx casteljau custom");
    assert.ok(wasm === null || WebAssembly.validate(wasm), name);
    const [type, member] = name.split(".");
    assert.match(code, new RegExp(`export\\{.*\\b${type}\\b.*\\};\n$`));
    if (member) assert.match(types, new RegExp(`^ +(static |get |readonly )?${member}\\b`, "m"), name);
    await writeFile(join(folder, "alone", `${name}.d.ts`), types);
  }
  assert.equal(
    await compile(
      join(folder, "alone"),
      names.map((name) => `${name}.d.ts`),
    ),
    "",
  );
});

test("custom: bytes are encoded as xtask encodes them", { skip }, async () => {
  const { alphabet, frequent, length, text } = await import("../../js/glue/core-bytes.js");
  assert.deepEqual(encode(readFileSync(join(root, "js/glue/core.wasm"))), { alphabet, frequent, length, text });
});

/** @param {number} id @param {number[]} bytes */
const section = (id, ...bytes) => [id, bytes.length, ...bytes];
const [F, G, H, M] = [0x66, 0x67, 0x68, 0x6d];

/** A module: f calls g through the table, h is in the table as well; g reads the constant at 4, h the one at 32. */
const SMALL = Uint8Array.from([
  ...[0, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
  ...section(1, 1, 0x60, 0, 1, 0x7f), // () → i32
  ...section(3, 3, 0, 0, 0),
  ...section(4, 1, 0x70, 1, 3, 3),
  ...section(5, 1, 0, 1),
  ...section(7, 4, 1, F, 0, 0, 1, G, 0, 1, 1, H, 0, 2, 1, M, 2, 0),
  ...section(9, 1, 0, 0x41, 1, 0x0b, 2, 1, 2),
  ...section(
    ...[10, 3],
    ...[7, 0, 0x41, 1, 0x11, 0, 0, 0x0b],
    ...[7, 0, 0x41, 0, 0x28, 2, 4, 0x0b],
    ...[7, 0, 0x41, 0, 0x28, 2, 32, 0x0b],
  ),
  ...section(11, 1, 0, 0x41, 4, 0x0b, 32, 7, 0, 0, 0, ...Array(24).fill(1), 9, 0, 0, 1),
]);
const SMALL_NEEDS = {
  data: [4, 28, 32, 4],
  exports: { f: { data: [4, 4], table: [1] }, g: { data: [4, 4], table: [] }, h: { data: [32, 2], table: [] } },
};

test("cut: functions, the table and constants that an export needs", async () => {
  const module = new Module(SMALL);
  const start = async (names, needs) => {
    const { bytes } = module.cut(new Set(names), needs);
    const { instance } = /** @type {any} */ (await WebAssembly.instantiate(bytes));
    return { bytes, exports: instance.exports };
  };
  const whole = await start(["f", "g", "h"], null);
  assert.deepEqual(whole.bytes, SMALL);
  const f = await start(["f"], SMALL_NEEDS);
  assert.equal(f.exports.f(), 7);
  assert.deepEqual(Object.keys(f.exports), ["f", "m"]);
  assert.equal(new Uint8Array(f.exports.m.buffer).filter((byte) => byte > 0).length, 1);
  assert.equal(new Module(f.bytes).bodies.length, 2);
  const h = await start(["h"], SMALL_NEEDS);
  assert.equal(h.exports.h(), 9);
  assert.equal(new Module(h.bytes).table.size, 0);
});

test("cut: an unknown instruction is refused", () => {
  const bytes = SMALL.slice();
  bytes[bytes.lastIndexOf(0x11)] = 0x06; // try
  assert.throws(() => new Module(bytes), { message: "cut: expected an instruction of WebAssembly 2.0, got 0x6" });
});
