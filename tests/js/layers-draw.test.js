// How the layers of <bezier-applet> draw: on a tape, and as SVG.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve } from "#js/index.js";
import { figureOf } from "#js/editor/figure.js";
import { Lens } from "#js/layers/lens.js";
import { LAYERS } from "#js/layers/index.js";
import { Recorder, svgFigure } from "#js/layers/svg.js";
import { FONT_FAMILY } from "#js/ui/tokens.js";
import { BASES, LAYER_NAMES, withView } from "#js/editor/state.js";
import { drawn, stateWith, Tape, theme } from "./layers-page.js";
import { pointsOf } from "./reference.js";

const BOX = { width: 670, height: 480 };

/** What may come: all equal, on a line, there and back, a cloud, smaller than numbers tell, as far as is allowed. */
const CLOUDS = {
  equal: () => [100, 100],
  line: (i) => [10 * i, 20 * i],
  back: (i) => [i % 2 ? 500 : 10, 100],
  random: (i) => [(i * 7919) % 670, (i * 104729) % 480],
  tiny: (i) => [300 + 1e-9 * ((i * 7919) % 13), 200 + 1e-9 * ((i * 7) % 11)],
  ulps: (i) => [1e6 + (i % 2) * 1e-10, 1e6],
  huge: (i) => [((i * 7919) % 2000) * 1000 - 1e6, ((i * 104729) % 2000) * 1000 - 1e6],
};
const VIEWS = [null, { x: 300, y: 200, width: 1e-6, height: 1e-6 }, { x: -3e4, y: -2e4, width: 6e4, height: 5e4 }];

/** Draws all layers of a kind of points in all views; fails at a throw, a number that is none, or a picture without end. */
function drawAll(changes, count) {
  for (const [kind, point] of Object.entries(CLOUDS)) {
    const points = Array.from({ length: count }, (_, i) => point(i));
    for (const view of VIEWS) {
      const words = `${changes.basis} ${changes.degree} of ${count}, ${kind}, ${view ? view.width : "unmoved"}`;
      const fineness = { tolerance: 0.01, segments: 50, ticks: 50 };
      const state = stateWith({ ...changes, points, pointer: [300, 200], t: 1.3, segment: 1, ...fineness });
      const { ctx, told } = drawn({ ...(view ? withView(state, view) : state), layers: "all" });
      const large = ctx.calls.flat().filter((each) => typeof each === "number" && !(Math.abs(each) < 1e5));
      assert.deepEqual(large, [], words);
      assert.ok(ctx.calls.length < 200_000, `${words}: ${ctx.calls.length} calls`);
      assert.doesNotMatch(told.map((each) => each.words).join(), /NaN|undefined|cannot/, words);
    }
  }
}

for (const basis of BASES) {
  for (const degree of basis === "bezier" || basis === "b-spline" ? [1, 2, 3, 7, "n"] : [3]) {
    test(`all layers draw whatever comes: ${basis}, degree ${degree}`, () => {
      for (const count of [2, 4, 8]) drawAll({ basis, degree, labels: ["P1", "b0", "p0"][count % 3] }, count);
    });
  }
}

test("all layers draw a curve of degree 64 and a chain of 500 points in bounded work", () => {
  for (const [basis, [degree, count]] of Object.entries({
    bezier: [64, 65],
    "b-spline": [64, 200],
    natural: [3, 500],
  })) {
    const points = Array.from({ length: count }, (_, i) => CLOUDS.random(i));
    const { ctx } = drawn({ basis, degree, points, layers: "all", pointer: [1, 1], t: 1.5 });
    assert.ok(ctx.calls.length < 200_000, `${ctx.calls.length} calls`);
  }
});

test("there is a layer for every name that can be switched, and each alone adds something to the picture", () => {
  assert.deepEqual(LAYERS.map(({ name }) => name).sort(), [...LAYER_NAMES].sort());
  const S = pointsOf("100,100 300,100 100,300 300,300");
  const length = (layers) => drawn({ points: S, layers, pointer: [1, 1] }).ctx.calls.length;
  const bare = length([]);
  for (const name of LAYER_NAMES) {
    if (name === "names") assert.ok(length(["construction", name]) > length(["construction"]), name);
    else assert.ok(length([name]) > bare, name);
  }
});

