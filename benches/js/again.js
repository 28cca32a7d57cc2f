// Questions that a large path is asked again and again, compared with paper.js, which keeps lengths and boxes, too.
import { Path } from "casteljau";
import paper from "paper/dist/paper-core.js";
import { random } from "./inputs.js";

const SEGMENTS = 6000;
const SIZE = 100;
const CALLS = 100;
/** paper.js compares all segments: 60 ms for each call. */
const FEW_CALLS = 4;

paper.setup(new paper.Size(100, 100));

/** A closed outline of smooth cubics around the origin, with many bays. */
function outline() {
  const point = (/** @type {number} */ k) => {
    const angle = (2 * Math.PI * k) / (3 * SEGMENTS);
    const radius = SIZE * (1 + 0.3 * Math.sin(40 * angle) + 0.1 * Math.sin(333 * angle));
    return `${radius * Math.cos(angle)} ${radius * Math.sin(angle)}`;
  };
  let d = `M${point(0)}`;
  for (let k = 0; k < SEGMENTS; k++) d += `C${point(3 * k + 1)} ${point(3 * k + 2)} ${point(3 * k + 3)}`;
  return `${d}Z`;
}

const d = outline();
const [theirs, ours] = [new paper.Path(d), Path.fromSVG(d)];
const length = ours.length();
const next = random(11);
const queries = Array.from({ length: CALLS }, () => [3 * SIZE * (next() - 0.5), 3 * SIZE * (next() - 0.5)]);
const fewQueries = queries.slice(0, FEW_CALLS);
const lengths = queries.map(() => next() * length);

/** Small paths for a pointer that moves over them: 500 of 40 segments. */
const drawing = Array.from({ length: 500 }, (_, k) => {
  const at = (/** @type {number} */ i) => `${(k % 25) * 12 + i * 0.25} ${Math.floor(k / 25) * 12 + 4 * Math.sin(i)}`;
  return `M${Array.from({ length: 41 }, (_, i) => at(i)).join("L")}`;
});
const [theirDrawing, ourDrawing] = [drawing.map((d) => new paper.Path(d)), drawing.map((d) => Path.fromSVG(d))];
const pointers = Array.from({ length: FEW_CALLS }, () => [300 * next(), 240 * next()]);

/** @param {number} a @param {number} b @param {number} tolerance @param {string} what */
function assertNear(a, b, tolerance, what) {
  if (!(Math.abs(a - b) <= tolerance)) throw new Error(`${what}: ${a}, paper.js ${b}`);
}

/** @param {number[]} q */
const theirHit = (q) => Math.min(...theirDrawing.map((path) => path.getNearestLocation(q).distance));
const ourIndex = Path.index(ourDrawing);
/** @param {number[]} q */
const ourHit = (q) => /** @type {{ distance: number }} */ (ourIndex.nearest(q)).distance;

/**
 * @template T
 * @param {readonly T[]} list
 * @param {(item: T) => number} measure
 */
const sum = (list, measure) => list.reduce((total, item) => total + measure(item), 0);

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    id: "again-point-at-length",
    work: "point at a length of a path of 6,000 segments, asked again",
    peer: "paper.js getPointAt",
    items: CALLS,
    check: () => {
      assertNear(length, theirs.length, 1e-6 * length, "length");
      for (const s of lengths) {
        const [a, b] = [/** @type {any} */ (ours.pointAtLength(s)).point, theirs.getPointAt(s)];
        assertNear(Math.hypot(a.x - b.x, a.y - b.y), 0, 1e-2, `point at ${s}`);
      }
    },
    theirs: () => sum(lengths, (s) => theirs.getPointAt(s).x),
    ours: () => sum(lengths, (s) => /** @type {any} */ (ours.pointAtLength(s)).point.x),
  },
  {
    id: "again-nearest",
    work: "nearest point of a path of 6,000 segments, asked again",
    peer: "paper.js getNearestLocation",
    items: FEW_CALLS,
    rounds: 9,
    check: () => {
      for (const q of fewQueries) {
        const [a, b] = [/** @type {any} */ (ours.nearest(q)).distance, theirs.getNearestLocation(q).distance];
        if (!(a <= b + 1e-9 && a > b - 1e-2)) throw new Error(`nearest: ${a}, paper.js ${b}`);
      }
    },
    theirs: () => sum(fewQueries, (q) => theirs.getNearestLocation(q).distance),
    ours: () => sum(fewQueries, (q) => /** @type {any} */ (ours.nearest(q)).distance),
  },
  {
    id: "again-contains",
    work: "point in a path of 6,000 segments, asked again",
    peer: "paper.js contains",
    items: CALLS,
    check: () => {
      for (const q of queries) if (ours.contains(q) !== theirs.contains(q)) throw new Error(`contains: ${q}`);
    },
    theirs: () => sum(queries, (q) => +theirs.contains(q)),
    ours: () => sum(queries, (q) => +ours.contains(q)),
  },
  {
    id: "again-nearest-of",
    work: "nearest of 500 paths of 40 segments",
    peer: "paper.js getNearestLocation of all",
    items: FEW_CALLS,
    rounds: 9,
    check: () => {
      for (const q of pointers) assertNear(ourHit(q), theirHit(q), 1e-9, "nearest of all");
    },
    theirs: () => sum(pointers, theirHit),
    ours: () => sum(pointers, ourHit),
  },
];
