// The Web Worker of the page: asks one library all facts, and sends each answer as soon as it is there.
import { textOf } from "./answers.js";
import { ask } from "./judge.js";
import { LOADERS } from "./load.js";

/** @typedef {{ library: string, facts: import("./facts.js").Fact[] }} Request */
/** @typedef {{ id: string, grade: import("./judge.js").Grade, off: number, text: string }} Reply */
/** @typedef {{ end: string | null }} End the error, if there is one */

addEventListener("message", async ({ data }) => {
  const { library, facts } = /** @type {Request} */ (data);
  try {
    const { answers } = await LOADERS[library]();
    for (const fact of facts) {
      const { grade, off, got } = ask(answers, fact);
      postMessage({ id: fact.id, grade, off, text: grade === "not offered" ? "" : textOf(got) });
    }
    postMessage({ end: null });
  } catch (error) {
    postMessage({ end: `${library}: ${error instanceof Error ? error.message : error}` });
  }
});
