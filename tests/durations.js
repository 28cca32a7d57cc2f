// A reporter for Node's test runner: at the end the seconds of each test file, and an error if no test has run.
import { basename } from "node:path";

/** @param {AsyncIterable<{ type: string, data: any }>} source */
export default async function* durations(source) {
  /** @type {Map<string, number>} */
  const milliseconds = new Map();
  for await (const { type, data } of source) {
    const ran = (type === "test:pass" || type === "test:fail") && data.nesting === 0 && data.skip === undefined;
    if (!ran || !data.file) continue;
    const file = basename(data.file);
    milliseconds.set(file, (milliseconds.get(file) ?? 0) + data.details.duration_ms);
  }
  if (milliseconds.size === 0) {
    process.exitCode = 1;
    yield "\nno test has run: expected a file or a part of a test name\n";
  }
  const slowestFirst = [...milliseconds].sort(([, a], [, b]) => b - a);
  yield [
    "\nSeconds of each file:",
    ...slowestFirst.map(([file, ms]) => `  ${(ms / 1000).toFixed(1).padStart(6)}  ${file}`),
    "",
  ].join("\n");
}
