// Seeded inputs, equal in every run on every machine.

/**
 * Random numbers in [0, 1), the same for the same seed (mulberry32, by Tommy Ettinger).
 *
 * @param {number} seed
 * @returns {() => number}
 */
export function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/**
 * 2D cubics with random control points in a square of 200 units, as flat lists of 8 coordinates.
 *
 * @param {number} count
 * @returns {number[][]}
 */
export function cubics(count) {
  const next = random(1);
  return Array.from({ length: count }, () => Array.from({ length: 8 }, () => 200 * next()));
}

/**
 * Parameters strictly between 0 and 1.
 *
 * @param {number} count
 * @returns {Float64Array}
 */
export function parameters(count) {
  const next = random(2);
  return Float64Array.from({ length: count }, () => 0.001 + 0.998 * next());
}
