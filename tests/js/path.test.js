// Paths. The table of path data, good and bad, is read by tests/path/table.rs, too.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { inspect } from "node:util";
import { Curve, Path, Spline } from "casteljau";
import { hash, pathText, Rng } from "./random-path-data.js";
import { near, pointsOf, recorder, refused, SEVEN, SPACE, untyped } from "./reference.js";

const RING = "M0 0H4V4H0Z M1 1V3H3V1Z";
const TRIANGLE = new Spline([0, 0, 1, 0, 0, 1], { degree: 1, closed: true });
const HIGH = new Curve([0, 0, 1, 9, 8, -9, 4, 7, 3, -5, 9, 2]);
const WRONG_POINTS = pointsOf("NaN,0 0,Infinity 1,2,3");

const table = JSON.parse(readFileSync(new URL("../texts/svg.json", import.meta.url), "utf8"));

const bits = (numbers) => new BigUint64Array(Float64Array.from(numbers).buffer);

/** The path, and the error's message and offset if there was one. */
function read(d) {
  try {
    return { path: Path.fromSVG(d) };
  } catch (/** @type {any} */ error) {
    assert.equal(error.constructor, RangeError, `${error}`);
    assert.ok(error.path instanceof Path);
    return { path: error.path, error: error.message, offset: error.offset };
  }
}

