// Every JavaScript example of the README runs; a line that ends in "// → value" is checked against that value.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../", import.meta.url));
const readme = readFileSync(`${root}README.md`, "utf8");
const examples = [...readme.matchAll(/^```js\n([\s\S]*?)^```$/gm)].map(([, code]) => code);

/** @param {string} code */
const checked = (code) =>
  code.replace(/^(.*); \/\/ → (.*)$/gm, (_, expression, value) => `assert.deepEqual(${expression}, ${value});`);

test("the README has its examples", () => {
  assert.ok(examples.length >= 4, `found ${examples.length}`);
  for (const code of examples) assert.match(code, / \/\/ → /, "an example without a checked line");
});

for (const code of examples) {
  test(`README: ${code.split("\n")[2]}`, () => {
    // From the package's folder "casteljau" means the package itself, as built.
    const script = `import assert from "node:assert/strict";\n${checked(code)}`;
    execFileSync(process.execPath, ["--input-type=module", "--eval", script], { cwd: root, stdio: "pipe" });
  });
}
