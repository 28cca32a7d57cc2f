// Path.builder: the methods of a canvas context, compared with the commands of SVG path data and with d3.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Path } from "casteljau";

const { PI } = Math;

/** What is drawn on a builder. @param {(builder: import("casteljau").PathBuilder) => void} draw */
function built(draw) {
  const builder = Path.builder();
  draw(builder);
  return builder.build();
}

test("commands are those of path data", () => {
  const path = built((b) => {
    b.moveTo(1, 2);
    b.lineTo(3, 4);
    b.quadraticCurveTo(5, 6, 7, 8);
    b.bezierCurveTo(9, 10, 11, 12, 13, 14);
    b.closePath();
    b.lineTo(20, 20);
  });
  assert.equal(path.toSVG(), "M1,2 L3,4 Q5,6 7,8 C9,10 11,12 13,14 Z M1,2 L20,20");
});

test("without a subpath, a command starts one at its first point", () => {
  assert.equal(built((b) => b.lineTo(1, 1)).toSVG(), "");
  assert.equal(built((b) => b.quadraticCurveTo(1, 1, 2, 0)).toSVG(), "M1,1 Q1,1 2,0");
  assert.equal(built((b) => b.bezierCurveTo(1, 1, 2, 0, 3, 0)).toSVG(), "M1,1 C1,1 2,0 3,0");
  assert.equal(built((b) => b.closePath()).subpathCount, 0);
});

test("a builder is empty after build and can be used again", () => {
  const builder = Path.builder();
  builder.rect(0, 0, 2, 1);
  assert.equal(builder.build().toSVG(), "M0,0 L2,0 L2,1 L0,1 Z");
  assert.equal(builder.build().subpathCount, 0);
  builder.lineTo(1, 1);
  builder.lineTo(2, 2);
  assert.equal(builder.build().toSVG(), "M1,1 L2,2");
});

test("arcs: direction, full turns, and a line to the start", () => {
  const lengths = [
    [0, PI / 2, false, PI / 2],
    [0, PI / 2, true, 1.5 * PI],
    [0, 7, false, 2 * PI],
    [0, -7, true, 2 * PI],
    [0, -PI / 2, false, 1.5 * PI],
    [1, 1, false, 0],
  ];
  for (const [start, end, backwards, length] of lengths) {
    const path = built((b) => b.arc(5, 5, 1, Number(start), Number(end), Boolean(backwards)));
    assert.ok(Math.abs(path.length() - Number(length)) < 1e-4, `${start} ${end} ${backwards}: ${path.length()}`);
  }
  const quarter = built((b) => b.arc(0, 0, 2, 0, PI / 2));
  assert.deepEqual([quarter.subpaths[0].eval(0), quarter.subpaths[0].eval(9)].length, 2);
  assert.equal(quarter.toSVG().split(" ").at(-1), "0,2");
  assert.ok(quarter.area() > 0, "a growing angle");
  const after = built((b) => {
    b.moveTo(0, 0);
    b.arc(10, 0, 1, 0, PI / 2);
  });
  assert.ok(after.toSVG().startsWith("M0,0 L11,0 A"));
  assert.equal(built((b) => b.arc(5, 5, 0, 0, 1)).length(), 0);
});

test("an ellipse is that of Path.ellipse", () => {
  const path = built((b) => {
    b.ellipse(1, 2, 4, 3, 0.5, 0, 2 * PI);
    b.closePath();
  });
  assert.ok(path.equals(Path.ellipse([1, 2], 4, 3, 0.5), 1e-12));
  const fine = Path.builder({ tolerance: 1e-12 });
  fine.arc(0, 0, 1, 0, 2 * PI);
  assert.ok(Math.abs(fine.build().length() - 2 * PI) < 1e-10);
});

test("arcTo is tangent to both lines", () => {
  const path = built((b) => {
    b.moveTo(0, 0);
    b.arcTo(10, 0, 10, 10, 4);
    b.lineTo(10, 10);
  });
  const [first, ...rest] = path.subpaths[0].segments();
  assert.deepEqual(first.eval(1), { x: 6, y: 0 });
  for (const arc of rest.slice(0, -1)) {
    for (const t of [0, 0.3, 1]) {
      const { x, y } = arc.eval(t);
      assert.ok(Math.abs(Math.hypot(x - 6, y - 4) - 4) < 1e-4);
    }
  }
  const lines = (x2, y2, radius) =>
    built((b) => {
      b.moveTo(0, 0);
      b.arcTo(5, 0, x2, y2, radius);
    }).toSVG();
  assert.equal(lines(9, 0, 1), "M0,0 L5,0", "one line");
  assert.equal(lines(5, 0, 1), "M0,0 L5,0", "two equal points");
  assert.equal(lines(5, 5, 0), "M0,0 L5,0", "no radius");
});

test("roundRect: radii in the order of CSS, reduced where they do not fit, and negative sizes", () => {
  const area = (...args) => built((b) => b.roundRect(.../** @type {[number, number, number, number]} */ (args))).area();
  const missing = (r) => (1 - PI / 4) * r * r;
  assert.equal(area(0, 0, 4, 3), 12);
  assert.ok(Math.abs(area(0, 0, 10, 10, 2) - (100 - 4 * missing(2))) < 1e-3);
  assert.ok(Math.abs(area(0, 0, 10, 10, [1, 2, 3]) - (100 - missing(1) - 2 * missing(2) - missing(3))) < 1e-3);
  assert.ok(Math.abs(area(0, 0, 10, 4, 100) - (40 - 4 * missing(2))) < 1e-3);
  assert.equal(area(0, 0, 0, 4, 1), 0);
  assert.ok(area(10, 0, -10, 10, 2) < 0, "the direction of a negative size");
  const corner = built((b) => b.roundRect(10, 10, -10, -10, [4, 0, 0, 0]));
  assert.ok(!corner.contains([9.9, 9.9]) && corner.contains([0.1, 0.1]));
  const next = built((b) => {
    b.rect(1, 2, 3, 4);
    b.lineTo(9, 9);
  });
  assert.ok(next.toSVG().endsWith("M1,2 L9,9"));
});

