// Makes the calls of some functions on a thread of its own: a call that does not return must not stop the test.
import { parentPort, workerData } from "node:worker_threads";
import { setImmediate } from "node:timers/promises";
import { argumentsOf, GROUPS } from "./calls.js";
import { checkAnswer, checkRefusal, works } from "./checks.js";
import { lines, rowOf } from "./generator.js";
import { READERS } from "./parsers.js";

/** Cases that the generator makes at once. */
const CHUNK = 2_000;
/** Calls after which the thread is idle for a moment. */
const YIELD_AFTER = 16;
/** Failures of a function that are told. */
const SHOWN = 2;

const { path, seed, first, count, names, progress } = workerData;
const calls = Object.assign({}, ...GROUPS, READERS);
/** Which call is running, for the thread that watches: the place of its function, and its number. */
const current = new Float64Array(progress);

/** @param {string} name @param {any} given a case */
function run(name, given) {
  const values = argumentsOf(given.arguments);
  let answer;
  try {
    answer = calls[name](values);
  } catch (/** @type {any} */ error) {
    if (error?.code === "ERR_ASSERTION") throw error;
    checkRefusal(error);
    return works();
  }
  checkAnswer(name, given, answer, values);
}

async function runFunction(name, place) {
  const failures = [];
  let failed = 0;
  for (let from = first; from < first + count; from += CHUNK) {
    for (const line of lines(path, seed, rowOf(name), from, Math.min(CHUNK, first + count - from))) {
      const given = JSON.parse(line);
      current.set([place, given.number]);
      // What weak references point to is kept until the thread has been idle once.
      if (given.number % YIELD_AFTER === 0) await setImmediate();
      try {
        run(name, given);
      } catch (/** @type {any} */ error) {
        failed++;
        if (failures.length < SHOWN)
          failures.push({ number: given.number, mode: given.mode, message: `${error?.message ?? error}` });
      }
    }
  }
  return { name, failed, failures };
}

const port = /** @type {import("node:worker_threads").MessagePort} */ (parentPort);
for (const [place, name] of names.entries()) port.postMessage(await runFunction(name, place));
port.close();
