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
  "sample-reused": { minRatio: 12 },
  "sample-fresh": { minRatio: 8 },
  eval: { minRatio: 1 },
  split: { minRatio: 5 },
  offset: { minRatio: 100 },
  length: { minRatio: 3 },
  nearest: { minRatio: 5 },
  easing: { minRatio: 1 / 1.5 },

  "path-paper": { minRatio: 5 },
  "path-properties": { minRatio: 5 },

  "intersect-9-bezier-js": { minRatio: 500 },
  "intersect-9-paper": { minRatio: 20 },
  "intersect-paper": { minRatio: 20 },
  "intersect-lyon_geom": { minRatio: 1 },
  "intersect-9-lyon_geom": { minRatio: 1 },

  "teapot-16-reused-three": { minRatio: 40 },
  "teapot-64-reused-three": { minRatio: 40 },
  "teapot-16-reused-loop": { minRatio: 3 },
  "teapot-64-reused-loop": { minRatio: 3 },

  "adaptive-verb": { minRatio: 100 },
  "adaptive-triangles": { max: 13_500 },
  "adaptive-triangle": { max: 200 }, // ns

  "first-call": { max: 5e6 }, // ns
  size: { max: 40_000 }, // bytes
  "size-elements": { max: 45_000 },
  frame: { max: 4e6 }, // ns

  "growth-segments": { max: 2 },
  "growth-patches": { max: 2 },
  "growth-sample": { max: 2 },
  "growth-equidistant": { max: 2 },
  "growth-path": { max: 2 },
  "growth-nearest": { max: 2 },
  "growth-interpolate": { max: 2 },
  "growth-move": { max: 2 },

  "length-kurbo": { minRatio: 1 },
  "length-0.001-lyon_geom": { minRatio: 1 },
  "length-0.001-kurbo": { minRatio: 1 },

  "offset-0.1-kurbo": { minRatio: 1 },
  "flatten-0.1-kurbo": { minRatio: 1 },
  "flatten-0.01-kurbo": { minRatio: 1 },
  "nearest-kurbo": { minRatio: 1 },
  "flatten-0.1-kurbo-segments": { minRatio: 1 },
  "flatten-0.01-kurbo-segments": { minRatio: 1 },
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
