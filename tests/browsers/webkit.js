// WebKitGTK over its WebDriver, in an X server without a screen.
import { spawn } from "node:child_process";
import { createServer } from "node:net";
import { startScreen } from "./screen.js";
import { until } from "./until.js";

const COMMANDS = {
  navigate: ["POST", "url"],
  execute: ["POST", "execute/async"],
  act: ["POST", "actions"],
  release: ["DELETE", "actions"],
  timeouts: ["POST", "timeouts"],
  resize: ["POST", "window/rect"],
};

/**
 * Starts the driver and a session, which starts the browser.
 *
 * @param {string} path of the driver
 * @returns {Promise<import("./session.js").Transport>}
 */
export async function startWebKit(path) {
  const screen = await startScreen();
  const port = await freePort();
  // A group of its own, so that the browser and its processes end with the driver.
  const driver = spawn(path, [`--port=${port}`], {
    stdio: "ignore",
    detached: true,
    env: { ...process.env, DISPLAY: screen.display },
  });
  const stop = () => {
    try {
      process.kill(-(driver.pid ?? 0));
    } catch {
      // ended already
    }
    screen.end();
  };
  const base = `http://127.0.0.1:${port}/`;
  try {
    await until("WebKitWebDriver to listen", () =>
      fetch(`${base}status`).then(
        (answer) => answer.ok,
        () => false,
      ),
    );
    const { sessionId } = await ask("POST", `${base}session`, { capabilities: {} });
    const session = `${base}session/${sessionId}`;
    const send = (command, parameters) => ask(COMMANDS[command][0], `${session}/${COMMANDS[command][1]}`, parameters);
    return {
      send,
      end: () =>
        ask("DELETE", session)
          .catch(() => {})
          .then(stop),
    };
  } catch (error) {
    stop();
    throw error;
  }
}

/** One command; the error's words where it fails. */
async function ask(method, url, parameters) {
  const body = method === "POST" ? JSON.stringify(parameters ?? {}) : undefined;
  const { value } = await (await fetch(url, { method, body })).json();
  if (value?.error)
    throw new Error(`${new URL(url).pathname.split("/").slice(3).join("/")}: ${value.error}: ${value.message}`);
  return value;
}

async function freePort() {
  const server = createServer();
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(undefined)));
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  await new Promise((done) => server.close(done));
  return port;
}