test("errors", () => {
  const refused = (act, message) => assert.throws(() => built(act), { message });
  refused((b) => b.moveTo(NaN, 1), "x: expected a finite number, got NaN");
  refused((b) => b.lineTo("1", 1), 'x: expected a number, got "1"');
  refused((b) => b.arc(0, 0, -1, 0, 1), "radiusX: expected a number from 0, got -1");
  refused((b) => b.arc(0, 0, 1, 0, 1, 2), "counterclockwise: expected true or false, got 2");
  refused((b) => b.arcTo(0, 0, 1, 1, -1), "radius: expected a number from 0, got -1");
  refused((b) => b.roundRect(0, 0, 1, 1, [1, 2, 3, 4, 5]), "radii: expected 1 to 4 numbers, got 5");
  refused((b) => b.roundRect(0, 0, 1, 1, -1), "radii: expected numbers from 0, got -1");
  refused((b) => b.moveTo(1e200, 0), "builder: expected coordinates from -2^500 to 2^500 (3.27e150), got 1e+200 0");
});

test("path data: what toPathData gives comes back, and CSS has the same numbers", () => {
  const path = Path.fromSVG("M0 0H4Q6 2 4 4C3 5 1 5 0 4ZM9 9L8 7");
  const data = path.toPathData();
  assert.equal(data.map(({ type }) => type).join(""), "MLQCZML");
  assert.ok(Path.fromPathData(data).equals(path));
  const relative = Path.fromPathData([
    { type: "m", values: [1, 1] },
    { type: "h", values: new Float32Array([3]) },
    { type: "a", values: [2, 2, 0, 0, 1, 2, 2] },
    { type: "z", values: [] },
  ]);
  assert.ok(relative.equals(Path.fromSVG("m1 1h3a2 2 0 0 1 2 2z")));
  const css =
    "shape(from 0px 0px, line to 4px 0px, curve to 4px 4px with 6px 2px, curve to 0px 4px with 3px 5px / 1px 5px";
  assert.equal(path.toCSS(), `${css}, close, move to 9px 9px, line to 8px 7px)`);
  assert.equal(
    Path.fromSVG("M0.25 0H4Z").toCSS({ precision: 1, fillRule: "evenodd" }),
    "shape(evenodd from .3px 0px, line to 4px 0px, close)",
  );
  assert.equal(new Path([]).toCSS(), "none");
  assert.equal(Path.from(new Curve([0, 0, 1, 2, 2, 0, 3, 2, 4, 0])).toPathData()[1].type, "C");
  const refused = (segments, message) => assert.throws(() => Path.fromPathData(segments), { message });
  refused("M", 'segments: expected an array of {type, values}, got "M"');
  refused([null], "segments[0].type: expected a command of path data, got undefined");
  refused(
    [
      { type: "M", values: [0, 0] },
      { type: "X", values: [] },
    ],
    'segments[1].type: expected a command of path data, got "X"',
  );
  refused([{ type: "M", values: [0, NaN] }], "segments[0].values[1]: expected a finite number, got NaN");
});

test("lengthAt is the inverse of timeAtLength", () => {
  const path = Path.fromSVG("M0 0H4M0 1Q3 4 6 1T12 1");
  for (const s of [0, 1, 4, 6.5, path.length()]) {
    const time = path.timeAtLength(s);
    assert.ok(time && Math.abs(path.lengthAt(time) - s) < 1e-9, `${s}`);
  }
  assert.equal(path.lengthAt({ subpath: 1, t: -3 }), 4);
  assert.equal(path.lengthAt({ subpath: 0, t: 9 }), 4);
});

test("union, intersect and exclude of more than two paths, with options at last", () => {
  const disks = [0, 1, 2].map((x) => Path.circle([x, 0], 1));
  for (const operation of /** @type {const} */ (["union", "intersect", "exclude"])) {
    const [a, b, c] = disks;
    assert.ok(a[operation](b, c).equals(Path.combine(disks, operation)), operation);
    const options = /** @type {const} */ ({ fillRule: "evenodd" });
    assert.ok(a[operation](b, c, options).equals(Path.combine(disks, operation, options)), operation);
    assert.ok(a[operation](b, undefined).equals(Path.combine([a, b], operation)), operation);
  }
  const [a, b, c] = disks;
  const surplus = /** @type {any} */ (c);
  assert.throws(() => a.subtract(b, surplus), {
    message: "options: expected an object, got a Path; did you mean Path.combine?",
  });
  assert.throws(() => a.union(b, surplus.subpaths[0], c), { message: "paths[1]: expected a Path, got a Spline" });
  assert.throws(() => new Path(/** @type {any} */ ("M0 0")), { message: /did you mean Path.fromSVG\?$/ });
  assert.throws(() => a.stroke(1, /** @type {any} */ ({ lineJoin: "round" })), {
    message: "lineJoin: unknown option; did you mean join?",
  });
});
