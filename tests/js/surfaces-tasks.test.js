// The tasks of the chapter on surfaces: not done at the start, done when it is done, and their own answers count.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Surface } from "casteljau";
import { boundingSphereOf } from "#js/elements/surface/camera.js";
import { figureOf } from "#js/elements/surface/figure.js";
import { Geometry } from "#js/elements/surface/geometry.js";
import { surfaceNamed } from "#js/elements/surface/models.js";
import { settingsOf } from "#js/elements/surface/settings.js";
import { maxRadialError } from "../../www/figures/lib/circle.js";
import { revolved } from "../../www/figures/lib/revolution.js";
import { JOINT_POINT, jointAngle, SURFACES } from "../../www/figures/lib/surfaces.js";
import { checkPrediction, load, testTasks } from "./task-cases.js";
import { near, pairs, pointsOf } from "./reference.js";

/** What a task sees of <bezier-surface>, with the element's own figure. */
function figure(properties) {
  const element = {
    ...{ model: "teapot", segments: 12, tolerance: null, u: 0.5, v: 0.5, patch: null, given: null },
    ...properties,
    get surface() {
      return element.given ?? surfaceNamed(settingsOf(element));
    },
    set surface(surface) {
      element.given = surface;
    },
    get figure() {
      const { surface } = element;
      const scene = {
        surface,
        settings: settingsOf(element),
        sphere: boundingSphereOf(surface.vertices, "z"),
        picked: element.patch ?? (surface.patchCount === 1 ? 0 : null),
      };
      return figureOf(scene, new Geometry().facts(scene));
    },
  };
  return element;
}

/** What it sees of <reyes-dicing>. */
const diced = (zoom, size) => ({
  zoom,
  size,
  get figure() {
    return { zoom: this.zoom, size: this.size };
  },
  /** Between the first and the second power of the zoom, as numbers that are rounded up. */
  countAt: (/** @type {number} */ at) => Math.round(1000 * at ** 1.5),
});

/** What it sees of <ray-tracing>. */
function traced(state, segments) {
  const element = { state, target: { segments }, start: () => Object.assign(element, { state: "done" }) };
  const figure = () => ({ state: element.state, segments: element.target.segments });
  return Object.defineProperty(element, "figure", { get: figure });
}

/** What it sees of <lathe-surface>. */
const lathe = (handle) => ({
  handle,
  get error() {
    return maxRadialError(4, this.handle);
  },
});

/** What it sees of <fig-octant>: the middle of the patch is the farthest from the sphere. */
const octant = (weight) => ({
  weight,
  get error() {
    const row = (1 + 2 * this.weight) / (2 + 2 * this.weight);
    return Math.abs(Math.hypot(row * row * Math.SQRT2, row) - 1);
  },
});

const saddle = (z) => Surface.parse(`1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 ${z}\n`);

const moved = (name, index, to) => ({ surface: SURFACES[name]().movePoint(index, to) });

