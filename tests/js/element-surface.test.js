// <bezier-surface> without a page: the numbers below the picture, the figure that pages read, what is refused.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Surface } from "casteljau";
import { RationalSurface } from "casteljau/nurbs";
import { Surface as SurfaceOfOtherEntry } from "#js/surfaces.js";
import { boundingSphereOf, HOME, moved, cameraMatricesOf } from "#js/elements/surface/camera.js";
import { figureOf } from "#js/elements/surface/figure.js";
import { Geometry } from "#js/elements/surface/geometry.js";
import { isocurves, outline } from "#js/elements/surface/lines.js";
import { withPointAt } from "#js/elements/surface/state.js";
import { Subject } from "#js/elements/surface/subject.js";
import { elementOf } from "./element-node.js";

const { BezierSurface } = await import("#js/elements/surface/element.js");

/** What the element shows with these attributes, or of a surface of the page's own. */
function scene(attributes, given = /** @type {Surface | null} */ (null)) {
  const subject = new Subject(() => {});
  subject.editor.replaceState({ ...subject.state, ...attributes, given });
  return subject.scene(null);
}
const facts = (attributes, given = /** @type {Surface | null} */ (null)) =>
  new Geometry().facts(scene(attributes, given));
const [WIDTH, HEIGHT] = [640, 460];
/** The numbers of a mesh by pixels in a view. */
function factsSeen(attributes, view) {
  const geometry = new Geometry();
  const shown = scene(attributes);
  geometry.seen(cameraMatricesOf(moved(HOME, view), boundingSphereOf(shown.surface.vertices, "z"), WIDTH, HEIGHT));
  return geometry.facts(shown);
}
/** A flat square as one patch. */
const flat = (Type = Surface) => {
  const vertices = [0, 1, 2, 3].flatMap((y) => [0, 1, 2, 3].map((x) => [x, y, 0]));
  return new Type({ vertices, patches: [vertices.map((_, k) => k)] });
};

test("triangles and vertices are counted, for the parts that are shown", () => {
  for (const [attributes, triangles, vertices] of /** @type {[object, number, number][]} */ ([
    [{ segments: 5 }, 32 * 2 * 25, 32 * 36],
    [{ segments: 5, evaluation: "gpu" }, 32 * 2 * 25, 32 * 36],
    [{ segments: 5, parts: "body lid" }, 16 * 2 * 25, 16 * 36],
    [{ segments: 5, parts: "" }, 0, 0],
    [{ segments: 64 }, 32 * 2 * 64 ** 2, 32 * 65 ** 2],
    [{ show: "" }, 0, 0],
    [{ show: "isocurves net" }, 0, 0],
    [{ model: "kettle", segments: "many", shading: "shiny", u: -4, tolerance: -1 }, 32 * 2 * 144, 32 * 169],
  ])) {
    const counted = facts(attributes);
    assert.deepEqual([counted.triangles, counted.vertices], [triangles, vertices], JSON.stringify(attributes));
  }
  assert.deepEqual(
    [facts({ evaluation: "gpu" }).ms, facts({ evaluation: "gpu", tolerance: 0.1 }).ms === null],
    [null, false],
  );
});

test("the graphics card evaluates grids of low degrees only", () => {
  const n = 13;
  const vertices = Array.from({ length: n * n }, (_, k) => [k % n, Math.floor(k / n), Math.sin(k)]);
  const high = new Surface({ vertices, patches: [vertices.map((_, k) => k)] }, { degreeU: n - 1, degreeV: n - 1 });
  assert.notEqual(facts({ evaluation: "gpu" }, high).ms, null);
  assert.equal(facts({ evaluation: "gpu" }, flat()).ms, null);
});

test("the original height is 4/3 of the squashed one; with y up it is along y", () => {
  const size = (attributes, axis) => {
    const along = scene(attributes).surface.vertices.filter((_, i) => i % 3 === axis);
    return Math.max(...along) - Math.min(...along);
  };
  for (const [attributes, axis, expected] of /** @type {[object, number, number][]} */ ([
    [{}, 2, 3.15],
    [{ height: "original" }, 2, 4.2],
    [{ up: "y" }, 1, 3.15],
  ]))
    assert.ok(Math.abs(size(attributes, axis) - expected) < 1e-9, JSON.stringify(attributes));
});

