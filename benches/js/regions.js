// Boolean operations and strokes of paths, compared with paper.js and with PathKit (Skia compiled to wasm).
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { Path } from "casteljau";
import paper from "paper/dist/paper-core.js";
import { assertSame } from "./harness.js";
import { cubics, random } from "./inputs.js";

/** PathKit calculates with 32 bits. */
const THEIR_TOLERANCE = 1e-4;
const isQuick = process.argv.includes("--quick");
/** The cubics of each of the two large outlines, and the strokes; fewer in a quick run, which only compares results. */
const [COUNT, STROKES] = isQuick ? [400, 100] : [6400, 1000];
const ICONS = 32;
const WIDTH = 10;

const require = createRequire(import.meta.url);
/** In Node it would fetch its wasm file by a path, which is not an address. */
const wasmBinary = readFileSync(require.resolve("pathkit-wasm/bin/pathkit.wasm"));
const PathKit = await require("pathkit-wasm/bin/pathkit.js")({ wasmBinary });
paper.setup(new paper.Size(100, 100));

/**
 * A closed smooth outline with small random waves around a circle.
 *
 * @param {() => number} next
 * @param {number} count the number of cubics
 * @param {[number, number]} centre
 * @param {number} radius
 * @param {number} wave the depth of the waves, relative to the radius
 */
function outline(next, count, centre, radius, wave) {
  const radii = Array.from({ length: count }, () => radius * (1 - wave * next()));
  const at = (/** @type {number} */ k) => {
    const angle = (2 * Math.PI * (k % count)) / count;
    const r = radii[k % count];
    return [centre[0] + r * Math.cos(angle), centre[1] + r * Math.sin(angle)];
  };
  const handle = (/** @type {number} */ k, /** @type {number} */ sign) => {
    const [[x, y], [x0, y0], [x1, y1]] = [at(k), at(k + count - 1), at(k + 1)];
    return [x + (sign * (x1 - x0)) / 6, y + (sign * (y1 - y0)) / 6];
  };
  let d = `M${at(0)}`;
  for (let k = 0; k < count; k++) d += `C${handle(k, 1)} ${handle(k + 1, -1)} ${at(k + 1)}`;
  return `${d}Z`;
}

/** Two shapes of 8 cubics that overlap, each with a hole. */
function icons() {
  const next = random(4);
  return Array.from({ length: ICONS }, () =>
    [0, 0.6].map((x) => {
      const centre = /** @type {[number, number]} */ ([10 + 10 * x, 10 + 4 * next()]);
      return `${outline(next, 8, centre, 9, 0.5)}${outline(next, 4, centre, 3, 0.3)}`;
    }),
  );
}

/** @param {string[]} data path data of both outlines */
function sides(data) {
  const [a, b] = data.map((d) => Path.fromSVG(d));
  const [p, q] = data.map((d) => new paper.CompoundPath(d));
  const [s, t] = data.map((d) => PathKit.FromSVGString(d));
  return {
    ours: () => a.union(b, EVEN_ODD),
    byPaper: () => {
      p.fillRule = "evenodd";
      q.fillRule = "evenodd";
      return p.unite(q, { insert: false });
    },
    byPathKit: () => {
      for (const path of [s, t]) path.setFillType(PathKit.FillType.EVENODD);
      return PathKit.MakeFromOp(s, t, PathKit.PathOp.UNION);
    },
  };
}
/** The fill rule does not depend on how the holes of the icons run. */
const EVEN_ODD = /** @type {const} */ ({ fillRule: "evenodd" });

const large = () => {
  const next = random(5);
  return sides([outline(next, COUNT, [500, 500], 400, 0.02), outline(next, COUNT, [504, 502], 400, 0.02)]);
};
/** @type {ReturnType<typeof large> | undefined} */
let made;
const rings = () => (made ??= large());
const pairs = icons().map(sides);

/**
 * The area of a result of PathKit, and its deletion.
 *
 * @param {any} path
 */