/** Each task: its start as the page has it, what one may try in vain, and what does it. @type {[string, any, any[], any][]} */
const TASKS = [
  [
    "centre-height",
    { given: SURFACES.nine() },
    [
      moved("nine", 4, [0, 0, 2.13]),
      moved("nine", 4, [0, 0, 0.5]),
      { surface: moved("nine", 0, [-3, -3, -1]).surface.movePoint(4, [0, 0, 2 + 1 / 4]) },
    ],
    moved("nine", 4, [1, -1, 1.9]),
  ],
  ["corner-10", { model: "patch", u: 0.3, v: 0.7 }, pointsOf("0,1 1,0.01 1,1").map(([u, v]) => ({ u, v })), { v: 0 }],
  [
    "highest-point",
    { given: SURFACES.hill(), u: 0.6, v: 0.7 },
    [
      ...pointsOf("0,0 0.5,0.5 0.33,0.33").map(([u, v]) => ({ u, v })), // at 1/3 the weight of P11 is greatest
      { u: 0, v: 0, ...moved("hill", 0, [-3, -3, 20]) },
    ],
    (e) => Object.assign(e, highest(e.surface.patch(0))),
  ],
  [
    "fewest-segments",
    { model: "patch", segments: 4 },
    [
      { segments: 15 },
      { segments: 17 },
      { segments: 1, surface: Surface.parse("1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n") }, // a flat patch
      { tolerance: 0.01 },
    ],
    { tolerance: null, segments: 16 },
  ],
  [
    "pole",
    { parts: "lid", patch: 0, u: 0.5, v: 0.3 },
    [{ v: 1 }, { patch: null, v: 0 }, { patch: 0, u: 0, v: 0.3 }],
    { patch: 2, u: 0.1, v: 0 },
  ],
  [
    "smooth-joint",
    { given: SURFACES.joint(), patch: 1 },
    [moved("joint", 8, [1.5, 0, 1.7]), moved("joint", 7, [0, 0, 0.3]), moved("joint", 3, [1.5, -2.5, 0])],
    moved("joint", 8, [2, 0.4, 2.15]),
  ],
  [
    "few-triangles",
    { segments: 8 },
    [{ segments: 24 }, { flatness: 0.01 }, { flatness: null, tolerance: 0.02 }],
    { tolerance: 0.0099 },
  ],
  // The mesh has 32 n² + 4 n + 1 vertices of 24 bytes and 64 n² − 8 n triangles of 6; the patches take 290 · 12 + 32 · 16 · 2 bytes.
  [
    "hundredfold",
    () => ({ model: "teapot", segments: 8 }),
    [{ segments: 40 }, { segments: 12 }, { segments: 19 }, { segments: 20, model: "curve" }],
    { segments: 20, model: "teapot" },
  ],
  [
    "collapsed-patch",
    {},
    [{ patch: 4 }, { patch: 19 }, { patch: 27 }, { patch: 20, model: "teacup" }],
    { patch: 31, model: "teapot" },
  ],
  // The largest error of a quarter by cubics, and of an octant by the weight w: r = (1 + 2 w) / (√2 (1 + w)) in the middle of a row.
  ["round-lathe", () => lathe(0.56), [{ handle: 0.54 }, { handle: 0.5525 }, { handle: 0.55 }], { handle: 0.552 }],
  ["sphere-weight", () => octant(1), [{ weight: 0.68 }, { weight: 0.74 }, { weight: 0.5 }], { weight: 0.706 }],
  ["spout-hit", { patch: 4 }, [{ patch: 12 }, { patch: null }, { patch: 20 }, { patch: 18 }], { patch: 19 }],
  [
    "micropolygons",
    () => diced(1, 16),
    [{ zoom: 0.5 }, { zoom: 0.25 }, { zoom: 0.65, size: 6 }, { zoom: 0.8, size: 16 }],
    { zoom: 0.3 + 7 * 0.05, size: 16 },
  ],
  [
    "outline-edges",
    () => traced("idle", 3),
    [{ state: "running" }, { state: "cancelled" }, { state: "done", target: { segments: 5 } }],
    { target: { segments: 4 } },
  ],
  [
    "own-square",
    {},
    [
      { surface: saddle(1) },
      { surface: Surface.parse("1\n1 1\n0 0 0\n2 0 0\n0 1 0\n2 1 0\n") },
      { surface: Surface.parse("1\n1 1\n0 0 0\n1 0 1\n0 1 0\n1 1 1\n") }, // flat, with sides of length √2
      { surface: Surface.parse("1\n1 1\n0 0 0\n1 0 0\n0 1 0\n-1 -1 0\n") }, // flat, four points at distances of 1
    ],
    { surface: saddle(0) },
  ],
];

/** To hundredths, as the sliders have it; by looking everywhere. */
function highest(patch) {
  const places = Array.from({ length: 101 * 101 }, (_, k) => ({ u: (k % 101) / 100, v: Math.floor(k / 101) / 100 }));
  return places.reduce((best, each) => (patch.eval(each.u, each.v).z > patch.eval(best.u, best.v).z ? each : best));
}

/** The control points of a patch. @param {{ patch(k: number): { controlPoints(): Float64Array } }} surface @param {number} k */
const net = (surface, k) => surface.patch(k).controlPoints();

test("the lathe makes the body of the teapot; a profile from axis to axis makes a closed surface", () => {
  const pot = Surface.teapot();
  const lathe = SURFACES.lathe();
  assert.equal(lathe.patchCount, 8);
  for (let k = 0; k < 8; k++) near(net(lathe, k), net(pot, 4 + k), 1e-12);
  const half = /** @type {[number, number][]} */ (pointsOf("0,1 0.56,1 1,0.56 1,0 1,-0.56 0.56,-1 0,-1"));
  const ball = revolved(half, 0.56);
  const { open, shared, collapsed } = ball.topology();
  assert.deepEqual([open.length, shared.length, collapsed.length], [0, 12, 8]);
  assert.ok(Math.abs((ball.volume() ?? 0) / ((4 / 3) * Math.PI) - 1) < 0.02);
});

testTasks(TASKS, figure);

const chapter = readFileSync(new URL("../../www/surfaces/index.md", import.meta.url), "utf8");
const used = [...chapter.matchAll(/^::: task ([\w-]+)(?: for=([\w-]+))?$/gm)];