test("a finer tolerance makes more triangles; by pixels a view that is smaller, or sees less, is coarser", () => {
  const [coarse, fine] = [facts({ tolerance: 0.05 }), facts({ tolerance: 0.005 })];
  assert.deepEqual([coarse.error, coarse.unit], [0.05, ""]);
  assert.ok(fine.triangles > 4 * coarse.triangles, `${coarse.triangles} and ${fine.triangles}`);
  const [far, small, near] = [1, 0.5, 8].map((zoom) => factsSeen({ pixels: 1 }, { zoom }));
  assert.deepEqual([far.error, far.unit], [1, "px"]);
  assert.ok(far.triangles > 1.6 * small.triangles && near.triangles < far.triangles, `${[far, small, near]}`);
});

test("the recursion of the text leaves cracks, wherever a patch begins; a flat patch stays whole", () => {
  const { triangles, recursion } = facts({ flatness: 0.05 });
  assert.ok(recursion && recursion.pieces > 100 && recursion.depth >= 2 && recursion.cracks > 10);
  assert.equal(triangles, 2 * recursion.pieces);
  const { vertices, patches } = Surface.teapot();
  const turned = new Surface({ vertices, patches: patches.map((net, k) => (k % 2 ? [...net].reverse() : net)) });
  const after = facts({ flatness: 0.05 }, turned).recursion;
  assert.deepEqual([after?.pieces, after?.cracks], [recursion.pieces, recursion.cracks]);
  assert.equal(facts({ tolerance: 0.05 }).recursion, null);
  assert.deepEqual(facts({ flatness: 0.05 }, flat()).recursion, { pieces: 1, depth: 0, cracks: 0, widest: 0 });
});

test("curves as tubes and ribbons are bodies without their surface; more lines are more triangles", () => {
  const [few, many] = [facts({ show: "tubes", lines: 2 }), facts({ show: "tubes", lines: 5 })];
  assert.ok(few.triangles > 1000 && many.triangles > 1.8 * few.triangles, `${few.triangles} and ${many.triangles}`);
  const surface = { model: "patch", show: "surface" };
  assert.ok(facts({ ...surface, show: "surface ribbons" }).triangles > facts(surface).triangles);
});

test("the description of the figure names what is shown", () => {
  const shown = scene({ model: "patch", segments: 4, u: 1, v: 0 });
  const figure = figureOf(shown, new Geometry().facts(shown));
  assert.deepEqual([figure.model, figure.segments, figure.degreeU, figure.points.length], ["patch", 4, 3, 16]);
  assert.deepEqual(
    [figure.points[3], figure.place?.point],
    [
      [3, -3, 0.5],
      [3, -3, 0.5],
    ],
    "S(1, 0) is the fourth point",
  );
  assert.deepEqual([figure.mesh.triangles, figure.mesh.vertices], [32, 25]);
  const fine = scene({ model: "patch", tolerance: 0.05 });
  const { segments, tolerance, mesh } = /** @type {any} */ (figureOf(fine, new Geometry().facts(fine)));
  assert.deepEqual([segments, tolerance, mesh.error], [null, 0.05, 0.05]);
});

test("a probe has its nearest point; what is no point has none", () => {
  const nearest = (probe) => figureOf(scene({ model: "patch", probe }), null).nearest;
  const found = nearest("3 -3, 4");
  const away = (u, v) => {
    const { x, y, z = 0 } = scene({ model: "patch" }).surface.patch(0).eval(u, v);
    return Math.hypot(x - 3, y + 3, z - 4);
  };
  assert.ok(found && Math.abs(away(found.u, found.v) - found.distance) < 1e-12);
  for (let k = 0; k < 121; k++) assert.ok(away((k % 11) / 10, Math.floor(k / 11) / 10) >= found.distance - 1e-12);
  for (const none of ["", "1 2", "1 2 x", "1 2 3 4", "NaN 0 0", null]) assert.equal(nearest(none), null, `${none}`);
});

