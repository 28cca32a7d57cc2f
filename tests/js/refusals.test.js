// @ts-nocheck: these calls pass what the types refuse.
// Wrong arguments are refused: refusals.txt lists the arguments of all functions by their kinds, of which every wrong value is
// passed, and single calls with their messages. After every refusal the package works on.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, afterEach, test } from "node:test";
import { Curve, easing, Patch, Path, Spline, Surface } from "casteljau";
import { NurbsCurve, NurbsSurface, RationalCurve, RationalPatch, RationalSurface } from "casteljau/nurbs";
import { CUBIC, pointsOf, recorder, refused, SEVEN, SPACE } from "./reference.js";

const cubic = new Curve(CUBIC);
const space = new Curve(SPACE);
const quadratic = new Curve(CUBIC.slice(1));
const seven = new Spline(SEVEN);
const spaceSpline = new Spline([...SPACE, ...SPACE.slice(1)]);
const mixed = Spline.fromCurves([new Curve([0, 0, 1, 0]), new Curve([1, 0, 2, 0, 3, 1])]);
const conic = RationalCurve.conic([0, 0], [1, 1], [2, 0], 0.5);
const nurbs = NurbsCurve.circle([0, 0], 1);
const cylinder = NurbsSurface.cylinder([0, 0, 0], 1, 2);
const quarter = cylinder.patches()[0];
const weighted = cylinder.toSurface();
const line = new Spline([0, 0, 1, 0], { degree: 1 });
const ring = new Spline(CUBIC.slice(1), { closed: true });
const path = new Path([seven]);
const two = Path.fromSVG("M0 0H4V4H0Z M10 0H14");
const empty = new Path([]);
/** The square [0, 3] × [0, 3] at z = 2: control points on a lattice. */
const plane = new Patch(Array.from({ length: 16 }, (_, i) => [i % 4, i >> 2, 2]));
const surface = Surface.fromPatches([plane]);
const teapot = Surface.teapot();
const mesh = surface.grid({ segments: 1 });
const target = recorder();
const START = { subpath: 0, t: 0 };
const view = { pixels: 1, viewProjection: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], viewport: [640, 480] };

const works = () => {
  assert.deepEqual(new Curve(CUBIC).eval(0.5), { x: 4, y: 6 });
  assert.deepEqual(
    [cubic.eval(0.5), seven.eval(1), plane.eval(0, 0)],
    [
      { x: 4, y: 6 },
      { x: 2, y: 0 },
      { x: 0, y: 0, z: 2 },
    ],
  );
  assert.deepEqual([...new Curve(SPACE).sample(1)], [...SPACE[0], ...SPACE[3]]);
  assert.equal(teapot.patchCount, 32);
};
afterEach(works);
after(works);

/** An array whose buffer was given away. */
function detached(length = 8) {
  const array = new Float64Array(length).fill(1);
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
}

const NOT_NUMBERS = [null, "1", "", true, {}, [], [0.5], 1n, Symbol("t"), () => 1, new Date(0), { valueOf: () => 1 }];
const NOT_FINITE = [NaN, Infinity, -Infinity];
const whole = (range) => [RangeError, [1.5, NaN, Infinity], `expected a whole number ${range}.*got `];