test("what is flat is not said to be otherwise", async () => {
  const { check } = await load("own-square");
  const words = (z) => check(figure({ given: Surface.parse(`1\n1 1\n0 0 0\n1 0 ${z}\n0 1 0\n1 1 1\n`) }).figure).words;
  assert.match(words(1), /^The patch is flat, but .* lengths 1\.41 and 1\.00\.$/);
  assert.match(words(0.5), /^The patch is not flat/);
  const turned = Surface.parse("1\n1 1\n0 0 0\n0 0 1\n0 1 0\n0 1 1\n");
  assert.equal(check(figure({ given: turned }).figure).done, true, "a square in another plane");
});

test("the bytes that a task computes are those of the mesh", async () => {
  const { meshBytes } = await load("hundredfold");
  for (const segments of [1, 8, 19, 20]) {
    const { positions, normals, indices } = Surface.teapot().tessellate({ segments, weld: "position" });
    assert.equal(meshBytes(segments), positions.byteLength + normals.byteLength + indices.byteLength, `${segments}`);
  }
});

test("numbers to be typed: the answer of each is computed here, and each of three wrong ones has a hint", async () => {
  const patch = SURFACES.hill().patch(0);
  const parts = patch.split(0.5, 0.5).flatMap((part) => pairs(part.controlPoints(), 3).map(String));
  const { shared, open, collapsed } = Surface.teapot().topology();
  /** @type {Record<string, number[]>} */
  const expected = {
    "split-count": [new Set(parts).size],
    "vertices-16": [Surface.teapot().grid({ segments: 16 }).positions.length / 3],
    "common-vertices": [new Set([0, 3, 6, 9, 12, 0, 4, 8, 12]).size - 1], // twelfths
    "plane-distance": [Math.abs(0 * 1 - 9 * 2 + 12 * 4) / Math.hypot(0, -9, 12)],
    "next-values": [1, 2, 3].map((k) => 1 + 3 * k + (4 * k * (k - 1)) / 2 + (6 * k * (k - 1) * (k - 2)) / 6),
    "shared-wires": [2 * shared.length + open.length + collapsed.length - shared.length - collapsed.length],
    "most-intersections": [2 * 3],
  };
  for (const [name, values] of Object.entries(expected)) {
    const { answer } = await load(name);
    assert.deepEqual(answer.values, values, name);
    const wrong = Object.keys(answer.hints);
    assert.ok(wrong.length >= 3 && !wrong.includes(values.join(" ")), name);
    for (const key of wrong)
      assert.ok(
        key.split(" ").every((word) => String(Number(word)) === word) && key.split(" ").length === values.length,
        key,
      );
    assert.ok(answer.because.length > 20);
  }
});

test("every task of the chapter is tested or only predicted, and is about a figure that is there", async () => {
  const tested = TASKS.map(([name]) => name);
  assert.ok(used.length >= 16);
  for (const [, name, about] of used) {
    const task = await load(name);
    assert.equal(Boolean(task.check), tested.includes(name), name);
    if (task.check) assert.match(chapter, new RegExp(` id="${about}"`));
    if (task.predict) checkPrediction(task.predict);
    assert.ok(task.check || task.predict || task.answer, name);
  }
  for (const name of tested) {
    const isUsed = used.some((each) => each[1] === name);
    assert.ok(isUsed, name);
  }
});

