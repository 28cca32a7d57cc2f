// Fitting cubics to the points of a pen stroke, and simplifying icons, compared with paper.js.
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { Path, Spline } from "casteljau";
import paper from "paper/dist/paper-core.js";
import { hand } from "../../www/ink/samples.js";

const COUNT = 2_000;
const TOLERANCE = 1;
const points = hand(COUNT, 3).map(([x, y]) => [x, y]);
paper.setup(new paper.Size(100, 100));

const fitted = () => Spline.fit(points, { tolerance: TOLERANCE });

/** The fit by paper.js, whose tolerance is compared with squared distances. */
function byPaper() {
  const path = new paper.Path({ segments: points });
  path.simplify(TOLERANCE ** 2);
  const { curves } = path;
  path.remove();
  return curves;
}

const [ours, theirs] = [fitted().segmentCount, byPaper().length];

/** Our spline is within the tolerance of every point, with fewer segments. */
function check() {
  const spline = fitted();
  const farthest = Math.max(...points.map((point) => spline.nearest(point).distance));
  if (!(farthest <= TOLERANCE && ours < theirs)) throw new Error(`fit: ${farthest}, ${ours} ${theirs}`);
}

/** Every 40th icon of bootstrap-icons is taken. */
const EVERY = 40;
/** 0.5 % of the size of the icons, 16. */
const ICON_TOLERANCE = 0.08;
/** Points of each segment at which distances are measured. */
const SAMPLES = 8;

const icons = new URL("icons/", `file://${createRequire(import.meta.url).resolve("bootstrap-icons/package.json")}`);
const drawings = readdirSync(icons)
  .filter((_, k) => k % EVERY === 0)
  .flatMap((file) => [...readFileSync(new URL(file, icons), "utf8").matchAll(/ d="([^"]*)"/g)])
  .map(([, d]) => Path.fromSVG(d));

/** The drawings as paths of paper.js. Its `simplify` changes a path, so each run takes copies. */
const originals = drawings.map((path) => new paper.CompoundPath(path.toSVG()));
function simplifiedByPaper() {
  return originals.map((drawing) => {
    const copy = drawing.clone({ insert: false });
    for (const path of copy.children ?? []) path.simplify(ICON_TOLERANCE ** 2);
    return copy;
  });
}
const simplified = () => drawings.map((path) => path.simplify(ICON_TOLERANCE));

/** @param {Path[]} paths */
const segmentCount = (paths) =>
  paths.flatMap((path) => path.subpaths).reduce((sum, spline) => sum + spline.segmentCount, 0);

/** The greatest distance of points of two paths from the other one. @param {Path} a @param {Path} b */
function distance(a, b) {
  const oneWay = (/** @type {Path} */ from, /** @type {Path} */ to) => {
    const points = from.subpaths.flatMap((spline) => [...spline.sample(SAMPLES * spline.segmentCount)]);
    let farthest = 0;
    for (let k = 0; k < points.length; k += 2)
      farthest = Math.max(farthest, to.nearest([points[k], points[k + 1]])?.distance ?? Infinity);
    return farthest;
  };
  return Math.max(oneWay(a, b), oneWay(b, a));
}

const [ourIcons, theirIcons] = [simplified(), simplifiedByPaper().map((copy) => Path.fromSVG(copy.pathData))];
const [ourCount, theirCount] = [ourIcons, theirIcons].map(segmentCount);
/** @param {Path[]} icons */
const farthest = (icons) => Math.max(...icons.map((icon, k) => distance(icon, drawings[k])));
const [ourDistance, theirDistance] = [ourIcons, theirIcons].map(farthest);

/** Ours are within the tolerance both ways. */
function checkIcons() {
  if (!(ourDistance <= ICON_TOLERANCE)) throw new Error(`simplify: ${ourDistance}`);
}

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    id: "fit-paper",
    work: `fit of ${COUNT.toLocaleString("en-US")} points by ${ours} cubics, paper.js ${theirs}`,
    peer: "paper.js simplify",
    items: 1,
    check,
    theirs: () => byPaper().length,
    ours: () => fitted().segmentCount,
  },
  {
    id: "simplify-icons-paper",
    work: `${drawings.length} paths of icons: ${segmentCount(drawings)} segments become ${ourCount} within ${ourDistance.toFixed(3)}, paper.js ${theirCount} within ${theirDistance.toFixed(3)}`,
    peer: "paper.js simplify",
    items: drawings.length,
    check: checkIcons,
    theirs: () => simplifiedByPaper().length,
    ours: () => simplified().length,
  },
];
