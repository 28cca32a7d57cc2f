// The tasks of the chapter on surfaces: not done at the start, done when it is done, and their own answers count.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Surface } from "casteljau";
import { frameOf } from "../../js/elements/surface/camera.js";
import { figureOf } from "../../js/elements/surface/figure.js";
import { Geometry } from "../../js/elements/surface/geometry.js";
import { surfaceNamed } from "../../js/elements/surface/models.js";
import { settingsOf } from "../../js/elements/surface/settings.js";
import { JOINT_POINT, jointAngle, SURFACES } from "../../www/figures/lib/surfaces.js";
import { load, testTasks } from "./task-cases.js";

/** What a task sees of <bezier-surface>, with the element's own figure. */
function figure(properties) {
  const element = {
    model: "teapot",
    parts: null,
    height: "squashed",
    up: "z",
    segments: 12,
    tolerance: null,
    pixels: null,
    flatness: null,
    lines: 4,
    shading: "smooth",
    show: "surface",
    evaluation: "cpu",
    u: 0.5,
    v: 0.5,
    step: 4,
    swept: false,
    patch: null,
    given: null,
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
        frame: frameOf(surface.vertices, "z"),
        picked: element.patch ?? (surface.patchCount === 1 ? 0 : null),
      };
      return figureOf(scene, new Geometry().facts(scene));
    },
  };
  return element;
}

/** What it sees of <reyes-dicing>. */
const diced = (zoom) => ({
  zoom,
  get figure() {
    return { zoom: this.zoom, micropolygons: 1000 };
  },
});

/** What it sees of <ray-tracing>. */
const traced = (state, segments) => ({
  state,
  target: { segments },
  start() {
    this.state = "done";
  },
  get figure() {
    return { state: this.state, segments: this.target.segments };
  },
});

const saddle = (z) => Surface.parse(`1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 ${z}\n`);

/** Each task: its start as the page has it, what one may try in vain, and what does it. */
const TASKS = {
  "centre-height": {
    start: () => figure({ given: SURFACES.nine() }),
    vain: [
      (e) => (e.surface = SURFACES.nine().movePoint(4, [0, 0, 2.13])),
      (e) => (e.surface = SURFACES.nine().movePoint(4, [0, 0, 0.5])),
      (e) =>
        (e.surface = SURFACES.nine()
          .movePoint(0, [-3, -3, -1])
          .movePoint(4, [0, 0, 2 + 1 / 4])),
    ],
    right: (e) => (e.surface = SURFACES.nine().movePoint(4, [1, -1, 1.9])),
  },
  "corner-10": {
    start: () => figure({ model: "patch", u: 0.3, v: 0.7 }),
    vain: [(e) => Object.assign(e, { u: 0, v: 1 }), (e) => Object.assign(e, { u: 1, v: 0.01 })],
    right: (e) => (e.v = 0),
  },
  "highest-point": {
    start: () => figure({ given: SURFACES.hill(), u: 0.6, v: 0.7 }),
    vain: [(e) => Object.assign(e, { u: 0, v: 0 }), (e) => Object.assign(e, { u: 0.5, v: 0.5 })],
    right: (e) => Object.assign(e, highest(e.surface.patch(0))),
  },
  "fewest-segments": {
    start: () => figure({ model: "patch", segments: 4 }),
    vain: [(e) => (e.segments = 15), (e) => (e.segments = 17), (e) => (e.tolerance = 0.01)],
    right: (e) => Object.assign(e, { tolerance: null, segments: 16 }),
  },
  pole: {
    start: () => figure({ parts: "lid", patch: 0, u: 0.5, v: 0.3 }),
    vain: [(e) => (e.v = 1), (e) => Object.assign(e, { patch: null, v: 0 })],
    right: (e) => Object.assign(e, { patch: 2, u: 0.1, v: 0 }),
  },
  "smooth-joint": {
    start: () => figure({ given: SURFACES.joint(), patch: 1 }),
    vain: [
      (e) => (e.surface = SURFACES.joint().movePoint(8, [1.5, 0, 1.7])),
      (e) => (e.surface = SURFACES.joint().movePoint(7, [0, 0, 0.3])),
      (e) => (e.surface = SURFACES.joint().movePoint(3, [1.5, -2.5, 0])),
    ],
    right: (e) => (e.surface = SURFACES.joint().movePoint(8, [2, 0.4, 2.15])),
  },
  "few-triangles": {
    start: () => figure({ segments: 8 }),
    vain: [
      (e) => (e.segments = 24),
      (e) => (e.flatness = 0.01),
      (e) => Object.assign(e, { flatness: null, tolerance: 0.02 }),
    ],
    right: (e) => (e.tolerance = 0.0099),
  },
  hundredfold: {
    start: () => ({ segments: 8 }),
    vain: [(e) => (e.segments = 40), (e) => (e.segments = 12)],
    right: (e) => (e.segments = firstOver(100)),
  },
  "collapsed-patch": {
    start: () => figure({}),
    vain: [
      (e) => (e.patch = 4),
      (e) => (e.patch = 19),
      (e) => (e.patch = 27),
      (e) => Object.assign(e, { patch: 20, model: "teacup" }),
    ],
    right: (e) => Object.assign(e, { patch: 31, model: "teapot" }),
  },
  "spout-hit": {
    start: () => figure({ patch: 4 }),
    vain: [(e) => (e.patch = 12), (e) => (e.patch = null), (e) => (e.patch = 20), (e) => (e.patch = 18)],
    right: (e) => (e.patch = 19),
  },
  micropolygons: {
    start: () => diced(1),
    vain: [(e) => (e.zoom = 0.45), (e) => (e.zoom = 0.55)],
    right: (e) => (e.zoom = 0.3 + 4 * 0.05),
  },
  "outline-edges": {
    start: () => traced("idle", 3),
    vain: [
      (e) => (e.state = "running"),
      (e) => (e.state = "cancelled"),
      (e) => Object.assign(e, { state: "done", target: { segments: 5 } }),
    ],
    right: (e) => (e.target.segments = 4),
  },
  "own-square": {
    start: () => figure({}),
    vain: [(e) => (e.surface = saddle(1)), (e) => (e.surface = Surface.parse("1\n1 1\n0 0 0\n2 0 0\n0 1 0\n2 1 0\n"))],
    right: (e) => (e.surface = saddle(0)),
  },
};

