// How times are taken: both sides in turn, warmed, many rounds, medians, results consumed.

/**
 * One row: the same work done by a peer and by us. Both functions return a number that depends on their result.
 *
 * @typedef {object} Row
 * @property {string} id as in targets.js
 * @property {string} work
 * @property {string} peer
 * @property {number} items how often one call does the work
 * @property {() => void} check throws unless both sides give the same answer
 * @property {() => number} theirs
 * @property {() => number} ours
 */

/** @typedef {{ rounds: number, batch: number, warm: number }} Effort rounds, and ms for one batch and for warming up */

/** @type {Effort} */
export const FULL = { rounds: 31, batch: 10, warm: 300 };
/** To see that everything runs; its times mean nothing. */
export const QUICK = { rounds: 1, batch: 0, warm: 0 };

/** All results end up here, so that no compiler may leave the work out. */
let sink = 0;

/**
 * Checks that both sides agree, then times them in turn.
 *
 * @param {Row} row
 * @param {Effort} effort
 */
export function race({ id, work, peer, items, check, theirs, ours }, effort) {
  check();
  const [their, our] = timesInTurn([theirs, ours], effort).map((times) => times.map((t) => t / items));
  // Both times of a round were taken side by side, so their ratio suffers least from what else the machine does.
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
 * @param {(() => number)[]} acts
 * @param {Effort} effort
 * @returns {number[][]}
 */
export function timesInTurn(acts, { rounds, batch, warm }) {
  const calls = acts.map((act) => Math.ceil(batch / warmedUp(act, warm)));
  const times = acts.map(() => /** @type {number[]} */ ([]));
  for (let round = 0; round < rounds; round++) {
    for (let k = 0; k < acts.length; k++) {
      const side = (k + round) % acts.length; // no side is always the first
      times[side].push(1e6 * milliseconds(acts[side], calls[side] || 1));
    }
  }
  if (Number.isNaN(sink)) throw new Error("a result was not a number");
  return times;
}

/**
 * Runs a function for a while.
 *
 * @param {() => number} act
 * @param {number} warm ms
 * @returns {number} the ms that one warm call takes
 */
function warmedUp(act, warm) {
  let calls = 1;
  for (const start = performance.now(); performance.now() - start < warm; calls *= 2) milliseconds(act, calls);
  return milliseconds(act, Math.max(1, calls >> 2));
}

/**
 * @param {() => number} act
 * @param {number} calls
 */
function milliseconds(act, calls) {
  const start = performance.now();
  for (let i = 0; i < calls; i++) sink += act();
  return (performance.now() - start) / calls;
}

/** @param {number[]} numbers */
export const median = (numbers) => quantile(numbers, 0.5);

/**
 * Half the distance between the quartiles, as a part of the median.
 *
 * @param {number[]} numbers
 */
export const spread = (numbers) => (quantile(numbers, 0.75) - quantile(numbers, 0.25)) / 2 / median(numbers);

/**
 * @param {number[]} numbers
 * @param {number} part 0 for the least, 1 for the greatest
 */
function quantile(numbers, part) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const place = part * (sorted.length - 1);
  const below = Math.floor(place);
  const above = Math.ceil(place);
  return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
}

/**
 * Throws unless two lists of numbers agree.
 *
 * @param {string} what
 * @param {ArrayLike<number>} theirs
 * @param {ArrayLike<number>} ours
 * @param {number} tolerance the greatest difference allowed
 */
export function assertSame(what, theirs, ours, tolerance) {
  if (theirs.length !== ours.length) throw new Error(`${what}: ${theirs.length} numbers, ours ${ours.length}`);
  for (let i = 0; i < ours.length; i++) {
    if (!(Math.abs(theirs[i] - ours[i]) <= tolerance)) {
      throw new Error(`${what}[${i}]: ${theirs[i]}, ours ${ours[i]}, more than ${tolerance} apart`);
    }
  }
}
