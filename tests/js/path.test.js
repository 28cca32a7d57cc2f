// Paths. The table of path data, good and bad, is read by tests/path/table.rs, too.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Curve, Path, Spline } from "casteljau";
import { near, recorder, refused, SEVEN, SPACE } from "./reference.js";

const table = JSON.parse(readFileSync(new URL("../texts/svg.json", import.meta.url), "utf8"));

const bits = (numbers) => new BigUint64Array(Float64Array.from(numbers).buffer);

/** The path, and the error's message and offset if there was one. */
function read(d) {
  try {
    return { path: Path.fromSVG(d) };
  } catch (error) {
    assert.ok(error instanceof RangeError && error.path instanceof Path, `${error}`);
    return { path: error.path, error: error.message, offset: error.offset };
  }
}

for (const { name, d, svg, subpaths, error, offset, ...brief } of table) {
  test(`path data: ${name}`, () => {
    const got = read(d);
    assert.deepEqual([got.error, got.offset], [error, offset]);
    const text = got.path.toSVG();
    if (svg !== undefined) assert.equal(text, svg);
    for (const digits of [0, 2, 5]) if (`brief${digits}` in brief) assert.equal(got.path.toSVG({ precision: digits }), brief[`brief${digits}`]);
    const again = Path.fromSVG(text);
    assert.ok(again.equals(got.path));
    assert.equal(again.toSVG(), text);
    if (!subpaths) return;
    assert.equal(got.path.subpaths.length, subpaths.length);
    got.path.subpaths.forEach((spline, k) => {
      const [closed, degrees, points] = subpaths[k];
      assert.deepEqual([spline.closed, spline.degrees], [closed, degrees]);
      assert.deepEqual(bits(spline.controlPoints()), bits(points));
    });
  });
}

const RING = "M0 0H4V4H0Z M1 1V3H3V1Z";

test("what is inside", () => {
  const ring = Path.fromSVG(RING);
  assert.deepEqual([[0.5, 2], [2, 2], [5, 2]].map((p) => ring.winding(p)), [1, 0, 0]);
  assert.ok(ring.contains({ x: 0.5, y: 2 }) && !ring.contains([2, 2]));
  const twice = Path.fromSVG("M0 0H4V4H0Z M1 1H3V3H1Z");
  assert.equal(twice.winding([2, 2]), 2);
  assert.ok(twice.contains([2, 2]) && !twice.contains([2, 2], "evenodd") && twice.contains([0.5, 2], "evenodd"));
});

test("bounds, flattening, empty paths", () => {
  const path = Path.fromSVG("M100,200 C100,100 250,100 250,200 S400,300 400,200");
  assert.deepEqual(path.bounds(), { min: { x: 100, y: 125 }, max: { x: 400, y: 275 } });
  assert.deepEqual(path.controlBounds(), { min: { x: 100, y: 100 }, max: { x: 400, y: 300 } });
  const [line] = path.flatten(0.1);
  assert.deepEqual(line, path.subpaths[0].flatten(0.1));
  assert.equal(Path.fromSVG(RING).flatten(1).length, 2);
  const empty = new Path([]);
  assert.deepEqual([empty.bounds(), empty.controlBounds(), empty.flatten(1), empty.toSVG(), empty.subpaths], [null, null, [], "", []]);
  assert.equal(empty.winding([0, 0]), 0);
  assert.ok(empty.equals(Path.fromSVG("")));
});

test("paths of splines and curves, and back", () => {
  const spline = new Spline(SEVEN);
  const ring = new Spline([[0, 0], [1, 0], [0, 1]], { degree: 1, closed: true });
  const curve = new Curve([[0, 0], [1, 1], [2, 0]]);
  const path = new Path([spline, ring, curve]);
  assert.equal(path.subpathCount, 3);
  assert.ok(path.subpaths[0].equals(spline) && path.subpaths[1].equals(ring));
  assert.equal(path.toSVG(), "M0,0 C0,2 2,2 2,0 C2,-4 4,-2 4,0 M0,0 L1,0 L0,1 Z M0,0 Q1,1 2,0");
  assert.ok(Path.fromJSON(JSON.parse(JSON.stringify(path))).equals(path));
  assert.ok(path.reverse().reverse().equals(path));
  assert.equal(path.reverse().toSVG(), "M4,0 C4,-2 2,-4 2,0 C2,2 0,2 0,0 M0,0 L0,1 L1,0 Z M2,0 Q1,1 0,0");
  assert.equal(path.transform([2, 0, 0, 1, 10, -1]).toSVG(), "M10,-1 C10,1 14,1 14,-1 C14,-5 18,-3 18,-1 M10,-1 L12,-1 L10,0 Z M10,-1 Q12,0 14,-1");
  assert.ok(!path.equals(path.reverse()) && path.equals(path.transform([1, 0, 0, 1, 0, 1e-9]), 1e-8));
  assert.throws(() => path.subpaths.push(spline), TypeError);
});