/** To hundredths, as the sliders have it; by looking everywhere. */
function highest(patch) {
  const places = Array.from({ length: 101 * 101 }, (_, k) => ({ u: (k % 101) / 100, v: Math.floor(k / 101) / 100 }));
  return places.reduce((best, each) => (patch.eval(each.u, each.v).z > patch.eval(best.u, best.v).z ? each : best));
}

/** By the formulas of the counts: the mesh has 32 n² + 4 n + 1 vertices of six numbers and 64 n² − 8 n triangles. */
function firstOver(times) {
  const patches = 290 * 12 + 32 * 16 * 2;
  const mesh = (n) =>
    (32 * n * n + 4 * n + 1) * 24 + (64 * n * n - 8 * n) * 3 * (32 * n * n + 4 * n + 1 > 65536 ? 4 : 2);
  let n = 1;
  while (mesh(n) <= times * patches) n++;
  return n;
}

/** The next values of a cubic from one value and its differences. */
function byAdditions([f, d1, d2, d3], count) {
  return Array.from({ length: count }, () => {
    [f, d1, d2] = [f + d1, d1 + d2, d2 + d3];
    return f;
  });
}

testTasks(TASKS);

const chapter = readFileSync(new URL("../../www/surfaces/index.md", import.meta.url), "utf8");
const used = [...chapter.matchAll(/^::: task ([\w-]+)(?: for=([\w-]+))?$/gm)];

test("every task of the chapter is tested or only predicted, and is about a figure that is there", async () => {
  assert.ok(used.length >= 16);
  for (const [, name, about] of used) {
    const task = await load(name);
    assert.equal(Boolean(task.check), name in TASKS, name);
    if (task.check) assert.match(chapter, new RegExp(` id="${about}"`));
    if (!task.predict) continue;
    const { options, answer, because } = task.predict;
    assert.ok(answer in options && because.length > 20, name);
    assert.equal(new Set(options).size, options.length);
  }
  assert.deepEqual(
    Object.keys(TASKS).filter((name) => !used.some((each) => each[1] === name)),
    [],
  );
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
  assert.equal(306 - 4 - 12, 290);
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
  assert.equal((-9 * 2 + 12 * 4) / Math.hypot(9, 12), 2, "the distance from the plane");
  assert.deepEqual(byAdditions([1, 3, 4, 6], 3), [4, 11, 28]);
  const weight = (t) => 3 * t * (1 - t) ** 2;
  assert.ok(Math.abs(weight(1 / 3) - 4 / 9) < 1e-15);
});

/** The legs across a side of a teapot patch, from the side inwards, in the order of the side. */
function legsAcross(patch, { edge, reversed }) {
  const points = patch.controlPoints();
  const at = (i, j) => [...points.slice(3 * (4 * j + i), 3 * (4 * j + i) + 3)];
  const pairs = [0, 1, 2, 3].map((k) => {
    const [onSide, inside] = {
      u0: [at(0, k), at(1, k)],
      u1: [at(3, k), at(2, k)],
      v0: [at(k, 0), at(k, 1)],
      v1: [at(k, 3), at(k, 2)],
    }[edge];
    return inside.map((x, axis) => x - onSide[axis]);
  });
  return reversed ? pairs.reverse() : pairs;
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

test("what the text says of splitting, of the second derivatives and of the tip of the knob", () => {
  const hill = SURFACES.hill().patch(0);
  const parts = hill.split(0.5, 0.5).map((part) => part.controlPoints());
  const points = parts.flatMap((net) => Array.from({ length: 16 }, (_, k) => `${net.slice(3 * k, 3 * k + 3)}`));
  assert.equal(new Set(points).size, 49);
  const lid = Surface.teapot().patch(20);
  for (const u of [0.1, 0.5, 0.9]) {
    const { z = 0 } = lid.normal(u, 0);
    assert.ok(Math.abs(Math.abs(z) - 1) < 1e-12, "one normal at the tip");
  }
  assert.ok(jointAngle(SURFACES.joint()) > 30);
  assert.ok(jointAngle(SURFACES.joint().movePoint(JOINT_POINT.vertex, JOINT_POINT.at)) < 1e-5);
});
