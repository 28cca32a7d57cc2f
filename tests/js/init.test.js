// Starting the core: at the first call, ahead of it, and from outside bytes.
import assert from "node:assert/strict";
import { copyFile, cp, mkdtemp, readdir, readFile, rm } from "node:fs/promises";
import { createRequire } from "node:module";
import { after, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { serve } from "../page/server.js";
import { pointsOf } from "./reference.js";

const dist = new URL("../../dist/", import.meta.url);
const wasm = await readFile(new URL("casteljau.wasm", dist));
const TRIANGLE = pointsOf("0,0 1,2 2,0");
const isReady = ({ Curve }) => assert.deepEqual(new Curve(TRIANGLE).eval(0.5), { x: 1, y: 1 });

/** Copies of dist/, below the package so that their files are modules. */
const copies = await mkdtemp(fileURLToPath(new URL("fresh-", dist)));
after(() => rm(copies, { recursive: true }));

/** A copy of the package with no state yet: the files that entries share have the state. */
async function fresh(name) {
  const folder = await mkdtemp(`${copies}/`);
  const files = (await readdir(dist)).filter((file) => file === name || /^shared-.*\.js$/.test(file));
  await Promise.all(files.map((file) => copyFile(new URL(file, dist), `${folder}/${file}`)));
  return import(pathToFileURL(`${folder}/${name}`).href);
}

/** Counts the compilations that an action causes. */
async function compilations(act) {
  const { Module, compile } = WebAssembly;
  let count = 0;
  const construct = (target, args) => {
    count++;
    return Reflect.construct(target, args);
  };
  const apply = (target, self, args) => {
    count++;
    return Reflect.apply(target, self, args);
  };
  Object.assign(WebAssembly, { Module: new Proxy(Module, { construct }), compile: new Proxy(compile, { apply }) });
  try {
    await act();
  } finally {
    Object.assign(WebAssembly, { Module, compile });
  }
  return count;
}

test("import compiles nothing, the first call does, once", async () => {
  let casteljau;
  const call = () => isReady(casteljau);
  const counts = [await compilations(async () => (casteljau = await fresh("index.js")))];
  counts.push(await compilations(call), await compilations(call));
  assert.deepEqual(counts, [0, 1, 0]);
});

test("curves and surfaces are modules of their own, each compiled when it is needed", async () => {
  const { Curve, Surface } = await fresh("index.js");
  const surface = () => Surface.teapot().area();
  const counts = [await compilations(surface), await compilations(surface)];
  counts.push(await compilations(() => isReady({ Curve })));
  assert.deepEqual(counts, [1, 0, 1]);
});

test("slim has one module for both, and one arena", async () => {
  const { init, Curve, Surface } = await fresh("slim.js");
  assert.equal(await compilations(() => init(wasm)), 1);
  const mesh = Surface.teapot().tessellate({ tolerance: 1e-3 });
  assert.ok(mesh.positions.length > 1000);
  const points = new Curve(TRIANGLE).sample(3_000_000); // the arena is moved, and given back
  assert.equal(points[points.length - 2], 2);
  assert.equal(Surface.teapot().bounds().min.z, 0);
  isReady({ Curve });
});

test("the whole package takes a module from outside, too", async () => {
  const { init, Curve, Surface } = await fresh("index.js");
  assert.equal(await compilations(() => init(wasm)), 1);
  isReady({ Curve });
  assert.equal(Surface.teapot().bounds().min.z, 0);
});

test("init is optional and idempotent", async () => {
  const { init, Curve } = await fresh("index.js");
  assert.equal(await compilations(init), 3); // curves, regions and surfaces
  assert.equal(await compilations(init), 0);
  isReady({ Curve });
});

test("a first call while init is under way does no harm", async () => {
  const { init, Curve } = await fresh("index.js");
  const pending = [init(), init()];
  isReady({ Curve });
  await Promise.all(pending);
  isReady({ Curve });
});

test("slim refuses a call before init, and works after it", async () => {
  const { init, Curve } = await fresh("slim.js");
  assert.throws(() => new Curve(TRIANGLE).eval(0.5), { name: "Error", message: /init/ });
  await init(wasm);
  isReady({ Curve });
});

test("slim takes a module, bytes, a Response with or without a type, and a promise", async () => {
  const response = (type) => new Response(wasm, type && { headers: { "Content-Type": type } });
  const sources = [new WebAssembly.Module(wasm), wasm, new Uint8Array(wasm).buffer, response("application/wasm")];
  for (const source of [...sources, response(undefined), Promise.resolve(response("application/wasm"))]) {
    const { init, Curve } = await fresh("slim.js");
    await init(source);
    isReady({ Curve });
  }
});

test("slim takes a URL", async () => {
  const server = await serve({ "/": fileURLToPath(dist) });
  const { init, Curve } = await fresh("slim.js");
  await assert.rejects(init(new URL("/none.wasm", server.url)), /404/);
  await init(new URL("/casteljau.wasm", server.url));
  isReady({ Curve });
  server.close();
});

test("what is no source is refused by kind, and init can be called again", async () => {
  const { init, Curve } = await fresh("slim.js");
  for (const [kind, source] of Object.entries({ nothing: undefined, string: "casteljau.wasm", number: 7, Object: {} }))
    await assert.rejects(init(source), { name: "TypeError", message: new RegExp(`got ${kind}`) });
  await assert.rejects(init(new Uint8Array(3)), WebAssembly.CompileError);
  await assert.rejects(init(Promise.reject(new Error("offline"))), /offline/);
  await init(wasm);
  isReady({ Curve });
});

test("the bundles are loadable anywhere: no import.meta, no top-level await, no URL of another file", async () => {
  const names = (await readdir(dist)).filter((name) =>
    /^(core|surfaces|slim|bezier-app|index|paths|shared-.*)\.js$/.test(name),
  );
  assert.ok(names.length > 8);
  for (const name of names) {
    const text = await readFile(new URL(name, dist), "utf8");
    assert.doesNotMatch(text, /import\.meta|^await |new URL\(|\bimport\(/m, name);
    const alone = ["core.js", "surfaces.js", "slim.js", "bezier-app.js"].includes(name);
    if (alone) assert.doesNotMatch(text, /\bimport\s*["'{]|\bfrom\s*"\.\//m, name);
  }
  assert.equal(typeof createRequire(import.meta.url)("casteljau").init, "function");
});

test("slim carries no wasm", async () => {
  const slim = await readFile(new URL("slim.js", dist));
  const whole = await readFile(new URL("casteljau.global.js", dist));
  assert.ok(whole.length - slim.length > wasm.length);
});

test("where a policy forbids WebAssembly, the error says what it needs", async () => {
  const { Module, compile } = WebAssembly;
  const blocked = new WebAssembly.CompileError("call to WebAssembly.Module() blocked by CSP");
  const construct = () => {
    throw blocked;
  };
  Object.assign(WebAssembly, { Module: new Proxy(Module, { construct }), compile: () => Promise.reject(blocked) });
  try {
    const { Curve, init } = await fresh("index.js");
    const message =
      /^casteljau: WebAssembly is refused here; a Content-Security-Policy needs script-src 'wasm-unsafe-eval'$/;
    assert.throws(() => new Curve(TRIANGLE).eval(0.5), { message, cause: blocked });
    await assert.rejects(init(), { message, cause: blocked });
  } finally {
    Object.assign(WebAssembly, { Module, compile });
  }
});

test("in Node the module is read from its file, and a missing file is named", async () => {
  const folder = await mkdtemp(`${copies}/`);
  await cp(new URL("node/", dist), `${folder}/node`, { recursive: true });
  const { Curve, Path } = await import(pathToFileURL(`${folder}/node/index.js`).href);
  const message = /^casteljau: .*casteljau\.wasm cannot be read; .*"module"/;
  assert.throws(() => new Curve(TRIANGLE).eval(0.5), { message });
  await copyFile(new URL("casteljau.wasm", dist), `${folder}/casteljau.wasm`);
  isReady({ Curve });
  assert.equal(Path.circle([0, 0], 1).nearest([3, 0])?.distance, 2);
});