test("drawing is a function of its arguments: twice the same, and paints are put back", () => {
  const [first, second] = [1, 2].map(() => drawn({ layers: "all", pointer: [200, 350] }));
  assert.deepEqual(first.ctx.calls, second.ctx.calls);
  assert.equal(first.ctx.globalAlpha, 1);
  assert.deepEqual(first.ctx.of("setLineDash").at(-1), [[]]);
});

test("points: discs on the curve, squares off it, hollow at the edge when they are outside, faint while they wait", () => {
  const { ctx } = drawn({ points: pointsOf("100,100 900,-50 300,300 400,100 500,300") });
  const discs = ctx.of("arc").map(([x, y, r]) => [x, y, r]);
  assert.ok(discs.some(([x, y, r]) => x === 100 && y === 100 && r === 6));
  const squares = ctx.of("rect").map(([x, y, w]) => [x + w / 2, y + w / 2]);
  assert.deepEqual(squares, pointsOf("664,6 300,300 500,300"));
  const fills = ctx.calls.flatMap((call, i) => (ctx.calls[i - 1]?.[0] === "rect" ? [call.slice(-2).join(" ")] : []));
  assert.deepEqual(fills, ["paper 1", "handle 1", "paper 0.55"]);
});

test("sizes are CSS pixels: on a canvas half as wide they are twice as large in the box", () => {
  const radius = (px) => drawn({}, px).ctx;
  assert.equal(radius(2).of("arc")[0][2], 2 * radius(1).of("arc")[0][2]);
});

test("Hermite's vectors have heads, other tangents none", () => {
  const heads = (basis) =>
    drawn({ basis }).ctx.calls.filter(([name, ...rest]) => name === "fill" && rest.at(-2) === "handle").length;
  assert.equal(heads("hermite"), heads("bezier") + 1);
});

test("a view enlarges the curve about its corner, marks keep their size", () => {
  const view = { x: 100, y: 50, width: 67, height: 48 };
  const lines = (changes) => drawn({ points: pointsOf("110,60 120,70 130,60 140,70"), ...changes }).ctx;
  const [plain, close] = [lines({}), lines({ view })];
  const [far, near] = [plain.of("bezierCurveTo")[0], close.of("bezierCurveTo")[0]];
  far.forEach((value, i) => assert.ok(Math.abs(near[i] - 10 * (value - (i % 2 ? 50 : 100))) < 1e-9));
  assert.equal(close.of("arc")[0][2], 6);
});

test("at any zoom, the canvas gets distinct numbers, and the visible part is right", () => {
  const curve = new Curve([70, 330, 110, 90, 235, 120, 325, 230]);
  const at = curve.eval(0.3);
  for (const size of [1, 1e-3, 1e-6]) {
    const view = { x: at.x - size / 2, y: at.y - (size * 480) / 670 / 2, width: size, height: (size * 480) / 670 };
    const tape = new Tape();
    new Lens(/** @type {any} */ (tape), { box: BOX, view }).curve(curve.controlPoints());
    const vertices = tape.calls.map(([, x, y]) => [x, y]);
    const largest = Math.max(...vertices.flat().map(Math.abs));
    assert.ok(largest <= 2 ** 14, `${size}: ${largest}`);
    const distances = vertices.slice(1).map((end, k) => new Curve([vertices[k], end]).nearest([335, 240]).distance);
    const least = Math.min(...distances);
    assert.ok(least < 0.1, `${size}: the view's middle lies ${least} from what is drawn`);
  }
});

/** Where the lens cuts. */
const FAR = 2 ** 13;
const rounded = (numbers) => numbers.map((x) => Math.round(1e6 * x) / 1e6);

