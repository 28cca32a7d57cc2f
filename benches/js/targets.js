// The targets of all rows.

/**
 * `minRatio`: the smallest allowed ratio to the peer, 1 means "not slower" (or "not larger").
 * `max`: the largest allowed result of this package, in the row's unit.
 * Rows without a target are only reported.
 *
 * @typedef {{ minRatio?: number, max?: number }} Target
 */

/** @type {Record<string, Target>} */
export const TARGETS = {
  "sample-reused": { minRatio: 15 },
  "sample-fresh": { minRatio: 8 },
  eval: { minRatio: 2 },
  split: { minRatio: 6 },
  offset: { minRatio: 120 },
  length: { minRatio: 5 },
  nearest: { minRatio: 8 },
  easing: { minRatio: 1 },
  "nurbs-eval-verb": { minRatio: 5 },
  "nurbs-length-verb": { minRatio: 5 },
  "nurbs-nearest-verb": { minRatio: 5 },
  "nurbs-sphere-verb": { minRatio: 10 },
  "nurbs-torus-verb": { minRatio: 10 },
  "fit-paper": { minRatio: 10 },

  "again-point-at-length": { max: 2_000 }, // ns
  "again-nearest": { max: 4_000 },
  "again-contains": { max: 2_000 },
  "again-nearest-of": { max: 100_000 },

  "scroll-curves": { max: 50_000_000 }, // ns
  "scroll-surfaces": { max: 50_000_000 },
  "scroll-ink": { max: 50_000_000 },

  "path-paper": { minRatio: 8 },
  "path-properties": { minRatio: 20 },

  "union-paper": { minRatio: 15 },
  "union-pathkit": { minRatio: 1 },
  "union-icons-paper": { minRatio: 5 },
  "stroke-pathkit": { minRatio: 1 },

  "area-kurbo": { minRatio: 1 },
  "inflections-kurbo": { minRatio: 1 },
  "bounds-kurbo": { minRatio: 1 },
  "time-at-length-kurbo": { minRatio: 0.5 },
  "path-area-kurbo": { minRatio: 1 },
  "flatten-lines-kurbo": { minRatio: 1 },
  "to-svg-kurbo": { minRatio: 0.7 },
  "dash-kurbo": { minRatio: 1 },

  "intersect-9-bezier-js": { minRatio: 500 },
  "intersect-9-paper": { minRatio: 8 },
  "intersect-paper": { minRatio: 6 },
  "intersect-lyon_geom": { minRatio: 1.5 },
  "intersect-9-lyon_geom": { minRatio: 2 },

  "teapot-16-reused-three": { minRatio: 40 },
  "teapot-64-reused-three": { minRatio: 60 },
  "teapot-16-reused-loop": { minRatio: 3.5 },
  "teapot-64-reused-loop": { minRatio: 3.5 },

  "adaptive-verb": { minRatio: 70 },
  "adaptive-triangles": { max: 13_500 },
  "adaptive-triangle": { max: 200 }, // ns

  "first-call": { max: 5e6 }, // ns
  size: { max: 365_000 }, // bytes
  "size-elements": { max: 45_000 },
  frame: { max: 4e6 }, // ns
  scroll: { max: 50e6 }, // ns

  "growth-segments": { max: 1.25 },
  "growth-patches": { max: 1.25 },
  "growth-sample": { max: 1.25 },
  "growth-equidistant": { max: 1.25 },
  "growth-path": { max: 1.25 },
  "growth-nearest": { max: 1.25 },
  "growth-interpolate": { max: 1.25 },
  "growth-move": { max: 1.25 },

  "union-linesweeper": { minRatio: 1.5 },
  "union-i_curve": { minRatio: 1.5 },
  "stroke-kurbo": { minRatio: 1.2 },
  "split-lyon_geom": { minRatio: 0.6 },
  "halve-kurbo": { minRatio: 1 },
  "halve-lyon_geom": { minRatio: 1 },
  "eval-kurbo": { minRatio: 1 },
  "eval-lyon_geom": { minRatio: 1 },
  "length-kurbo": { minRatio: 2 },
  "length-0.001-lyon_geom": { minRatio: 1 },
  "length-0.001-kurbo": { minRatio: 1 },

  "offset-0.1-kurbo": { minRatio: 1.2 },
  "flatten-0.1-kurbo": { minRatio: 1.5 },
  "flatten-0.01-kurbo": { minRatio: 2 },
  "flatten-0.1-lyon_geom": { minRatio: 0.6 },
  "flatten-0.01-lyon_geom": { minRatio: 1 },
  "nearest-kurbo": { minRatio: 3 },
  "flatten-0.1-kurbo-segments": { minRatio: 0.8 },
  "flatten-0.01-kurbo-segments": { minRatio: 0.8 },
};

/**
 * Adds the target of a result and whether it is met (null without a target).
 *
 * @template {{ id: string, ours: number, ratio: number | null }} Result
 * @param {Result} result
 */
export function withVerdict(result) {
  const target = TARGETS[result.id] ?? null;
  return { ...result, target, met: target && isMet(target, result) };
}

/**
 * @param {Target} target
 * @param {{ ours: number, ratio: number | null }} result
 */
function isMet({ minRatio, max }, { ours, ratio }) {
  if (minRatio !== undefined && !(ratio !== null && ratio >= minRatio)) return false;
  return max === undefined || ours <= max;
}
