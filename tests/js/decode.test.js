// The bytes that travel as text are the bytes of the wasm file; the encoder's own tests are in xtask/src/encode.rs.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { decodeBytes } from "#js/wasm/decode-bytes.js";
import * as curves from "../../js/glue/curves-bytes.js";
import * as surfaces from "../../js/glue/surfaces-bytes.js";

const { alphabet } = curves;

for (const [name, { text, frequent, length }] of Object.entries({ curves, surfaces })) {
  const wasm = await readFile(new URL(`../../js/glue/${name}.wasm`, import.meta.url));

  test(`${name}: the text decodes to the wasm file`, () => {
    assert.ok(Buffer.from(decodeBytes(text, alphabet, frequent, length)).equals(wasm));
  });

  test(`${name}: gzip still sees through the text`, () => {
    const ratio = gzipSync(text, { level: 9 }).length / gzipSync(wasm, { level: 9 }).length;
    assert.ok(ratio < 1.1, `the text is ${((ratio - 1) * 100).toFixed(1)} % larger than the wasm file, after gzip`);
  });
}

test("each form of byte decodes: one character, two characters, the last of each", () => {
  const first = Array.from({ length: 60 }, (_, i) => i + 100);
  const single = alphabet[0] + alphabet[59];
  const double = alphabet[60] + alphabet[0] + alphabet[62] + alphabet[195 - 2 * alphabet.length];
  assert.deepEqual([...decodeBytes(single + double, alphabet, first, 4)], [100, 159, 0, 255]);
});