/** The wrong values of each kind of argument: the class of the error, the values, the message. */
const KINDS = {
  number: [
    [TypeError, [undefined, ...NOT_NUMBERS], "expected a number, got "],
    [RangeError, NOT_FINITE, "expected a finite number, got "],
  ],
  /** A parameter or a list of them. */
  times: [
    [TypeError, [undefined, ...NOT_NUMBERS.filter((value) => !Array.isArray(value))], "expected a number, got "],
    [RangeError, NOT_FINITE, "expected a finite number, got "],
  ],
  finite: [[RangeError, NOT_FINITE, "expected a finite number, got "]],
  canvas: [[TypeError, [undefined, null, 5, {}], "expected "]],
  tolerance: [
    [TypeError, [undefined, ...NOT_NUMBERS], "expected a number, got "],
    [RangeError, NOT_FINITE, "expected a finite number, got "],
    [RangeError, [0, -0, -1], "expected a number above 0, got "],
    [RangeError, [1e-30], "expected at least \\S+ .*got 1e-30$"],
  ],
  /** A tolerance that may be left out. */
  optionalTolerance: [
    [TypeError, NOT_NUMBERS, "expected a number, got "],
    [RangeError, NOT_FINITE, "expected a finite number, got "],
    [RangeError, [0, -1], "expected a number above 0, got "],
  ],
  /** How far values may be from each other to be equal; 0 is allowed. */
  slack: [[RangeError, [-1, ...NOT_FINITE], "expected "]],
  length: [
    [TypeError, ["1"], "expected a number"],
    [RangeError, [-1, ...NOT_FINITE], "expected "],
  ],
  count: [
    [TypeError, [undefined, ...NOT_NUMBERS], "expected a whole number"],
    [RangeError, [0, -1], "expected a whole number from 1.*got "],
    whole("from 1"),
  ],
  degree: [
    [TypeError, ["3", null, 3n], "expected "],
    [RangeError, [-1, 65], "expected a whole number from [01] to 64, got "],
    whole("from [01] to 64"),
  ],
  point: [
    [TypeError, [undefined, null, "0,0", 5], "expected a point"],
    [TypeError, [{ x: 0 }], "expected a number, got undefined$", "\\.y"],
    [TypeError, [{ x: "1", y: 2 }], "expected a number, got ", "\\.x"],
    [RangeError, [[0, 0, 0]], "expected 2 coordinates, got 3$"],
    [RangeError, [[0, Infinity]], "expected a finite number, got Infinity$", "\\[1\\]"],
  ],
  spacePoint: [
    [TypeError, [undefined, null, "0,0", 7], "expected a point"],
    [TypeError, [{ x: 0, y: 1 }], "expected a number, got undefined$", "\\.z"],
    [RangeError, [[0, 1]], "expected 3 coordinates, got 2$"],
    [RangeError, [[0, NaN, 0]], "expected a finite number, got NaN$", "\\[1\\]"],
  ],
  points: [
    [
      TypeError,
      [
        undefined,
        null,
        5,
        "0,0 1,1",
        {},
        { length: 2, 0: [0, 0], 1: [1, 1] },
        new DataView(new ArrayBuffer(32)),
        new Map(),
        1n,
        () => CUBIC,
      ],
      "expected an array of points, got ",
    ],
    [
      TypeError,
      [
        [[0, 0], null, [1, 1], [2, 2]],
        [[0, 0], "x", [1, 1], [2, 2]],
        [[0, 0], 5, [1, 1], [2, 2]],
      ],
      "expected a point .*got ",
      "\\[1\\]",
    ],
    [
      TypeError,
      NOT_NUMBERS.map((bad) => [CUBIC[0], [1, bad], ...CUBIC.slice(2)]),
      "expected a number, got ",
      "\\[1\\]\\[1\\]",
    ],
    [
      RangeError,
      NOT_FINITE.map((bad) => [CUBIC[0], [bad, 1], ...CUBIC.slice(2)]),
      "expected a finite number, got ",
      "\\[1\\]\\[0\\]",
    ],
    [RangeError, [[CUBIC[0], SPACE[1], ...CUBIC.slice(2)]], "expected 2 coordinates, got 3$", "\\[1\\]"],
  ],
  parameters: [
    [TypeError, [undefined, null, 0.5, "0.5", {}], "expected an array of numbers, got "],
    [TypeError, [[0, "1"], [0, undefined], BigInt64Array.of(0n, 0n)], "expected a number, got ", "\\[[01]\\]"],
    [RangeError, [[0, NaN]], "expected a finite number, got NaN$", "\\[1\\]"],
  ],
  into: [
    [TypeError, [null, [], new Float32Array(99), new ArrayBuffer(99), "into", 5], "expected a Float64Array, got "],
    [RangeError, [new Float64Array(3)], "expected at least \\d+ numbers, got 3$"],
    [RangeError, [detached()], "expected at least \\d+ numbers, got 0$"],
  ],
  matrix: [
    [TypeError, [undefined, null, 5, {}], "expected "],
    [RangeError, [[], [1, 0, 0, 1, 0], new Array(9).fill(0), detached(6)], "expected 6 or 16 numbers, got "],
    [RangeError, [[1, 0, 0, 1, NaN, 0]], "expected a finite number, got NaN$", "\\[4\\]"],
    [RangeError, [[1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]], "expected an affine map .*got 1 0 0 1$"],
  ],
  basis: [
    [TypeError, [undefined, null, 5, {}], "expected "],
    [RangeError, ["spline"], 'expected one of "bezier", .*got "spline"; did you mean "b-spline"\\?$'],
    [
      RangeError,
      [[], new Array(15).fill(1), new Float64Array(17), detached(16), pointsOf("1,2 3,4")],
      "expected 16 numbers",
    ],
    [RangeError, [new Array(16).fill(NaN)], "expected a finite number", "\\[0\\]"],
    [TypeError, [new Array(16).fill("1")], "expected a number", "\\[0\\]"],
  ],
  location: [
    [TypeError, [undefined, null, 0.5, "0"], "expected an object \\{subpath, t\\}, got"],
    [TypeError, [{ t: 0 }], "expected ", "\\.subpath"],
    [TypeError, [{ subpath: 0 }], "expected ", "\\.t"],
    [
      RangeError,
      [-1, 2, 0.5].map((subpath) => ({ subpath, t: 0 })),
      "expected a whole number from 0 to 1",
      "\\.subpath",
    ],
    [RangeError, [{ subpath: 0, t: NaN }], "expected a finite number", "\\.t"],
  ],
  joint: [
    [TypeError, ["1", null, undefined, 1n], "expected "],
    [RangeError, [-1, 0, 2, 0.5, NaN], "expected a whole number from 1 to 1, got "],
  ],
  mode: [
    [RangeError, ["G1", "smooth", ""], 'expected one of "free", "g1", "c1", "c2", "g2", "auto", got '],
    [TypeError, [2], "expected "],
  ],
  coordinate: [[TypeError, [{}, { x: 1, y: 1 }, { z: 1 }, undefined], "expected exactly one of x, y, got"]],
  other: [[TypeError, [undefined, null, CUBIC, {}, 5, "M0 0", { casteljauType: "mesh" }, mesh], "expected a .*, got "]],
  text: [[TypeError, [undefined, null, 5, {}, [], new Uint8Array(3)], "expected a string, got "]],
  options: [[TypeError, [5, "closed", true, 3n], "expected an object, got "]],
  json: [[TypeError, [undefined, null, "{}", 5, {}], "expected an object with "]],
  flag: [[TypeError, ["false", 0, 1, null], "expected true or false, got "]],
};