test("each section ends with a task and a sample", () => {
  const sections = chapter.split(/^## /m).slice(1);
  assert.ok(sections.length >= 13);
  for (const section of sections)
    assert.match(section, /^::: task [\s\S]*^::: sample [\w-]+\n:::\s*(\[|$(?![\s\S]))/m, section.slice(0, 40));
});

test("what the text says of the predictions and of the data is so", async () => {
  const teapot = Surface.teapot();
  assert.equal(teapot.patchCount, 32);
  assert.equal(teapot.vertices.length / 3, 290);
  const { shared, open, collapsed } = teapot.topology();
  assert.deepEqual([shared.length, open.length, collapsed.length], [52, 16, 8]);
  assert.deepEqual([Surface.teacup().patchCount, Surface.teaspoon().patchCount], [26, 16]);
  assert.equal(Surface.teapot({ bottom: false }).patchCount, 28);
  assert.deepEqual([teapot.bounds()?.max.z, Surface.teapot({ height: "original" }).bounds()?.max.z], [3.15, 4.2]);
  assert.equal(teapot.grid({ segments: 16 }).positions.length / 3, 9248);
  assert.equal(teapot.tessellate({ segments: 16, weld: "position" }).positions.length / 3, 8257);
  assert.equal(Surface.teapot({ rim: false, body: false, spout: false, lid: false, bottom: false }).patchCount, 4);
  const patch = surfaceNamed(settingsOf(/** @type {any} */ ({ model: "patch" }))).patch(0);
  const { x, y, z } = patch.eval(1, 0);
  assert.deepEqual([x, y, z], [...patch.controlPoints().slice(9, 12)], "S(1, 0) is P30, the last point of row 0");
  assert.equal(teapot.isocurves({ lines: 1 }).length, 68, "the wires on the sides of the patches");
  assert.equal(teapot.patches.filter((net) => new Set(Array.from(net)).size < 16).length, 8);
});

/** The legs across a side of a teapot patch, from the side inwards, in the order of the side. */
function legsAcross(patch, { edge, reversed }) {
  const points = pairs(patch.controlPoints(), 3);
  const legs = [0, 1, 2, 3].map((k) => {
    const [side, inside] = edge.endsWith("0") ? [0, 1] : [3, 2];
    const [from, to] = [side, inside].map((i) => points[edge.startsWith("u") ? 4 * k + i : 4 * i + k]);
    return to.map((x, axis) => x - from[axis]);
  });
  return reversed ? legs.reverse() : legs;
}

test("the joints of the teapot are smooth: the ratio is 1, and 4 or 1/4 at rim and spout", () => {
  const teapot = Surface.teapot();
  const ratios = teapot.topology().shared.map(([a, b]) => {
    const [before, after] = [legsAcross(teapot.patch(a.patch), a), legsAcross(teapot.patch(b.patch), b)];
    const rows = before.map((p, k) => ({ p, q: after[k] })).filter(({ p }) => Math.hypot(...p) > 0);
    const found = rows.map(({ p, q }) => {
      const ratio = Math.hypot(...q) / Math.hypot(...p);
      q.forEach((x, axis) => assert.ok(Math.abs(x + ratio * p[axis]) < 1e-6, `${a.patch} and ${b.patch}`));
      return Number(ratio.toFixed(6));
    });
    assert.equal(new Set(found).size, 1, `one ratio: ${found}`);
    return `${found[0]} ${[a.patch, b.patch].sort((x, y) => x - y)}`;
  });
  const unequal = ratios.filter((each) => !each.startsWith("1 "));
  assert.deepEqual(unequal, ["4 0,4", "4 1,5", "4 2,6", "4 3,7", "0.25 16,18", "0.25 17,19"]);
});

test("the normal at a collapsed side, from the control vectors that the text gives", () => {
  const choose = (n, k) => (k === 0 ? 1 : (choose(n, k - 1) * (n - k + 1)) / k);
  const minus = (p, q) => p.map((x, axis) => x - q[axis]);
  const crossed = ([ax, ay, az], [bx, by, bz]) => [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
  const net = pairs(SURFACES.hill().patch(0).controlPoints(), 3).map((point, k) => (k < 4 ? [0, 0, 4] : point)); // row 0 is one point
  const patch = new Surface({ vertices: net, patches: [net.map((_, k) => k)] }).patch(0);
  const point = (i, j) => net[4 * j + i];
  const q = [0, 1, 2, 3, 4, 5].map((i) =>
    [0, 1, 2]
      .flatMap((j) => (i - j >= 0 && i - j <= 3 ? [[j, i - j]] : []))
      .reduce(
        (sum, [j, k]) => {
          const product = crossed(minus(point(j + 1, 1), point(j, 1)), minus(point(k, 1), point(k, 0)));
          return sum.map((x, axis) => x + (choose(2, j) * choose(3, k) * product[axis]) / choose(5, i));
        },
        [0, 0, 0],
      ),
  );
  for (const u of [0, 0.2, 0.5, 0.9, 1]) {
    const along = q.reduce(
      (sum, vector, i) => {
        const weight = choose(5, i) * u ** i * (1 - u) ** (5 - i);
        return sum.map((x, axis) => x + weight * vector[axis]);
      },
      [0, 0, 0],
    );
    const { x, y, z = 0 } = patch.normal(u, 0);
    const length = Math.hypot(...along);
    assert.ok(
      Math.hypot(along[0] / length - x, along[1] / length - y, along[2] / length - z) < 1e-9,
      `${u}: ${along} and ${x} ${y} ${z}`,
    );
  }
});

test("what the text says of splitting, of the second derivatives and of the tip of the knob", () => {
  const hill = SURFACES.hill().patch(0);
  const points = hill.split(0.5, 0.5).flatMap((part) => pairs(part.controlPoints(), 3).map(String));
  assert.equal(new Set(points).size, 49);
  const lid = Surface.teapot().patch(20);
  for (const u of [0.1, 0.5, 0.9]) {
    const { z = 0 } = lid.normal(u, 0);
    assert.ok(Math.abs(Math.abs(z) - 1) < 1e-12, "one normal at the tip");
  }
  assert.ok(jointAngle(SURFACES.joint()) > 30);
  assert.ok(jointAngle(SURFACES.joint().movePoint(JOINT_POINT.vertex, JOINT_POINT.at)) < 1e-5);
});
