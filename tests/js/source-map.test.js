// The edits of built files: their source maps lead to the same places as before.
import assert from "node:assert/strict";
import { SourceMap } from "node:module";
import { test } from "node:test";
import { transform } from "esbuild";
import { replaceMapped, withoutContents } from "../../xtask/source-map.js";

const SOURCE = `const first = call("short");
export function second() {
  return call("a longer text") + call("short") + third;
}
export const third = "end";
const far = () => call("short"), last = second;
export { far, last, first };
`;

test("positions behind replacements of either length stay right", async () => {
  const { code, map } = await transform(SOURCE, { minify: true, sourcemap: true, sourcefile: "source.js" });
  for (const replacement of ["", "x", "a".repeat(100)]) {
    const { mappings, ...rest } = JSON.parse(map);
    const edited = replaceMapped(code, mappings, /"short"|function/g, () => replacement);
    assert.notEqual(edited.code, code);
    const before = new SourceMap(JSON.parse(map));
    const after = new SourceMap({ ...rest, mappings: edited.mappings });
    for (const word of ["a longer text", '"end"', "export{"]) {
      const find = (text, positions) => {
        const lines = text.split("\n");
        const line = lines.findIndex((each) => each.includes(word));
        const { originalLine, originalColumn } = positions.findEntry(line, lines[line].indexOf(word));
        return [originalLine, originalColumn];
      };
      assert.deepEqual(find(edited.code, after), find(code, before), `${word} behind "${replacement}"`);
    }
  }
});

test("contents can be left out", () => {
  const map = { version: 3, sources: ["a.js", "b.js"], sourcesContent: ["1", "2"], names: [], mappings: "" };
  const { sourcesContent } = JSON.parse(withoutContents(JSON.stringify(map), (source) => source === "a.js"));
  assert.deepEqual(sourcesContent, [null, "2"]);
});