test("a surface of another entry point is taken; what is none is refused; undefined means the model and the first view", () => {
  const element = elementOf(BezierSurface);
  const first = element.view;
  element.surface = flat(/** @type {any} */ (SurfaceOfOtherEntry));
  assert.deepEqual([element.surface.patchCount, element.figure.model], [1, "teapot"]);
  const copied = "object without keys; structuredClone and postMessage need toJSON() and fromJSON()";
  /** @type {[any, string][]} */
  const others = [
    [7, "number"],
    [{ casteljauType: "mesh" }, "object"],
    [structuredClone(element.surface), copied],
  ];
  for (const [wrong, got] of others) {
    const message = `surface: expected a Surface or null, got ${got}`;
    assert.throws(() => (element.surface = wrong), { name: "TypeError", message });
  }
  assert.equal(element.surface.patchCount, 1);
  element.view = { turn: 10, zoom: 3 };
  assert.deepEqual([element.view.turn, element.view.zoom], [10, 3]);
  element.surface = undefined;
  element.view = undefined;
  assert.deepEqual([element.surface.patchCount, element.view], [32, first]);
});

test("moved points: one after the other, all at once and after undo, the surface is the same", () => {
  const moves = [5, 40, 5, 17].map((vertex, k) => /** @type {const} */ ([vertex, [k, -k, 2 * k]]));
  const moved = (/** @type {typeof moves} */ some) =>
    some.reduce((surface, [vertex, to]) => surface.movePoint(vertex, to), Surface.teacup()).vertices;
  const subject = new Subject(() => {});
  const { editor } = subject;
  editor.replaceState({ ...subject.state, model: "teacup" });
  for (const [k, [vertex, to]] of moves.entries()) {
    editor.dispatch((state) => withPointAt(state, subject.modelKey, vertex, [...to]), { by: "user" });
    assert.deepEqual(subject.surface.vertices, moved(moves.slice(0, k + 1)));
  }
  editor.undo();
  editor.undo();
  assert.deepEqual(subject.surface.vertices, moved(moves.slice(0, 2)));
  editor.redo();
  editor.redo();
  const other = new Subject(() => {});
  other.editor.replaceState(subject.state);
  for (const { surface } of [subject, other]) assert.deepEqual(surface.vertices, moved(moves));
});

test("isocurves and sides of surfaces with weights are drawn through the points of their rational curves", () => {
  let seed = 1;
  const random = () => {
    seed = (seed * 16807) % 2147483647;
    return seed / 2147483647;
  };
  const numbers = (count, make) => Array.from({ length: count }, make);
  for (const exponent of [0, 1, 20, 400]) {
    const surface = new RationalSurface(
      {
        vertices: numbers(12, () => numbers(3, () => 2 * random() - 1)),
        patches: [numbers(12, (_, k) => k)],
        weights: [numbers(12, () => 2 ** (exponent * (2 * random() - 1)))],
      },
      { degreeU: 3, degreeV: 2 },
    );
    const patch = surface.patch(0);
    const sides = [0, 1].flatMap((end) => [patch.isocurveAtU(end), patch.isocurveAtV(end)]);
    for (const [pieces, curves] of /** @type {[Float32Array, import("casteljau/nurbs").RationalCurve<3>[]][]} */ ([
      [isocurves(/** @type {any} */ (surface), 3), surface.isocurves({ lines: 3 })],
      [outline(/** @type {any} */ (patch)), sides],
    ])) {
      const segments = pieces.length / 6 / curves.length;
      const expected = curves.flatMap((curve) => {
        const points = curve.sample(segments);
        return numbers(segments, (_, k) => [...points.subarray(3 * k, 3 * k + 6)]).flat();
      });
      assert.equal(pieces.length, expected.length);
      for (const [k, value] of expected.entries()) assert.ok(Math.abs(pieces[k] - value) < 1e-6, `2^${exponent}: ${k}`);
    }
  }
});