function areaAndDelete(path) {
  const area = Path.fromSVG(path.toSVGString()).area(EVEN_ODD);
  path.delete();
  return area;
}

/** @param {any} path */
function useAndDelete(path) {
  const empty = path.isEmpty?.() ?? 0;
  path.delete();
  return Number(empty);
}

/** @param {{ ours: () => Path, byPaper: () => any, byPathKit: () => any }} side */
function checkPaper({ ours, byPaper }) {
  const area = ours().area();
  assertSame("area of the union", [Math.abs(byPaper().area)], [area], THEIR_TOLERANCE * area);
}

/** @param {{ ours: () => Path, byPathKit: () => any }} side */
function checkPathKit({ ours, byPathKit }) {
  const area = ours().area();
  assertSame("area of the union", [areaAndDelete(byPathKit())], [area], THEIR_TOLERANCE * area);
}

const strokes = cubics(STROKES).map((p) => `M${p.slice(0, 2)}C${p.slice(2)}`);
const ourPaths = strokes.map((d) => Path.fromSVG(d));
const theirPaths = strokes.map((d) => PathKit.FromSVGString(d));
/** @type {import("casteljau").StrokeOptions} */
const ROUND = { join: "round", cap: "round", tolerance: 0.1, simple: false };

function strokesByPathKit() {
  let sum = 0;
  for (const path of theirPaths) {
    const copy = path.copy();
    copy.stroke({ width: WIDTH, join: PathKit.StrokeJoin.ROUND, cap: PathKit.StrokeCap.ROUND });
    sum += useAndDelete(copy);
  }
  return sum;
}

/** The areas of both strokes agree for most curves; PathKit's strokes of tight turns are wrong. */
function checkStrokes() {
  const same = strokes.filter((_, k) => {
    const copy = theirPaths[k].copy();
    copy.stroke({ width: WIDTH, join: PathKit.StrokeJoin.ROUND, cap: PathKit.StrokeCap.ROUND });
    copy.simplify();
    const area = ourPaths[k].stroke(WIDTH, { ...ROUND, simple: true }).area();
    return Math.abs(areaAndDelete(copy) - area) < 5e-3 * area;
  });
  if (same.length < 0.9 * strokes.length) throw new Error(`stroke: only ${same.length} of ${STROKES} areas agree`);
}

/** @param {import("casteljau").StrokeOptions} options */
const ourStrokes = (options) => () => ourPaths.reduce((sum, path) => sum + path.stroke(WIDTH, options).subpathCount, 0);

const UNION = { work: `union of 2 × ${COUNT.toLocaleString("en-US")} cubics`, items: 1, rounds: 9 };
const STROKE = { peer: "PathKit stroke, overlapping", items: STROKES, check: checkStrokes, theirs: strokesByPathKit };

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    ...UNION,
    id: "union-paper",
    peer: "paper.js unite",
    check: () => checkPaper(rings()),
    theirs: () => rings().byPaper().children?.length ?? 1,
    ours: () => rings().ours().subpathCount,
  },
  {
    ...UNION,
    id: "union-pathkit",
    peer: "PathKit op",
    check: () => checkPathKit(rings()),
    theirs: () => useAndDelete(rings().byPathKit()),
    ours: () => rings().ours().subpathCount,
  },
  {
    id: "union-icons-paper",
    work: "union of two icons of 12 cubics",
    peer: "paper.js unite",
    items: ICONS,
    check: () => pairs.forEach(checkPaper),
    theirs: () => pairs.reduce((sum, pair) => sum + pair.byPaper().area, 0),
    ours: () => pairs.reduce((sum, pair) => sum + pair.ours().subpathCount, 0),
  },
  { ...STROKE, id: "stroke-pathkit", work: "stroke of a cubic, overlapping", ours: ourStrokes(ROUND) },
  {
    ...STROKE,
    id: "stroke-simple-pathkit",
    work: "stroke of a cubic, ours without overlaps",
    ours: ourStrokes({ ...ROUND, simple: true }),
  },
];
