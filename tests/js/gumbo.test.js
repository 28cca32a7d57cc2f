// Ed Catmull's Gumbo, the most difficult model, whose data are not part of the project.
import { existsSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { Surface } from "casteljau";
import { testFiles } from "./mesh-files.js";

const file = new URL("../../../shared/data/gumbo.json", import.meta.url);
if (existsSync(file)) {
  const { vertices, patches } = JSON.parse(readFileSync(file, "utf8"));
  const surface = new Surface({ vertices, patches });
  testFiles("Gumbo", surface.tessellate({ tolerance: 0.02 }));
  testFiles("Gumbo as tubes", surface.wireframe({ lines: 2, radius: 0.05 }));
} else {
  test("Gumbo as glb, stl and obj", { skip: "../shared/data/gumbo.json is absent" }, () => {});
}
