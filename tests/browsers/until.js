import { setTimeout as pause } from "node:timers/promises";

/** An upper bound, many times longer than a browser takes on a busy machine. */
const PATIENCE_MS = 120_000;
/** Between two questions to another process, which cannot be asked to tell. */
const INTERVAL_MS = 25;

/**
 * Asks again and again until the answer is neither false nor nothing.
 *
 * @template T
 * @param {string} what is waited for
 * @param {() => T | Promise<T>} ask
 * @returns {Promise<T>}
 */
export async function until(what, ask) {
  const patience = AbortSignal.timeout(PATIENCE_MS);
  for (;;) {
    const answer = await ask();
    if (answer) return answer;
    if (patience.aborted) throw new Error(`expected ${what} within ${PATIENCE_MS / 1000} s, got nothing`);
    await pause(INTERVAL_MS);
  }
}
