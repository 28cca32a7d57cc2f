// The native results, which `cargo bench` writes to its target folder.
import { readFileSync, statSync } from "node:fs";
import { fileURLToPath } from "node:url";

const root = new URL("../../", import.meta.url);
const target = process.env.CARGO_TARGET_DIR ?? fileURLToPath(new URL("target", root));

/** Older results may belong to another state of the machine or of the code. */
const MAX_AGE_MINUTES = 60;

/** The groups of benches/native: the work, and the number of items of one iteration. */
const GROUPS = [
  { group: "flatten-0.1", work: "native: flatten a cubic, tolerance 0.1", items: 1000, peers: ["kurbo", "lyon_geom"] },
  {
    group: "flatten-0.01",
    work: "native: flatten a cubic, tolerance 0.01",
    items: 1000,
    peers: ["kurbo", "lyon_geom"],
  },
  { group: "offset-0.1", work: "native: offset of a cubic by 10, tolerance 0.1", items: 1000, peers: ["kurbo"] },
  { group: "eval", work: "native: eval(t), one point", items: 1000, peers: ["kurbo", "lyon_geom"] },
  { group: "split", work: "native: split(t)", items: 1000, peers: ["lyon_geom"] },
  { group: "halve", work: "native: halve", items: 1000, peers: ["kurbo", "lyon_geom"] },
  { group: "length", work: "native: length of a cubic, to 1e-9", items: 1000, peers: ["kurbo"] },
  { group: "length-0.001", work: "native: length of a cubic, to 0.001", items: 1000, peers: ["kurbo", "lyon_geom"] },
  { group: "area", work: "native: area of a cubic", items: 1000, peers: ["kurbo"] },
  { group: "inflections", work: "native: inflections of a cubic", items: 1000, peers: ["kurbo"] },
  { group: "bounds", work: "native: bounds of a cubic", items: 1000, peers: ["kurbo"] },
  { group: "time-at-length", work: "native: parameter at a length of a cubic, to 1e-9", items: 1000, peers: ["kurbo"] },
  { group: "path-area", work: "native: area of a path of 1,000 segments", items: 1, peers: ["kurbo"] },
  { group: "flatten-lines", work: "native: flatten a path of 1,000 lines", items: 1, peers: ["kurbo"] },
  { group: "to-svg", work: "native: path data of 1,000 segments", items: 1, peers: ["kurbo"] },
  { group: "dash", work: "native: dashes of a path of 1,000 segments", items: 1, peers: ["kurbo"] },
  { group: "nearest", work: "native: nearest point of a cubic", items: 1000, peers: ["kurbo"] },
  { group: "intersect", work: "native: curve × curve, random pairs", items: 500, peers: ["lyon_geom"] },
  { group: "intersect-9", work: "native: curve × curve, 9 intersections", items: 1, peers: ["lyon_geom"] },
  { group: "union", work: "native: union of 2 × 6,400 cubics", items: 1, peers: ["linesweeper", "i_curve"] },
  { group: "stroke", work: "native: stroke of a cubic, tolerance 0.1, overlapping", items: 1000, peers: ["kurbo"] },
  { group: "stroke-simple", work: "native: stroke of a cubic, without overlaps", items: 1000, peers: [] },
  { group: "simplify", work: "native: simplify an outline of 200 cubics, tolerance 0.1", items: 20, peers: ["kurbo"] },
  { group: "teapot-16", work: "native: teapot, 16 segments, reused", items: 1, peers: [] },
  { group: "teapot-64", work: "native: teapot, 64 segments, reused", items: 1, peers: [] },
];

/** The rows with recent results. */
export function results() {
  return [...GROUPS.flatMap(timeRows), ...segmentRows()];
}

/** @param {(typeof GROUPS)[number]} group */
function timeRows({ group, work, items, peers }) {
  const ours = estimate(group, "casteljau", items);
  if (!ours) return [];
  const row = (/** @type {string | null} */ peer) => {
    const their = peer ? estimate(group, peer, items) : null;
    const [theirs, ratio] = their ? [their.ns, their.ns / ours.ns] : [null, null];
    return {
      id: peer ? `${group}-${peer}` : group,
      work,
      peer,
      unit: "ns",
      theirs,
      ours: ours.ns,
      ratio,
      spread: [their?.spread ?? 0, ours.spread],
    };
  };
  return peers.length ? peers.map(row) : [row(null)];
}

/** The number of segments of 1,000 flattened cubics, which the benchmark counts before it measures times. */
function segmentRows() {
  /** @type {{ tolerance: number, segments: Record<string, number>, worst: Record<string, number> }[]} */
  const counts = json("tmp/flatten.json") ?? [];
  return counts.flatMap(({ tolerance, segments, worst }) =>
    ["kurbo", "lyon_geom"].map((peer) => ({
      id: `flatten-${tolerance}-${peer}-segments`,
      work: `native: flatten 1,000 cubics, tolerance ${tolerance}: segments`,
      peer,
      unit: "segments",
      theirs: segments[peer],
      ours: segments.casteljau,
      ratio: segments[peer] / segments.casteljau,
      spread: [0, 0],
      worstDistanceByTolerance: { theirs: worst[peer], ours: worst.casteljau },
    })),
  );
}

/**
 * The median of a criterion benchmark.
 *
 * @param {string} group
 * @param {string} side
 * @param {number} items
 */
function estimate(group, side, items) {
  const found = json(`criterion/${group}/${side}/new/estimates.json`);
  if (!found) return null;
  const { median, median_abs_dev: deviation } = found;
  return { ns: median.point_estimate / items, spread: deviation.point_estimate / median.point_estimate };
}

/**
 * A file in the target folder; null if it does not exist or is too old.
 *
 * @param {string} name
 * @returns {any}
 */
function json(name) {
  const path = `${target}/${name}`;
  const age = Date.now() - (statSync(path, { throwIfNoEntry: false })?.mtimeMs ?? 0);
  return age < 60_000 * MAX_AGE_MINUTES ? JSON.parse(readFileSync(path, "utf8")) : null;
}
