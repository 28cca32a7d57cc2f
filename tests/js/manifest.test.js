// dist/custom-elements.json has everything that the sources of the elements have, and says something about each.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readdir, readFile } from "node:fs/promises";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

globalThis.CSSStyleSheet ??= /** @type {any} */ (function StyleSheet() {});
const root = new URL("../../", import.meta.url);
const read = (path) => readFile(new URL(path, root), "utf8");
const manifest = JSON.parse(await read("dist/custom-elements.json"));
const declarations = manifest.modules.flatMap((module) => module.declarations);
/** The class of each element, from the module that the manifest names. */
const classes = Object.fromEntries(
  await Promise.all(
    manifest.modules.map(async ({ path, declarations: [{ name }] }) => [name, (await import(`../../${path}`))[name]]),
  ),
);
const declared = (tagName) => declarations.find((each) => each.tagName === tagName);

/** The code of what draws the elements, without comments: JSDoc says what there is, and here it is looked for. */
const FOLDERS = ["elements", "layers", "ui"];
const texts = FOLDERS.map(async (folder) => {
  const names = (await readdir(new URL(`js/${folder}`, root), { recursive: true })).filter((name) =>
    /\.ts$/.test(name),
  );
  return Promise.all(names.map((name) => read(`js/${folder}/${name}`)));
});
const code = (await Promise.all(texts))
  .flat(2)
  .join("\n")
  .replace(/\/\*\*[\s\S]*?\*\//g, "");
/** Inside of the style sheets: what stands in where a property is not set, and what a script sets. */
const INSIDE = ["--bz-broken-ink", "--bz-smooth-ink", "--bz-box"];

const all = (text, pattern) => [...new Set([...text.matchAll(pattern)].map(([, name]) => name))].sort();
const names = (list = []) => list.map(({ name }) => name).sort();
const without = (list, others) => list.filter((each) => !others.includes(each));

test("every element that is defined", async () => {
  const files = all(await read("js/elements/on-demand.ts"), /import\("\.\/(define\/\w+)\.js"\)/g);
  const texts = await Promise.all(files.map((file) => read(`js/elements/${file}.ts`)));
  const defined = texts.flatMap((text) => all(text, /define\("([\w-]+)"/g)).sort();
  assert.ok(defined.length >= 6);
  assert.deepEqual(declarations.map(({ tagName }) => tagName).sort(), defined);
  for (const { exports, declarations } of manifest.modules) {
    const [{ name, tagName }] = declarations;
    assert.equal(typeof classes[name], "function");
    for (const [kind, exported] of Object.entries({ js: name, "custom-element-definition": tagName }))
      assert.ok(exports.some((each) => each.kind === kind && each.name === exported));
  }
});

test("attributes, properties and methods are those of the classes, each once", () => {
  for (const { name, tagName, attributes, members, ...rest } of declarations) {
    const Class = classes[name];
    assert.deepEqual(names(attributes), [...Class.observedAttributes].sort(), tagName);
    for (const { name: each, kind } of members) {
      assert.ok(each in Class.prototype || Class.elementProperties.has(each), `${tagName}: ${each}`);
      if (kind === "method") assert.equal(typeof Class.prototype[each], "function", `${tagName}: ${each}`);
    }
    for (const list of [attributes, members, rest.events, rest.cssParts, rest.cssProperties, rest.slots])
      assert.equal(new Set(names(list)).size, list?.length ?? 0, `${tagName}: nothing twice`);
  }
});

test("events, parts, slots and custom properties are those of the code", () => {
  const declaredNames = (list) => [...new Set(declarations.flatMap((each) => names(each[list])))].sort();
  assert.deepEqual(declaredNames("cssParts"), all(code, /\bpart(?:=|: )"([\w-]+)"/g));
  const slots = [...(/<slot>/.test(code) ? [""] : []), ...all(code, /<slot name="([\w-]+)"/g)];
  assert.deepEqual(declaredNames("slots"), slots.sort());
  const events = ["change", "input", ...all(code, /new Event\("(\w+)"/g)];
  assert.deepEqual(without(declaredNames("events"), events), []);
  assert.deepEqual(without(all(code, /(--bz-[\w-]+)/g), [...INSIDE, ...declaredNames("cssProperties")]), []);
});

test("each is described, and the attributes name their properties", () => {
  for (const { tagName, description, attributes, members, events, cssParts, cssProperties, slots } of declarations) {
    assert.ok(description?.length > 20, tagName);
    for (const each of [...events, ...cssParts, ...cssProperties, ...slots])
      assert.ok(each.description, `${tagName}: ${each.name}`);
    for (const { name, fieldName } of attributes) {
      const described = members.some((each) => each.name === fieldName && each.attribute === name);
      assert.ok(described, `${tagName}: ${name}`);
    }
    for (const { name, type, kind } of members) assert.ok(kind === "method" || type.text, `${tagName}: ${name}`);
  }
});

test("no public member of an element is left undescribed", () => {
  const options = /** @type {const} */ ({ cwd: fileURLToPath(root), encoding: "utf8" });
  const { status, stderr } = spawnSync(process.execPath, ["xtask/manifest.js", "--check"], options);
  assert.equal(status, 0, stderr);
});

test("the methods that the sources have for pages are in it", () => {
  const methods = (tagName) => names(declared(tagName).members.filter(({ kind }) => kind === "method"));
  const applet =
    "appendPoint insertJoint randomize redo removePoint reset split edit toBlob toCode toJSON toSVG undo".split(" ");
  assert.deepEqual(without(applet, methods("bezier-applet")), []);
  assert.deepEqual(without(["redo", "toBlob", "undo"], methods("bezier-surface")), []);
  assert.deepEqual(methods("bezier-easing"), ["checkValidity", "reportValidity", "setCustomValidity"]);
  const edit = declared("bezier-applet").members.find(({ name }) => name === "edit");
  const parameters = edit.parameters.map(({ name, optional }) => `${name}${optional === true ? "?" : ""}`);
  assert.deepEqual(parameters, ["what", "done?"]);
});

test("the package says where it is", async () => {
  const { customElements, files, exports } = JSON.parse(await read("package.json"));
  assert.equal(customElements, "./dist/custom-elements.json");
  assert.equal(exports["./custom-elements.json"], customElements);
  assert.ok(files.includes("dist"));
});