test("drawing, as its splines are drawn", () => {
  const shapes = [new Spline(SEVEN), new Spline([[0, 0], [1, 0], [0, 1]], { degree: 1, closed: true }), new Curve([[0, 0], [1, 9], [8, -9], [4, 7], [3, -5], [9, 2]])];
  for (const options of [undefined, { tolerance: 0.01 }]) {
    const [whole, parts] = [recorder(), recorder()];
    new Path(shapes).trace(whole, options);
    for (const shape of shapes) shape.trace(parts, options);
    assert.deepEqual(whole.calls, parts.calls);
  }
});

test("higher degrees become cubics", () => {
  const curve = new Curve([[0, 0], [1, 9], [8, -9], [4, 7], [3, -5], [9, 2]]);
  const target = recorder();
  curve.trace(target, { tolerance: 0.01 });
  const [coarse, fine] = [1, 1e-6].map((tolerance) => new Path([curve]).toSVG({ tolerance }));
  assert.ok(coarse.length < fine.length);
  near([...Path.fromSVG(new Path([curve]).toSVG({ tolerance: 0.01 })).subpaths[0].controlPoints()].slice(2), target.calls.slice(1).flatMap(([, ...p]) => p));
  assert.ok(/^M0,0( C\S+ \S+ \S+)+$/.test(fine), fine);
});

test("refusals", () => {
  for (const bad of [undefined, null, 5, {}, [], new Uint8Array(3)]) refused(() => Path.fromSVG(bad), TypeError, /^d: expected a string, got /);
  for (const bad of [undefined, null, 5, "M0 0", {}, new Spline(SEVEN)]) refused(() => new Path(bad), TypeError, /^splines: /);
  for (const bad of [undefined, null, 5, "M0 0", [[0, 0]], new Path([])]) refused(() => new Path([bad]), TypeError, /^splines\[0\]: /);
  refused(() => new Path([new Spline(SEVEN), new Spline(SPACE)]), TypeError, /^splines\[1\]: .*2D.*3D/);
  refused(() => new Path([,]), TypeError, /^splines\[0\]: /);
  for (const bad of [undefined, null, 5, [], {}, { subpaths: 5 }]) refused(() => Path.fromJSON(bad), TypeError, /^json: /);
  const path = Path.fromSVG(RING);
  for (const bad of [undefined, null, 5, "0 0"]) refused(() => path.contains(bad), TypeError, /^point: /);
  for (const bad of [[NaN, 0], [0, Infinity], [1, 2, 3]]) refused(() => path.winding(bad), RangeError, /^point/);
  refused(() => path.contains([0, 0], "odd"), RangeError, /^rule: /);
  for (const bad of [-1, 0.5, 101, NaN, Infinity]) refused(() => path.toSVG({ precision: bad }), RangeError, /^precision: /);
  refused(() => path.toSVG({ precision: "2" }), TypeError, /^precision: /);
  refused(() => path.toSVG(2), TypeError, /^options: /);
  for (const bad of [0, -1, 1e-20, NaN, Infinity]) {
    refused(() => path.toSVG({ tolerance: bad }), RangeError, /^tolerance: /);
    refused(() => path.trace(recorder(), { tolerance: bad }), RangeError, /^tolerance: /);
    refused(() => path.flatten(bad), RangeError, /^tolerance: /);
  }
  refused(() => path.trace({}), TypeError, /^target: /);
  refused(() => path.transform([1, 2]), RangeError, /^matrix: /);
  refused(() => path.equals(RING), TypeError, /^other: /);
  refused(() => path.equals(path, -1), RangeError, /^tolerance: /);
});