test("lines and polygons are cut where they lie far outside; a hull around the whole view still fills it", () => {
  const tape = new Tape();
  const lens = new Lens(/** @type {any} */ (tape), { box: BOX, view: { x: 0, y: 0, width: 6.7e-4, height: 4.8e-4 } });
  lens.beginPath();
  lens.moveTo(-100, 1e-4);
  lens.lineTo(100, 1e-4);
  assert.deepEqual(tape.of("moveTo").map(rounded), [[-FAR, 100]]);
  assert.deepEqual(tape.of("lineTo").map(rounded), [[FAR, 100]]);
  tape.calls = [];
  lens.polygon([-100, -100, 100, -100, 100, 100, -100, 100]);
  const corners = [...tape.of("moveTo"), ...tape.of("lineTo")];
  assert.equal(corners.length, 4);
  const sizes = corners.map(rounded).map(([x, y]) => [Math.abs(x), Math.abs(y)]);
  assert.deepEqual(sizes, new Array(4).fill([FAR, FAR]));
  tape.calls = [];
  lens.polygon([1, 1, 2, 1, 2, 2]);
  assert.deepEqual(tape.of("lineTo"), []);
});

test("a curve of degree 9 is drawn within a tenth of a pixel", () => {
  const curve = new Curve(Array.from({ length: 10 }, (_, i) => CLOUDS.random(i)));
  const tape = new Tape();
  new Lens(/** @type {any} */ (tape), { box: BOX, view: { x: 0, y: 0, ...BOX } }).curve(curve.controlPoints());
  const vertices = [...tape.of("moveTo"), ...tape.of("lineTo")];
  for (let k = 0; k + 1 < vertices.length; k++) {
    const [[ax, ay], [bx, by]] = [vertices[k], vertices[k + 1]];
    assert.ok(curve.nearest([(ax + bx) / 2, (ay + by) / 2]).distance < 0.1);
  }
});

test("words do not lie on each other or on points where there is room", () => {
  const { ctx } = drawn({ layers: ["construction", "names", "weights"], labels: "P1" });
  const boxes = ctx.of("fillText").map(([text, x, y]) => ({ text, x, y, half: 3.75 * [...text].length }));
  assert.ok(boxes.length >= 7 + 12 + 4, `${boxes.length} words`);
  boxes.forEach((a, i) => {
    for (const b of boxes.slice(i + 1)) {
      const apart = Math.abs(a.x - b.x) >= a.half + b.half - 1e-9 || Math.abs(a.y - b.y) >= 16 - 1e-9;
      assert.ok(apart, `${a.text} lies on ${b.text}`);
    }
  });
});

test("words stay inside the picture", () => {
  const { ctx } = drawn({ points: pointsOf("0,0 670,0 670,480 0,480"), layers: ["weights"] }, 2);
  for (const [text, x, y] of ctx.of("fillText")) {
    const half = 7.5 * text.length;
    assert.ok(x >= half && x <= 670 - half && y >= 16 && y <= 480 - 16, `${text} at ${x}, ${y}`);
  }
});

