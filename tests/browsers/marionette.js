// Firefox over Marionette, its own form of WebDriver: the same commands as JSON over a socket, with no program between.
import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { startScreen } from "./screen.js";
import { until } from "./until.js";

/** The port is chosen by Firefox, which writes it into this file of its profile. */
const PORT_FILE = "MarionetteActivePort";
const PREFERENCES = {
  "marionette.port": 0,
  "browser.startup.page": 0,
  "browser.shell.checkDefaultBrowser": false,
  "datareporting.policy.dataSubmissionEnabled": false,
  "app.normandy.enabled": false,
  "services.settings.server": "data:,none", // nothing is fetched
  "webgl.force-enabled": true, // in software
};

const COMMANDS = {
  navigate: "WebDriver:Navigate",
  execute: "WebDriver:ExecuteAsyncScript",
  act: "WebDriver:PerformActions",
  release: "WebDriver:ReleaseActions",
  timeouts: "WebDriver:SetTimeouts",
  resize: "WebDriver:SetWindowRect",
};

/**
 * Starts Firefox and a session in it.
 *
 * @param {string} path of the program
 * @returns {Promise<import("./session.js").Transport>}
 */
export async function startFirefox(path) {
  const profile = await mkdtemp(join(tmpdir(), "casteljau-firefox-"));
  const lines = Object.entries(PREFERENCES).map(
    ([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});\n`,
  );
  await writeFile(join(profile, "user.js"), lines.join(""));
  const screen = await startScreen(); // without one (--headless) there is no WebGL in software
  const env = { ...process.env, DISPLAY: screen.display };
  const firefox = spawn(path, ["--marionette", "--no-remote", "--profile", profile], { stdio: "ignore", env });
  const ended = new Promise((done) => firefox.once("exit", done));
  try {
    const port = await until("Firefox to listen", () =>
      readFile(join(profile, PORT_FILE), "utf8").then(Number, () => 0),
    );
    const { call, close } = await dial(port);
    await call("WebDriver:NewSession", {});
    const end = async () => {
      close();
      firefox.kill();
      await ended;
      screen.end();
      await rm(profile, { recursive: true, force: true, maxRetries: 5 });
    };
    return { send: (command, parameters) => call(COMMANDS[command], parameters), end };
  } catch (error) {
    firefox.kill();
    screen.end();
    throw error;
  }
}

/** Opens the socket. A packet is its length, a colon, and [kind, number, name or error, parameters or result]. */
async function dial(port) {
  const socket = connect(port, "127.0.0.1");
  const waiting = new Map();
  let count = 0;
  let buffer = Buffer.alloc(0);
  socket.on("data", (/** @type {Buffer} */ bytes) => {
    buffer = Buffer.concat([buffer, bytes]);
    for (let packet = take(); packet; packet = take()) waiting.get(packet[1])?.(packet);
  });
  const take = () => {
    const colon = buffer.indexOf(":");
    const end = colon + 1 + Number(buffer.subarray(0, Math.max(colon, 0)));
    if (colon < 0 || buffer.length < end) return undefined;
    const packet = JSON.parse(buffer.subarray(colon + 1, end).toString());
    buffer = buffer.subarray(end);
    return packet;
  };
  await new Promise((done, failed) => socket.once("connect", done).once("error", failed));
  const call = async (name, parameters) => {
    const number = ++count;
    const answer = new Promise((done) => waiting.set(number, done));
    const text = JSON.stringify([0, number, name, parameters]);
    socket.write(`${Buffer.byteLength(text)}:${text}`);
    const [, , error, result] = await answer;
    if (error) throw new Error(`${name}: ${error.error}: ${error.message}`);
    return result && "value" in result ? result.value : result;
  };
  return { call, close: () => socket.destroy() };
}
