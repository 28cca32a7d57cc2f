// The pictures of the first page, drawn by the package while the site is built. Their scripts (www/home/things) start from them.
import { Curve, InkStroke, Path, Spline } from "casteljau";
import { GLYPHS } from "../glyph/glyphs.js";
import { FIRST_CURVE, graphOf, yOf } from "../home/things/graph.js";
import { LEAF, LEAF_AT, ringOf } from "../home/things/ring.js";

const PRECISION = { precision: 1 };
const [WIDTH, HEIGHT] = [320, 200];

/** Loops that get smaller, drawn with a pressure that follows the direction. */
export function inkPicture() {
  const [LOOPS, SAMPLES] = [4.6, 160];
  const ink = new InkStroke({
    size: 8.5,
    thinning: 0.75,
    smoothing: 0.6,
    streamline: 0,
    taper: { start: 50, end: 60 },
    pressure: "device",
  });
  for (let i = 0; i <= SAMPLES; i++) {
    const part = i / SAMPLES;
    const angle = 2 * Math.PI * LOOPS * part - 2.2;
    const radius = 66 - 40 * part;
    const [across, along] = [radius * Math.cos(angle), 0.6 * radius * Math.sin(angle)];
    const x = 66 + 190 * part + along - 0.35 * across;
    const y = 102 + across - 10 * part;
    ink.append(x, y, { pressure: 0.54 - 0.44 * Math.sin(angle - 0.3) });
  }
  return ink.outline().toSVG(PRECISION);
}

export function easingPicture() {
  return { ...graphOf(FIRST_CURVE), end: yOf(1) };
}

/** The ampersand of the glyph page, fitted into the picture. */
export function glyphPicture() {
  const path = Path.fromSVG(GLYPHS["&"]);
  const { min, max } = /** @type {import("casteljau").Bounds<2>} */ (path.bounds());
  const scale = (0.88 * HEIGHT) / (max.y - min.y);
  const [x, y] = [(min.x + max.x) / 2, (min.y + max.y) / 2];
  return path.transform([scale, 0, 0, scale, WIDTH / 2 - scale * x, HEIGHT / 2 - scale * y]).toSVG(PRECISION);
}

export function shapesPicture() {
  const ring = ringOf(Path);
  const leaf = Path.fromSVG(LEAF).transform([1, 0, 0, 1, LEAF_AT[0], LEAF_AT[1]]);
  return {
    union: ring.union(leaf).toSVG(PRECISION),
    leaf: LEAF,
    at: LEAF_AT.join(" "),
    crossings: ring.intersections(leaf).map(({ point }) => [point.x.toFixed(1), point.y.toFixed(1)]),
  };
}

/** A closed path in space, its shadow, and its rotation-minimizing frames at equal lengths. */
export function cameraPicture() {
  const [RIBS, RIB_LENGTH, GROUND] = [60, 17, -46];
  const points = [
    [-125, -55, 10],
    [-70, 45, 34],
    [40, 62, 2],
    [128, 22, 24],
    [96, -62, -6],
    [-10, -80, 40],
  ];
  const spline = Spline.interpolate(points, { closed: true, dimension: 3 });
  /** x to the right, y into the picture, z up. @param {number[]} point */
  const project = ([x, y, z]) =>
    [154 + x + 0.22 * y, 106 - 0.42 * y - 0.95 * z].map((value) => value.toFixed(1)).join(" ");
  const triples = (/** @type {ArrayLike<number>} */ flat) =>
    Array.from({ length: flat.length / 3 }, (_, i) => [flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]]);
  const pathOf = (/** @type {number[][]} */ all) => `M${project(all[0])}C${all.slice(1).map(project).join(" ")}`;
  const given = triples(spline.controlPoints());
  const control = [...given, given[0]]; // it is closed
  const frames = spline.frames(spline.equidistantTimes(RIBS));
  const binormals = triples(frames.binormals); // they point downwards
  const ribs = triples(frames.points)
    .slice(0, RIBS)
    .map((point, i) => [point, point.map((x, k) => x - RIB_LENGTH * binormals[i][k])].map(project).join("L"));
  return {
    path: pathOf(control),
    shadow: pathOf(control.map(([x, y]) => [x, y, GROUND])),
    ribs: `M${ribs.join("M")}`,
    start: project(control[0]),
  };
}

/** The curve of the sample "home", y up as there: its first half, its polygon and its highest point. */
export function firstCurvePicture() {
  const up = [1, 0, 0, -1, 60, 130];
  const curve = new Curve([
    [0, 0],
    [0, 100],
    [200, 100],
    [200, 0],
  ]).transform(up);
  const [left, right] = curve.split(0.5);
  const { x, y } = curve.eval(0.5);
  return {
    left: left.toSVG(PRECISION),
    right: right.toSVG(PRECISION),
    polygon: `M${curve
      .points()
      .map(({ x, y }) => `${x} ${y}`)
      .join("L")}`,
    x,
    y,
  };
}
