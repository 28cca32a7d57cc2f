// A second reporter for Node's test runner: lists the skipped tests with their reasons, one per line, for the driver's
// summary. A run without tests is a failure, because then a name on the command line matches nothing.

/** Older versions of Node report the tests that `--test-name-pattern` excludes as skipped, with this reason. */
const FILTERED = "test name does not match pattern";

/**
 * @param {AsyncIterable<{ type: string, data: { name: string, skip?: string | boolean, details?: { type?: string } }
 * }>} events
 */
export default async function* skipped(events) {
  let count = 0;
  for await (const { type, data } of events) {
    if (type !== "test:pass" && type !== "test:fail") continue;
    if (data.skip === FILTERED || data.details?.type === "suite") continue;
    count += 1;
    // `skip` is an empty string if the test gives no reason.
    if (data.skip !== undefined)
      yield `${data.name}: ${typeof data.skip === "string" && data.skip ? data.skip : "no reason given"}\n`;
  }
  if (count === 0) {
    console.error("error: no test ran");
    process.exitCode = 1;
  }
}