for (const { name, d, svg, subpaths, error, offset, ...brief } of table) {
  test(`path data: ${name}`, () => {
    const got = read(d);
    assert.deepEqual([got.error, got.offset], [error, offset]);
    const text = got.path.toSVG();
    if (svg !== undefined) assert.equal(text, svg);
    for (const digits of [0, 2, 5])
      if (`brief${digits}` in brief) assert.equal(got.path.toSVG({ precision: digits }), brief[`brief${digits}`]);
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

/** Whether the path that is read from a text is the one that was written: arcs are read up to rounding. */
function isSame(read, path, text) {
  const size = Math.max(0, ...path.toJSON().subpaths.flatMap(({ points }) => points.flat().map(Math.abs)));
  return read.equals(path, text.includes("A") ? 1e-13 * size : 0);
}

test("both doors read and write the same: 20,000 texts, one in eight wrong", () => {
  const rng = new Rng(1);
  let state = 0x811c9dc5;
  for (let k = 0; k < 20_000; k++) {
    const d = pathText(rng);
    const { path, error = "" } = read(d);
    const all = path.toSVG();
    for (const text of [error, all, path.toSVG({ precision: k % 8 })]) state = hash(state, text);
    assert.ok(isSame(Path.fromSVG(all), path, all), d);
  }
  assert.equal(state, 149_936_219); // as in tests/path/svg.rs
});

test("equal arcs of one ellipse are written as one", () => {
  const commands = (path) => path.toSVG().replace(/[^A-Z]/g, "");
  const square = Path.rect([0, 0], 10, 10);
  const rounded = square.roundCorners(2);
  assert.ok(rounded.subpaths[0].segmentCount > 20, "fine cubics");
  const text = "M2 0H8A2 2 0 0 1 10 2V8A2 2 0 0 1 8 10H2A2 2 0 0 1 0 8V2A2 2 0 0 1 2 0Z";
  assert.equal(rounded.toSVG({ precision: 3 }), text);
  assert.equal(commands(rounded), "MLALALALAZ");
  // Both corners at an end of a stadium are one half circle.
  assert.equal(commands(square.roundCorners(5)).replaceAll(/[^A]/g, "").length, 2);
  const circle = Path.circle([3, -4], 5, { tolerance: 1e-9 });
  assert.equal(circle.toSVG(), "M8,-4 A5,5 0 0 1 -2,-4 A5,5 0 0 1 8,-4 Z");
  const thirds = Path.fromSVG("M5 0A5 5 0 0 1 4 3A5 5 0 0 1 1.4 4.8A5 5 0 0 1-1.76 4.68");
  assert.equal(thirds.toSVG(), "M5,0 A5,5 0 0 1 -1.76,4.68");
});

test("arcs of finer cubics are read again with the same tolerance", () => {
  const rng = new Rng(5);
  let [state, missed] = [0x811c9dc5, 0];
  for (let k = 0; k < 2_000; k++) {
    const [rx, ry, degrees, large, sweep, x] = [40, 40, 180, 2, 2, 80].map((count) => rng.below(count));
    const d = `M1 2A${rx + 9} ${ry + 9} ${degrees} ${large} ${sweep} ${x + 2} 7`;
    const tolerance = Number(`1e-${5 + rng.below(5)}`);
    const path = Path.fromSVG(d, { tolerance });
    const text = path.toSVG();
    assert.ok(isSame(Path.fromSVG(text, { tolerance }), path, text), `${d} ${text}`);
    if (!/^M[^A-Z]* A[^A-Z]*$/.test(text)) missed++;
    for (const written of [text, path.toSVG({ precision: k % 8 })]) state = hash(state, written);
  }
  assert.equal(missed, 0);
  assert.equal(state, 1_608_952_176); // as in tests/path/svg.rs
});

test("numbers of every size come back to the bit", () => {
  const rng = new Rng(2);
  const view = new DataView(new ArrayBuffer(8));
  const wild = () => {
    view.setUint32(0, rng.next());
    view.setUint32(4, rng.next());
    if (rng.below(4) === 0) return [0, -0, 1, 5e-324, 2 ** 500][rng.below(5)];
    return Math.abs(view.getFloat64(0)) <= 2 ** 500 ? view.getFloat64(0) : 0.5;
  };
  for (let k = 0; k < 5_000; k++) {
    const closed = rng.below(2) === 0;
    const degree = 1 + rng.below(3);
    const count = degree * (1 + rng.below(4)) + (closed ? 0 : 1);
    const spline = new Spline(Float64Array.from({ length: 2 * count }, wild), { degree, closed });
    const [again] = Path.fromSVG(spline.toSVG()).subpaths;
    assert.deepEqual([again.closed, again.degrees], [spline.closed, spline.degrees]);
    assert.deepEqual(bits(again.controlPoints()), bits(spline.controlPoints()));
  }
});

test("garbage", () => {
  const alphabet = "MmLlHhVvCcSsQqTtAaZz0123456789.,-+eE \t\n\r\fxé😀\0\ud800";
  const rng = new Rng(4);
  for (let k = 0; k < 20_000; k++) {
    const start = rng.below(4) ? "M1 2" : "";
    const d = start + Array.from({ length: rng.below(60) }, () => alphabet[rng.below(alphabet.length)]).join("");
    const { path, offset = 0 } = read(d);
    assert.ok(offset <= d.length && isSame(Path.fromSVG(path.toSVG()), path, path.toSVG()), d);
  }
});

test("ten megabytes at once; two of anything, good and bad", () => {
  const large = (piece, size = 2e6) => piece.repeat(size / piece.length);
  const icon = "m12.5 3.25c-1.5.5-3 1.25-4 2.75s-1 3.5.25 5 4 1.5 5.5 0h2l3-1.5q1-2 0-3.5t-2-1zm2 1a2 3 15 012.5 1.5z";
  const path = Path.fromSVG(`M0 0${large(icon, 1e7)}`);
  assert.ok(path.subpathCount > 100_000 && path.length() > 1e6);
  for (const good of ["z", "m0 0", "M0 0z", "0 0 ", "a0 0 0 0 0 0 0"])
    assert.ok(Path.fromSVG(`M0 0 ${large(good)}`).subpathCount >= 0);
  for (const bad of ["9", "e", "-", ".", ",", "M", "\u00a0", "1.", "((", "😀"])
    assert.ok(read(`M0 0L${large(bad)}`).error.length < 400, bad);
});

test("curves and splines as path data", () => {
  assert.equal(new Curve([0, 0, 1, 1, 2, 0]).toSVG(), "M0,0 Q1,1 2,0");
  assert.equal(new Curve([0, 0, 0.25, 1.5, 2, 0]).toSVG({ precision: 1 }), "M0 0Q.3 1.5 2 0");
  assert.equal(TRIANGLE.toSVG(), "M0,0 L1,0 L0,1 Z");
  refused(() => new Curve(SPACE).toSVG(), TypeError, /^toSVG: .*2D.*3D/);
  refused(() => new Spline(SPACE).toSVG(), TypeError, /^toSVG: .*2D.*3D/);
  refused(() => new Curve(SEVEN).toSVG({ tolerance: 0 }), RangeError, /^tolerance: /);
});

test("sizes", () => {
  const ring = Path.fromSVG(RING);
  assert.deepEqual([ring.area(), ring.length()], [12, 24]);
  near(ring.moments(), { area: 12, x: 24, y: 24, xx: 68, xy: 48, yy: 68 });
  const empty = new Path([]);
  assert.deepEqual([empty.area(), empty.length(), empty.moments().xx], [0, 0, 0]);
  near(Path.fromSVG("M10 5A5 5 0 1 1 0 5 5 5 0 0 1 10 5z").length(), 10 * Math.PI, 1e-5);
  refused(() => ring.length(-1), RangeError, /^tolerance: /);
});

test("what is inside", () => {
  const ring = Path.fromSVG(RING);
  const windings = pointsOf("0.5,2 2,2 5,2").map((p) => ring.windingNumber(p));
  assert.deepEqual(windings, [1, 0, 0]);
  assert.ok(ring.contains({ x: 0.5, y: 2 }) && !ring.contains([2, 2]));
  const twice = Path.fromSVG("M0 0H4V4H0Z M1 1H3V3H1Z");
  assert.equal(twice.windingNumber([2, 2]), 2);
  const evenOdd = pointsOf("2,2 0.5,2").map((p) => twice.contains(p, { fillRule: "evenodd" }));
  assert.deepEqual([twice.contains([2, 2]), ...evenOdd], [true, false, true]);
});

test("a refusal after a part of the answer was written says why, and the next calls work", () => {
  const arch = (x) => new Path([new Spline([0, 0, 0, x, x, x, x, 0], { degree: 3, dimension: 2 })]);
  const several = new Path([1, 1, 1, 1].flatMap((x) => [...arch(x).subpaths]));
  const fine = several.flatten(1e-12)[0].ts.length; // the core's memory now is large enough for what follows
  assert.ok(fine > 400_000);
  const both = new Path([...arch(1).subpaths, ...arch(1e6).subpaths]);
  const message = /^tolerance: expected at least 4\.6\d*e-10 \(4 ulps of the largest coordinate\), got 1e-12$/;
  refused(() => both.flatten(1e-12), RangeError, message);
  assert.deepEqual(arch(1).subpaths[0].eval(0.5), { x: 0.5, y: 0.75 });
  assert.equal(several.flatten(1e-12)[3].ts.length, fine);
});

test("bounds, flattening, empty paths", () => {
  const path = Path.fromSVG("M100,200 C100,100 250,100 250,200 S400,300 400,200");
  assert.deepEqual(path.bounds(), { min: { x: 100, y: 125 }, max: { x: 400, y: 275 } });
  assert.deepEqual(path.controlBounds(), { min: { x: 100, y: 100 }, max: { x: 400, y: 300 } });
  const [line] = path.flatten(0.1);
  assert.deepEqual(line, { ...path.subpaths[0].flatten(0.1), closed: path.subpaths[0].closed });
  assert.deepEqual(
    Path.fromSVG("M0 0H1M0 0H1V1Z")
      .flatten(1)
      .map(({ closed }) => closed),
    [false, true],
  );
  assert.equal(Path.fromSVG(RING).flatten(1).length, 2);
  const empty = new Path([]);
  const answers = [empty.bounds(), empty.controlBounds(), empty.flatten(1), empty.toSVG(), empty.subpaths];
  assert.deepEqual(answers, [null, null, [], "", []]);
  assert.equal(empty.windingNumber([0, 0]), 0);
  assert.ok(empty.equals(Path.fromSVG("")));
});

test("the nearest point", () => {
  const ring = Path.fromSVG(RING);
  assert.deepEqual(ring.nearest([2, 2.5]), { subpath: 1, t: 1.5, point: { x: 2, y: 3 }, distance: 0.5 });
  assert.deepEqual(ring.nearest({ x: 9, y: 4 }), { subpath: 0, t: 2, point: { x: 4, y: 4 }, distance: 5 });
  assert.equal(new Path([]).nearest([0, 0]), null);
  const path = new Path([new Spline(SEVEN), new Curve([0, 9, 1, 8, 5, 7])]);
  const { subpath, t, point } = untyped(path.nearest([3, -1]));
  near(path.subpaths[subpath].eval(t), point);
  for (const bad of WRONG_POINTS) refused(() => path.nearest(bad), RangeError, /^point/);
});

test("by length", () => {
  const ring = Path.fromSVG(RING);
  const times = [6, 17, -1, 99].map((s) => Object.values(untyped(ring.timeAtLength(s))));
  assert.deepEqual(times, pointsOf("0,1.5 1,0.5 0,0 1,4"));
  const even = ring.equidistantTimes(6).map(({ subpath, t }) => [subpath, t]);
  assert.deepEqual(even, pointsOf("0,0 0,1 0,2 0,3 1,0 1,2 1,4"));
  const empty = new Path([]);
  assert.deepEqual([empty.timeAtLength(1), empty.equidistantTimes(3)], [null, []]);
  for (const bad of [NaN, Infinity]) refused(() => ring.timeAtLength(bad), RangeError, /^s: /);
  for (const bad of [0, -1, 0.5, NaN]) refused(() => ring.equidistantTimes(bad), RangeError, /^segments: /);
});

test("paths of splines and curves, and back", () => {
  const spline = new Spline(SEVEN);
  const path = new Path([spline, TRIANGLE, new Curve([0, 0, 1, 1, 2, 0])]);
  assert.equal(path.subpathCount, 3);
  assert.ok(path.subpaths[0].equals(spline) && path.subpaths[1].equals(TRIANGLE));
  assert.equal(path.toSVG(), "M0,0 C0,2 2,2 2,0 C2,-4 4,-2 4,0 M0,0 L1,0 L0,1 Z M0,0 Q1,1 2,0");
  assert.ok(Path.fromJSON(JSON.parse(JSON.stringify(path))).equals(path));
  assert.ok(path.reverse().reverse().equals(path));
  assert.equal(path.reverse().toSVG(), "M4,0 C4,-2 2,-4 2,0 C2,2 0,2 0,0 M0,0 L0,1 L1,0 Z M2,0 Q1,1 0,0");
  assert.equal(
    path.transform([2, 0, 0, 1, 10, -1]).toSVG(),
    "M10,-1 C10,1 14,1 14,-1 C14,-5 18,-3 18,-1 M10,-1 L12,-1 L10,0 Z M10,-1 Q12,0 14,-1",
  );
  assert.ok(!path.equals(path.reverse()) && path.equals(path.transform([1, 0, 0, 1, 0, 1e-9]), 1e-8));
  assert.throws(() => untyped(path.subpaths).push(spline), TypeError);
});

test("drawing, as its splines are drawn; higher degrees become cubics", () => {
  const shapes = [new Spline(SEVEN), TRIANGLE, HIGH];
  for (const options of [undefined, { tolerance: 0.01 }]) {
    const [whole, parts] = [recorder(), recorder()];
    new Path(shapes).trace(whole, options);
    for (const shape of shapes) shape.trace(parts, options);
    assert.deepEqual(whole.calls, parts.calls);
  }
  const target = recorder();
  HIGH.trace(target, { tolerance: 0.01 });
  const path = new Path([HIGH]);
  const [coarse, middle, fine] = [1, 0.01, 1e-6].map((tolerance) => path.toSVG({ tolerance }));
  assert.ok(coarse.length < fine.length && /^M0,0( C\S+ \S+ \S+)+$/.test(fine), fine);
  const drawn = target.calls.flatMap(([, ...numbers]) => numbers);
  near(Path.fromSVG(middle).subpaths[0].controlPoints(), drawn);
});

test("Node shows a path as SVG path data", () => {
  assert.equal(inspect(Path.fromSVG("M0 0H4Q5 6 7 8Z")), "Path M0,0 L4,0 Q5,6 7,8 Z");
  assert.equal(inspect({ path: new Path([]) }), "{ path: Path (empty) }");
  const long = inspect(Path.fromSVG(`M0 0${"L1 1".repeat(1000)}`));
  assert.ok(long.length < 1100 && long.endsWith("…"));
});

test("shapes are written as arcs, unless they are not wanted", () => {
  const circle = Path.circle([3, -4], 5);
  assert.equal(circle.toSVG(), "M8,-4 A5,5 0 0 1 -2,-4 A5,5 0 0 1 8,-4 Z");
  assert.equal(circle.toSVG({ precision: 1 }), "M8-4A5 5 0 0 1-2-4 5 5 0 0 1 8-4Z");
  assert.ok(Path.fromSVG(circle.toSVG({ arcs: false })).equals(circle));
  assert.equal(
    Path.rect([0, 0], 9, 6, { radii: 2 }).toSVG({ precision: 0 }),
    "M2 0H7A2 2 0 0 1 9 2V4A2 2 0 0 1 7 6H2A2 2 0 0 1 0 4V2A2 2 0 0 1 2 0Z",
  );
  assert.match(Path.ellipse([0, 0], 5, 2, 0.3).toSVG({ precision: 2 }), /^M\S+ \S+A5 2 17\.18873 0 1/);
  assert.match(circle.subpaths[0].toSVG(), /^M8,-4 C/);
  refused(() => circle.toSVG(untyped({ arcs: "yes" })), TypeError, /^arcs: expected true or false, got "yes"/);
});