test("SVG: the same picture, closed elements, no number that is none, colours that need no style sheet", () => {
  const state = stateWith({ layers: "all", pointer: [200, 350] });
  const svg = svgFigure(state, figureOf(state));
  assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg" viewBox="0 0 670 480"/);
  assert.match(svg, /<\/svg>$/);
  assert.doesNotMatch(svg, /NaN|Infinity|undefined|var\(/);
  assert.match(svg, /stroke="#0072b2" stroke-width="3"/);
  assert.ok(svg.includes(`font-family="${FONT_FAMILY.replaceAll('"', "&quot;")}"`), "the letters of the elements");
  const [paths, texts] = [svg.match(/<path [^<>]*\/>/g), svg.match(/<text [^<>]*>[^<>]*<\/text>/g)];
  const rest = svg.replace(/<path [^<>]*\/>|<text [^<>]*>[^<>]*<\/text>|<title>[^<>]*<\/title>/g, "");
  assert.match(rest, /^<svg [^<>]*><\/svg>$/);
  const { ctx } = drawn({ layers: "all", pointer: [200, 350] });
  assert.equal(texts?.length, ctx.of("fillText").length);
  assert.ok(Number(paths?.length) > 50);
  assert.ok(svg.length < 60_000, `${svg.length} characters`);
});

test("SVG: what comes from outside is text, not markup", () => {
  const state = stateWith();
  const options = { label: `<script>"&"</script>`, theme: { curve: `"><script>` }, opaque: true };
  const svg = svgFigure(state, figureOf(state), options);
  assert.match(svg, /<title>&lt;script&gt;&quot;&amp;&quot;&lt;\/script&gt;<\/title>/);
  assert.doesNotMatch(svg, /<script/);
  assert.match(svg, /<path fill="#ffffff" d="M0 0H670V480H0Z"\/>/);
});

test("SVG: a mark's fill and rim are one element, and so are a word and its rim", () => {
  const state = stateWith({ layers: [], points: pointsOf("100,100 200,50 300,300 400,100") });
  const svg = svgFigure(state, figureOf(state));
  assert.equal(svg.match(/<path /g)?.length, 2 + 4 + 1); // curve, tangents, four points, the diamond
  assert.equal(svg.match(/<text [^>]*stroke="#ffffff"[^>]*fill="#15202b">P\d</g)?.length, 4);
});

test("SVG: no element has an attribute twice, a path that is stroked twice is two elements", () => {
  const state = stateWith({ layers: "all", pointer: [200, 350] });
  for (const [element] of svgFigure(state, figureOf(state)).matchAll(/<[^>]*>/g)) {
    const names = [...element.matchAll(/ ([\w-]+)="/g)].map(([, name]) => name);
    assert.equal(new Set(names).size, names.length, element);
  }
  const recorder = new Recorder();
  recorder.moveTo(0, 0);
  recorder.lineTo(9, 9);
  for (const [strokeStyle, lineWidth] of /** @type {const} */ ([
    ["#fff", 4],
    ["#000", 2],
  ])) {
    Object.assign(recorder, { strokeStyle, lineWidth });
    recorder.stroke();
  }
  assert.equal(
    recorder.text,
    '<path d="M0 0L9 9" stroke="#fff" stroke-width="4"/><path d="M0 0L9 9" stroke="#000" stroke-width="2"/>',
  );
});

test("colours go by role", () => {
  const paints = drawn({ layers: "all" }).ctx.calls.flatMap((call) => call.slice(-3, -1));
  for (const role of new Set(paints.filter(Boolean))) assert.ok(role in theme, `${role} is no role`);
});

test("without the layer of names, the point of the construction under the pointer has its name", () => {
  const points = pointsOf("100,300 100,100 500,100 500,300");
  const words = (layers, pointer) =>
    drawn({ points, layers, pointer, t: 0.5 })
      .ctx.of("fillText")
      .map(([text]) => text);
  const own = ["P0", "P1", "P2", "P3"];
  assert.deepEqual(words(["construction"], [305, 92]), [...own, "P12"]);
  assert.deepEqual(words(["construction", "halves"], [202, 150]), [...own, "P0112"]);
  assert.deepEqual(words(["construction"], [300, 125]), own, "nothing is that near");
  assert.deepEqual(words(["construction"], null), own);
  assert.deepEqual(words(["polygon"], [305, 92]), own, "without the construction");
  assert.ok(words(["construction", "names"], [305, 92]).length > 5);
});

test("names stand beside the curve, not on it", () => {
  const points = pointsOf("60,60 600,60 60,420 600,420");
  const { ctx, state } = drawn({ points, layers: ["construction", "names"], t: 0.3 });
  const [{ curve }] = figureOf(state).pieces;
  for (const [text, x, y] of ctx.of("fillText")) {
    const { point } = curve.nearest([x, y]);
    const halfWidth = (7.5 * text.length) / 2;
    assert.ok(Math.abs(point.x - x) > halfWidth || Math.abs(point.y - y) > 8, `${text} at ${x}, ${y} is on the curve`);
  }
});
