// The API reference: every public name has an entry, and every sample, result and error message in www/api/entries is what the package gives.
import assert from "node:assert/strict";
import { test } from "node:test";
import { inspect as inspectInNode } from "node:util";
import * as casteljau from "casteljau";
import { NurbsCurve, NurbsSurface, RationalCurve, RationalPatch, RationalSurface } from "casteljau/nurbs";
import { checksOf, differences } from "../../www/api/build/run.js";
import { entryFolders, readEntries, SECTIONS } from "../../www/api/build/entries.js";
import { reference } from "../../www/api/build/reference.js";

const NURBS = { NurbsCurve, NurbsSurface, RationalCurve, RationalPatch, RationalSurface };

/** What `console.log` prints, on one line. */
const shown = (value) =>
  typeof value === "string" ? value : inspectInNode(value, { maxArrayLength: null }).replace(/\s+/g, " ");

for (const folder of entryFolders()) {
  for (const [name, entry] of readEntries(folder)) {
    test(`${folder}/${name}: the sample prints what the entry says`, async () => {
      assert.deepEqual(await differences(entry), []);
      assert.deepEqual(await differences(entry, shown), [], "as Node's console prints it");
    });

    test(`${folder}/${name}: the entry is complete`, () => {
      assert.match(entry.js?.code ?? "", /console\.log\(.*\/\/ → /s, "a sample that prints");
      assert.ok(entry.rust || entry.sections.get("Rust")?.text, "a sample in Rust, or why there is none");
      for (const section of SECTIONS.filter((section) => section !== "Rust" && section !== "Errors")) {
        assert.ok(entry.sections.get(section)?.text, `a section "${section}"`);
      }
      assert.ok(entry.sections.has("Errors"), 'a section "Errors"');
      for (const { code, result } of checksOf(entry)) assert.ok(code && result, `${code} // → ${result}`);
    });
  }
}

const { pages, types, elements } = reference();

test("every public name has an entry with a sentence", () => {
  const without = pages.flatMap(({ slug, items }) =>
    items.filter(({ summary }) => !summary).map(({ id }) => `${slug}/${id}`),
  );
  assert.deepEqual(without, []);
  const undescribed = types.filter(({ summary }) => !summary).map(({ name }) => name);
  assert.deepEqual(undescribed, []);
  const rows = elements.flatMap(({ tables }) => tables.flatMap((table) => table.rows));
  const undocumented = rows.filter(({ doc }) => !doc).map(({ id }) => id);
  assert.deepEqual(undocumented, []);
});

test("the entries are those of the built package", () => {
  const namesOf = (page) => pages.find(({ title }) => title === page)?.items.map(({ id }) => id) ?? [];
  for (const [name, value] of Object.entries({ ...casteljau, ...NURBS })) {
    if (!/^[A-Z]/.test(name)) {
      const isThere = pages.some(({ items }) => items.some(({ id }) => id === name));
      assert.ok(isThere, name);
      continue;
    }
    const exported = ["constructor", ...publicNames(value), ...publicNames(value.prototype)];
    assert.deepEqual(new Set(namesOf(name).filter((id) => !fields(name).includes(id))), new Set(exported), name);
  }
});

test("every file belongs to a public name", () => {
  const ids = new Set(pages.flatMap(({ slug, items }) => items.map(({ id }) => `${slug}/${id}`)));
  const files = entryFolders().flatMap((folder) => [...readEntries(folder).keys()].map((name) => `${folder}/${name}`));
  const unlisted = files.filter((file) => !ids.has(file));
  assert.deepEqual(unlisted, []);
});

/** The fields of a mesh are no members of its prototype. @param {string} name */
const fields = (name) =>
  name === "Mesh" ? ["positions", "normals", "uvs", "patchIds", "indices", "quads", "patchRanges"] : [];

/** By these, the entry points recognise each other's values. */
const INTERNAL = ["casteljauData", "casteljauIntersections", "casteljauType"];

/** @param {object} value a class or a prototype */
function publicNames(value) {
  const builtIn = new Set(["length", "name", "prototype", "constructor"]);
  const names = [];
  for (let at = value; at && at !== Function.prototype && at !== Object.prototype; at = Object.getPrototypeOf(at)) {
    const isClass = typeof at === "function";
    names.push(
      ...Object.getOwnPropertyNames(at).filter((name) => !(isClass ? builtIn.has(name) : name === "constructor")),
    );
  }
  return names.filter((name) => !name.startsWith("_") && !INTERNAL.includes(name));
}
