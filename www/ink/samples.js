// Samples as a hand makes them, for the first stroke of the page and for tests.

/** Milliseconds between samples. */
const INTERVAL = 8;
const LOOPS = 7;

/**
 * Loops like those of joined-up writing, in a box of 600 × 300, at whole units as the events of a mouse have them.
 *
 * @param {number} count of the samples
 * @param {number} seed another shape for each
 * @returns {[x: number, y: number, pressure: number, time: number][]}
 */
export function hand(count, seed) {
  return Array.from({ length: count }, (_, k) => {
    const part = k / (count - 1);
    // A hand is slower at the turns.
    const angle = 2 * Math.PI * LOOPS * part - 0.25 * Math.sin(4 * Math.PI * LOOPS * part);
    const height = 55 + 30 * Math.sin(1.7 * seed + 5 * part);
    const x = 65 + 460 * part - 32 * Math.sin(angle) - 0.35 * height * Math.cos(angle);
    const y = 150 + 12 * Math.sin(seed + 3 * part) + height * Math.cos(angle);
    return [Math.round(x), Math.round(y), 0.5 + 0.35 * Math.sin(angle + 0.6), INTERVAL * k];
  });
}
