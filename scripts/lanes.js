// Runs steps: those of a lane one after the other, the lanes at the same time.
import { existsSync, mkdirSync, readFileSync, rmSync } from "node:fs";
import { Skipped } from "./browsers.js";
import { logged, target } from "./run.js";

/**
 * @typedef {object} Step
 * @property {string} name
 * @property {string} title
 * @property {"rust" | "js"} lane what compiles and runs Rust, or what builds and runs JavaScript
 * @property {readonly string[]} [needs] the steps that have to pass before
 * @property {boolean} [selects] whether names of files or tests may follow its name
 * @property {boolean} [once] whether it does the same in every command, so that it need not run again on the same content
 * @property {(context: Context) => Promise<unknown>} act
 *
 * @typedef {object} Context
 * @property {readonly string[]} filters the names of the files or tests to run; if empty, all
 * @property {"few" | "usual" | "many"} amount how many cases generated tests have
 * @property {number} [cases] the number of cases of generated calls, if one was given
 * @property {string} skipped the file to which tests write that they are skipped, a line each
 *
 * @typedef {import("./summary.js").Record} Record
 */

/**
 * @param {readonly { step: Step, filters: readonly string[] }[]} chosen
 * @param {{ amount: Context["amount"], cases?: number, repeat(name: string, filters: readonly string[]): string,
 *   hasPassed(step: Step): boolean, show?(text: string): void }} options show: prints what happens
 * @returns {Promise<Record[]>} in the order of the steps
 */
export async function runLanes(chosen, { amount, cases, repeat, hasPassed, show = console.log }) {
  mkdirSync(`${target}/scripts`, { recursive: true });
  /** @type {Map<string, Promise<Record>>} */
  const records = new Map();
  const single = chosen.length === 1;

  /** @param {Step} step @param {readonly string[]} filters @returns {Promise<Record>} */
  async function record(step, filters) {
    const { name, title } = step;
    const skipped = `${target}/scripts/${name}.skipped`;
    rmSync(skipped, { force: true });
    const begin = performance.now();
    /** @type {string[]} */
    const log = [];
    // The output of a single step is shown as it comes.
    if (single) log.push = (...texts) => texts.map((text) => process.stdout.write(text)).length;
    else show(`         ${title} (${name}) …`);
    const result = await logged(log, async () => {
      try {
        for (const needed of step.needs ?? []) {
          const { outcome } = (await records.get(needed)) ?? {};
          if (outcome && outcome !== "passed")
            throw new Skipped(`needs ${needed}, which ${outcome === "FAILED" ? "failed" : "was skipped"}`);
        }
        if (hasPassed(step))
          return { outcome: /** @type {const} */ ("passed"), note: ": passed before, on the same content" };
        await step.act({ filters, amount, cases, skipped });
        return { outcome: /** @type {const} */ ("passed") };
      } catch (error) {
        const reason = /** @type {Error} */ (error).message;
        return {
          outcome: error instanceof Skipped ? /** @type {const} */ ("skipped") : /** @type {const} */ ("FAILED"),
          reason,
        };
      }
    });
    const seconds = (performance.now() - begin) / 1000;
    if (result.outcome === "FAILED") show(`\n━━ ${title} (${name})\n${log.join("")}\nerror: ${result.reason}\n`);
    show(`${seconds.toFixed(1).padStart(6)} s  ${title} (${name}): ${result.outcome}${result.note ?? ""}`);
    const lines = existsSync(skipped) ? readFileSync(skipped, "utf8").split("\n").filter(Boolean) : [];
    const { outcome, reason } = result;
    return {
      name,
      title,
      seconds,
      outcome,
      reason,
      repeat: repeat(name, filters),
      skippedTests: [...new Set(lines)].sort(),
    };
  }

  /** @param {Step["lane"]} lane */
  const inLane = (lane) => chosen.filter(({ step }) => step.lane === lane);
  for (const lane of /** @type {const} */ (["rust", "js"])) {
    let before = Promise.resolve();
    for (const { step, filters } of inLane(lane)) {
      const own = before.then(() => record(step, filters));
      records.set(step.name, own);
      before = own.then(() => {});
    }
  }
  return Promise.all(chosen.map(({ step }) => /** @type {Promise<Record>} */ (records.get(step.name))));
}