const ones = (count) => new Array(count).fill([0, 0]);
/** A list with a hole. */
const without = (at, list) => {
  delete list[at];
  return list;
};

/** What the calls of the table may name. */
const SCOPE = {
  ...{
    Curve,
    Path,
    Patch,
    Spline,
    Surface,
    easing,
    cubic,
    space,
    quadratic,
    seven,
    spaceSpline,
    line,
    ring,
    mixed,
    path,
    two,
  },
  ...{
    RationalCurve,
    NurbsCurve,
    conic,
    nurbs,
    RationalPatch,
    NurbsSurface,
    RationalSurface,
    cylinder,
    quarter,
    weighted,
    empty,
    plane,
    surface,
    teapot,
    mesh,
    target,
    view,
    START,
    CUBIC,
    SEVEN,
    detached,
    ones,
    without,
    pointsOf,
  },
};
/** A function of _, of which a text is the value. */
const callOf = (text) => {
  const make = new Function(...Object.keys(SCOPE), `return (_) => ${text}`);
  return make(...Object.values(SCOPE));
};

/** All texts that a text with ⟨a | b⟩ stands for. @returns {string[]} */
function expanded(text) {
  const [, before, choices, rest] = text.match(/^(.*?)⟨(.*?)⟩(.*)$/) ?? [];
  if (choices === undefined) return [text];
  return choices.split("|").flatMap((choice) => expanded(before + choice.trim() + rest));
}

