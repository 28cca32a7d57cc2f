import { spawn } from "node:child_process";

/**
 * The display that is there; else, on Linux, an X server without a screen, which chooses its own number and tells it.
 *
 * @returns {Promise<{ display: string, end(): void }>}
 */
export async function startScreen() {
  if (process.env.DISPLAY || process.platform !== "linux") return { display: process.env.DISPLAY ?? "", end() {} };
  const server = spawn("Xvfb", ["-displayfd", "3", "-screen", "0", "1280x1400x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  const number = await new Promise((done, failed) => {
    server.once("error", failed).once("exit", () => failed(new Error("Xvfb ended")));
    /** @type {import("node:stream").Readable} */ (server.stdio[3]).once("data", (bytes) => done(String(bytes).trim()));
  });
  return { display: `:${number}`, end: () => void server.kill() };
}
