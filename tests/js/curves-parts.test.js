// What stands behind the figures of the chapter on curves: plots, maps, the editor's numbers, words, and the pictures of the build.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { posterOf } from "../../www/build/posters.js";
import { bothWays, matrixOf } from "../../www/figures/lib/affine.js";
import { along, jumps } from "../../www/figures/lib/along.js";
import { apart, polylineError } from "../../www/tasks/utils/curves.js";
import { formatNumber, matrixSummary, parseNumber } from "../../www/figures/lib/matrix.js";
import { hermiteSummary, treeSummary } from "../../www/figures/lib/summaries.js";
import { viewAt } from "../../www/figures/lib/zoom.js";
import { near, pointsOf, untyped } from "./reference.js";

test("speed and curvature along a chain jump where the joint says so", () => {
  const chain = new Spline([70, 330, 90, 120, 250, 110, 330, 200, 430, 300, 560, 380, 600, 160]);
  const told = (mode, what) => {
    const { lines, joints } = along((mode ? chain.setJoint(1, mode) : chain).segments(), what);
    const values = lines.flat().map(([, y]) => y);
    assert.equal(lines.length, 2);
    assert.deepEqual([lines[0][0][0], lines[0].at(-1)?.[0], lines[1].at(-1)?.[0]], [0, 1, 2]);
    return jumps(joints[0], Math.max(...values) - Math.min(0, ...values));
  };
  const speeds = [told(null, "speed"), told("g1", "speed"), told("c1", "speed"), told("c2", "speed")];
  assert.deepEqual(speeds, [true, true, false, false]);
  assert.deepEqual([told("c1", "curvature"), told("c2", "curvature")], [true, false]);
  const lasting = along(chain.segments(), "speed", [1, 2]);
  assert.deepEqual(lasting.starts, [0, 1, 3]);
  assert.equal(lasting.lines[1].at(-1)?.[0], 3);
  // |3(P3 − P2)| / 1 and |3(P4 − P3)| / 2
  const { at, before, after } = lasting.joints[0];
  near([at, before, after], [1, 3 * Math.hypot(80, 90), (3 * Math.hypot(100, 100)) / 2], 1e-9);
  const [line] = along([new Curve([0, 0, 30, 40])], "speed").lines;
  assert.ok(line.every(([, speed]) => Math.abs(speed - 50) < 1e-12));
});

test("an affine map does the same to the control points and to the curve", () => {
  for (const [turn, shear, width] of pointsOf("0,0,1 25,0.3,1 -180,-1,0.3")) {
    const { dots, gap } = bothWays({ turn, shear, width });
    assert.ok(gap < 1e-12 && dots.length > 10, String(gap));
  }
  const turned = matrixOf({ turn: 90, shear: 0, width: 1 }).map((x) => Math.round(x) + 0);
  assert.deepEqual(turned, [0, 1, -1, 0, 0, 0]);
});

test("numbers of the matrix are read and written as people do", () => {
  assert.deepEqual(["1", "−1/6", " 2 / 3 ", "-0.5", "1e3"].map(parseNumber), [1, -1 / 6, 2 / 3, -0.5, 1000]);
  for (const wrong of ["", "x", "1/2/3", "NaN", "1/0", "/2", "Infinity"])
    assert.ok(!Number.isFinite(parseNumber(wrong)), wrong);
  const texts = [-1, 0, 0.5, 1 / 6, -2 / 3, 4 / 6, 0.1].map(formatNumber);
  assert.deepEqual(texts, ["−1", "0", "0.5", "1/6", "−2/3", "2/3", "0.1"]);
  for (const name of /** @type {const} */ (["bezier", "hermite", "b-spline", "catmull-rom"])) {
    for (const x of Curve.basisMatrix(name))
      assert.ok(Math.abs(parseNumber(formatNumber(x)) - x) < 1e-15, `${name}: ${x}`);
  }
  assert.match(matrixSummary([...Curve.basisMatrix("b-spline")]), /add up to 1/);
  assert.match(matrixSummary([...Curve.basisMatrix("hermite")]), /do not add up/); // in its own data: ends and velocities
});

test("words and views", () => {
  assert.equal(
    hermiteSummary(untyped(pointsOf("90,370 180,120 440,80 590,330"))),
    "From (90, 370) with the velocity (270, −750), to (590, 330) with (450, 750).",
  );
  assert.equal(hermiteSummary([]), "");
  assert.equal(treeSummary({ segments: 1, error: 26.456 }), "1 piece, measured error 26.46 px.");
  assert.equal(treeSummary({ segments: 64, error: 0.0012 }), "64 pieces, measured error 1.2e-3 px.");
  assert.equal(treeSummary(null), "");
  assert.equal(viewAt(1, { x: 5, y: 5 }), "0 0 670 480");
  assert.equal(viewAt(10, { x: 100, y: 50 }), "66.5 26 67 48");
});

test("distances: a polyline's from its curve, and between curves", () => {
  const arch = new Curve([0, 0, 50, 100, 100, 0]);
  assert.equal(polylineError(arch, 1), 50); // the vertex of the parabola over its chord
  assert.ok(Math.abs(polylineError(arch, 2) - 12.5 * Math.SQRT1_2) < 1e-12); // a quarter, at right angles to a chord that climbs by 1
  assert.equal(apart(arch, arch.elevate()) < 1e-12, true);
  assert.equal(apart(arch, new Curve([0, 0, 50, 0, 100, 0])), 50);
});

test("the build draws an applet as its attributes say", () => {
  const svg = posterOf({ points: "0,0 0,100 100,100 100,0", show: "polygon", label: "An <arch>", id: "x" });
  assert.match(svg, /^<svg [^>]*role="img"/);
  assert.ok(svg.includes("<title>An &lt;arch&gt;</title>"));
  assert.match(svg, /d="M0 0C0 100 100 100 100 0"/);
  for (const name of ["P0", "P1", "P2", "P3"]) assert.ok(svg.includes(`>${name}</text>`), name);
  assert.notEqual(posterOf({ points: "0,0 0,100 100,100 100,0", basis: "hermite" }), svg);
  assert.throws(() => posterOf({ points: "none" }), RangeError);
});
