// Measures times: both sides in turn after a warm-up, medians of many rounds, results used.

/**
 * One row: the same work done by a peer and by this package. Both functions return a number that depends on the result.
 *
 * @typedef {object} Row
 * @property {string} id as in targets.js
 * @property {string} work
 * @property {string} peer
 * @property {number} items how many times one call does the work
 * @property {number} [rounds] fewer rounds than usual, for calls that take seconds
 * @property {() => void} check throws if the two sides give different results
 * @property {() => number} theirs
 * @property {() => number} ours
 */

/**
 * The number of rounds, and the time in ms for one batch and for the warm-up.
 *
 * @typedef {{ rounds: number, batchMs: number, warmUpMs: number }} Effort
 */

/** @type {Effort} */
export const FULL = { rounds: 31, batchMs: 10, warmUpMs: 300 };
/** To check that everything runs; the times are meaningless. */
export const QUICK = { rounds: 1, batchMs: 0, warmUpMs: 0 };

/** The sum of all results, so that the compiler cannot remove the work. */
let sink = 0;

/**
 * Checks that both sides agree, then measures them in turn.
 *
 * @param {Row} row
 * @param {Effort} effort
 */
export function compare({ id, work, peer, items, check, theirs, ours, rounds = Infinity }, effort) {
  check();
  const limited = { ...effort, rounds: Math.min(rounds, effort.rounds) };
  const [their, our] = timesInTurn([theirs, ours], limited).map((times) => times.map((t) => t / items));
  // Both times of a round are measured one after the other, so their ratio is least affected by other load.
  const ratio = median(their.map((t, round) => t / our[round]));
  return {
    id,
    work,
    peer,
    unit: "ns",
    theirs: median(their),
    ours: median(our),
    ratio,
    spread: [spread(their), spread(our)],
  };
}

/**
 * Nanoseconds per call of each function, one number for each round.
 *
 * @param {(() => number)[]} functions
 * @param {Effort} effort
 * @returns {number[][]}
 */
export function timesInTurn(functions, { rounds, batchMs, warmUpMs }) {
  const calls = functions.map((run) => Math.ceil(batchMs / warmUp(run, warmUpMs)));
  const times = functions.map(() => /** @type {number[]} */ ([]));
  for (let round = 0; round < rounds; round++) {
    for (let k = 0; k < functions.length; k++) {
      const side = (k + round) % functions.length; // alternates which side is first
      times[side].push(1e6 * milliseconds(functions[side], calls[side] || 1));
    }
  }
  if (Number.isNaN(sink)) throw new Error("a result was not a number");
  return times;
}

/**
 * Runs a function until it is optimised.
 *
 * @param {() => number} run
 * @param {number} warmUpMs
 * @returns {number} the time of one call in ms
 */
function warmUp(run, warmUpMs) {
  let calls = 1;
  for (const start = performance.now(); performance.now() - start < warmUpMs; calls *= 2) milliseconds(run, calls);
  return milliseconds(run, Math.max(1, calls >> 2));
}

/**
 * @param {() => number} run
 * @param {number} calls
 */
function milliseconds(run, calls) {
  const start = performance.now();
  for (let i = 0; i < calls; i++) sink += run();
  return (performance.now() - start) / calls;
}

/** @param {number[]} numbers */
export const median = (numbers) => quantile(numbers, 0.5);

/**
 * Half the distance between the quartiles, relative to the median.
 *
 * @param {number[]} numbers
 */
export const spread = (numbers) => (quantile(numbers, 0.75) - quantile(numbers, 0.25)) / 2 / median(numbers);

/**
 * @param {number[]} numbers
 * @param {number} fraction 0 for the smallest, 1 for the largest
 */
function quantile(numbers, fraction) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const position = fraction * (sorted.length - 1);
  const below = Math.floor(position);
  const above = Math.ceil(position);
  return sorted[below] + (position - below) * (sorted[above] - sorted[below]);
}

/**
 * Throws if two lists of numbers differ.
 *
 * @param {string} what
 * @param {ArrayLike<number>} theirs
 * @param {ArrayLike<number>} ours
 * @param {number} tolerance the largest allowed difference
 */
export function assertSame(what, theirs, ours, tolerance) {
  if (theirs.length !== ours.length) throw new Error(`${what}: ${theirs.length} numbers, ours ${ours.length}`);
  for (let i = 0; i < ours.length; i++) {
    if (!(Math.abs(theirs[i] - ours[i]) <= tolerance)) {
      throw new Error(`${what}[${i}]: ${theirs[i]}, ours ${ours[i]}, more than ${tolerance} apart`);
    }
  }
}
