// Every JavaScript example of the README and of docs/migration.md runs; a line that ends in "// → value" is checked against that value.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../", import.meta.url));
/** The texts, and how many examples each has at least. */
const TEXTS = { "README.md": 1, "docs/migration.md": 6 };

/** @param {string} name */
const examplesOf = (name) =>
  [...readFileSync(`${root}${name}`, "utf8").matchAll(/^```js\n([\s\S]*?)^```$/gm)].map(([, code]) => code);

/** @param {string} code */
const checked = (code) =>
  code.replace(/^(.*); \/\/ → (.*)$/gm, (_, expression, value) => `assert.deepEqual(${expression}, ${value});`);

for (const [name, count] of Object.entries(TEXTS)) {
  const examples = examplesOf(name);

  test(`${name} has its examples`, () => {
    assert.ok(examples.length >= count, `found ${examples.length}`);
    for (const code of examples) assert.match(code, / \/\/ → /, "an example without a checked line");
  });

  for (const code of examples) {
    test(`${name}: ${code.split("\n").find((line) => line.startsWith("const "))}`, () => {
      // From the package's folder "casteljau" means the package itself, as built.
      const script = `import assert from "node:assert/strict";\n${checked(code)}`;
      execFileSync(process.execPath, ["--input-type=module", "--eval", script], { cwd: root, stdio: "pipe" });
    });
  }
}
