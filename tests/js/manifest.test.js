// dist/custom-elements.json has everything that the sources of the elements have, and says something about each.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readdir, readFile } from "node:fs/promises";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

globalThis.CSSStyleSheet ??= /** @type {any} */ (function StyleSheet() {});
const classes = await import("casteljau/elements");
const root = new URL("../../", import.meta.url);
const read = (path) => readFile(new URL(path, root), "utf8");
const manifest = JSON.parse(await read("dist/custom-elements.json"));
const declarations = manifest.modules.flatMap((module) => module.declarations);
const declared = (tagName) => declarations.find((each) => each.tagName === tagName);

/** All text of some files and folders. */
async function sources(...paths) {
  const texts = await Promise.all(
    paths.map(async (path) => {
      if (path.endsWith(".ts")) return read(path);
      const names = (await readdir(new URL(path, root), { recursive: true })).filter((name) => name.endsWith(".ts"));
      return (await Promise.all(names.map((name) => read(`${path}/${name}`)))).join("\n");
    }),
  );
  // JSDoc says what there is; here it is looked for in the code.
  return texts.join("\n").replace(/\/\*\*[\s\S]*?\*\//g, "");
}

const companion = (...names) => ["companion", "style", ...names].map((name) => `js/elements/companions/${name}.ts`);
const FIELDS = "js/ui/number-fields.ts";
const SOURCES = {
  "bezier-applet": ["js/elements/applet", "js/layers", "js/ui/handles.ts", "js/ui/tokens.ts", "js/applet/style.ts"],
  "bezier-surface": ["js/elements/surface"],
  "bezier-bernstein": companion("bernstein", "bernstein-view"),
  "bezier-equation": [...companion("equation", "equation-view"), FIELDS],
  "bezier-coordinates": [...companion("coordinates", "coordinates-view"), FIELDS],
  "bezier-easing": [...companion("easing", "easing-view", "easing-handles", "easing-picture"), FIELDS],
};
/** Inside of the style sheets: what stands in where a property is not set, and what a script sets. */
const INSIDE = ["--bz-broken-ink", "--bz-smooth-ink", "--bz-box"];

const all = (text, pattern) => [...new Set([...text.matchAll(pattern)].map(([, name]) => name))].sort();
const names = (list = []) => list.map(({ name }) => name).sort();
const without = (list, others) => list.filter((each) => !others.includes(each));

test("every element that is defined", async () => {
  const files = all(await read("js/elements/index.ts"), /export \{ \w+ \} from "\.\/(define\/\w+)\.js"/g);
  const texts = await Promise.all(files.map((file) => read(`js/elements/${file}.ts`)));
  const defined = texts.flatMap((text) => all(text, /define\("([\w-]+)"/g)).sort();
  assert.ok(defined.length >= 6);
  assert.deepEqual(declarations.map(({ tagName }) => tagName).sort(), defined);
  assert.deepEqual(Object.keys(SOURCES).sort(), defined, "this test knows them all");
  for (const { name, tagName } of declarations) {
    assert.equal(typeof classes[name], "function");
    const { exports } = manifest.modules[0];
    for (const [kind, exported] of Object.entries({ js: name, "custom-element-definition": tagName }))
      assert.ok(exports.some((each) => each.kind === kind && each.name === exported));
  }
});

for (const [tagName, paths] of Object.entries(SOURCES)) {
  test(`${tagName}: attributes, properties, methods, events, parts, slots and custom properties`, async () => {
    const { name, attributes, members, events, cssParts, cssProperties, slots } = declared(tagName);
    const text = await sources(...paths);
    const Class = classes[name];
    assert.deepEqual(names(attributes), [...Class.observedAttributes].sort());
    for (const { name: each } of members)
      assert.ok(each in Class.prototype || Class.elementProperties.has(each), `${each} is there`);
    const methods = members.filter(({ kind }) => kind === "method");
    for (const { name: each } of methods) assert.equal(typeof Class.prototype[each], "function", each);
    const told = ["change", "input", ...all(text, /new Event\("(\w+)"/g)].sort();
    assert.deepEqual(names(events), [...new Set(told)]);
    assert.deepEqual(names(cssParts), all(text, /\bpart(?:=|: )"([\w-]+)"/g));
    const expected = [...(/<slot>/.test(text) ? [""] : []), ...all(text, /<slot name="([\w-]+)"/g)].sort();
    assert.deepEqual(names(slots), expected);
    assert.deepEqual(without(without(all(text, /(--bz-[\w-]+)/g), INSIDE), names(cssProperties)), []);
    for (const list of [attributes, members, events, cssParts, cssProperties, slots])
      assert.equal(new Set(names(list)).size, list?.length ?? 0, "nothing twice");
  });
}

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
    "appendPoint insertJoint randomize redo removePoint reset split steer toBlob toCode toJSON toSVG undo".split(" ");
  assert.deepEqual(without(applet, methods("bezier-applet")), []);
  assert.deepEqual(without(["redo", "toBlob", "undo"], methods("bezier-surface")), []);
  assert.deepEqual(methods("bezier-easing"), ["checkValidity", "reportValidity", "setCustomValidity"]);
  const steer = declared("bezier-applet").members.find(({ name }) => name === "steer");
  const parameters = steer.parameters.map(({ name, optional }) => `${name}${optional === true ? "?" : ""}`);
  assert.deepEqual(parameters, ["what", "done?"]);
});

test("the package says where it is", async () => {
  const { customElements, files, exports } = JSON.parse(await read("package.json"));
  assert.equal(customElements, "./dist/custom-elements.json");
  assert.equal(exports["./custom-elements.json"], customElements);
  assert.ok(files.includes("dist"));
});
