// Each entry of the API reference that has a Rust sample is linked to its counterpart in the Rust documentation.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { entryFolders, readEntries } from "../../www/api/build/entries.js";
import { counterpart, rustAddress, snakeCase } from "../../www/api/build/rustdoc.js";
import { reference } from "../../www/api/build/reference.js";

const docs = fileURLToPath(new URL("../../site/rust/", import.meta.url));

test("every link to the Rust documentation has its target", () => {
  const { pages } = reference();
  const missing = [];
  for (const folder of entryFolders()) {
    const title = pages.find(({ slug }) => slug === folder)?.title ?? folder;
    for (const [name, { rust }] of readEntries(folder)) {
      if (!rust) continue;
      const address = rustAddress(counterpart(title, name, rust.info));
      const [file, id] = address.split("#");
      const found = existsSync(docs + file) && (!id || readFileSync(docs + file, "utf8").includes(`id="${id}"`));
      if (!found) missing.push(`${folder}/${name}: ${address}`);
    }
  }
  assert.deepEqual(missing, []);
});

test("names in Rust", () => {
  assert.equal(snakeCase("toSVG"), "to_svg");
  assert.equal(snakeCase("fromBSpline"), "from_bspline");
  assert.equal(snakeCase("timesAtCoordinate"), "times_at_coordinate");
  assert.equal(counterpart("easing", "toLinear", ""), "Easing::to_linear");
  assert.equal(counterpart("Curve", "constructor", ""), "Curve::new");
});
