// Fitting cubics to the points of a pen stroke, compared with paper.js.
import { Spline } from "casteljau";
import paper from "paper/dist/paper-core.js";
import { hand } from "../../www/ink/samples.js";

const COUNT = 2_000;
const TOLERANCE = 1;
const points = hand(COUNT, 3).map(([x, y]) => [x, y]);
paper.setup(new paper.Size(100, 100));

const fitted = () => Spline.fit(points, { tolerance: TOLERANCE });

/** Its tolerance is compared with squared distances. */
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
];
