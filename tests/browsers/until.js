const PATIENCE_MS = 60_000;
const PAUSE_MS = 25;

/**
 * Asks again and again until the answer is neither false nor nothing.
 *
 * @template T
 * @param {string} what is waited for
 * @param {() => T | Promise<T>} ask
 * @returns {Promise<T>}
 */
export async function until(what, ask) {
  const end = Date.now() + PATIENCE_MS;
  for (;;) {
    const answer = await ask();
    if (answer) return answer;
    if (Date.now() > end) throw new Error(`waited in vain for ${what}`);
    await new Promise((done) => setTimeout(done, PAUSE_MS));
  }
}
