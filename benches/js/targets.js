// What is asked of each row: all targets of the benchmarks, in one place.

/**
 * `least`: ours must be at least so many times as fast (or small) as the peer; 1 means "not slower".
 * `most`: our own number must not be above this, in the row's unit.
 * A row that is not listed here is only reported.
 *
 * @typedef {{ least?: number, most?: number }} Target
 */

/** @type {Record<string, Target>} */
export const TARGETS = {
  "sample-reused": { least: 12 },
  "sample-fresh": { least: 8 },
  eval: { least: 1 },
  split: { least: 5 },
  offset: { least: 100 },
  length: { least: 3 },
  nearest: { least: 5 },
  easing: { least: 1 / 1.5 },

  "path-paper": { least: 5 },
  "path-properties": { least: 5 },

  "intersect-9-bezier-js": { least: 500 },
  "intersect-9-paper": { least: 20 },
  "intersect-paper": { least: 20 },
  "intersect-lyon_geom": { least: 1 },
  "intersect-9-lyon_geom": { least: 1 },

  "teapot-16-reused-three": { least: 40 },
  "teapot-64-reused-three": { least: 40 },
  "teapot-16-reused-loop": { least: 3 },
  "teapot-64-reused-loop": { least: 3 },

  "adaptive-verb": { least: 100 },
  "adaptive-triangles": { most: 13_500 },
  "adaptive-triangle": { most: 200 }, // ns

  "first-call": { most: 5e6 }, // ns
  size: { most: 40_000 }, // bytes
  "size-elements": { most: 45_000 },
  frame: { most: 4e6 }, // ns

  "growth-segments": { most: 2 },
  "growth-patches": { most: 2 },
  "growth-sample": { most: 2 },
  "growth-evenly": { most: 2 },
  "growth-path": { most: 2 },
  "growth-nearest": { most: 2 },
  "growth-through": { most: 2 },
  "growth-move": { most: 2 },

  "length-kurbo": { least: 1 },
  "length-0.001-lyon_geom": { least: 1 },
  "length-0.001-kurbo": { least: 1 },

  "offset-0.1-kurbo": { least: 1 },
  "flatten-0.1-kurbo": { least: 1 },
  "flatten-0.01-kurbo": { least: 1 },
  "nearest-kurbo": { least: 1 },
  "flatten-0.1-kurbo-segments": { least: 1 },
  "flatten-0.01-kurbo-segments": { least: 1 },
};

/**
 * A result with its target and whether it is met (`null`: there is none).
 *
 * @template {{ id: string, ours: number, ratio: number | null }} Result
 * @param {Result} result
 */
export function judged(result) {
  const target = TARGETS[result.id] ?? null;
  return { ...result, target, met: target && isMet(target, result) };
}

/**
 * @param {Target} target
 * @param {{ ours: number, ratio: number | null }} result
 */
function isMet({ least, most }, { ours, ratio }) {
  if (least !== undefined && !(ratio !== null && ratio >= least)) return false;
  return most === undefined || ours <= most;
}