const table = readFileSync(new URL("./refusals.txt", import.meta.url), "utf8").split(/^== .*\n/m);
const [, ARGUMENTS, RANGES, TYPES, OPTIONS] = table.map((part) => part.split("\n").filter((row) => row !== ""));

const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
const messageOf = (text) => new RegExp(`^${escaped(text).replaceAll("…", ".*")}$`, "s");

for (const row of ARGUMENTS) {
  const [, kind, name, calls] = row.match(/^(\w+) (\S+): (.*)$/);
  test(row, () => {
    for (const text of expanded(calls))
      for (const [type, values, message, place = ""] of KINDS[kind])
        for (const value of values)
          refused(() => callOf(text)(value), type, new RegExp(`^${escaped(name)}${place}: ${message}`, "s"), text);
  });
}

for (const [type, rows] of [
  [RangeError, RANGES],
  [TypeError, TYPES],
])
  for (const row of rows)
    test(row, () => {
      const [calls, message] = row.split(" → ");
      for (const text of expanded(calls)) refused(callOf(text), type, messageOf(message), text);
    });

const refuses = (act, message) => assert.throws(act, { name: "TypeError", message });

test("unknown options", () => {
  for (const call of OPTIONS.flatMap(expanded).map(callOf)) {
    refuses(() => call({ zzz: 1 }), /^zzz: unknown option; expected \w/);
    call({ zzz: undefined });
    call({});
  }
  cubic.toSVG(null);
});

test("unknown options: the nearest known one is suggested", () => {
  const both = { left: 3, right: 1 };
  refuses(() => path.stroke({ ...both, stops: [] }), "stops: unknown option; expected left, right");
  refuses(() => path.strokeContains([0, 0], both, { simple: true }), /^simple: unknown option; expected /);
  refuses(() => cubic.offset(1, { tol: 1 }), "tol: unknown option; did you mean tolerance?");
  refuses(() => cubic.toSVG({ precison: 2 }), "precison: unknown option; did you mean precision?");
  refuses(() => cubic.toSVG({ Tolerance: 2 }), "Tolerance: unknown option; did you mean tolerance?");
  refuses(() => surface.grid({ segment: 2 }), "segment: unknown option; did you mean segments?");
  refuses(() => seven.offset(1, { jion: "miter" }), "jion: unknown option; expected tolerance, join");
  refuses(() => new Spline(SEVEN, { isClosed: true }), "isClosed: unknown option; did you mean closed?");
  refuses(() => path.union(path, { rule: "evenodd" }), /^rule: .*fillRule/);
  refuses(() => cubic.offset(1, { ["x".repeat(1e6)]: 1 }), /^x{40}…: unknown option; expected tolerance$/);
});

test("functions that are callbacks", () => {
  assert.equal([cubic, seven].map(Path.from).length, 2);
  assert.deepEqual([cubic.toJSON()].map(Curve.fromJSON)[0].toJSON(), cubic.toJSON());
});

test("a refused call leaves the array that was given as it is", () => {
  const into = new Float64Array(3).fill(5);
  assert.throws(() => cubic.sample(9, { into }));
  assert.deepEqual([...into], [5, 5, 5]);
});
