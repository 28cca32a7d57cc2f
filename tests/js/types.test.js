// The types of the package, as a strict TypeScript program sees them. The programs are in types/.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

const folder = join(dirname(fileURLToPath(import.meta.url)), "types");
const tsc = join(folder, "../../../node_modules/typescript/bin/tsc");
const OPTIONS = ["--ignoreConfig", "--strict", "--noEmit", "--target", "es2022", "--module", "nodenext"];

test("the programs in types/ compile, and only where they expect an error there is one", async () => {
  const programs = readdirSync(folder).filter((name) => name.endsWith(".ts"));
  assert.ok(programs.length > 0);
  const args = [tsc, ...OPTIONS, "--lib", "es2022,dom", "--types", "", ...programs];
  const { stdout } = await promisify(execFile)(process.execPath, args, { cwd: folder }).catch((error) => error);
  assert.equal(stdout, "");
});
