// What Node shows of curves and splines, and that unused classes are still left out of bundles.
import assert from "node:assert/strict";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { inspect } from "node:util";
import { Curve, InkStroke, Path, Spline, Surface } from "casteljau";
import * as surfaces from "casteljau/surfaces";
import { build } from "esbuild";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");

test("console.log shows the points", () => {
  const curve = new Curve([0, 0, 1, 2.5, 2, 0]);
  assert.equal(inspect(curve), "Curve { points: [ [ 0, 0 ], [ 1, 2.5 ], [ 2, 0 ] ] }");
  const spline = new Spline([0, 0, 1, 1, 2, 0], { degree: 1, closed: true });
  const text = "Spline { points: [ [ 0, 0 ], [ 1, 1 ], [ 2, 0 ] ], degrees: [ 1, 1, 1 ], closed: true }";
  assert.equal(inspect(spline, { breakLength: Infinity }), text);
});

test("console.log shows the points inside of other values, down to the depth of the caller", () => {
  const line = new Curve([0, 0, 1, 1]);
  const shown = "Curve { points: [ [ 0, 0 ], [ 1, 1 ] ] }";
  assert.equal(inspect({ a: { b: line } }, { breakLength: Infinity, compact: true }), `{ a: { b: ${shown} } }`);
  assert.equal(inspect({ a: line }, { depth: 0 }), "{ a: [Curve] }");
  assert.deepEqual(Object.keys(line), []);
});

test("console.log shows what surfaces, meshes and other values are", () => {
  const oneLine = (value) => inspect(value, { breakLength: Infinity, compact: 10 });
  for (const Class of [Surface, surfaces.Surface]) {
    const teapot = Class.teapot();
    const count = teapot.vertices.length / 3;
    assert.equal(oneLine(teapot), `Surface { patches: 32, degrees: [ '3 × 3' ], vertices: ${count} }`);
    const quad = Class.fromJSON({
      vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0],
      patches: [[0, 1, 2, 3]],
      degrees: [[1, 1]],
    });
    assert.equal(oneLine(quad), "Surface { patches: 1, degrees: [ '1 × 1' ], vertices: 4 }");
    const points = "[ 0, 0, 0 ], [ 1, 0, 0 ], [ 0, 1, 0 ], [ 1, 1, 0 ]";
    assert.equal(oneLine(quad.patch(0)), `Patch { net: [ ${points} ], degreeU: 1, degreeV: 1 }`);
    assert.equal(oneLine(quad.grid({ segments: 2 })), "Mesh { vertices: 9, triangles: 8, patches: 1 }");
    assert.equal(inspect([[teapot]], { depth: 1 }), "[ [ [Surface] ] ]");
  }
  assert.equal(oneLine(Path.index([Path.rect([0, 0], 1, 1)])), "PathIndex { paths: 1 }");
  assert.equal(oneLine(new InkStroke({ size: 4 })), "InkStroke { spline: null }");
});

test("the text of paths, and of curves and splines in the plane, is their SVG path data", () => {
  const curve = new Curve([0, 0, 1, 2.5, 2, 0]);
  assert.equal(String(curve), "M0,0 Q1,2.5 2,0");
  assert.equal(`${new Spline([0, 0, 1, 1, 2, 0], { degree: 1, closed: true })}`, "M0,0 L1,1 L2,0 Z");
  assert.equal(String(Path.circle([0, 0], 1)), Path.circle([0, 0], 1).toSVG());
  assert.equal(`[${new Path([])}]`, "[]");
  assert.equal(
    String(
      new Curve([
        [0, 0, 0],
        [1, 1, 2],
      ]),
    ),
    '{"points":[[0,0,0],[1,1,2]]}',
  );
});

/** xtask/size.js checks its size. */
test("{ easing } is bundled without the classes of curves", async () => {
  const contents = `import { easing } from "./dist/index.js"; globalThis.used = easing;`;
  const options = /** @type {const} */ ({ bundle: true, minify: true, format: "esm", write: false });
  const { outputFiles } = await build({ stdin: { contents, resolveDir: root }, ...options });
  assert.doesNotMatch(outputFiles[0].text, /nodejs\.util\.inspect|WebAssembly/);
});
