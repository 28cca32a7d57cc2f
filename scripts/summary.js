// The summary of a run: a table of times, the failures, the skipped steps and tests, and one line of counts.

/**
 * @typedef {object} Record
 * @property {string} name
 * @property {string} title
 * @property {number} seconds
 * @property {"passed" | "FAILED" | "skipped"} outcome
 * @property {string} [reason] of a failure, or why it was skipped
 * @property {string} repeat the command that repeats the step
 * @property {string[]} skippedTests each with its reason
 */

/** @param {readonly Record[]} records @param {number} seconds */
export function summary(records, seconds) {
  const time = (/** @type {number} */ s) => `${s.toFixed(1).padStart(7)} s`;
  const rows = records.map(({ name, title, seconds, outcome, skippedTests: { length } }) => {
    const tests = length > 0 ? `, ${length} ${length === 1 ? "test" : "tests"} skipped` : "";
    return `  ${outcome.padEnd(8)}${time(seconds)}  ${title} (${name})${tests}\n`;
  });
  const failed = records
    .filter(({ outcome }) => outcome === "FAILED")
    .map(({ name, reason, repeat }) => `  ${name}: ${reason}\n      to repeat: ${repeat}\n`);
  const skipped = records.flatMap(({ name, outcome, reason, skippedTests }) =>
    [...(outcome === "skipped" ? [reason] : []), ...skippedTests].map((text) => `  ${name}: ${text}\n`),
  );
  const titled = (/** @type {string} */ title, /** @type {string[]} */ lines) =>
    lines.length > 0 ? `\n${title}:\n${lines.join("")}` : "";
  const count = (/** @type {string} */ wanted) => records.filter(({ outcome }) => outcome === wanted).length;
  return `
━━ Summary
${rows.join("")}  ${"".padEnd(8)}${time(seconds)}  together
${titled("Failed", failed)}${titled("Skipped", skipped)}
${count("passed")} passed, ${count("FAILED")} failed, ${count("skipped")} skipped
`;
}
